// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What are the sines and cosines of many angles, to the last bit?
//
// Plain C++, spans only. The specification is `base::sin_cos`: every vector target gives its bits.

#include <span>

namespace vandplan::simd {

/// Number of angles in a batch.
inline constexpr std::size_t turns_of_batch = 8;

/// Sines and cosines of angles of at most `base::series::moderate` [rad] in absolute value. All
/// sizes are one multiple of `turns_of_batch`.
void sines_and_cosines(std::span<const double> angles, std::span<double> sines,
                       std::span<double> cosines) noexcept;

}  // namespace vandplan::simd

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which way do many angles point, to the last bit?
//
// Plain C++, spans only. The specification is `base::sin_cos`: every vector target gives its bits.

#include <span>

namespace vandplan::simd {

/// How many angles are one batch.
inline constexpr std::size_t turns_of_batch = 8;

/// Sines and cosines of angles up to `base::series::moderate` [rad], batches of them.
void sines_and_cosines(std::span<const double> angles, std::span<double> sines,
                       std::span<double> cosines) noexcept;

}  // namespace vandplan::simd

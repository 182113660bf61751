// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long are the shortest Reeds-Shepp paths between many pairs of poses, to the last bit?
//
// Plain C++, spans only. The specification is `vandplan::reeds_shepp_length`: every vector target
// gives its bits.

#include <span>

namespace vandplan::simd {

/// Lengths from every first to every second pose [m]: x, y [m], heading [rad], one pose after the
/// other; either one pose or as many as there are lengths. `radius` > 0 [m]. Pairs that are not for
/// vectors get NaN: headings of many turns, distances beyond 1e100 radii, numbers that are not
/// finite, and in a build without vectors all of them.
void exact_lengths(std::span<const double> from, std::span<const double> to, double radius,
                   std::span<double> out) noexcept;

/// The largest distance along x or y that is for vectors, in turning radii.
inline constexpr double most_radii = 1e100;

}  // namespace vandplan::simd

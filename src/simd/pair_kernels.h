// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long are the shortest Reeds-Shepp paths between many pairs of poses, to the last bit?
//
// Plain C++, spans only. The specification is `vandplan::reeds_shepp_length`: every vector target
// gives its bits.

#include <span>

namespace vandplan::simd {

/// Lengths from each pose of `from` to the pose of `to` with the same index [m]. A pose is three
/// numbers: x, y [m], heading [rad]. Either side has one pose, or as many as `out` has lengths.
/// `radius` > 0 [m]. Pairs that vectors cannot handle get NaN: headings of many turns, distances
/// beyond 1e100 radii, numbers that are not finite. In a build without vectors all pairs get NaN.
void exact_lengths(std::span<const double> from, std::span<const double> to, double radius,
                   std::span<double> out) noexcept;

/// Largest distance along x or y that vectors handle [turning radii].
inline constexpr double most_radii = 1e100;

}  // namespace vandplan::simd

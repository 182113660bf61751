// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is the table of bounds asked for many nodes at once?
//
// Plain C++, spans only. The scalar functions are the specification; every vector target gives the
// same bits.

#include <span>

#include "simd/bound_grid.h"
#include "simd/series.h"

namespace vandplan::simd {

/// The pose to which the lengths lead [m, rad]; heading in [-pi, pi].
struct BoundSample {
  float x, y, heading;
};

/// Bounds of a length: low <= length <= high [m].
struct LowHigh {
  float low, high;
};

/// Bounds of the length between a node at (dx, dy) from the sample [m] and the sample; headings in
/// [-pi, pi], `radius` of turning [m].
[[nodiscard]] LowHigh length_bounds(const BoundEntry* entries, float dx, float dy,
                                    float heading_node, float heading_sample,
                                    float radius) noexcept;

/// Bounds of the lengths from every node, given as structure of arrays, to one sample [m]. Equal
/// sizes.
void length_bounds(const BoundEntry* entries, std::span<const float> x, std::span<const float> y,
                   std::span<const float> heading, const BoundSample& sample, float radius,
                   std::span<float> low, std::span<float> high) noexcept;

namespace scalar {
void length_bounds(const BoundEntry* entries, std::span<const float> x, std::span<const float> y,
                   std::span<const float> heading, const BoundSample& sample, float radius,
                   std::span<float> low, std::span<float> high) noexcept;
}

// What scalar and vector code share.

/// Bound of the relative error of a distance in float. Turns are off by less than 4 * noise [rad].
inline constexpr float noise = 0x1p-20F;

/// Taylor's series of sin(x) / x and of cos(x) in x^2, last term first; error 1e-7 up to pi/2.
inline constexpr float sine_series[] = {-1.0F / 39916800, 1.0F / 362880, -1.0F / 5040,
                                        1.0F / 120,       -1.0F / 6,     1.0F};
inline constexpr float cosine_series[] = {
    1.0F / 479001600, -1.0F / 3628800, 1.0F / 40320, -1.0F / 720, 1.0F / 24, -0.5F, 1.0F};

}  // namespace vandplan::simd

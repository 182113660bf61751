// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long are the shortest Reeds-Shepp paths from many nodes to one pose?
//
// Plain C++, spans only. The scalar functions are the specification; every vector target gives the
// same bits. All in float: lengths for ranking, off by no more than `length_error` says.

#include <span>

namespace vandplan::simd {

/// The pose to which the paths lead [m, rad]; heading in [-pi, pi].
struct LengthSample {
  float x, y, heading;
};

/// Length between a node at (dx, dy) from the sample [m] and the sample [m]; headings in
/// [-pi, pi], `radius` of turning [m].
[[nodiscard]] float reeds_shepp_length(float dx, float dy, float heading_node, float heading_sample,
                                       float radius) noexcept;

/// Lengths from every node, given as structure of arrays, to one sample [m]. Equal sizes.
void reeds_shepp_lengths(std::span<const float> x, std::span<const float> y,
                         std::span<const float> heading, const LengthSample& sample, float radius,
                         std::span<float> out) noexcept;

namespace scalar {
void reeds_shepp_lengths(std::span<const float> x, std::span<const float> y,
                         std::span<const float> heading, const LengthSample& sample, float radius,
                         std::span<float> out) noexcept;
}

/// Bound of a length's error as a share of length + radius, for poses that round to these floats.
/// It is seven times the largest error that tests/steering/reeds_shepp_batch_test.cpp finds.
inline constexpr float length_error = 0x1p-18F;

// What scalar and vector code share: polynomials in x^2, last term first.

/// Polynomials of (sin(x) / x - 1) / x^2 and (cos(x) - 1 + x^2 / 2) / x^4 up to pi/2. Sine and
/// cosine are right to 1e-8.
inline constexpr float sine_rest[] = {2.6089702e-6F, -1.98111318e-4F, 8.33308847e-3F,
                                      -0.166666605F};
inline constexpr float cosine_rest[] = {-2.61940736e-7F, 2.47693185e-5F, -1.38885694e-3F,
                                        4.16666558e-2F};

/// Polynomial of (atan(x) / x - 1) / x^2 up to tan(pi/8). The arc tangent's relative error is 2e-8.
inline constexpr float arc_tangent_rest[] = {8.0699567e-2F, -0.138832571F, 0.199783001F,
                                             -0.333329676F};
inline constexpr float tan_eighth = 0.41421356F;  ///< tan(pi/8)

}  // namespace vandplan::simd

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "simd/length_kernels.h"
#include "simd/series.h"

namespace vandplan::simd {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

float at_least_zero(float value) noexcept { return value > 0.0F ? value : 0.0F; }

float root(float value) noexcept { return std::sqrt(at_least_zero(value)); }

// Sine and cosine of an angle in [-pi/2, pi/2].
struct Direction {
  float sin, cos;
};

Direction direction(float angle) noexcept {
  const float z = angle * angle;
  const float sin = angle + (angle * z) * horner(sine_rest, z);
  const float cos = (1.0F - 0.5F * z) + (z * z) * horner(cosine_rest, z);
  return {sin, cos};
}

// The angle in [-pi, pi] of a vector (x, y) that is not zero.
float atan_2(float y, float x) noexcept {
  const float abs_x = std::abs(x);
  const float abs_y = std::abs(y);
  const float a = abs_x < abs_y ? abs_x : abs_y;
  const float b = abs_x < abs_y ? abs_y : abs_x;
  // The angle from the nearer of 0 and 45 degrees.
  const bool middle = a > b * tan_eighth;
  const float q = (a - (middle ? b : 0.0F)) / (b + (middle ? a : 0.0F));
  const float z = q * q;
  float angle = (q + (q * z) * horner(arc_tangent_rest, z)) + (middle ? pi / 4 : 0.0F);
  if (abs_x < abs_y) angle = pi / 2 - angle;
  if (x < 0.0F) angle = pi - angle;
  return y < 0.0F ? -angle : angle;
}

// The angle of the vector (x, y) turned by that of the vector (p, q).
float angle_of_turned(float x, float y, float p, float q) noexcept {
  return atan_2(y * p + x * q, x * p - y * q);
}

// A pair of poses in its mean frame (steering/mean_frame.h), all signs positive, in turning radii.
struct FloatCircles {
  float x, y;
  float a, s, c;  // half turn, its sine and cosine
  float lr, rl;   // squared distances of left and right circles, less 4
};

FloatCircles circles(float dx, float dy, float heading_node, float heading_sample,
                     float radius) noexcept {
  const float mean = 0.5F * (heading_node + heading_sample);
  const float turns = std::nearbyint(mean * (1 / pi));
  const auto [sin, cos] = direction((mean - turns * pi) - turns * rest_of_pi);
  const float scale = 1.0F / radius;
  FloatCircles p;
  p.x = std::abs(dx * cos + dy * sin) * scale;
  p.y = std::abs(dy * cos - dx * sin) * scale;
  const float difference = std::abs(heading_node - heading_sample);
  const float other_way = (2 * pi - difference) + 2 * rest_of_pi;
  p.a = 0.5F * at_least_zero(difference < other_way ? difference : other_way);
  const auto [s, c] = direction(p.a);
  p.s = s;
  p.c = c;
  const float shared = (p.x - 2 * s) * (p.x + 2 * s);
  p.lr = shared + p.y * (p.y - 4 * c);
  p.rl = shared + p.y * (p.y + 4 * c);
  return p;
}

// Length of the shortest word of arcs (8.4, 8.7, 8.8), where the first left and the last right
// circle overlap.
float shortest_of_arcs(const FloatCircles& p) noexcept {
  const float x = p.x + 2 * p.s;
  const float across = 2 * p.c - p.y;
  const float between = root(p.x * p.x + across * across);
  const float ahead = (p.x - 2 * p.s) * p.c - p.y * p.s;
  const bool is_r_lr_l = p.lr + (8 * p.s) * x <= 0;
  const bool is_lr_lr = p.lr * (between + 4) + (4 * (between + 2)) * (p.s * x + p.y * p.c) <= 0 &&
                        ahead + (2 * p.y) * p.s <= 0;
  float length;
  if (is_r_lr_l) {  // 8.8
    const float cos = 1 - p.rl * 0.0625F;
    const float sin = root(p.rl * (32 - p.rl)) * 0.0625F;
    length = 2 * angle_of_turned(p.y + 2 * p.c, -p.x, 2 * cos - 1, 2 * sin);
  } else {  // 8.4
    const float square = x * x + p.y * p.y;
    length = 2 * angle_of_turned(x, p.y, root(1 - square * 0.0625F), root(square) * 0.25F);
  }
  if (is_lr_lr) {  // 8.7
    const float sin_squared = -p.lr / (8 * (2 + between));
    const float lr_lr = 8 * atan_2(root(sin_squared), root(1 - sin_squared)) - 2 * p.a;
    if (!is_r_lr_l || lr_lr < length) length = lr_lr;
  }
  return length;
}

// Length of the shortest word. The choice is that of steering/reeds_shepp_formulas.h;
// docs/proofs/steering.md proves it.
float shortest(const FloatCircles& p) noexcept {
  if (p.rl <= 0) return 2 * p.a;  // 8.3

  const float less = p.x - 2 * p.s;
  const float ahead = less * p.c - p.y * p.s;
  if (ahead <= 0 && p.x * p.s - p.y * p.c >= (2 * p.c) * p.c) {  // 8.10
    return (root(4 + p.rl) - 2) + 2 * p.a;
  }
  if (ahead >= 0 && less * p.s - p.y * p.c >= 0) {  // 8.1
    return root(less * less + p.y * p.y) + 2 * p.a;
  }
  const float x = p.x + 2 * p.s;
  const float beyond = (x * p.c + p.y * p.s) - 2;
  if (p.rl >= 16 && beyond <= 0) {  // 8.11
    const float d = root(p.rl);
    return (d + (pi - 4)) + 2 * angle_of_turned(p.y + 2 * p.c, -p.x, d, 2);
  }
  const float square = x * x + p.y * p.y;
  if (square >= 8 && beyond >= 0 && ahead + (4 * p.s) * p.c <= 2) {  // 8.9
    const float d = root(square - 4);
    return (d - 2) + 2 * angle_of_turned(x, p.y, d, 2);
  }
  if (p.lr >= 0) {  // 8.2
    const float d = root(p.lr);
    return d + 2 * angle_of_turned(p.x, p.y - 2 * p.c, d, 2);
  }
  return shortest_of_arcs(p);
}

}  // namespace

float reeds_shepp_length(float dx, float dy, float heading_node, float heading_sample,
                         float radius) noexcept {
  return shortest(circles(dx, dy, heading_node, heading_sample, radius)) * radius;
}

void scalar::reeds_shepp_lengths(std::span<const float> x, std::span<const float> y,
                                 std::span<const float> heading, const LengthSample& sample,
                                 float radius, std::span<float> out) noexcept {
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] =
        reeds_shepp_length(x[i] - sample.x, y[i] - sample.y, heading[i], sample.heading, radius);
  }
}

}  // namespace vandplan::simd

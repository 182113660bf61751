// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "simd/bound_kernels.h"

namespace vandplan::simd {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

// Sine and cosine of an angle in [-pi, pi], maybe both with the wrong sign.
struct Direction {
  float sin, cos;
};

Direction direction_up_to_sign(float angle) noexcept {
  const float turns = std::nearbyint(angle * (1 / pi));
  const float x = (angle - turns * pi) - turns * rest_of_pi;
  return {x * horner(sine_series, x * x), horner(cosine_series, x * x)};
}

// The cell of a coordinate in [0, 1], and the place across this cell in [0, 1].
struct Place {
  int cell;
  float across;
};

// The place of a coordinate among `cells` cells. NaN gets the first cell, because std::max gives
// its first argument then.
Place place(float coordinate, int cells) noexcept {
  const float scaled = coordinate * static_cast<float>(cells);
  const auto cell =
      static_cast<int>(std::min(static_cast<float>(cells - 1), std::max(0.0F, scaled)));
  return {cell, scaled - static_cast<float>(cell)};
}

float signed_bits(std::uint32_t word, int skip, int count) noexcept {
  return static_cast<float>(static_cast<std::int32_t>(word << skip) >> (32 - count));
}

}  // namespace

LowHigh length_bounds(const BoundEntry* entries, float dx, float dy, float heading_node,
                      float heading_sample, float radius) noexcept {
  const auto [sin, cos] = direction_up_to_sign(0.5F * (heading_node + heading_sample));
  const float along = std::abs(dx * cos + dy * sin);
  const float across = std::abs(dy * cos - dx * sin);
  const float difference = std::abs(heading_node - heading_sample);
  const float turn = std::max(std::min(difference, 2 * pi - difference), 0.0F);
  const float distance = std::sqrt(dx * dx + dy * dy) * (1.0F / radius);

  const Place u = place(distance / (distance + static_cast<float>(radial_reach)), radial_cells);
  const Place v = place(across / std::max(along + across, 1e-30F), side_cells);
  const Place w = place(turn * (1 / pi), turn_cells);
  const BoundEntry entry = entries[bound_index(u.cell, v.cell, w.cell)];

  const float base = signed_bits(entry.base_width, 0, 16);
  const auto width = static_cast<float>(entry.base_width & 0xFFFFU);
  const float flat =
      signed_bits(entry.slopes, 0, 11) * u.across + signed_bits(entry.slopes, 11, 11) * v.across;
  const float excess = (base + signed_bits(entry.slopes, 22, 10) * w.across) + slope_step * flat;
  const auto unit = static_cast<float>(bound_unit);
  // No path is shorter than the distance or the turn.
  const float low =
      std::max(distance * (1 - noise) + std::max(excess, 0.0F) * unit, turn - 4 * noise);
  const float high = distance * (1 + noise) + (excess + width) * unit;
  return {low * radius, high * radius};
}

void scalar::length_bounds(const BoundEntry* entries, std::span<const float> x,
                           std::span<const float> y, std::span<const float> heading,
                           const BoundSample& sample, float radius, std::span<float> low,
                           std::span<float> high) noexcept {
  for (std::size_t i = 0; i < low.size(); ++i) {
    const LowHigh bounds = simd::length_bounds(entries, x[i] - sample.x, y[i] - sample.y,
                                               heading[i], sample.heading, radius);
    low[i] = bounds.low;
    high[i] = bounds.high;
  }
}

}  // namespace vandplan::simd

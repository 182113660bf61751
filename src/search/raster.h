// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it between cells of a guide's grid, and from a point to the side of a polygon?

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "vandplan/geometry.h"

namespace vandplan::search {

/// Cell of a grid: column and row.
struct RasterCell {
  std::int32_t x = 0, y = 0;
  bool operator==(const RasterCell&) const = default;
};

/// Cost of a step to a neighbour [1/5 cell]. The ratio 7 / 5 is near the square root of two.
inline constexpr std::int32_t straight_cost = 5;
inline constexpr std::int32_t diagonal_cost = 7;

/// Least cost of a way between two cells [1/5 cell]; reached where nothing is blocked.
[[nodiscard]] inline std::int32_t cost_between(const RasterCell& a, const RasterCell& b) noexcept {
  const std::int32_t dx = std::abs(a.x - b.x);
  const std::int32_t dy = std::abs(a.y - b.y);
  return straight_cost * std::max(dx, dy) + (diagonal_cost - straight_cost) * std::min(dx, dy);
}

/// Squared distance from a point to the line segment from `a` to `b` [m^2].
[[nodiscard]] inline double squared_distance(const Point& p, const Point& a,
                                             const Point& b) noexcept {
  const double ux = b.x - a.x;
  const double uy = b.y - a.y;
  const double uu = ux * ux + uy * uy;
  const double t = uu > 0 ? ((p.x - a.x) * ux + (p.y - a.y) * uy) / uu : 0.0;
  const double along = std::clamp(t, 0.0, 1.0);
  const double dx = a.x + along * ux - p.x;
  const double dy = a.y + along * uy - p.y;
  return dx * dx + dy * dy;
}

/// The x where the line segment from `a` to `b` crosses a height; beyond an end, the x of that end.
[[nodiscard]] inline double place_at(const Point& a, const Point& b, double height) noexcept {
  if (a.y == b.y) return height < a.y ? a.x : b.x;
  return a.x + std::clamp((height - a.y) / (b.y - a.y), 0.0, 1.0) * (b.x - a.x);
}

}  // namespace vandplan::search

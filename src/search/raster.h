// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which cells of a grid are near the side of a polygon, and how far is it between cells?

#include <algorithm>
#include <cmath>
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

/// Slack where a nearly level side is crossed [cells].
inline constexpr double level_slack = 1e-3;

/// Square cells over the plane.
struct Raster {
  Point origin = {};  ///< lower left corner of cell (0, 0) [m]
  double side = 1.0;  ///< side of a cell [m]

  /// Cell that contains a point.
  [[nodiscard]] RasterCell cell_of(const Point& point) const noexcept {
    return {static_cast<std::int32_t>(std::floor((point.x - origin.x) / side)),
            static_cast<std::int32_t>(std::floor((point.y - origin.y) / side))};
  }
  [[nodiscard]] Point centre_of(const RasterCell& cell) const noexcept {
    return {origin.x + (cell.x + 0.5) * side, origin.y + (cell.y + 0.5) * side};
  }

  /// Calls `visit(cell, squared distance)` for each cell from `first` to `last` whose centre is
  /// within `reach` [m] of the side from `a` to `b`, and for some cells around them. Returns the
  /// number of calls.
  template <typename Visit>
  std::int64_t visit_near(const Point& a, const Point& b, double reach, const RasterCell& first,
                          const RasterCell& last, Visit visit) const {
    // Clamped in double, as the offset of an obstacle may exceed an integer.
    const auto index = [this](double offset, std::int32_t low, std::int32_t high) {
      return static_cast<std::int32_t>(
          std::clamp(std::floor(offset / side), low + 0.0, high + 0.0));
    };
    reach += side * level_slack;
    const Point low = centre_of(first);
    const Point high = centre_of(last);
    if (std::max(a.x, b.x) + reach < low.x || std::min(a.x, b.x) - reach > high.x ||
        std::max(a.y, b.y) + reach < low.y || std::min(a.y, b.y) - reach > high.y) {
      return 0;
    }
    std::int64_t calls = 0;
    const std::int32_t y_last = index(std::max(a.y, b.y) + reach - origin.y, first.y, last.y);
    for (std::int32_t y = index(std::min(a.y, b.y) - reach - origin.y, first.y, last.y);
         y <= y_last; ++y) {
      // Each row looks only at the part of the side beside it.
      const double middle = centre_of({0, y}).y;
      const double one = place_at(a, b, middle - reach);
      const double other = place_at(a, b, middle + reach);
      const std::int32_t x_last = index(std::max(one, other) + reach - origin.x, first.x, last.x);
      for (std::int32_t x = index(std::min(one, other) - reach - origin.x, first.x, last.x);
           x <= x_last; ++x) {
        visit(RasterCell{x, y}, squared_distance(centre_of({x, y}), a, b));
        ++calls;
      }
    }
    return calls;
  }
};

}  // namespace vandplan::search

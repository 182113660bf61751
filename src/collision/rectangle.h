// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is a rectangular footprint from a side of a polygon, in the vehicle's frame?

#include <algorithm>
#include <cmath>

#include "vandplan/geometry.h"

namespace vandplan::collision {

/// Rectangle from `back` behind to `front` ahead of the rear axle along x, and `half_width` to each
/// side [m].
struct Rectangle {
  double back, front, half_width;

  /// Rectangle with a frame of width `by` around it [m].
  [[nodiscard]] Rectangle grown(double by) const noexcept {
    return {back + by, front + by, half_width + by};
  }

  /// Whether the side from a to b touches the rectangle. Two convex sets are disjoint exactly if
  /// the normal of a side of one of them separates them.
  [[nodiscard]] bool meets(const Point& a, const Point& b) const noexcept {
    const double middle = (front - back) / 2;
    const double half_length = (front + back) / 2;
    const double ax = a.x - middle;
    const double bx = b.x - middle;
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    return (std::min(ax, bx) <= half_length) & (std::max(ax, bx) >= -half_length) &
           (std::min(a.y, b.y) <= half_width) & (std::max(a.y, b.y) >= -half_width) &
           (std::abs(ax * dy - a.y * dx) <= half_length * std::abs(dy) + half_width * std::abs(dx));
  }
};

/// Squared distance between a rectangle and the side from a to b [m^2]; 0 if they touch. Two
/// disjoint convex sets are nearest at a corner of one of them.
[[nodiscard]] inline double squared_distance(const Rectangle& body, const Point& a,
                                             const Point& b) noexcept {
  if (body.meets(a, b)) return 0.0;
  const auto from_point = [&](const Point& p) {
    const double dx = std::max({-body.back - p.x, p.x - body.front, 0.0});
    const double dy = std::max(std::abs(p.y) - body.half_width, 0.0);
    return dx * dx + dy * dy;
  };
  double least = std::min(from_point(a), from_point(b));
  const Point d{b.x - a.x, b.y - a.y};
  const double squared = d.x * d.x + d.y * d.y;
  for (const double x : {-body.back, body.front}) {
    for (const double y : {-body.half_width, body.half_width}) {
      const double along = (x - a.x) * d.x + (y - a.y) * d.y;
      if (along <= 0 || along >= squared) continue;  // The nearest point is an end of the side.
      const double aside = (x - a.x) * d.y - (y - a.y) * d.x;
      least = std::min(least, aside * aside / squared);
    }
  }
  return least;
}

}  // namespace vandplan::collision

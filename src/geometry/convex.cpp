// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/convex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vandplan::geometry {
namespace {

/// Twice the area of the triangle a, b, c; positive if the way from a over b to c turns left.
double cross(const Point& a, const Point& b, const Point& c) noexcept {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

Polygon counter_clockwise(Polygon polygon) {
  double area = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    area += cross(polygon[0], polygon[i - 1], polygon[i]);
  }
  if (area < 0.0) std::ranges::reverse(polygon);
  return polygon;
}

double squared_distance_to_side(const Point& point, const Point& a, const Point& b) noexcept {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double along = (point.x - a.x) * dx + (point.y - a.y) * dy;
  const double part = squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
  const double x = point.x - a.x - part * dx;
  const double y = point.y - a.y - part * dy;
  return x * x + y * y;
}

double signed_distance(std::span<const Point> convex, const Point& point) noexcept {
  double least = std::numeric_limits<double>::infinity();
  bool is_inside = true;
  Point a = convex.back();
  for (const Point& b : convex) {
    least = std::min(least, squared_distance_to_side(point, a, b));
    is_inside = is_inside && cross(a, b, point) >= 0.0;
    a = b;
  }
  return is_inside ? -std::sqrt(least) : std::sqrt(least);
}

// Two convex sets are apart exactly if the normal of a side of one of them tells them apart, and
// then one is nearest at a corner of the other.
double squared_distance(std::span<const Point> convex, const Point& a, const Point& b) noexcept {
  bool is_apart = false;
  bool left = true;   // all corners are left of the line through a and b
  bool right = true;  // all corners are right of the line through a and b
  double least = std::numeric_limits<double>::infinity();
  Point from = convex.back();
  for (const Point& to : convex) {
    is_apart = is_apart || (cross(from, to, a) < 0.0 && cross(from, to, b) < 0.0);
    const double side = cross(a, b, to);
    left = left && side > 0.0;
    right = right && side < 0.0;
    least = std::min({least, squared_distance_to_side(a, from, to),
                      squared_distance_to_side(b, from, to), squared_distance_to_side(to, a, b)});
    from = to;
  }
  return is_apart || left || right ? least : 0.0;
}

}  // namespace vandplan::geometry

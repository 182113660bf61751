// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does a path hit something? The most naive answer: points of the outline, at every millimetre.
//
// Right because it only asks whether points lie in polygons, and skips nothing. Blind to a part
// of an obstacle that is thinner than `outline_step` and crosses the whole footprint.

#include <algorithm>
#include <cmath>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan {

inline constexpr double outline_step = 0.1;  // [m]

/// By the number of sides that a ray crosses.
inline bool naive_contains(const Polygon& polygon, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/// The outline of the footprint grown by `margin` [m] on each side, in the vehicle frame.
inline std::vector<Point> naive_outline(const Footprint& body, double margin) {
  const double front = body.front + margin;
  const double rear = -body.rear - margin;
  const double side = body.half_width + margin;
  std::vector<Point> points;
  for (double x = rear; x < front; x += outline_step) {
    points.push_back({x, -side});
    points.push_back({x, side});
  }
  for (double y = -side; y < side; y += outline_step) {
    points.push_back({rear, y});
    points.push_back({front, y});
  }
  points.push_back({front, side});
  return points;
}

/// Whether the footprint grown by `margin` hits one of the obstacles at one of the poses.
inline bool naive_hit(const Footprint& body, double margin, const std::vector<PathPoint>& points,
                      const std::vector<Polygon>& obstacles) {
  const std::vector<Point> outline = naive_outline(body, margin);
  const auto in_body = [&](const Point& p) {
    return p.x >= -body.rear - margin && p.x <= body.front + margin &&
           std::abs(p.y) <= body.half_width + margin;
  };
  for (const PathPoint& point : points) {
    for (Polygon polygon : obstacles) {
      for (Point& p : polygon) {
        const Pose seen = relative(point.pose, {p.x, p.y, 0});
        p = {seen.x, seen.y};
      }
      const auto in_polygon = [&](const Point& p) { return naive_contains(polygon, p); };
      if (std::any_of(polygon.begin(), polygon.end(), in_body)) return true;
      if (std::any_of(outline.begin(), outline.end(), in_polygon)) return true;
    }
  }
  return false;
}

}  // namespace vandplan

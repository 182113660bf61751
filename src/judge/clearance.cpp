// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vandplan::judge {
namespace {

double distance_to_side(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double part = squared > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared : 0.0;
  const double nearest = std::clamp(part, 0.0, 1.0);
  return std::hypot(p.x - (a.x + nearest * dx), p.y - (a.y + nearest * dy));
}

}  // namespace

double distance_to_rectangle(const Point& p, const Rectangle& body) {
  const double dx = std::max({body.x_min - p.x, 0.0, p.x - body.x_max});
  const double dy = std::max({body.y_min - p.y, 0.0, p.y - body.y_max});
  return std::hypot(dx, dy);
}

double distance_of_side(const Point& a, const Point& b, const Rectangle& body) {
  const std::array<Point, 4> corners = {Point{body.x_min, body.y_min},
                                        {body.x_max, body.y_min},
                                        {body.x_max, body.y_max},
                                        {body.x_min, body.y_max}};
  // Two convex sets are apart exactly if one of the directions of their sides tells them apart.
  bool apart = std::max(a.x, b.x) < body.x_min || std::min(a.x, b.x) > body.x_max ||
               std::max(a.y, b.y) < body.y_min || std::min(a.y, b.y) > body.y_max;
  int left = 0;
  int right = 0;
  for (const Point& corner : corners) {
    const double cross = (b.x - a.x) * (corner.y - a.y) - (b.y - a.y) * (corner.x - a.x);
    left += cross > 0;
    right += cross < 0;
  }
  apart = apart || left == 4 || right == 4;
  if (!apart) return 0.0;
  double distance = std::min(distance_to_rectangle(a, body), distance_to_rectangle(b, body));
  for (const Point& corner : corners) distance = std::min(distance, distance_to_side(corner, a, b));
  return distance;
}

double clearance(const Position& position, const Rectangle& body, const Polygon& polygon) {
  const auto cos = static_cast<double>(std::cos(position.heading));
  const auto sin = static_cast<double>(std::sin(position.heading));
  const auto seen_from_vehicle = [&](const Point& corner) {
    const auto dx = static_cast<double>(corner.x - position.x);
    const auto dy = static_cast<double>(corner.y - position.y);
    return Point{dx * cos + dy * sin, dy * cos - dx * sin};
  };
  double distance = std::numeric_limits<double>::infinity();
  // The body holds its rear axle, the origin. If no side touches the body, the body is inside the
  // polygon exactly if a ray from the origin crosses an odd number of sides.
  bool inside = false;
  Point a = seen_from_vehicle(polygon.back());
  for (const Point& corner : polygon) {
    const Point b = seen_from_vehicle(corner);
    distance = std::min(distance, distance_of_side(a, b, body));
    if ((a.y > 0) != (b.y > 0) && a.x - a.y * (b.x - a.x) / (b.y - a.y) > 0) inside = !inside;
    a = b;
  }
  return inside ? 0.0 : distance;
}

}  // namespace vandplan::judge

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/site_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vandplan::io {
namespace {

/// The line without corners that repeat the corner before.
std::vector<Point> without_repeats(std::span<const Point> line) {
  std::vector<Point> corners;
  for (const Point& point : line) {
    if (corners.empty() || !(corners.back() == point)) corners.push_back(point);
  }
  return corners;
}

}  // namespace

std::vector<Polygon> walls_along(std::span<const Point> line, double width) {
  const std::vector<Point> corners = without_repeats(line);
  if (corners.size() < 2) return {};
  const bool is_closed = corners.front() == corners.back();
  std::vector<Polygon> walls;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Point& from = corners[i];
    const Point& to = corners[i + 1];
    const double x = to.x - from.x;
    const double y = to.y - from.y;
    const double factor = width / 2 / std::sqrt(x * x + y * y);
    const Point along = {x * factor, y * factor};  // Half the width long.
    const double before = is_closed || i > 0 ? 1.0 : 0.0;
    const double behind = is_closed || i + 2 < corners.size() ? 1.0 : 0.0;
    const Point a = {from.x - before * along.x, from.y - before * along.y};
    const Point b = {to.x + behind * along.x, to.y + behind * along.y};
    walls.push_back({{a.x + along.y, a.y - along.x},
                     {b.x + along.y, b.y - along.x},
                     {b.x - along.y, b.y + along.x},
                     {a.x - along.y, a.y + along.x}});
  }
  return walls;
}

Polygon square_around(const Point& center, double side) {
  const double half = side / 2;
  return {{center.x - half, center.y - half},
          {center.x + half, center.y - half},
          {center.x + half, center.y + half},
          {center.x - half, center.y + half}};
}

Polygon circle_shape(const Point& center, double radius, bool around) {
  constexpr int count = 32;
  const double reach = around ? radius / std::cos(std::numbers::pi / count) : radius;
  Polygon corners;
  corners.reserve(count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    corners.push_back({center.x + reach * std::cos(angle), center.y + reach * std::sin(angle)});
  }
  return corners;
}

bool is_box(const Polygon& ring) {
  const Bounds box = bounding_box(ring);
  const double slack = 0.01 * std::max(box.x_max - box.x_min, box.y_max - box.y_min);
  const auto is_at_corner = [&](const Point& p) {
    return std::min(p.x - box.x_min, box.x_max - p.x) <= slack &&
           std::min(p.y - box.y_min, box.y_max - p.y) <= slack;
  };
  return ring.size() >= 4 && std::ranges::all_of(ring, is_at_corner);
}

}  // namespace vandplan::io

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/obstacles.h"

#include <algorithm>

namespace vandplan::collision {
namespace {

/// Consecutive sides of a polygon.
struct Group {
  Sides sides;
  double left;  // Least x of the whole polygon.
};

double twice_area(const Polygon& polygon) {
  double area = 0.0;
  const Point& o = polygon[0];  // Near the corners, to reduce cancellation.
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[i + 1];
    area += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  return area;
}

Bounds box_of(const Sides& sides) {
  const auto [x_min, x_max] = std::minmax_element(sides.x.begin(), sides.x.end());
  const auto [y_min, y_max] = std::minmax_element(sides.y.begin(), sides.y.end());
  return {*x_min, *x_max, *y_min, *y_max};
}

/// Appends all sides of a polygon, counter-clockwise.
void append_groups(Polygon polygon, std::vector<Group>& groups) {
  if (twice_area(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
  const std::size_t count = polygon.size();
  double left = polygon[0].x;
  for (const Point& corner : polygon) left = std::min(left, corner.x);
  for (std::size_t first = 0; first < count; first += 4) {
    Group group{.sides = {}, .left = left};
    for (std::size_t i = 0; i < 5; ++i) {
      const Point& corner = polygon[std::min(first + i, count) % count];
      group.sides.x[i] = corner.x;
      group.sides.y[i] = corner.y;
    }
    groups.push_back(group);
  }
}

/// Winding number of the sides around a point, counted at their crossings of its ray along x.
int winding(const Sides& sides, const Point& p) {
  int sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool a_below = sides.y[i] <= p.y;
    const bool b_below = sides.y[i + 1] <= p.y;
    if (a_below == b_below) continue;
    const double dx = sides.x[i + 1] - sides.x[i];
    const double dy = sides.y[i + 1] - sides.y[i];
    const bool p_is_left = dx * (p.y - sides.y[i]) - dy * (p.x - sides.x[i]) > 0;
    if (p_is_left == a_below) sum += a_below ? 1 : -1;
  }
  return sum;
}

}  // namespace

Obstacles::Obstacles(std::span<const Polygon> polygons) {
  std::vector<Group> groups;
  for (const Polygon& polygon : polygons) append_groups(polygon, groups);
  std::vector<Bounds> boxes;
  boxes.reserve(groups.size());
  for (const Group& group : groups) boxes.push_back(box_of(group.sides));
  std::vector<Bounds> near;
  std::vector<Bounds> right_of;
  for (const std::uint32_t i : geometry::spatial_order(boxes)) {
    sides_.push_back(groups[i].sides);
    near.push_back(boxes[i]);
    right_of.push_back(boxes[i]);
    // A polygon contains no point left of it. So right of its least x all of its groups are
    // counted.
    right_of.back().x_min = groups[i].left;
  }
  near_ = geometry::BoxTree(near);
  right_of_ = geometry::BoxTree(right_of);
}

bool Obstacles::contain(const Point& point) const noexcept {
  // All polygons are counter-clockwise, so the sum is the number of polygons that contain the
  // point.
  int sum = 0;
  (void)right_of_.any({point.x, point.x, point.y, point.y}, [&](std::uint32_t i) {
    sum += winding(sides_[i], point);
    return false;
  });
  return sum != 0;
}

}  // namespace vandplan::collision

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/trigonometry.h"

namespace vandplan {

double wrap_angle(double angle) noexcept {
  constexpr double pi = std::numbers::pi;
  if (angle >= -pi && angle < pi) return angle;
  const double wrapped = angle - 2 * pi * std::floor((angle + pi) / (2 * pi));
  return wrapped < pi && wrapped >= -pi ? wrapped : -pi;  // rounding can land on +pi
}

Pose compose(const Pose& frame, const Pose& local) noexcept {
  const auto [sin, cos] = base::sin_cos(frame.heading);
  return {frame.x + local.x * cos - local.y * sin, frame.y + local.x * sin + local.y * cos,
          wrap_angle(frame.heading + local.heading)};
}

Pose relative(const Pose& frame, const Pose& pose) noexcept {
  const auto [sin, cos] = base::sin_cos(frame.heading);
  const double dx = pose.x - frame.x;
  const double dy = pose.y - frame.y;
  return {dx * cos + dy * sin, dy * cos - dx * sin, wrap_angle(pose.heading - frame.heading)};
}

bool contains(const Bounds& bounds, const Point& point) noexcept {
  return point.x >= bounds.x_min && point.x <= bounds.x_max && point.y >= bounds.y_min &&
         point.y <= bounds.y_max;
}

Bounds bounding_box(std::span<const Point> points) noexcept {
  if (points.empty()) return {};
  Bounds box{points[0].x, points[0].x, points[0].y, points[0].y};
  for (const Point& p : points) {
    box.x_min = std::min(box.x_min, p.x);
    box.x_max = std::max(box.x_max, p.x);
    box.y_min = std::min(box.y_min, p.y);
    box.y_max = std::max(box.y_max, p.y);
  }
  return box;
}

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/vehicle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/require.h"
#include "base/trigonometry.h"
#include "geometry/convex.h"

namespace vandplan {
namespace {

/// The smallest footprint around an outline; it is as wide to the left as to the right.
Footprint footprint_around(const Polygon& outline) noexcept {
  const Bounds box = bounding_box(outline);
  return {.rear = -box.x_min,
          .front = box.x_max,
          .half_width = std::max(std::abs(box.y_min), std::abs(box.y_max))};
}

/// The outline, counter-clockwise, if it is not empty; otherwise the corners of the footprint.
Polygon outline_or_corners(const Polygon& outline, const Footprint& footprint) {
  if (!outline.empty()) return geometry::counter_clockwise(outline);
  const std::array<Point, 4> rectangle = corners(footprint, {});
  return {rectangle.begin(), rectangle.end()};
}

}  // namespace

bool same_lengths(const Vehicle& a, Vehicle b) {
  b.limits = a.limits;
  return a == b;
}

double steering_angle(const Vehicle& vehicle, double curvature) noexcept {
  return base::atan_2(vehicle.wheelbase * curvature, 1.0);
}

double turning_radius(double wheelbase, double steering_angle) {
  base::require(wheelbase > 0.0, "wheelbase", wheelbase, "more than 0 m");
  base::require(steering_angle > 0.0 && steering_angle < std::numbers::pi / 2, "max_steering_angle",
                steering_angle, "more than 0 and less than 1.5707 rad");
  const auto [sin, cos] = base::sin_cos(steering_angle);
  return wheelbase * cos / sin;
}

double max_curvature_rate(const Vehicle& vehicle) noexcept {
  constexpr double speed = 1.0;  // [m/s]
  return vehicle.limits.max_curvature_rate.value_or(vehicle.limits.max_steering_rate /
                                                    (vehicle.wheelbase * speed));
}

Footprint footprint(const Vehicle& vehicle) noexcept {
  if (!vehicle.outline.empty()) return footprint_around(vehicle.outline);
  return {.rear = vehicle.rear_overhang,
          .front = vehicle.wheelbase + vehicle.front_overhang,
          .half_width = vehicle.width / 2};
}

Footprint footprint(const Trailer& trailer) noexcept {
  if (!trailer.outline.empty()) return footprint_around(trailer.outline);
  return {.rear = trailer.rear_overhang,
          .front = trailer.wheelbase + trailer.front_overhang,
          .half_width = trailer.width / 2};
}

Polygon body_outline(const Vehicle& vehicle) {
  return outline_or_corners(vehicle.outline, footprint(vehicle));
}

Polygon body_outline(const Trailer& trailer) {
  return outline_or_corners(trailer.outline, footprint(trailer));
}

Footprint wheel_footprint(const Vehicle& vehicle) noexcept {
  const double track = vehicle.track_width.value_or(vehicle.width);
  return {.rear = 0.0, .front = vehicle.wheelbase, .half_width = track / 2};
}

double inner_radius(const Footprint& footprint) noexcept {
  return std::min({footprint.half_width, footprint.rear, footprint.front});
}

double inner_radius(const Vehicle& vehicle) {
  if (vehicle.outline.empty()) return inner_radius(footprint(vehicle));
  return std::max(0.0, -geometry::signed_distance(body_outline(vehicle), {}));
}

std::array<Point, 4> corners(const Footprint& footprint, const Pose& pose) noexcept {
  const base::SinCos heading = base::sin_cos(pose.heading);
  const auto at = [&](double forward, double left) {
    return Point{pose.x + forward * heading.cos - left * heading.sin,
                 pose.y + forward * heading.sin + left * heading.cos};
  };
  return {at(-footprint.rear, -footprint.half_width), at(footprint.front, -footprint.half_width),
          at(footprint.front, footprint.half_width), at(-footprint.rear, footprint.half_width)};
}

}  // namespace vandplan

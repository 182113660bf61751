// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/vehicle.h"

#include <algorithm>

#include "base/trigonometry.h"

namespace vandplan {

bool same_lengths(const Vehicle& a, const Vehicle& b) noexcept {
  Vehicle other = b;
  other.limits = a.limits;
  return a == other;
}

double steering_angle(const Vehicle& vehicle, double curvature) noexcept {
  return base::atan_2(vehicle.wheelbase * curvature, 1.0);
}

double max_curvature_rate(const Vehicle& vehicle) noexcept {
  constexpr double speed = 1.0;  // [m/s]
  return vehicle.limits.max_curvature_rate.value_or(vehicle.limits.max_steering_rate /
                                                    (vehicle.wheelbase * speed));
}

Footprint footprint(const Vehicle& vehicle) noexcept {
  return {.rear = vehicle.rear_overhang,
          .front = vehicle.wheelbase + vehicle.front_overhang,
          .half_width = vehicle.width / 2};
}

Footprint wheel_footprint(const Vehicle& vehicle) noexcept {
  const double track = vehicle.track_width.value_or(vehicle.width);
  return {.rear = 0.0, .front = vehicle.wheelbase, .half_width = track / 2};
}

double inner_radius(const Footprint& footprint) noexcept {
  return std::min({footprint.half_width, footprint.rear, footprint.front});
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

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/robot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vandplan/input_error.h"
#include "vandplan/problem.h"

namespace vandplan::ros {
namespace {

/// Length of a vehicle, rounded to remove the noise of a subtraction [m].
double length_of(double metres) { return std::round(metres * 1e9) / 1e9; }

/// The regular polygon of 16 sides around a circle about the origin.
Polygon around_circle(double radius) {
  if (!(radius > 0.0 && std::isfinite(radius))) {
    throw InputError("footprint", "has a radius of " + std::to_string(radius) + ", expected > 0 m");
  }
  constexpr int sides = 16;
  const double corner = radius / std::cos(std::numbers::pi / sides);
  Polygon polygon;
  for (int i = 0; i < sides; ++i) {
    const double angle = (2 * i + 1) * std::numbers::pi / sides;
    polygon.push_back({corner * std::cos(angle), corner * std::sin(angle)});
  }
  return polygon;
}

/// The hull of points, counter-clockwise, without corners on its sides.
Polygon hull_of(Polygon points) {
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  Polygon hull;
  const auto add = [&hull](const Point& p, std::size_t least) {
    const auto turns_left = [&] {
      const Point& a = hull[hull.size() - 2];
      const Point& b = hull.back();
      return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0.0;
    };
    while (hull.size() > least && !turns_left()) hull.pop_back();
    hull.push_back(p);
  };
  for (const Point& p : points) add(p, 1);  // below, from left to right
  const std::size_t below = hull.size();
  for (auto p = points.rbegin() + 1; p < points.rend(); ++p) add(*p, below);
  hull.pop_back();  // the first corner again
  return hull;
}

/// The body of a robot as a convex polygon in the frame base_link.
Polygon body_of(const Robot& robot) {
  if (robot.radius) return around_circle(*robot.radius);
  const Polygon& corners = robot.footprint;
  for (const auto& [x, y] : corners) {
    if (!std::isfinite(x) || !std::isfinite(y)) {
      throw InputError("footprint", "has a corner that is not finite, expected metres");
    }
  }
  if (corners.size() < 3) {
    throw InputError("footprint", "has " + std::to_string(corners.size()) +
                                      " corners, expected at least 3, or a radius");
  }
  return is_convex(corners) ? corners : hull_of(corners);
}

/// Whether a polygon is the rectangle of a box, which is as wide to the left as to the right.
bool is_even_rectangle(const Polygon& body, const Bounds& box) {
  return body.size() == 4 && -box.y_min == box.y_max &&
         std::all_of(body.begin(), body.end(), [&](const Point& p) {
           return (p.x == box.x_min || p.x == box.x_max) && (p.y == box.y_min || p.y == box.y_max);
         });
}

}  // namespace

Vehicle vehicle_of(const Robot& robot, const Chassis& chassis) {
  const Polygon body = body_of(robot);
  const Bounds box = bounding_box(body);
  const double front = box.x_max - chassis.rear_axle;
  const double wheelbase = chassis.wheelbase.value_or(front);
  if (!(wheelbase > 0.0)) {
    throw InputError("wheelbase", "is " + std::to_string(wheelbase) +
                                      " m, expected > 0: set it, or rear_axle behind the front");
  }
  Vehicle vehicle{.wheelbase = length_of(wheelbase),
                  .front_overhang = length_of(front - wheelbase),
                  .rear_overhang = length_of(chassis.rear_axle - box.x_min),
                  .width = length_of(2 * std::max(-box.y_min, box.y_max)),
                  .min_turning_radius = chassis.min_turning_radius,
                  .limits = chassis.limits};
  if (vehicle.rear_overhang < 0.0) {
    throw InputError("footprint", "is ahead of the rear axle, expected it to hold the axle");
  }
  if (vehicle.front_overhang < 0.0 || !is_even_rectangle(body, box)) {
    for (const auto& [x, y] : body) {
      vehicle.outline.push_back({length_of(x - chassis.rear_axle), y});
    }
  }
  try {
    check_vehicle(vehicle);
  } catch (const InputError& error) {
    if (error.where() != "vehicle.outline") throw;
    throw InputError("footprint", error.problem());
  }
  return vehicle;
}

}  // namespace vandplan::ros

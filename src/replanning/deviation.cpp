// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/deviation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vandplan::replanning {
namespace {

constexpr double off_place = 0.5;                    // largest distance from the drive [m]
constexpr double off_speed = 0.5;                    // largest error of speed [m/s]
constexpr double off_angle = std::numbers::pi / 18;  // largest error of an angle [rad]
constexpr double rounding = 1e-9;                    // rounding error of a hitch angle [rad]

}  // namespace

double planned_hitch_angle(const Vehicle& vehicle, double hitch_angle) {
  if (!vehicle.trailer) return 0.0;
  const double most = vehicle.max_hitch_angle;
  return std::abs(hitch_angle) <= most + off_angle ? std::clamp(hitch_angle, -most, most)
                                                   : hitch_angle;
}

bool is_folded_up(const Vehicle& vehicle, double hitch_angle) {
  return vehicle.trailer && std::abs(hitch_angle) > vehicle.max_hitch_angle + rounding;
}

RigMotion measured_motion(const Vehicle& vehicle, const VehicleState& state,
                          const RigMotion& planned, const Point& origin) {
  const Pose pose{state.pose.x - origin.x, state.pose.y - origin.y, state.pose.heading};
  return {{.pose = pose, .curvature = state.curvature, .gear = gear_of(state.v), .v = state.v},
          planned_hitch_angle(vehicle, state.hitch_angle.value_or(planned.hitch_angle))};
}

bool is_off(const RigMotion& measured, const RigMotion& planned) {
  const Pose off = relative(planned.pose, measured.pose);
  return std::hypot(off.x, off.y) > off_place || std::abs(off.heading) > off_angle ||
         std::abs(measured.v - planned.v) > off_speed ||
         std::abs(measured.hitch_angle - planned.hitch_angle) > off_angle;
}

}  // namespace vandplan::replanning

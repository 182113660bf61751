// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/towed.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/trigonometry.h"
#include "vandplan/rig.h"

namespace vandplan::rig {
namespace {

using search::Connector, search::CostRule;

/// Of the hitch, per metre of the rear axle, at most.
double swing(const Vehicle& vehicle) {
  return std::abs(vehicle.hitch) / vehicle.min_turning_radius;
}

/// Between the way of the hitch and the trailer, at most [rad].
double most_angle(const Vehicle& vehicle) {
  return vehicle.max_hitch_angle + base::atan_2(swing(vehicle), 1.0);
}

double least_cost_alone(const Task& task, const CostRule& rule) {
  return Connector(task, rule).least_cost(task.start, task.goal, {rule.initial_gear, {}});
}

}  // namespace

Task towed_task(const Task& task) {
  const Trailer& trailer = *task.vehicle.trailer;
  constexpr double nearly_right = std::numbers::pi / 2 - 1e-3;
  const auto [sin, cos] = base::sin_cos(std::min(most_angle(task.vehicle), nearly_right));
  Task towed = task;
  towed.vehicle = Vehicle{trailer.wheelbase, trailer.front_overhang, trailer.rear_overhang,
                          trailer.width, trailer.wheelbase * cos / sin};
  towed.vehicle.outline = trailer.outline;
  towed.start = trailer_pose(task.vehicle, {task.start, task.hitch_angles.start});
  towed.goal = trailer_pose(task.vehicle, {task.goal, task.hitch_angles.goal});
  towed.steering = Steering::reeds_shepp;
  towed.curvatures = {};
  towed.hitch_angles = {};
  return towed;
}

double least_cost(const Task& task, const CostRule& rule) {
  const double of_tractor = least_cost_alone(task, rule);
  if (most_angle(task.vehicle) >= std::numbers::pi / 2) return of_tractor;
  CostRule of_metres = rule;  // the curvature that has a price is the tractor's
  of_metres.curvature_change_cost = 0.0;
  const double of_trailer = least_cost_alone(towed_task(task), of_metres);
  return std::max(of_tractor, of_trailer / std::hypot(1.0, swing(task.vehicle)));
}

}  // namespace vandplan::rig

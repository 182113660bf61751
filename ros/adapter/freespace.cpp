// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/freespace.h"

#include <algorithm>
#include <numbers>

#include "vandplan/problem.h"

namespace vandplan::ros {

Vehicle vehicle_of(const FreespaceVehicle& shape, double max_turning_ratio,
                   const DrivingLimits& limits) {
  Vehicle vehicle{
      .wheelbase = shape.base_length,
      .front_overhang = std::max(0.0, shape.length - shape.base2back - shape.base_length),
      .rear_overhang = shape.base2back,
      .width = shape.width,
      .min_turning_radius =
          turning_radius(shape.base_length, shape.max_steering * max_turning_ratio),
      .limits = limits};
  check_vehicle(vehicle);
  return vehicle;
}

Request request_of(const FreespaceParameters& parameters, const FreespaceVehicle& shape,
                   const Parameters::Values& own) {
  const double longest = parameters.time_limit / 1000.0;
  const double usual = std::min(longest, default_time_limit);
  Parameters::Values given = {
      {"allow_unknown", false},
      {"lethal_cost", std::int64_t{parameters.obstacle_threshold}},
      {"time_limit", usual},
      {"reverse_weight", 1.0 + std::max(parameters.reverse_weight, 0.0)},
      {"gear_change_cost", std::max(parameters.direction_change_weight, 0.0)}};
  const auto cost = own.find("cost");
  if (cost != own.end() && cost->second == OptionValue(std::string("time"))) {
    given.erase("reverse_weight");  // where the cost is the time, no price counts
    given.erase("gear_change_cost");
  }
  for (const auto& [name, value] : own) given.insert_or_assign(name, value);
  Parameters values;
  values.set(given);
  return {.heading = values.goal_heading(),
          .slack = {.ahead = parameters.longitudinal_goal_range / 2,
                    .aside = parameters.lateral_goal_range / 2,
                    .heading = parameters.angle_goal_range / 2 * std::numbers::pi / 180},
          .vehicle = vehicle_of(shape, parameters.max_turning_ratio, values.chassis().limits),
          .cost_rule = values.cost_rule(),
          .options = values.options(),
          .patience = own.count("time_limit") == 0 ? longest - usual : 0.0};
}

std::vector<Waypoint> waypoints_of(std::span<const PathPose> poses) {
  std::vector<Waypoint> waypoints;
  bool is_back = !poses.empty() && poses.front().gear == Gear::reverse;
  for (const PathPose& at : poses) {
    waypoints.push_back({at.pose, is_back});
    is_back = at.gear == Gear::reverse;
    if (at.is_cusp) waypoints.push_back({at.pose, is_back});
  }
  return waypoints;
}

}  // namespace vandplan::ros

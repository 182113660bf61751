// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a vehicle of Autoware get a path over its costmap?
//
// base_link is the midpoint of the rear axle, as our poses have it.

#include <vector>

#include "ros/adapter/planner.h"

namespace vandplan::ros {

/// What of Autoware's `PlannerCommonParam` means something here, with its names and units.
struct FreespaceParameters {
  double time_limit = 30000.0;           ///< longest time to wait for a path [ms]
  double reverse_weight = 0.7;           ///< what a metre in reverse costs more [m]; at least 0
  double direction_change_weight = 1.5;  ///< cost of a gear change [m]; at least 0
  double lateral_goal_range = 0.0;       ///< whole width of the goal's box [m]
  double longitudinal_goal_range = 0.0;  ///< whole length of the goal's box [m]
  double angle_goal_range = 0.0;         ///< whole range of the goal's heading [degrees]
  double max_turning_ratio = 1.0;        ///< share of the steering angle that may be used; (0, 1]
  int obstacle_threshold = 100;          ///< least cost of an obstacle; 1 to 100
};

/// Autoware's `VehicleShape`, with its names.
struct FreespaceVehicle {
  double length = 0.0;        ///< [m]
  double width = 0.0;         ///< [m]
  double base_length = 0.0;   ///< rear axle to front axle [m]
  double max_steering = 0.0;  ///< largest angle of the front wheels [rad]
  double base2back = 0.0;     ///< rear axle to the rear [m]
};

/// The vehicle that Autoware's `VehicleInfo` describes, or its `VehicleShape`.
template <typename From>
FreespaceVehicle freespace_vehicle(const From& from) {
  if constexpr (requires { from.vehicle_length_m; }) {
    return {.length = from.vehicle_length_m,
            .width = from.vehicle_width_m,
            .base_length = from.wheel_base_m,
            .max_steering = from.max_steer_angle_rad,
            .base2back = from.rear_overhang_m};
  } else {
    return {.length = from.length,
            .width = from.width,
            .base_length = from.base_length,
            .max_steering = from.max_steering,
            .base2back = from.base2back};
  }
}

/// The vehicle of a shape. Throws InputError naming the number that is wrong, in our words.
[[nodiscard]] Vehicle vehicle_of(const FreespaceVehicle& shape, double max_turning_ratio,
                                 const DrivingLimits& limits = {});

/// A wish for a path with Autoware's parameters; values that `own` sets beyond its defaults take
/// precedence. A search of Autoware ends with its first path, long before its time limit: here a
/// path is improved until `default_time_limit`, or as long as `own` says. Throws InputError as
/// `vehicle_of` and `Parameters::set`.
[[nodiscard]] Request request_of(const FreespaceParameters& parameters,
                                 const FreespaceVehicle& shape, const Parameters::Values& own = {});

/// A pose with the gear in which it is reached.
struct Waypoint {
  Pose pose = {};
  bool is_back = false;  ///< whether it is reached in reverse
};

/// Waypoints of a path. Where the gear changes, two of them have one pose, first with the gear
/// before. The first waypoint has the gear of the second.
[[nodiscard]] std::vector<Waypoint> waypoints_of(std::span<const PathPose> poses);

}  // namespace vandplan::ros

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for messages of Autoware: the names that our plugins use.

#include <cstdint>
#include <geometry_msgs/msg/pose.hpp>
#include <std_msgs/msg/header.hpp>
#include <vector>

namespace builtin_interfaces::msg {
struct Duration {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
};
}  // namespace builtin_interfaces::msg

namespace autoware_planning_msgs::msg {
struct TrajectoryPoint {
  builtin_interfaces::msg::Duration time_from_start;
  geometry_msgs::msg::Pose pose;
  float longitudinal_velocity_mps = 0.0F;
  float lateral_velocity_mps = 0.0F;
  float acceleration_mps2 = 0.0F;
  float heading_rate_rps = 0.0F;
  float front_wheel_angle_rad = 0.0F;
  float rear_wheel_angle_rad = 0.0F;
};
struct Trajectory {
  std_msgs::msg::Header header;
  std::vector<TrajectoryPoint> points;
};
}  // namespace autoware_planning_msgs::msg

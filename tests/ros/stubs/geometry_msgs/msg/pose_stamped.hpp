// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for a message of ROS 2: the names that our plugins use.

#include <geometry_msgs/msg/pose.hpp>
#include <std_msgs/msg/header.hpp>

namespace geometry_msgs::msg {
struct PoseStamped {
  std_msgs::msg::Header header;
  Pose pose;
};
}  // namespace geometry_msgs::msg

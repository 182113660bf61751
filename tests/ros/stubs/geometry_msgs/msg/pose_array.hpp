// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for a message of ROS 2: the names that our plugins use.

#include <geometry_msgs/msg/pose.hpp>
#include <std_msgs/msg/header.hpp>
#include <vector>

namespace geometry_msgs::msg {
struct PoseArray {
  std_msgs::msg::Header header;
  std::vector<Pose> poses;
};
}  // namespace geometry_msgs::msg

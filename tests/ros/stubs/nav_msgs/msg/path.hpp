// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for a message of ROS 2: the names that our plugins use.

#include <geometry_msgs/msg/pose_stamped.hpp>
#include <vector>

namespace nav_msgs::msg {
struct Path {
  std_msgs::msg::Header header;
  std::vector<geometry_msgs::msg::PoseStamped> poses;
};
}  // namespace nav_msgs::msg

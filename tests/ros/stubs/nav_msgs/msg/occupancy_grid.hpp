// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for a message of ROS 2: the names that our plugins use.

#include <cstdint>
#include <geometry_msgs/msg/pose.hpp>
#include <std_msgs/msg/header.hpp>
#include <vector>

namespace nav_msgs::msg {
struct MapMetaData {
  float resolution = 0.0F;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  geometry_msgs::msg::Pose origin;
};
struct OccupancyGrid {
  std_msgs::msg::Header header;
  MapMetaData info;
  std::vector<std::int8_t> data;
};
}  // namespace nav_msgs::msg

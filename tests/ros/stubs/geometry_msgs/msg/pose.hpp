// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for messages of ROS 2: the names that our plugins use.

namespace geometry_msgs::msg {
struct Point {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};
struct Quaternion {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;
};
struct Pose {
  Point position;
  Quaternion orientation;
};
}  // namespace geometry_msgs::msg

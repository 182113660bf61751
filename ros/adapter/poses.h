// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which poses does a path consist of, as ROS writes them?

#include <vector>

#include "vandplan/motion.h"
#include "vandplan/path.h"

namespace vandplan::ros {

/// A rotation about the vertical axis, as messages hold it.
struct Quaternion {
  double z = 0.0;  ///< sine of half the heading
  double w = 1.0;  ///< cosine of half the heading
};

[[nodiscard]] Quaternion quaternion_of(double heading) noexcept;

/// Heading of a rotation in space, its yaw [rad]: what roll and pitch it has is left out.
[[nodiscard]] double heading_of(double x, double y, double z, double w) noexcept;

/// A pose of a path. The heading is where the front of the robot points, in reverse too.
struct PathPose {
  Pose pose = {};             ///< pose of base_link, in the frame in which one plans
  Gear gear = Gear::forward;  ///< gear in which the path goes on; at its end the last one
  double curvature = 0.0;     ///< curvature of the midpoint of the rear axle there [1/m]
  /// Whether the robot changes its gear there. Nav2's controllers find such a pose by themselves:
  /// the way to it and the way on point in opposite directions.
  bool is_cusp = false;
};

/// Poses of a path, for a rear axle at x = `rear_axle` in the frame base_link [m]. They are at most
/// `step` apart [m] and hold start, goal, every change of gear and curvature. Two of them are at
/// least 0.2 mm apart, unless a whole stroke is shorter.
[[nodiscard]] std::vector<PathPose> poses_of(const Path& path, double step, double rear_axle);

/// A point of a trajectory, with the fields of autoware_planning_msgs/TrajectoryPoint.
struct TrajectoryPoint {
  double time_from_start = 0.0;            ///< time since the start [s]
  Pose pose = {};                          ///< pose of base_link, the midpoint of the rear axle
  double longitudinal_velocity_mps = 0.0;  ///< speed [m/s]; negative in reverse
  double acceleration_mps2 = 0.0;          ///< change of the speed [m/s^2]
  double heading_rate_rps = 0.0;           ///< change of the heading [rad/s]
  double front_wheel_angle_rad = 0.0;      ///< angle of the front wheel [rad]; positive to the left
};

/// The fastest drive along a path within the limits of the vehicle, which begins with wheels turned
/// to `start_curvature` [1/m]. Its points are at most `period` apart [s]. Throws InputError as
/// `speed_profile`, or naming "step" for the period.
[[nodiscard]] std::vector<TrajectoryPoint> trajectory_of(const Path& path, const Vehicle& vehicle,
                                                         double start_curvature, double period);

}  // namespace vandplan::ros

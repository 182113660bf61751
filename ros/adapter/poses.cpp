// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/poses.h"

#include <algorithm>
#include <cmath>

namespace vandplan::ros {
namespace {

// Nav2 takes two poses within 1e-4 m for a turn on the spot.
constexpr double least_distance = 2e-4;

}  // namespace

Quaternion quaternion_of(double heading) noexcept {
  return {std::sin(heading / 2), std::cos(heading / 2)};
}

double heading_of(double x, double y, double z, double w) noexcept {
  return std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

std::vector<PathPose> poses_of(const Path& path, double step, double rear_axle) {
  // The finest step that `sampled` takes is a 10^7th of the length.
  const std::vector<PathPoint> points = sampled(path, std::max(step, 1e-6 * length(path)));
  // A point says the gear of what is driven next. So the gear changes where it differs from that of
  // the point before.
  const auto is_end = [&](std::size_t i) { return i == 0 || i + 1 == points.size(); };
  const auto is_cusp = [&](std::size_t i) {
    return !is_end(i) && points[i].gear != points[i - 1].gear;
  };
  std::vector<PathPose> poses;
  poses.reserve(points.size());
  double last = 0.0;      // distance of the last pose that was taken
  std::size_t ahead = 0;  // next point that stays
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PathPoint& point = points[i];
    while (ahead + 1 < points.size() && (ahead <= i || !(is_end(ahead) || is_cusp(ahead)))) ++ahead;
    const bool is_crowded =
        point.s - last < least_distance || points[ahead].s - point.s < least_distance;
    if (is_crowded && !is_end(i) && !is_cusp(i)) continue;
    const Pose& axle = point.pose;
    poses.push_back({.pose = rear_axle == 0.0 ? axle : compose(axle, {-rear_axle, 0.0, 0.0}),
                     .gear = point.gear,
                     .curvature = point.curvature,
                     .is_cusp = is_cusp(i)});
    last = point.s;
  }
  return poses;
}

std::vector<TrajectoryPoint> trajectory_of(const Path& path, const Vehicle& vehicle,
                                           double start_curvature, double period) {
  const SpeedProfile speeds = speed_profile(path, vehicle, {.start_curvature = start_curvature});
  std::vector<TrajectoryPoint> points;
  for (const Motion& motion : sampled(path, vehicle, speeds, period)) {
    points.push_back({.time_from_start = motion.t,
                      .pose = motion.pose,
                      .longitudinal_velocity_mps = motion.v,
                      .acceleration_mps2 = motion.a,
                      .heading_rate_rps = motion.v * motion.curvature,
                      .front_wheel_angle_rad = motion.steering_angle});
  }
  return points;
}

}  // namespace vandplan::ros

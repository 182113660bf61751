// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/poses.h"

#include <algorithm>
#include <cmath>

namespace vandplan::ros {
namespace {

// Nav2 takes two poses within 1e-4 m for a turn on the spot.
constexpr double least_distance = 2e-4;

/// A point of one of several paths, with its distance since the start of the first one.
struct Place {
  PathPoint point;
  bool stays = false;  // whether it is start, goal or a change of gear
};

/// Points of all paths in turn; the end of one and the start of the next are one point.
std::vector<Place> places_of(std::span<const Path> paths, double step) {
  std::vector<Place> places;
  double driven = 0.0;
  for (const Path& path : paths) {
    // The finest step that `sampled` takes is a 10^7th of the length.
    const double whole = length(path);
    const std::vector<PathPoint> points = sampled(path, std::max(step, 1e-6 * whole));
    if (points.size() > 1 && !places.empty()) places.pop_back();
    for (PathPoint point : points) {
      point.s += driven;
      if (points.size() > 1 || places.empty()) places.push_back({point});
    }
    driven += whole;
  }
  return places;
}

}  // namespace

Quaternion quaternion_of(double heading) noexcept {
  return {std::sin(heading / 2), std::cos(heading / 2)};
}

double heading_of(double x, double y, double z, double w) noexcept {
  return std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

std::vector<PathPose> poses_of(std::span<const Path> paths, double step, double rear_axle) {
  std::vector<Place> places = places_of(paths, step);
  if (places.empty()) return {};
  std::vector<PathPose> poses;
  // A point says the gear of what is driven next. So the gear changes where it differs from that of
  // the point before.
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_cusp =
        i > 0 && i + 1 < places.size() && places[i].point.gear != places[i - 1].point.gear;
    places[i].stays = is_cusp || i == 0 || i + 1 == places.size();
  }
  double last = 0.0;      // distance of the last pose that was taken
  std::size_t ahead = 0;  // next place that stays
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [point, stays] = places[i];
    while (ahead + 1 < places.size() && (ahead <= i || !places[ahead].stays)) ++ahead;
    const bool is_crowded =
        point.s - last < least_distance || places[ahead].point.s - point.s < least_distance;
    if (!stays && is_crowded) continue;
    const Pose& axle = point.pose;
    poses.push_back({.pose = rear_axle == 0.0 ? axle : compose(axle, {-rear_axle, 0.0, 0.0}),
                     .gear = point.gear,
                     .curvature = point.curvature,
                     .is_cusp = stays && i > 0 && i + 1 < places.size()});
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

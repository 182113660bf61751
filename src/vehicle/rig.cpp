// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/vehicle.h"

#include <algorithm>
#include <cmath>

#include "base/require.h"
#include "base/trigonometry.h"
#include "path/finite.h"
#include "vandplan/input_error.h"
#include "vehicle/hitch_motion.h"

namespace vandplan {
namespace {

const Trailer& trailer_of(const Vehicle& vehicle) {
  if (!vehicle.trailer) throw InputError("vehicle.trailers", "are missing, expected one");
  return *vehicle.trailer;
}

vehicle::Coupling coupling_of(const Vehicle& vehicle) {
  return {.hitch = vehicle.hitch, .wheelbase = trailer_of(vehicle).wheelbase};
}

Pose moved_ahead(const Pose& pose, double distance) noexcept {
  const auto [sin, cos] = base::sin_cos(pose.heading);
  return {pose.x + distance * cos, pose.y + distance * sin, pose.heading};
}

}  // namespace

Pose trailer_pose(const Vehicle& vehicle, const State& state) {
  Pose pose = moved_ahead(state.pose, vehicle.hitch);
  pose.heading = wrap_angle(pose.heading - state.hitch_angle);
  return moved_ahead(pose, -trailer_of(vehicle).wheelbase);
}

Pose tractor_pose(const Vehicle& vehicle, const Pose& trailer, double hitch_angle) {
  Pose pose = moved_ahead(trailer, trailer_of(vehicle).wheelbase);
  pose.heading = wrap_angle(pose.heading + hitch_angle);
  return moved_ahead(pose, -vehicle.hitch);
}

double hitch_rate(const Vehicle& vehicle, double hitch_angle, double curvature) {
  return vehicle::hitch_rate(coupling_of(vehicle), hitch_angle, curvature);
}

double hitch_angle_after(const Vehicle& vehicle, double hitch_angle,
                         const Segment& segment) noexcept {
  if (!vehicle.trailer) return hitch_angle;
  return hitch_angle + vehicle::hitch_change(coupling_of(vehicle), hitch_angle, segment);
}

State advance(const Vehicle& vehicle, const State& state, const Segment& segment) noexcept {
  return {advance(state.pose, segment),
          wrap_angle(hitch_angle_after(vehicle, state.hitch_angle, segment))};
}

std::vector<double> sampled_hitch_angles(const Vehicle& vehicle, const Path& path,
                                         double start_angle, double step) {
  vandplan::path::check_finite(path);
  base::require(step > 0.0 && step >= length(path) / 1e7, "step", step,
                "more than 0 m, and 10^7 of them on the path at most");
  std::vector<double> angles;
  double angle = start_angle;
  for (const Segment& segment : path.segments) {
    const double size = std::abs(segment.length);
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(size / step)));
    for (std::size_t i = 0; i < steps; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(steps);
      angles.push_back(hitch_angle_after(vehicle, angle, part_of(segment, 0.0, size * part)));
    }
    angle = hitch_angle_after(vehicle, angle, segment);
  }
  angles.push_back(angle);
  return angles;
}

double largest_hitch_angle(const Vehicle& vehicle, double hitch_angle, const Segment& segment) {
  return vehicle::largest_hitch_angle(coupling_of(vehicle), hitch_angle, segment);
}

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a trailer do when its tractor drives?
//
// Formulas: docs/algorithms/trailers.md. Every vehicle that is passed here has a trailer, where
// nothing else is said.

#include <vector>

#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan {

/// Where a tractor with a trailer is: the pose of the tractor and the angle between both.
struct RigState {
  Pose pose = {};            ///< of the tractor, at the midpoint of its rear axle
  double hitch_angle = 0.0;  ///< heading of the tractor - heading of the trailer [rad]
  bool operator==(const RigState&) const = default;
};

/// Where the midpoint of the trailer's axle is and where the trailer points; heading in [-pi, pi).
/// Throws InputError without a trailer, as all functions here do that do not say otherwise.
[[nodiscard]] Pose trailer_pose(const Vehicle& vehicle, const RigState& state);

/// Where the tractor is when its trailer is there; heading in [-pi, pi).
[[nodiscard]] Pose tractor_pose(const Vehicle& vehicle, const Pose& trailer, double hitch_angle);

/// Change of the hitch angle per metre driven forward with that curvature [rad/m].
[[nodiscard]] double hitch_rate(const Vehicle& vehicle, double hitch_angle, double curvature);

/// The hitch angle after a tractor has driven the segment [rad]: exact but for rounding along arcs
/// and lines, within 1e-11 along clothoids of vehicles. Not wrapped: it goes on beyond pi where the
/// trailer turns round its hitch. An equilibrium stays exactly. Without a trailer the angle stays.
[[nodiscard]] double hitch_angle_after(const Vehicle& vehicle, double hitch_angle,
                                       const Segment& segment) noexcept;

/// The state after driving the segment; the hitch angle is in [-pi, pi) and stays without a
/// trailer.
[[nodiscard]] RigState advance(const Vehicle& vehicle, const RigState& state,
                               const Segment& segment) noexcept;

/// The hitch angles at the points that `sampled` gives for the path and that step [rad]. Without a
/// trailer the angle stays.
[[nodiscard]] std::vector<double> sampled_hitch_angles(const Vehicle& vehicle, const Path& path,
                                                       double start_angle, double step);

/// The largest |hitch angle| anywhere on the segment, both ends included [rad]. Along arcs and
/// lines it is that of an end: the angle moves towards or away from one equilibrium.
[[nodiscard]] double largest_hitch_angle(const Vehicle& vehicle, double hitch_angle,
                                         const Segment& segment);

}  // namespace vandplan

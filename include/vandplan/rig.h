// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a trailer do when its tractor drives?
//
// Formulas: docs/algorithms/trailers.md. Every vehicle that is passed here has a trailer, unless
// the docstring of a function says otherwise.

#include <vector>

#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan {

using RigState [[deprecated("use State")]] = State;

/// Pose of the trailer at the midpoint of its axle, in the frame of `state.pose`; heading in
/// [-pi, pi). Throws InputError naming "vehicle.trailers" if there is no trailer, as
/// `tractor_pose`, `hitch_rate` and `largest_hitch_angle` do.
[[nodiscard]] Pose trailer_pose(const Vehicle& vehicle, const State& state);

/// Pose of the tractor when the midpoint of its trailer's axle is at `trailer`, in the frame of
/// `trailer`; heading in [-pi, pi). `hitch_angle` is the tractor's heading less the trailer's
/// [rad].
[[nodiscard]] Pose tractor_pose(const Vehicle& vehicle, const Pose& trailer, double hitch_angle);

/// Change of the hitch angle per metre driven forward [rad/m]; in reverse it has the opposite sign.
/// `hitch_angle` is in rad, `curvature`
/// is that of the tractor's path [1/m].
[[nodiscard]] double hitch_rate(const Vehicle& vehicle, double hitch_angle, double curvature);

/// Hitch angle after a tractor has driven the segment [rad]. It is exact but for rounding along
/// arcs and lines, and within 1e-11 along clothoids of vehicles. An equilibrium stays exactly.
///
/// The angle is not wrapped: it goes on beyond pi where the trailer turns round its hitch. Without
/// a trailer the angle stays as it was.
[[nodiscard]] double hitch_angle_after(const Vehicle& vehicle, double hitch_angle,
                                       const Segment& segment) noexcept;

/// State after driving the segment, in the frame of `state`. The hitch angle is in [-pi, pi).
/// Without a trailer it is the one in `state`, wrapped.
[[nodiscard]] State advance(const Vehicle& vehicle, const State& state,
                            const Segment& segment) noexcept;
/// State after driving the segment from a state in the world's frame, in that frame.
[[nodiscard]] inline LocalState advance(const Vehicle& vehicle, const LocalState& state,
                                        const Segment& segment) noexcept {
  return Local(advance(vehicle, static_cast<const State&>(state), segment));
}

/// Hitch angles [rad] at the points that `sampled(path, step)` gives, one for each point.
/// `start_angle` is the hitch angle at the start of the path [rad], `step` the largest distance of
/// points [m]. The angles are not wrapped. Without a trailer all are `start_angle`. Throws
/// InputError naming "segments[3]" for a segment that is not finite, or "step" unless it is > 0 and
/// at least a 10^7th of the path's length.
[[nodiscard]] std::vector<double> sampled_hitch_angles(const Vehicle& vehicle, const Path& path,
                                                       double start_angle, double step);

/// Largest absolute hitch angle on the segment, both ends included [rad]. `hitch_angle` is that at
/// its begin. Along arcs and lines the largest one is at an end: the angle moves towards or away
/// from one equilibrium.
[[nodiscard]] double largest_hitch_angle(const Vehicle& vehicle, double hitch_angle,
                                         const Segment& segment);

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does the angle between a tractor and its trailer change along a segment?
//
// Formulas: docs/algorithms/trailers.md.

#include "base/trigonometry.h"
#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan::vehicle {

/// Lengths of a rig that decide how its trailer follows [m].
struct Coupling {
  double hitch = 0.0;      ///< x of the hitch in the tractor's frame
  double wheelbase = 1.0;  ///< distance from the hitch to the trailer's axle; > 0
};

/// Change of a hitch angle per metre driven forward at a curvature [rad/m].
[[nodiscard]] double hitch_rate(const Coupling& coupling, double angle, double curvature) noexcept;

/// Change of hitch angles along an arc or a line, prepared once for many angles.
class HitchAlongArc {
 public:
  HitchAlongArc(const Coupling& coupling, const Segment& arc) noexcept;

  /// Change of an angle [rad], of which sine and cosine are given; whole turns included.
  [[nodiscard]] double change(const base::SinCos& angle) const noexcept;

 private:
  double stretch_, shear_, turn_;  // the matrix M of (2), times the length
  double ratio_, even_;            // S and C of (4), times any factor
  double half_turns_;              // multiple of pi in half of the change [rad]
};

/// Change of the hitch angle along a whole segment [rad], whole turns included.
[[nodiscard]] double hitch_change(const Coupling& coupling, double angle,
                                  const Segment& segment) noexcept;

/// The largest |hitch angle| on a segment that begins with `angle` [rad].
[[nodiscard]] double largest_hitch_angle(const Coupling& coupling, double angle,
                                         const Segment& segment) noexcept;

/// Limits of a trailer's motion whatever its tractor does, from which bounds are made.
struct TrailerAlone {
  /// Largest angle between the motion of the hitch and the trailer [rad]. If it is below pi/2, the
  /// axle drives in the gear of the tractor.
  double most_angle;
  double radius;    ///< least turning radius of the axle if `most_angle` is below pi/2 [m]
  double most_way;  ///< largest way of the axle per metre of the tractor
};

/// Limits of the trailer of a vehicle, which must have one.
[[nodiscard]] TrailerAlone trailer_alone(const Vehicle& vehicle) noexcept;

}  // namespace vandplan::vehicle

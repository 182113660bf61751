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

/// What of a rig decides how its trailer follows [m].
struct Coupling {
  double hitch = 0.0;      ///< x of the hitch in the tractor's frame
  double wheelbase = 1.0;  ///< of the trailer, from the hitch to its axle; > 0
};

/// Change of the hitch angle per metre driven forward with that curvature [rad/m].
[[nodiscard]] double hitch_rate(const Coupling& coupling, double angle, double curvature) noexcept;

/// What an arc or a line does to hitch angles, worked out once for many of them.
class HitchAlongArc {
 public:
  HitchAlongArc(const Coupling& coupling, const Segment& arc) noexcept;

  /// Change of an angle [rad], of which sine and cosine are given; whole turns included.
  [[nodiscard]] double change(const base::SinCos& angle) const noexcept;

 private:
  double stretch_, shear_, turn_;  // the matrix M of (2), times the length
  double ratio_, even_;            // S and C of (4), times any factor
  double half_turns_;              // of half the angle, beyond what these tell [rad]
};

/// Change of the hitch angle along a whole segment [rad], whole turns included.
[[nodiscard]] double hitch_change(const Coupling& coupling, double angle,
                                  const Segment& segment) noexcept;

/// The largest |hitch angle| on a segment that begins with that angle [rad].
[[nodiscard]] double largest_hitch_angle(const Coupling& coupling, double angle,
                                         const Segment& segment) noexcept;

/// A trailer as if it drove by itself, whatever its tractor does: what bounds are made of.
struct TrailerAlone {
  double most_angle;  ///< between the way of the hitch and the trailer [rad]; while it is below
                      ///< pi/2, the axle drives in the gear of the tractor
  double radius;      ///< that its axle never turns below then [m]
  double most_way;    ///< of its axle, for each metre of the tractor
};

/// Of a vehicle with a trailer.
[[nodiscard]] TrailerAlone trailer_alone(const Vehicle& vehicle) noexcept;

}  // namespace vandplan::vehicle

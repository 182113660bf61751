// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does the angle between a tractor and its trailer change along a segment?
//
// Formulas: docs/algorithms/trailers.md.

#include "vandplan/path.h"

namespace vandplan::vehicle {

/// What of a rig decides how its trailer follows [m].
struct Coupling {
  double hitch = 0.0;      ///< x of the hitch in the tractor's frame
  double wheelbase = 1.0;  ///< of the trailer, from the hitch to its axle; > 0
};

/// Change of the hitch angle per metre driven forward with that curvature [rad/m].
[[nodiscard]] double hitch_rate(const Coupling& coupling, double angle, double curvature) noexcept;

/// Change of the hitch angle along a whole segment [rad], whole turns included.
[[nodiscard]] double hitch_change(const Coupling& coupling, double angle,
                                  const Segment& segment) noexcept;

/// The largest |hitch angle| on a segment that begins with that angle [rad].
[[nodiscard]] double largest_hitch_angle(const Coupling& coupling, double angle,
                                         const Segment& segment) noexcept;

}  // namespace vandplan::vehicle

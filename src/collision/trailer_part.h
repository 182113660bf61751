// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which arc replaces the way of a trailer in a collision check, and how far off is it?
//
// Theory: docs/algorithms/trailers.md; proof: docs/proofs/rigs.md.

#include <utility>

#include "base/trigonometry.h"
#include "collision/sweep.h"
#include "vandplan/vehicle.h"

namespace vandplan::collision {

/// State of a rig, with values that are needed repeatedly.
struct RigPlacement {
  RigPlacement(const Vehicle& vehicle, const Placement& tractor, double hitch_angle) noexcept;

  Placement tractor;
  double hitch_angle;  // Hitch angle [rad].
  base::SinCos fold;   // Sine and cosine of the hitch angle.
  Placement trailer;
};

/// Motion of a trailer while its tractor drives a part of a segment.
class TrailerPart {
 public:
  /// A whole segment. The vehicle must have a trailer and outlive the part.
  TrailerPart(const Vehicle& vehicle, const RigPlacement& from, const Segment& segment) noexcept;

  /// Rig at the end; its hitch angle is not wrapped.
  [[nodiscard]] const RigPlacement& to() const noexcept { return to_; }

  /// Whether the check may need too many parts.
  [[nodiscard]] bool is_too_long() const noexcept;

  /// Whether the trailer turns by at most half a radian, as `arc` and `deviation` require.
  [[nodiscard]] bool is_simple() const noexcept;

  /// Arc from the begin of the trailer's way, with the same change of heading.
  [[nodiscard]] PlacedSegment arc() const noexcept;

  /// Largest distance of a point within `reach` [m] of the trailer's axle from its place on the
  /// true way, when the arc is driven [m].
  [[nodiscard]] double deviation(double reach) const noexcept;

  /// Midpoint of the tractor's rear axle at the middle of the part.
  [[nodiscard]] Point tractor_in_the_middle() const noexcept;

  /// Largest distance of the tractor's rear axle from its place at the middle of the part [m].
  [[nodiscard]] double half_length() const noexcept;

  [[nodiscard]] std::pair<TrailerPart, TrailerPart> halves() const noexcept;

 private:
  TrailerPart(const Vehicle& vehicle, const RigPlacement& from, const RigPlacement& to,
              const Segment& segment) noexcept;

  const Vehicle* vehicle_;
  RigPlacement from_, to_;
  Segment segment_;   // Segment of the tractor.
  double last_;       // Curvature at the end [1/m].
  double fastest_;    // Largest speed of the trailer's hitch for a tractor's speed of 1.
  double most_turn_;  // Bound on the turn of the trailer [rad].
};

}  // namespace vandplan::collision

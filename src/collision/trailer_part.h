// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which arc stands for the way of a trailer when it is checked, and how far off is it?
//
// Theory and proof: docs/algorithms/trailers.md.

#include <utility>

#include "base/trigonometry.h"
#include "collision/sweep.h"
#include "vandplan/rig.h"

namespace vandplan::collision {

/// A state of a rig with what is asked of it again and again.
struct RigPlacement {
  RigPlacement(const Vehicle& vehicle, const Placement& tractor, double hitch_angle) noexcept;

  Placement tractor;
  double hitch_angle;  // [rad]
  base::SinCos fold;   // of the hitch angle
  Placement trailer;
};

/// What a trailer does while its tractor drives a part of a segment.
class TrailerPart {
 public:
  /// Along all of a segment; the vehicle has a trailer and outlives the part.
  TrailerPart(const Vehicle& vehicle, const RigPlacement& from, const Segment& segment) noexcept;

  /// The rig at the end, its hitch angle not wrapped.
  [[nodiscard]] const RigPlacement& to() const noexcept { return to_; }

  /// Whether more parts than can be checked in reasonable time may be needed.
  [[nodiscard]] bool is_too_long() const noexcept;

  /// Whether the trailer turns by half a radian at most: only then there are `arc` and `deviation`.
  [[nodiscard]] bool is_simple() const noexcept;

  /// From where the trailer begins, with the same change of heading.
  [[nodiscard]] PlacedSegment arc() const noexcept;

  /// How far a point within `reach` [m] of the trailer's axle is from its place on the true way
  /// when the arc is driven, at most [m].
  [[nodiscard]] double deviation(double reach) const noexcept;

  /// Where the midpoint of the tractor's rear axle is in the middle of the part.
  [[nodiscard]] Point tractor_in_the_middle() const noexcept;

  /// No point of the tractor's rear axle is further from its middle place than this [m].
  [[nodiscard]] double half_length() const noexcept;

  [[nodiscard]] std::pair<TrailerPart, TrailerPart> halves() const noexcept;

 private:
  TrailerPart(const Vehicle& vehicle, const RigPlacement& from, const RigPlacement& to,
              const Segment& segment) noexcept;

  const Vehicle* vehicle_;
  RigPlacement from_, to_;
  Segment segment_;   // of the tractor
  double last_;       // curvature
  double fastest_;    // speed of the trailer's hitch beside that of the tractor, at most
  double most_turn_;  // of the trailer, at most [rad]
};

}  // namespace vandplan::collision

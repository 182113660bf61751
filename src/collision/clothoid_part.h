// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which arc replaces a clothoid in a collision check, and how far off is it?
//
// Theory and proof: docs/algorithms/collision.md.

#include <utility>

#include "collision/sweep.h"

namespace vandplan::collision {

/// Largest distance between the footprint on an arc and on the clothoid that needs no larger margin
/// [m].
inline constexpr double arc_deviation = 0.1e-3;

/// Part of a clothoid, with the placements at its begin and end.
class ClothoidPart {
 public:
  /// A whole clothoid.
  ClothoidPart(const Placement& from, const Segment& clothoid) noexcept;

  [[nodiscard]] const Placement& to() const noexcept { return to_; }

  /// Whether the check may need too many parts, for a body within `reach` [m] of its rear axle.
  [[nodiscard]] bool is_too_long(double reach) const noexcept;

  /// Whether the vehicle turns to one side only, by at most one radian.
  [[nodiscard]] bool is_simple() const noexcept;

  /// Arc from the begin of the part, with the part's length and the curvature at its middle.
  [[nodiscard]] PlacedSegment arc() const noexcept;

  /// Largest distance of a point within `reach` [m] of the rear axle from its place on the
  /// clothoid, when the arc is driven [m].
  [[nodiscard]] double deviation(double reach) const noexcept;

  /// Whether the rear axle stays in the bounds if it begins in them. Requires a simple part.
  [[nodiscard]] bool keeps_to(const Bounds& bounds) const noexcept;

  /// The parts before and after the place of curvature 0; if there is none, before and after the
  /// middle.
  [[nodiscard]] std::pair<ClothoidPart, ClothoidPart> halves() const noexcept;

 private:
  ClothoidPart(const Placement& from, const Placement& to, const Segment& clothoid) noexcept
      : from_(from), to_(to), clothoid_(clothoid) {}

  Placement from_, to_;
  Segment clothoid_;
};

}  // namespace vandplan::collision

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which arc stands for a clothoid when it is checked, and how far off is it?
//
// Theory and proof: docs/algorithms/collision.md.

#include <utility>

#include "collision/sweep.h"

namespace vandplan::collision {

/// How far the footprint on an arc may be from where it is on the clothoid where nothing makes up
/// for it [m].
inline constexpr double arc_deviation = 0.1e-3;

/// A part of a clothoid, and where it begins and ends.
class ClothoidPart {
 public:
  /// All of a clothoid.
  ClothoidPart(const Placement& from, const Segment& clothoid) noexcept;

  [[nodiscard]] const Placement& to() const noexcept { return to_; }

  /// Whether more parts than can be checked in reasonable time may be needed, for a body within
  /// `reach` [m] of its rear axle.
  [[nodiscard]] bool is_too_long(double reach) const noexcept;

  /// Whether the vehicle turns to one side, by a radian at most.
  [[nodiscard]] bool is_simple() const noexcept;

  /// From the same place as long as the part, with the curvature that it has in its middle.
  [[nodiscard]] PlacedSegment arc() const noexcept;

  /// How far a point within `reach` [m] of the rear axle is from its place on the clothoid when the
  /// arc is driven, at most [m].
  [[nodiscard]] double deviation(double reach) const noexcept;

  /// Whether the rear axle keeps to the bounds if it is inside at the begin; of a simple part.
  [[nodiscard]] bool keeps_to(const Bounds& bounds) const noexcept;

  /// Before and after the place where the curvature is 0, or else the middle.
  [[nodiscard]] std::pair<ClothoidPart, ClothoidPart> halves() const noexcept;

 private:
  ClothoidPart(const Placement& from, const Placement& to, const Segment& clothoid) noexcept
      : from_(from), to_(to), clothoid_(clothoid) {}

  Placement from_, to_;
  Segment clothoid_;
};

}  // namespace vandplan::collision

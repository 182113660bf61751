// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which arcs stand for a clothoid when it is checked?
//
// Theory and proof: docs/algorithms/collision.md.

#include "collision/sweep.h"

namespace vandplan::collision {

/// How far the footprint on an arc is from where it is on the clothoid, at most [m].
inline constexpr double arc_deviation = 0.1e-3;

/// The arcs of one clothoid, in order. Each begins where the clothoid is, has its curvature in the
/// middle, and turns by at most a radian; no point within `reach` [m] of the rear axle is further
/// than `arc_deviation` from its place on the clothoid.
class ClothoidArcs {
 public:
  ClothoidArcs(const Placement& from, const Segment& clothoid, double reach) noexcept;

  /// Whether it takes more arcs than can be checked in reasonable time.
  [[nodiscard]] bool are_too_many() const noexcept;

  [[nodiscard]] bool is_done() const noexcept { return begin_ >= length_; }

  /// The arc that comes next; unless it `is_done`.
  [[nodiscard]] PlacedSegment arc() const noexcept;

  /// Goes on to the end of that arc, on the clothoid.
  void advance() noexcept;

  /// Where the clothoid is.
  [[nodiscard]] const Placement& here() const noexcept { return here_; }

  /// Whether the rear axle keeps to the bounds on the clothoid until the end of that arc, if it is
  /// inside now.
  [[nodiscard]] bool keeps_to(const Bounds& bounds) const noexcept;

 private:
  void find_end() noexcept;
  /// Where the clothoid is after so much of it; what is between `begin_` and there is short.
  [[nodiscard]] Placement after(double driven) const noexcept;

  Segment clothoid_;
  double length_;      // of the clothoid [m]
  double inflection_;  // driven until the curvature is 0; negative or beyond the end: nowhere [m]
  double longest_;     // of an arc [m]
  double begin_ = 0;   // of the next arc, driven [m]
  double end_ = 0;
  Placement here_;  // at its begin
  Placement there_;
};

}  // namespace vandplan::collision

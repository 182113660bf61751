// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which sides does a convex body that is no rectangle touch while one segment is driven?
//
// In closed form, without steps: docs/algorithms/collision.md, "Outlines".

#include <span>

#include "collision/sweep.h"
#include "vandplan/geometry.h"

namespace vandplan::collision {

/// All that a body with corners sweeps, and what is within a margin of it.
class OutlineSweep {
 public:
  /// The corners and the segment, which is no longer than `longest`, outlive this.
  OutlineSweep(std::span<const Point> corners, const PlacedSegment& placed, double margin) noexcept;

  /// Of a longer segment rounding might not be small enough [m].
  static constexpr double longest = 64.0;

  /// Whether a side may come within the margin: true wherever it does, false where it stays the
  /// margin and a millimetre away. If only the last corner comes near it may be false: that corner
  /// begins another side of the polygon, which has to be asked as well.
  [[nodiscard]] bool touches(const Sides& sides) const noexcept;

 private:
  [[nodiscard]] bool touches_side(const Point& a, const Point& b) const noexcept;
  [[nodiscard]] bool comes_near(const Point& point, double way, const Point& a,
                                const Point& b) const noexcept;
  [[nodiscard]] bool turns_near(const Point& point, double way, const Point& a,
                                const Point& b) const noexcept;

  std::span<const Point> corners_;
  const PlacedSegment& placed_;
  double gear_;  // 1 or -1
  double side_;  // of the turning centre: 1 to the left, -1 to the right
  bool turns_;
  double near_;  // no side may be nearer [m]
};

}  // namespace vandplan::collision

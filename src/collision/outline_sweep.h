// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which sides does a convex, non-rectangular body touch while one segment is driven?
//
// Closed form, without steps: docs/algorithms/collision.md, "Outlines".

#include <span>

#include "collision/sweep.h"
#include "vandplan/geometry.h"

namespace vandplan::collision {

/// Area swept by a body with corners, and all points within a margin of it.
class OutlineSweep {
 public:
  /// Corners and segment must outlive the object. The segment must be no longer than `longest`.
  OutlineSweep(std::span<const Point> corners, const PlacedSegment& placed, double margin) noexcept;

  /// Length of a segment up to which rounding errors are small enough [m].
  static constexpr double longest = 64.0;

  /// Whether a side may come within the margin. True wherever it does; false where it stays the
  /// margin plus a millimetre away. May be false if only the last corner comes near: that corner
  /// begins another side of the polygon, which must be tested as well.
  [[nodiscard]] bool touches(const Sides& sides) const noexcept;

 private:
  [[nodiscard]] bool touches_side(const Point& a, const Point& b) const noexcept;
  [[nodiscard]] bool comes_near(const Point& point, double way, const Point& a,
                                const Point& b) const noexcept;
  [[nodiscard]] bool turns_near(const Point& point, double way, const Point& a,
                                const Point& b) const noexcept;

  std::span<const Point> corners_;
  const PlacedSegment& placed_;
  double gear_;  // Gear: 1 or -1.
  double side_;  // Side of the turning centre: 1 left, -1 right.
  bool turns_;
  double near_;  // Distance that all sides must keep [m].
};

}  // namespace vandplan::collision

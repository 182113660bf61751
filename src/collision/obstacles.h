// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which sides of polygons are near, and does a polygon contain a point?

#include <span>
#include <vector>

#include "collision/sweep.h"
#include "geometry/box_tree.h"
#include "vandplan/geometry.h"

namespace vandplan::collision {

/// Sides of all polygons, four at a time, in an index of their boxes. Immutable.
class Obstacles {
 public:
  Obstacles() = default;
  explicit Obstacles(std::span<const Polygon> polygons);

  [[nodiscard]] bool is_empty() const noexcept { return sides_.empty(); }
  /// Whether there are so many sides that dividing a box around them pays.
  [[nodiscard]] bool are_many() const noexcept { return sides_.size() > 256; }

  /// Calls `visit(sides)` for sides that may meet the box, until it returns true. Returns whether
  /// it did.
  template <typename Visit>
  [[nodiscard]] bool any_near(const Bounds& box, Visit visit) const {
    return near_.any(box, [&](std::uint32_t i) { return visit(sides_[i]); });
  }

  /// Whether a polygon contains the point. The point must not lie on a side.
  [[nodiscard]] bool contain(const Point& point) const noexcept;

 private:
  std::vector<Sides> sides_;
  geometry::BoxTree near_;
  geometry::BoxTree right_of_;  // The boxes, each extended to the least x of its polygon.
};

}  // namespace vandplan::collision

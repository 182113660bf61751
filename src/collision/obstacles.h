// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which sides are near, and is a point inside a polygon?

#include <span>
#include <vector>

#include "collision/sweep.h"
#include "geometry/box_tree.h"
#include "vandplan/geometry.h"

namespace vandplan::collision {

/// The sides of all polygons, four at a time, in boxes that are found quickly. Immutable.
class Obstacles {
 public:
  Obstacles() = default;
  explicit Obstacles(std::span<const Polygon> polygons);

  [[nodiscard]] bool is_empty() const noexcept { return sides_.empty(); }
  /// Whether a box that holds them all is worth cutting.
  [[nodiscard]] bool are_many() const noexcept { return sides_.size() > 256; }

  /// Calls `visit(sides)` for sides that may meet the box until it returns true; says whether it
  /// did.
  template <typename Visit>
  [[nodiscard]] bool any_near(const Bounds& box, Visit visit) const {
    return near_.any(box, [&](std::uint32_t i) { return visit(sides_[i]); });
  }

  /// Whether a polygon contains the point, which must not lie on a side.
  [[nodiscard]] bool contain(const Point& point) const noexcept;

 private:
  std::vector<Sides> sides_;
  geometry::BoxTree near_;
  geometry::BoxTree right_of_;  // the boxes, each as far to the left as the whole polygon
};

}  // namespace vandplan::collision

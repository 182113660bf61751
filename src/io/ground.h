// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which pieces of ground touch, and where does the ground end?

#include <optional>
#include <utility>
#include <vector>

#include "geometry/box_tree.h"
#include "vandplan/geometry.h"
#include "vandplan/input_error.h"

namespace vandplan::io {

/// Outline of a piece of ground, counter-clockwise.
struct Ring {
  Polygon corners;
  Bounds box;
};

/// Ring of a polygon, without sides shorter than 1 mm; nothing if it has no area.
[[nodiscard]] std::optional<Ring> ring_of(const Polygon& polygon);

/// Rings that may overlap, and a tree of their boxes.
class Ground {
 public:
  explicit Ground(std::vector<Ring> rings) : rings_(std::move(rings)) {
    std::vector<Bounds> boxes;
    for (const Ring& ring : rings_) boxes.push_back(ring.box);
    tree_ = geometry::BoxTree(boxes);
  }

  [[nodiscard]] const std::vector<Ring>& rings() const { return rings_; }
  /// Indices of the rings whose boxes overlap a box.
  [[nodiscard]] std::vector<std::size_t> near(const Bounds& box) const {
    std::vector<std::size_t> found;
    (void)tree_.any(box, [&](std::size_t index) {
      found.push_back(index);
      return false;
    });
    return found;
  }

 private:
  std::vector<Ring> rings_;
  geometry::BoxTree tree_;
};

/// Limit for the work with rings that overlap without end, as in a road wound up.
class Effort {
 public:
  /// Throws an InputError naming "lanes" once more than some ten seconds' work is spent.
  void spend(std::size_t work) {
    spent_ += work;
    if (spent_ <= most) return;
    throw InputError("lanes", "overlap too often, expected fewer on one place");
  }

 private:
  static constexpr std::size_t most = 5'000'000'000;  // Comparisons of a point with a side.
  std::size_t spent_ = 0;
};

/// Walls along all sides beyond which there is no ground: rectangles 1 mm thick, just outside.
/// Gaps of less than 1 cm between rings count as ground.
[[nodiscard]] std::vector<Polygon> walls_around(const Ground& ground);

/// Whether two rings overlap by more than 10 cm.
[[nodiscard]] bool overlap(const Ring& one, const Ring& other, Effort& effort);

/// Whether a polygon and a ring have a point in common.
[[nodiscard]] bool touch(const Polygon& polygon, const Ring& ring);

/// Twice the area of a polygon [m^2]; negative if its corners are in clockwise order.
[[nodiscard]] double twice_area(const Polygon& polygon);

/// Distance between two points [m].
[[nodiscard]] double distance(const Point& a, const Point& b);

/// Point at a share of the way from a to b.
[[nodiscard]] Point between(const Point& a, const Point& b, double share);

/// Point rounded to 0.1 mm.
[[nodiscard]] Point rounded(const Point& point);

}  // namespace vandplan::io

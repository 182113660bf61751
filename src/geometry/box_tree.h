// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which of many boxes overlap this one?
//
// The tree is a packed R-tree (Kamel and Faloutsos 1993). Every block holds eight boxes side by
// side. The boxes of a level are the bounding boxes of the blocks below it. There are no pointers,
// and few boxes are one block, tested at once.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan::geometry {

/// Number of boxes in a block.
inline constexpr std::uint32_t box_fan_out = 8;

/// An order of the boxes in which neighbours in the list are neighbours in the plane.
[[nodiscard]] std::vector<std::uint32_t> spatial_order(std::span<const Bounds> boxes);

/// A tree of boxes in float, rounded outwards: it misses no overlap.
class BoxTree {
 public:
  BoxTree() = default;
  /// The tree of boxes in any order; it is fast for boxes in `spatial_order`.
  explicit BoxTree(std::span<const Bounds> boxes);

  /// Calls `visit(index)` for the boxes that overlap `query`, until a call returns true. Returns
  /// whether one did. Boxes that touch overlap. Allocates nothing.
  template <typename Visit>
  [[nodiscard]] bool any(const Bounds& query, Visit visit) const {
    return !levels_.empty() && any_in(levels_.size() - 1, 0, outer(query), visit);
  }

 private:
  static constexpr std::uint32_t fan_out = box_fan_out;

  struct Box {
    float x_min, x_max, y_min, y_max;
  };

  struct alignas(32) Block {
    std::array<float, fan_out> x_min, x_max, y_min, y_max;

    /// Bits of the boxes that overlap `box`: bit i for box i. Compilers vectorise the loop.
    [[nodiscard]] std::uint32_t overlapping(const Box& box) const {
      std::uint32_t bits = 0;
      for (std::uint32_t i = 0; i < fan_out; ++i) {
        const bool overlaps = (x_min[i] <= box.x_max) & (x_max[i] >= box.x_min) &
                              (y_min[i] <= box.y_max) & (y_max[i] >= box.y_min);
        bits |= overlaps ? 1U << i : 0U;
      }
      return bits;
    }
  };

  [[nodiscard]] static Box outer(const Bounds& box);

  template <typename Visit>
  bool any_in(std::size_t level, std::uint32_t block, const Box& query, Visit& visit) const {
    std::uint32_t bits = levels_[level][block].overlapping(query);
    for (std::uint32_t i = block * fan_out; bits != 0; ++i, bits >>= 1) {
      if ((bits & 1U) == 0) continue;
      if (level == 0 ? visit(i) : any_in(level - 1, i, query, visit)) return true;
    }
    return false;
  }

  std::vector<std::vector<Block>> levels_;  // first level: the boxes; last level: one block
};

}  // namespace vandplan::geometry

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do the cells of a mask say along a segment? docs/lab/zones.md.

#include <array>
#include <cstdint>
#include <vector>

#include "vandplan/collision.h"
#include "vandplan/path.h"

namespace vandplan::collision {

/// Cells of a mask that limit the speed or have a price.
class MaskCells {
 public:
  explicit MaskCells(const Mask& mask);

  [[nodiscard]] MaskUse use() const noexcept { return mask_.use; }

  /// Adds the places of a segment where the rear axle moves into another cell [m].
  void add_changes(const Pose& from, const Segment& segment, std::vector<double>& places) const;

  /// Applies what the mask says at a place to a part of a segment.
  void tell(const Point& place, GroundPart& part) const;
  /// Applies the least that the mask says at any place up to `reach` [m] from a place.
  void tell_least(const Point& place, double reach, GroundPart& part) const;

 private:
  /// Cells from (`column`, `row`) to before (`end_column`, `end_row`).
  struct Box {
    std::int32_t column, row, end_column, end_row;
  };

  void apply(double value, GroundPart& part) const;
  [[nodiscard]] std::uint8_t percent(std::int32_t column, std::int32_t row) const;
  [[nodiscard]] Box speaking() const;
  [[nodiscard]] Pose in_cells(const Pose& pose) const;

  Mask mask_;
  std::array<double, 256> values_;   // Value of each percentage.
  std::array<bool, 256> is_silent_;  // Whether a percentage says nothing.
  Box box_;                          // Box around all cells that say something.
};

}  // namespace vandplan::collision

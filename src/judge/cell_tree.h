// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the vehicle from the blocked cells of a map, in the eyes of the judge?
//
// A tree of squares of cells. Each square knows only whether it has a blocked cell. The search for
// the nearest blocked cell skips squares that are empty or too far away.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "judge/clearance.h"
#include "vandplan/geometry.h"

namespace vandplan::judge {

class CellTree {
 public:
  explicit CellTree(const OccupancyGrid& grid);

  /// Updates the tree after cells in a range of the grid have changed.
  void update(const CellRange& changed);

  /// Distance between the closed body and the closed blocked cells [m], if the curvature is
  /// constant. On a passage it is a lower bound for all positions. Values are cut off at `most`.
  [[nodiscard]] double clearance(const View& view, const Outline& body, double most,
                                 Effort& effort) const;

 private:
  /// Squares of one size, one bit each. Each row takes whole words. There is room for one more
  /// column and one more row, whose bits are never set.
  struct Level {
    std::int32_t columns = 0;
    std::int32_t rows = 0;
    std::vector<std::uint64_t> has_blocked;

    [[nodiscard]] std::size_t word_of(std::int32_t column, std::int32_t row) const;
  };
  struct Size {
    std::int32_t columns, rows;
  };
  class Search;

  /// Number of columns and rows of squares with sides of 2^level cells.
  [[nodiscard]] Size size_of(std::size_t level) const;
  /// Computes squares of a level from those of the level below.
  void fill(std::size_t level, const CellRange& squares);

  /// Whether a square with sides of 2^level cells has a blocked cell; false outside of the grid.
  [[nodiscard]] bool has_blocked(std::size_t level, std::int32_t column, std::int32_t row) const;

  /// Bit mask of the quarters with a blocked cell, for a square of level 1 or above. Bit 0 is the
  /// lower left quarter, bit 1 the lower right one, bit 2 the upper left one, bit 3 the upper right
  /// one.
  [[nodiscard]] unsigned blocked_quarters(std::size_t level, std::int32_t column,
                                          std::int32_t row) const;

  OccupancyGrid grid_;
  Real cos_, sin_;             ///< cosine and sine of the heading of the grid
  std::vector<Level> levels_;  ///< squares of level 1 and above; the last level is a single square
};

}  // namespace vandplan::judge

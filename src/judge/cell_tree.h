// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the vehicle from the blocked cells of a map, in the eyes of the judge?
//
// A tree of squares of cells, each of which knows no more than whether a blocked cell is in it:
// whoever looks for the nearest cell leaves out squares that are empty or too far away.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "judge/clearance.h"
#include "vandplan/occupancy_grid.h"

namespace vandplan::judge {

class CellTree {
 public:
  explicit CellTree(const OccupancyGrid& grid);

  /// The cells of the grid in a range have become others.
  void update(const CellRange& changed);

  /// Between the closed body and the closed squares of the blocked cells [m], if the curvature is
  /// constant: at one position the distance, on a passage no more than that at any of its
  /// positions, never more than `most`.
  [[nodiscard]] double clearance(const View& view, const Outline& body, double most,
                                 Effort& effort) const;

 private:
  /// Squares of one size: a bit each, of a row in as many words as it takes. Beside the last column
  /// and above the last row there is room for one more, never set.
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

  /// Of the squares with sides of 2^level cells.
  [[nodiscard]] Size size_of(std::size_t level) const;
  /// Squares of a level, from those of the level below.
  void fill(std::size_t level, const CellRange& squares);

  /// Whether a blocked cell is in a square with sides of 2^level cells; false outside of the grid.
  [[nodiscard]] bool has_blocked(std::size_t level, std::int32_t column, std::int32_t row) const;

  /// Which quarters of a square of level 1 or above hold a blocked cell: bit 0 is the lower left
  /// one, bit 1 the lower right one, bits 2 and 3 are those above.
  [[nodiscard]] unsigned blocked_quarters(std::size_t level, std::int32_t column,
                                          std::int32_t row) const;

  OccupancyGrid grid_;
  Real cos_, sin_;             ///< of the heading of the grid
  std::vector<Level> levels_;  ///< of level 1 and above; the last is a single square
};

}  // namespace vandplan::judge

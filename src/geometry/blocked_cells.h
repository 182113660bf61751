// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which cells of a grid are blocked, a bit each, and which of them can be hit first?
//
// Cells count from the lower left one of a frame, one cell wide, around the grid: what is outside.

#include <cstdint>

#include "geometry/bit_grid.h"
#include "vandplan/occupancy_grid.h"

namespace vandplan::geometry {

/// Cells of a grid, in the frame.
[[nodiscard]] CellBox in_frame(const CellRange& cells) noexcept;

/// Bits of a frame and the grid in it.
class BlockedCells {
 public:
  explicit BlockedCells(const OccupancyGrid& grid);

  /// The cells of the grid in a box have become others.
  void update(const OccupancyGrid& grid, const CellBox& changed);

  /// The number of columns, and of rows, with those of the frame.
  [[nodiscard]] std::int32_t columns() const noexcept { return blocked_.columns(); }
  [[nodiscard]] std::int32_t rows() const noexcept { return blocked_.rows(); }

  /// The cells that are blocked.
  [[nodiscard]] const BitGrid& blocked() const noexcept { return blocked_; }

  /// Edge cells are blocked and have a neighbour that is not: whatever comes from free ground hits
  /// such a one first.
  [[nodiscard]] const BitGrid& edges() const noexcept { return edges_; }

  /// Whether a cell is blocked; false outside of the frame.
  [[nodiscard]] bool is_blocked(std::int32_t x, std::int32_t y) const noexcept {
    return x >= 0 && y >= 0 && x < columns() && y < rows() && blocked_.is_set(x, y);
  }

 private:
  void mark_edges(const CellBox& box, bool outside_is_blocked);

  BitGrid blocked_;
  BitGrid edges_;
};

/// Whether a block of 2^shift times 2^shift cells holds one that is set.
[[nodiscard]] BitGrid blocks_of(const BitGrid& cells, int shift);

/// The same again for the blocks of a box of cells; says whether one became another.
bool update_blocks(const BitGrid& cells, int shift, const CellBox& changed, BitGrid& blocks);

}  // namespace vandplan::geometry

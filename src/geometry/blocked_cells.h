// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which cells of a grid are blocked, a bit each, and which of them can be hit first?
//
// Cells are counted in a frame: the grid and a border one cell wide, which stands for the ground
// outside. Cell (0, 0) is the lower left cell of the border.

#include <cstdint>

#include "geometry/bit_grid.h"
#include "vandplan/geometry.h"

namespace vandplan::geometry {

/// The cells of a range of a grid, counted in the frame.
[[nodiscard]] CellBox in_frame(const CellRange& cells) noexcept;

/// The blocked cells and the edge cells of a grid and its border, a bit each.
class BlockedCells {
 public:
  explicit BlockedCells(const OccupancyGrid& grid);

  /// Reads those cells of the grid again that lie in the box `changed`, counted in the frame.
  void update(const OccupancyGrid& grid, const CellBox& changed);

  /// The number of columns, and of rows, with those of the frame.
  [[nodiscard]] std::int32_t columns() const noexcept { return blocked_.columns(); }
  [[nodiscard]] std::int32_t rows() const noexcept { return blocked_.rows(); }

  /// The cells that are blocked.
  [[nodiscard]] const BitGrid& blocked() const noexcept { return blocked_; }

  /// The edge cells: blocked cells with a neighbour that is not blocked. A body that comes from
  /// free ground hits an edge cell first.
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

/// A bit for each block of 2^shift times 2^shift cells: whether one of its cells is set.
[[nodiscard]] BitGrid blocks_of(const BitGrid& cells, int shift);

/// Updates the bits that `blocks_of` gives for the blocks of the cells in `changed`. Returns
/// whether a bit changed.
bool update_blocks(const BitGrid& cells, int shift, const CellBox& changed, BitGrid& blocks);

}  // namespace vandplan::geometry

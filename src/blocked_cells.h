// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which cells of a grid are blocked, a bit each, and which of them can be hit first?
//
// Cells count from the lower left one of a frame, one cell wide, around the grid: what is outside.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "vandplan/occupancy_grid.h"

namespace vandplan {

/// A rectangle of cells: columns from `x_min` to `x_max`, rows likewise, both included.
struct CellBox {
  std::int32_t x_min, x_max, y_min, y_max;
};

/// Bits of a frame and the grid in it. Immutable.
class BlockedCells {
 public:
  explicit BlockedCells(const OccupancyGrid& grid);

  /// Of the cells with the frame.
  [[nodiscard]] std::int32_t columns() const noexcept { return columns_; }
  [[nodiscard]] std::int32_t rows() const noexcept { return rows_; }

  /// False outside of the frame.
  [[nodiscard]] bool is_blocked(std::int32_t x, std::int32_t y) const noexcept {
    if (x < 0 || y < 0 || x >= columns_ || y >= rows_) return false;
    return (blocked_[word_of(x, y)] >> (static_cast<std::uint32_t>(x) % 64) & 1U) != 0;
  }

  /// Calls `visit(y, x_begin, x_end)` for the runs of edge cells in a box until it returns true;
  /// says whether it did. An edge cell is blocked and has a neighbour that is not: whatever comes
  /// from free ground hits such a one first.
  template <typename Visit>
  [[nodiscard]] bool any_edge_run(const CellBox& box, Visit visit) const {
    return any_run(edges_, box, visit);
  }

  /// The same for runs of blocked cells.
  template <typename Visit>
  [[nodiscard]] bool any_blocked_run(const CellBox& box, Visit visit) const {
    return any_run(blocked_, box, visit);
  }

 private:
  using Bits = std::vector<std::uint64_t>;

  [[nodiscard]] std::size_t word_of(std::int32_t x, std::int32_t y) const noexcept {
    return static_cast<std::size_t>(y) * words_ + static_cast<std::size_t>(x) / 64;
  }

  template <typename Visit>
  [[nodiscard]] bool any_run(const Bits& bits, CellBox box, Visit& visit) const {
    box = {std::max(box.x_min, 0), std::min(box.x_max, columns_ - 1), std::max(box.y_min, 0),
           std::min(box.y_max, rows_ - 1)};
    if (box.x_min > box.x_max) return false;
    for (std::int32_t y = box.y_min; y <= box.y_max; ++y) {
      const std::size_t last = word_of(box.x_max, y);
      for (std::size_t i = word_of(box.x_min, y); i <= last; ++i) {
        if (bits[i] == 0) continue;
        const auto first = static_cast<std::int32_t>(i % words_ * 64);
        const auto in_box = [&](std::int32_t begin, std::int32_t end) {
          return end > box.x_min && begin <= box.x_max && visit(y, begin, end);
        };
        if (any_run_in(bits[i], first, in_box)) return true;
      }
    }
    return false;
  }

  /// The runs of ones in a word whose first bit is that of column `first`.
  template <typename Visit>
  [[nodiscard]] static bool any_run_in(std::uint64_t bits, std::int32_t first, Visit visit) {
    while (bits != 0) {
      const int begin = std::countr_zero(bits);
      const int end = begin + std::countr_one(bits >> begin);
      if (visit(first + begin, first + end)) return true;
      if (end == 64) break;
      bits &= ~std::uint64_t{0} << end;
    }
    return false;
  }

  void mark_edges(bool outside_is_blocked);

  std::int32_t columns_;
  std::int32_t rows_;
  std::size_t words_;  // of a row
  Bits blocked_;
  Bits edges_;
};

}  // namespace vandplan

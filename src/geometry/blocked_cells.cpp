// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/blocked_cells.h"

#include <algorithm>

namespace vandplan::geometry {

CellBox in_frame(const CellRange& cells) noexcept {
  return {cells.column + 1, cells.column + cells.columns, cells.row + 1, cells.row + cells.rows};
}

BlockedCells::BlockedCells(const OccupancyGrid& grid)
    : blocked_(grid.columns + 2, grid.rows + 2), edges_(grid.columns + 2, grid.rows + 2) {
  for (std::int32_t y = 0; y < grid.rows; ++y) {
    const Cell* const row =
        grid.cells->data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns);
    for (std::int32_t x = 0; x < grid.columns; ++x) {
      const bool blocked =
          row[x] == Cell::occupied || (row[x] == Cell::unknown && !grid.unknown_is_free);
      if (blocked) blocked_.set(x + 1, y + 1);
    }
  }
  if (!grid.unknown_is_free) {
    for (std::int32_t x = 0; x < columns(); ++x) {
      blocked_.set(x, 0);
      blocked_.set(x, rows() - 1);
    }
    for (std::int32_t y = 0; y < rows(); ++y) {
      blocked_.set(0, y);
      blocked_.set(columns() - 1, y);
    }
  }
  mark_edges({0, columns() - 1, 0, rows() - 1}, !grid.unknown_is_free);
}

void BlockedCells::update(const OccupancyGrid& grid, const CellBox& changed) {
  for (std::int32_t y = changed.y_min; y <= changed.y_max; ++y) {
    for (std::int32_t x = changed.x_min; x <= changed.x_max; ++x) {
      if (vandplan::is_blocked(grid, x - 1, y - 1)) {
        blocked_.set(x, y);
      } else {
        blocked_.clear(x, y);
      }
    }
  }
  mark_edges(widened(changed, 1), !grid.unknown_is_free);
}

/// Marks edge cells in the box, and beside it in the same words of bits.
void BlockedCells::mark_edges(const CellBox& box, bool outside_is_blocked) {
  const std::uint64_t outside = outside_is_blocked ? ~std::uint64_t{0} : 0;
  // Number of bits in the last word of a row; 0: all.
  const auto tail = static_cast<std::uint32_t>(columns()) % 64;
  const std::uint64_t beyond = tail == 0 ? 0 : ~std::uint64_t{0} << tail;
  const std::size_t words = blocked_.words();
  // A word of a row; bits outside of the frame are those of `outside`. The index before 0 wraps to
  // a large number.
  const auto word = [&](std::size_t i, std::int32_t y) {
    if (y < 0 || y >= rows() || i >= words) return outside;
    return i + 1 == words ? blocked_.word(i, y) | (outside & beyond) : blocked_.word(i, y);
  };
  const auto first = static_cast<std::size_t>(std::max(box.x_min, 0)) / 64;
  const auto last = static_cast<std::size_t>(std::min(box.x_max, columns() - 1)) / 64;
  for (std::int32_t y = std::max(box.y_min, 0); y <= std::min(box.y_max, rows() - 1); ++y) {
    for (std::size_t i = first; i <= last; ++i) {
      const std::uint64_t bits = word(i, y);
      const std::uint64_t left = bits << 1 | word(i - 1, y) >> 63;
      const std::uint64_t right = bits >> 1 | word(i + 1, y) << 63;
      const std::uint64_t surrounded = left & right & word(i, y - 1) & word(i, y + 1);
      edges_.word(i, y) = blocked_.word(i, y) & ~surrounded;
    }
  }
}

BitGrid blocks_of(const BitGrid& cells, int shift) {
  const auto blocks = [&](std::int32_t count) { return ((count - 1) >> shift) + 1; };
  BitGrid result(blocks(cells.columns()), blocks(cells.rows()));
  const CellBox all{0, cells.columns() - 1, 0, cells.rows() - 1};
  (void)cells.any_run(all, [&](std::int32_t y, std::int32_t begin, std::int32_t end) {
    for (std::int32_t x = begin >> shift; x <= (end - 1) >> shift; ++x) result.set(x, y >> shift);
    return false;
  });
  return result;
}

bool update_blocks(const BitGrid& cells, int shift, const CellBox& changed, BitGrid& blocks) {
  const CellBox box = shared(changed, {0, cells.columns() - 1, 0, cells.rows() - 1});
  bool has_changed = false;
  for (std::int32_t y = box.y_min >> shift; y <= box.y_max >> shift; ++y) {
    for (std::int32_t x = box.x_min >> shift; x <= box.x_max >> shift; ++x) {
      const CellBox block{x << shift, ((x + 1) << shift) - 1, y << shift, ((y + 1) << shift) - 1};
      const bool is_set =
          cells.any_run(block, [](std::int32_t, std::int32_t, std::int32_t) { return true; });
      if (is_set == blocks.is_set(x, y)) continue;
      has_changed = true;
      if (is_set) {
        blocks.set(x, y);
      } else {
        blocks.clear(x, y);
      }
    }
  }
  return has_changed;
}

}  // namespace vandplan::geometry

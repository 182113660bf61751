// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "blocked_cells.h"

namespace vandplan {

BlockedCells::BlockedCells(const OccupancyGrid& grid)
    : columns_(grid.columns + 2),
      rows_(grid.rows + 2),
      words_((static_cast<std::size_t>(columns_) + 63) / 64),
      blocked_(words_ * static_cast<std::size_t>(rows_)),
      edges_(blocked_.size()) {
  const auto set = [&](std::int32_t x, std::int32_t y) {
    blocked_[word_of(x, y)] |= std::uint64_t{1} << (static_cast<std::uint32_t>(x) % 64);
  };
  for (std::int32_t y = 0; y < grid.rows; ++y) {
    const Cell* const row =
        grid.cells->data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns);
    for (std::int32_t x = 0; x < grid.columns; ++x) {
      const bool blocked =
          row[x] == Cell::occupied || (row[x] == Cell::unknown && !grid.unknown_is_free);
      if (blocked) set(x + 1, y + 1);
    }
  }
  if (!grid.unknown_is_free) {
    for (std::int32_t x = 0; x < columns_; ++x) {
      set(x, 0);
      set(x, rows_ - 1);
    }
    for (std::int32_t y = 0; y < rows_; ++y) {
      set(0, y);
      set(columns_ - 1, y);
    }
  }
  mark_edges(!grid.unknown_is_free);
}

void BlockedCells::mark_edges(bool outside_is_blocked) {
  const std::uint64_t outside = outside_is_blocked ? ~std::uint64_t{0} : 0;
  const auto tail = static_cast<std::uint32_t>(columns_) % 64;  // bits of the last word; 0: all
  const std::uint64_t beyond = tail == 0 ? 0 : ~std::uint64_t{0} << tail;
  // A word of a row, what lies outside of the frame filled in.
  const auto word = [&](std::int32_t y, std::ptrdiff_t i) {
    const auto last = static_cast<std::ptrdiff_t>(words_) - 1;
    if (y < 0 || y >= rows_ || i < 0 || i > last) return outside;
    const std::uint64_t bits =
        blocked_[static_cast<std::size_t>(y) * words_ + static_cast<std::size_t>(i)];
    return i == last ? bits | (outside & beyond) : bits;
  };
  for (std::int32_t y = 0; y < rows_; ++y) {
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(words_); ++i) {
      const std::uint64_t bits = word(y, i);
      const std::uint64_t left = bits << 1 | word(y, i - 1) >> 63;
      const std::uint64_t right = bits >> 1 | word(y, i + 1) << 63;
      const std::uint64_t surrounded = left & right & word(y - 1, i) & word(y + 1, i);
      const std::size_t at = static_cast<std::size_t>(y) * words_ + static_cast<std::size_t>(i);
      edges_[at] = blocked_[at] & ~surrounded;
    }
  }
}

}  // namespace vandplan

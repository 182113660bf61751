// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the nearest blocked cell?
//
// Exact at the corners of the cells: the point of a cell that is nearest to a corner is a corner,
// too, so this is a distance transform of corners. In linear time: Meijster, Roerdink and
// Hesselink, "A general algorithm for computing distance transforms in linear time" (2000).

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/blocked_cells.h"

namespace vandplan::geometry {

/// The squares of the distances of all corners of cells from the nearest cell that is set.
class CornerSquares {
 public:
  /// Distances above it are not told apart [cells].
  static constexpr std::int32_t furthest = 255;

  explicit CornerSquares(const BitGrid& cells);

  /// The cells in a box have become others. The corners whose squares may have changed are in the
  /// box that is returned, which may be empty.
  CellBox update(const BitGrid& cells, const CellBox& changed);

  [[nodiscard]] std::int32_t columns() const noexcept { return columns_; }
  [[nodiscard]] std::int32_t rows() const noexcept { return rows_; }

  /// The squares from a corner on to the right.
  [[nodiscard]] const std::uint16_t* from(std::int32_t x, std::int32_t y) const noexcept {
    return squares_.data() + index_of(x, y);
  }

 private:
  /// Corners of a row that may change, and columns of which it depends to what.
  struct Stretch {
    std::int32_t y, begin, end;
    std::int32_t first_source, last_source;
  };

  [[nodiscard]] std::size_t index_of(std::int32_t x, std::int32_t y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] Stretch affected(std::int32_t y, const CellBox& changed) const;
  [[nodiscard]] bool is_less(const BitGrid& cells, const CellBox& changed) const;
  void lower(const BitGrid& cells, const std::vector<Stretch>& stretches);

  std::int32_t columns_, rows_;  // of corners
  std::vector<std::uint16_t> squares_;
};

/// How often the side of so many cells is doubled for about 10^8 squares or fewer.
[[nodiscard]] int field_shift(std::int64_t cells) noexcept;

/// Lengths and positions in cells, from the lower left corner of the frame.
class DistanceField {
 public:
  /// Distances above it are not told apart, but by the coarse copy [sides of its squares].
  static constexpr double furthest = CornerSquares::furthest;
  static constexpr double parts = 16.0;  ///< of a cell, that the coarse copy counts

  /// The field of squares of 2^shift times 2^shift cells, which are blocked if one of their cells
  /// is. Beside the field itself it keeps a coarse copy, of blocks of 2^coarseness times
  /// 2^coarseness cells, no smaller than the squares: small enough to stay in the cache.
  DistanceField(const BlockedCells& cells, int coarseness, int shift = 0);

  /// The cells in a box have become others: as if made anew.
  void update(const BlockedCells& cells, const CellBox& changed);

  /// Between which two numbers a distance lies.
  struct Range {
    double least, most;
  };

  /// The distance of a point from the nearest blocked cell.
  [[nodiscard]] Range around(const Point& point) const noexcept;

  /// No blocked cell is nearer to a point; from the coarse copy, up to `furthest` blocks.
  /// Outside of a free frame it grows with the way to the frame.
  [[nodiscard]] double at_least(const Point& point) const noexcept {
    // The nearest point of the frame, but for its last half cell: nothing that lies in the frame is
    // nearer to the point itself than to the block of this one, or than a free frame is.
    const double x = std::clamp(point.x, 0.0, last_x_);
    const double y = std::clamp(point.y, 0.0, last_y_);
    const auto i = static_cast<std::size_t>(x * per_block_);
    const auto j = static_cast<std::size_t>(y * per_block_);
    const double to_block = blocks_[j * block_columns_ + i] * (1 / parts);
    const double outside = std::max(std::abs(point.x - x), std::abs(point.y - y)) - half_a_cell;
    return std::max(to_block, outside * outside_is_free_);
  }

  /// The square of the distance at a corner of squares, at most that of `furthest`, in their sides.
  [[nodiscard]] std::uint32_t square_at(std::int32_t x, std::int32_t y) const noexcept {
    return *squares_.from(x, y);
  }

 private:
  static constexpr double half_a_cell = 0.5;  // beyond `last_x_` and `last_y_` the frame goes on

  void fill_blocks(const CellBox& blocks);

  double last_x_, last_y_;  // middle of the last cell
  double outside_is_free_;  // 1, or 0 where all ground outside is blocked
  int shift_;
  double side_, per_side_;   // of a square, and its inverse
  BitGrid blocked_squares_;  // with a blocked cell; one of no shift is a cell, and not kept
  CornerSquares squares_;
  int coarseness_;
  double per_block_;              // inverse of the cells along a side
  BitGrid blocked_blocks_;        // with a blocked cell
  CornerSquares between_blocks_;  // of these
  std::size_t block_columns_;
  std::vector<std::uint16_t> blocks_;  // distances of their nearest points, in parts, rounded down
};

}  // namespace vandplan::geometry

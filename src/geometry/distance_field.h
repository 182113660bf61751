// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the nearest blocked cell?
//
// The field is exact at the corners of cells. The point of a cell that is nearest to a corner is a
// corner, too, so this is a distance transform of corners. It takes linear time: Meijster, Roerdink
// and Hesselink, "A general algorithm for computing distance transforms in linear time" (2000).

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/blocked_cells.h"

namespace vandplan::geometry {

/// The squares of the distances of all corners of cells from the nearest cell that is set.
class CornerSquares {
 public:
  /// The largest distance [cells]; larger ones are not told apart.
  static constexpr std::int32_t furthest = 255;

  explicit CornerSquares(const BitGrid& cells);

  /// Updates the squares after cells in the box `changed` have changed. Returns a box, maybe empty,
  /// of the corners whose squares may have changed.
  CellBox update(const BitGrid& cells, const CellBox& changed);

  [[nodiscard]] std::int32_t columns() const noexcept { return columns_; }
  [[nodiscard]] std::int32_t rows() const noexcept { return rows_; }

  /// The squares of a corner and of those to the right of it.
  [[nodiscard]] const std::uint16_t* from(std::int32_t x, std::int32_t y) const noexcept {
    return squares_.data() + index_of(x, y);
  }

 private:
  /// Corners from `begin` to before `end` in row `y` that may change, and the first and the last
  /// column of corners that decide about them.
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

  std::int32_t columns_, rows_;  // numbers of corners
  std::vector<std::uint16_t> squares_;
};

/// Least shift with which `cells` cells make about 10^8 squares of 2^shift cells a side, or fewer.
[[nodiscard]] int field_shift(std::int64_t cells) noexcept;

/// Distances of points from the nearest blocked cell. Lengths and positions are in cells, counted
/// from the lower left corner of the frame.
class DistanceField {
 public:
  /// The largest distance [sides of a square]; only the coarse copy tells larger ones apart.
  static constexpr double furthest = CornerSquares::furthest;
  static constexpr double parts = 16.0;  ///< units per cell of distances in the coarse copy

  /// The field of squares of 2^shift times 2^shift cells; a square is blocked if one of its cells
  /// is. Beside it there is a coarse copy of blocks of 2^coarseness times 2^coarseness cells, no
  /// smaller than the squares. The copy is small enough to stay in the cache.
  DistanceField(const BlockedCells& cells, int coarseness, int shift = 0);

  /// Updates the field, as if it were made anew, after cells in the box `changed` have changed.
  void update(const BlockedCells& cells, const CellBox& changed);

  /// Bounds of a distance [cells].
  struct Range {
    double least, most;
  };

  /// Bounds of the distance of a point from the nearest blocked cell.
  [[nodiscard]] Range around(const Point& point) const noexcept;

  /// Lower bound of the distance of a point from blocked cells, from the coarse copy, up to
  /// `furthest` blocks. Outside of a free frame it grows with the distance from the frame.
  [[nodiscard]] double at_least(const Point& point) const noexcept {
    // (x, y) is the nearest point of the frame without its last half cell. No cell of the frame is
    // nearer to `point` than to the block of (x, y), or than a free frame is.
    const double x = std::clamp(point.x, 0.0, last_x_);
    const double y = std::clamp(point.y, 0.0, last_y_);
    const auto i = static_cast<std::size_t>(x * per_block_);
    const auto j = static_cast<std::size_t>(y * per_block_);
    const double to_block = blocks_[j * block_columns_ + i] * (1 / parts);
    const double outside = std::max(std::abs(point.x - x), std::abs(point.y - y)) - half_a_cell;
    return std::max(to_block, outside * outside_is_free_);
  }

  /// Square of the distance at a corner of squares, at most that of `furthest` [sides of a square].
  [[nodiscard]] std::uint32_t square_at(std::int32_t x, std::int32_t y) const noexcept {
    return *squares_.from(x, y);
  }

 private:
  static constexpr double half_a_cell = 0.5;  // width of the frame beyond `last_x_` and `last_y_`

  void fill_blocks(const CellBox& blocks);

  double last_x_, last_y_;  // middle of the frame's last column and of its last row
  double outside_is_free_;  // 1, or 0 if all ground outside is blocked
  int shift_;
  double side_, per_side_;   // side of a square, and its inverse
  BitGrid blocked_squares_;  // squares with a blocked cell; empty if shift is 0: squares are cells
  CornerSquares squares_;
  int coarseness_;
  double per_block_;              // inverse of the number of cells along the side of a block
  BitGrid blocked_blocks_;        // blocks with a blocked cell
  CornerSquares between_blocks_;  // distances of corners of blocks from `blocked_blocks_`
  std::size_t block_columns_;
  std::vector<std::uint16_t> blocks_;  // distance of each block's nearest point [1 / parts]
};

}  // namespace vandplan::geometry

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

/// Lengths and positions in cells, from the lower left corner of the frame. Immutable.
class DistanceField {
 public:
  /// Distances above it are not told apart, but by the coarse copy [cells].
  static constexpr double furthest = 255.0;

  /// Beside the field itself it keeps a coarse copy, of blocks of 2^coarseness times 2^coarseness
  /// cells: small enough to stay in the cache.
  DistanceField(const BlockedCells& cells, int coarseness);

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

  /// The square of the distance at a corner of cells, at most that of `furthest`.
  [[nodiscard]] std::uint32_t square_at(std::int32_t x, std::int32_t y) const noexcept {
    return squares_[static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x)];
  }

 private:
  static constexpr double parts = 16.0;       // of a cell, that the coarse copy counts
  static constexpr double half_a_cell = 0.5;  // beyond `last_x_` and `last_y_` the frame goes on

  void build_blocks(const BlockedCells& cells, int coarseness);

  double last_x_, last_y_;              // middle of the last cell
  double outside_is_free_;              // 1, or 0 where all ground outside is blocked
  std::size_t columns_;                 // of corners
  std::vector<std::uint16_t> squares_;  // of their distances
  double per_block_;                    // inverse of the cells along a side
  std::size_t block_columns_;
  std::vector<std::uint16_t> blocks_;  // distances of their nearest points, in parts, rounded down
};

}  // namespace vandplan::geometry

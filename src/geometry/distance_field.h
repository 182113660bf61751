// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the nearest blocked cell?
//
// Exact at the corners of the cells: the point of a cell that is nearest to a corner is a corner,
// too, so this is a distance transform of corners. In linear time: Meijster, Roerdink and
// Hesselink, "A general algorithm for computing distance transforms in linear time" (2000).

#include <algorithm>
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
  [[nodiscard]] double at_least(const Point& point) const noexcept {
    // The nearest point of the frame, but for its last half cell: nothing that lies in the frame is
    // nearer to the point itself than to the block of this one.
    const auto i = static_cast<std::size_t>(std::clamp(point.x, 0.0, last_x_) * per_block_);
    const auto j = static_cast<std::size_t>(std::clamp(point.y, 0.0, last_y_) * per_block_);
    return blocks_[j * block_columns_ + i] * (1 / parts);
  }

  /// The square of the distance at a corner of cells, at most that of `furthest`.
  [[nodiscard]] std::uint32_t square_at(std::int32_t x, std::int32_t y) const noexcept {
    return squares_[static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x)];
  }

 private:
  static constexpr double parts = 16.0;  // of a cell, that the coarse copy counts

  void build_blocks(const BlockedCells& cells, int coarseness);

  double last_x_, last_y_;              // middle of the last cell
  std::size_t columns_;                 // of corners
  std::vector<std::uint16_t> squares_;  // of their distances
  double per_block_;                    // inverse of the cells along a side
  std::size_t block_columns_;
  std::vector<std::uint16_t> blocks_;  // distances of their nearest points, in parts, rounded down
};

}  // namespace vandplan::geometry

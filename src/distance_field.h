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

#include "blocked_cells.h"

namespace vandplan {

/// Lengths and positions in cells, from the lower left corner of the frame. Immutable.
class DistanceField {
 public:
  /// Distances above it are not told apart [cells].
  static constexpr double furthest = 255.0;

  explicit DistanceField(const BlockedCells& cells);

  /// Between which two numbers a distance lies.
  struct Range {
    double least, most;
  };

  /// The distance of a point from the nearest blocked cell; above `furthest` at least `least`.
  [[nodiscard]] Range around(const Point& point) const noexcept {
    // Outside of the frame: nothing that lies in it is nearer than to the frame's nearest point.
    const double x = std::clamp(point.x, 0.0, last_x_);
    const double y = std::clamp(point.y, 0.0, last_y_);
    const auto i = static_cast<std::size_t>(x + 0.5);
    const auto j = static_cast<std::size_t>(y + 0.5);
    const double dx = x - static_cast<double>(i);
    const double dy = y - static_cast<double>(j);
    const double at_corner = std::sqrt(static_cast<double>(squares_[j * columns_ + i]));
    const double aside = std::sqrt(dx * dx + dy * dy);
    const double outside = std::abs(point.x - x) + std::abs(point.y - y);
    return {at_corner - aside, at_corner + aside + outside};
  }

  /// The square of the distance at a corner of cells, at most that of `furthest`.
  [[nodiscard]] std::uint32_t square_at(std::int32_t x, std::int32_t y) const noexcept {
    return squares_[static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x)];
  }

 private:
  std::size_t columns_;  // of corners
  double last_x_;
  double last_y_;
  std::vector<std::uint16_t> squares_;
};

}  // namespace vandplan

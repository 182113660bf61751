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

  /// Beside the field itself it keeps a coarse copy, of every 2^coarseness-th corner: small enough
  /// to stay in the cache.
  DistanceField(const BlockedCells& cells, int coarseness);

  /// Between which two numbers a distance lies.
  struct Range {
    double least, most;
  };

  /// The distance of a point from the nearest blocked cell; above `furthest` at least `least`.
  [[nodiscard]] Range around(const Point& point) const noexcept { return look_up(fine_, point); }

  /// The same from the coarse copy.
  [[nodiscard]] Range roughly_around(const Point& point) const noexcept {
    return look_up(coarse_, point);
  }

  /// The square of the distance at a corner of cells, at most that of `furthest`.
  [[nodiscard]] std::uint32_t square_at(std::int32_t x, std::int32_t y) const noexcept {
    return fine_.squares[static_cast<std::size_t>(y) * fine_.columns + static_cast<std::size_t>(x)];
  }

 private:
  /// Squared distances at corners that are `side` cells apart.
  struct Corners {
    double side;
    double last_x, last_y;  // of a corner [cells]
    std::size_t columns;
    std::vector<std::uint16_t> squares;
  };

  [[nodiscard]] static Range look_up(const Corners& corners, const Point& point) noexcept {
    // Outside of the frame: nothing that lies in it is nearer than to the frame's nearest point.
    const double x = std::clamp(point.x, 0.0, corners.last_x);
    const double y = std::clamp(point.y, 0.0, corners.last_y);
    const auto i = static_cast<std::size_t>(x / corners.side + 0.5);
    const auto j = static_cast<std::size_t>(y / corners.side + 0.5);
    const double dx = x - static_cast<double>(i) * corners.side;
    const double dy = y - static_cast<double>(j) * corners.side;
    const double square = corners.squares[j * corners.columns + i];
    const double aside = std::sqrt(dx * dx + dy * dy);
    const double outside = std::abs(point.x - x) + std::abs(point.y - y);
    return {std::sqrt(square) - aside, std::sqrt(square) + aside + outside};
  }

  Corners fine_;
  Corners coarse_;
};

}  // namespace vandplan

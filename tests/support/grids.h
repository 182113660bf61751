// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a test make a map without a file?

#include <string>
#include <utility>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/random.h"

namespace vandplan {

/// Rows from the top, as a map looks: '.' free, '#' occupied, '?' unknown.
inline OccupancyGrid grid_of(const std::vector<std::string>& rows, double resolution,
                             const Pose& origin = {}) {
  std::vector<Cell> cells;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      cells.push_back(c == '.' ? Cell::free : c == '#' ? Cell::occupied : Cell::unknown);
    }
  }
  return {.origin = origin,
          .resolution = resolution,
          .columns = static_cast<std::int32_t>(rows.front().size()),
          .rows = static_cast<std::int32_t>(rows.size()),
          .cells = std::move(cells)};
}

/// Every cell occupied with that probability.
inline OccupancyGrid random_grid(std::int32_t columns, std::int32_t rows, double density,
                                 Rng& rng) {
  std::vector<Cell> cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (Cell& cell : cells) cell = uniform01(rng) < density ? Cell::occupied : Cell::free;
  return {.columns = columns, .rows = rows, .cells = std::move(cells)};
}

/// The closed square of a cell.
inline Polygon square_of(const OccupancyGrid& grid, std::int32_t column, std::int32_t row) {
  Polygon square;
  for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    const Pose corner =
        compose(grid.origin, {(column + right) * grid.resolution, (row + up) * grid.resolution, 0});
    square.push_back({corner.x, corner.y});
  }
  return square;
}

/// The blocked cells, and what is around the grid if that is blocked.
inline std::vector<Polygon> squares_of(const OccupancyGrid& grid) {
  std::vector<Polygon> squares;
  for (std::int32_t row = 0; row < grid.rows; ++row) {
    for (std::int32_t column = 0; column < grid.columns; ++column) {
      if (is_blocked(grid, column, row)) squares.push_back(square_of(grid, column, row));
    }
  }
  if (grid.unknown_is_free) return squares;
  constexpr double far = 1e3;
  const double x = grid.columns * grid.resolution;
  const double y = grid.rows * grid.resolution;
  for (const Bounds& side : {Bounds{-far, 0, -far, far}, Bounds{x, far, -far, far},
                             Bounds{-far, far, -far, 0}, Bounds{-far, far, y, far}}) {
    Polygon& square = squares.emplace_back();
    for (const Point& p : {Point{side.x_min, side.y_min}, Point{side.x_max, side.y_min},
                           Point{side.x_max, side.y_max}, Point{side.x_min, side.y_max}}) {
      const Pose corner = compose(grid.origin, {p.x, p.y, 0});
      square.push_back({corner.x, corner.y});
    }
  }
  return squares;
}

}  // namespace vandplan

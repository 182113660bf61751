// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/cell_clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace vandplan::judge {
namespace {

struct Place2 {
  Real x, y;
};

/// The vehicle over the grid: in the frame of the grid, in metres.
struct Seat {
  Place2 axle;
  Place2 forward;  // unit vector
};

Seat seat_on(const OccupancyGrid& grid, const Position& position) {
  const Real turn = grid.origin.heading;
  const Real cos = std::cos(turn);
  const Real sin = std::sin(turn);
  const Real dx = position.x - grid.origin.x;
  const Real dy = position.y - grid.origin.y;
  const Real heading = position.heading - turn;
  return {{dx * cos + dy * sin, dy * cos - dx * sin}, {std::cos(heading), std::sin(heading)}};
}

/// First and last index of the cells between two places, one beyond the grid at most.
std::array<std::int32_t, 2> indices(Real low, Real high, Real side, std::int32_t count) {
  const auto index = [&](Real place) {
    return static_cast<std::int32_t>(std::clamp<Real>(std::floor(place / side), -1, count));
  };
  return {index(low), index(high)};
}

/// Whether a blocked cell has a side that is not another blocked cell's.
bool shows(const OccupancyGrid& grid, std::int32_t x, std::int32_t y) {
  return !is_blocked(grid, x - 1, y) || !is_blocked(grid, x + 1, y) ||
         !is_blocked(grid, x, y - 1) || !is_blocked(grid, x, y + 1);
}

/// Eight cells from (x, y) on, all of them in the grid.
std::uint64_t eight_cells(const OccupancyGrid& grid, std::int32_t x, std::int32_t y) {
  static_assert(static_cast<int>(Cell::free) == 0 && sizeof(Cell) == 1);
  std::uint64_t cells = 0;
  std::memcpy(&cells,
              grid.cells->data() +
                  static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns) +
                  static_cast<std::size_t>(x),
              sizeof cells);
  return cells;
}

/// How many cells from x on, up to `end`, do not show for sure: eights that are free, or occupied
/// among others that are.
std::int32_t hidden_run(const OccupancyGrid& grid, std::int32_t x, std::int32_t y,
                        std::int32_t end) {
  constexpr std::uint64_t occupied = 0x0101010101010101;
  static_assert(static_cast<int>(Cell::occupied) == 1);
  if (y < 1 || y + 1 >= grid.rows || x < 0) return 0;
  std::int32_t run = 0;
  for (; x + run + 8 <= std::min(end, grid.columns); run += 8) {
    const std::uint64_t cells = eight_cells(grid, x + run, y);
    if (cells == 0) continue;
    const bool is_inside = cells == occupied && eight_cells(grid, x + run, y - 1) == occupied &&
                           eight_cells(grid, x + run, y + 1) == occupied &&
                           is_blocked(grid, x + run - 1, y) && is_blocked(grid, x + run + 8, y);
    if (!is_inside) break;
  }
  return run;
}

/// The same as far as `most`, and no more than that.
double clearance_within(const Position& position, const Rectangle& body, const OccupancyGrid& grid,
                        double most) {
  const Seat seat = seat_on(grid, position);
  const Real side = grid.resolution;
  const auto [axle_x, axle_y] = std::array{indices(seat.axle.x, seat.axle.x, side, grid.columns)[0],
                                           indices(seat.axle.y, seat.axle.y, side, grid.rows)[0]};
  // The body holds its axle. If no cell that shows touches the body, the body is in blocked cells
  // exactly if the axle is.
  if (is_blocked(grid, axle_x, axle_y)) return 0.0;
  const auto seen = [&](Real x, Real y) {  // from the vehicle
    const Real dx = x - seat.axle.x;
    const Real dy = y - seat.axle.y;
    return Point{static_cast<double>(dx * seat.forward.x + dy * seat.forward.y),
                 static_cast<double>(dy * seat.forward.x - dx * seat.forward.y)};
  };
  double least = most;
  // A box around the body and `most` more.
  const Real middle_x = (body.x_min + body.x_max) / 2;
  const Real middle_y = (body.y_min + body.y_max) / 2;
  const Real half_length = (body.x_max - body.x_min) / 2;
  const Real half_width = (body.y_max - body.y_min) / 2;
  const Real cos = std::abs(seat.forward.x);
  const Real sin = std::abs(seat.forward.y);
  const Real x = seat.axle.x + middle_x * seat.forward.x - middle_y * seat.forward.y;
  const Real y = seat.axle.y + middle_x * seat.forward.y + middle_y * seat.forward.x;
  const Real reach_x = half_length * cos + half_width * sin + most;
  const Real reach_y = half_length * sin + half_width * cos + most;
  const auto columns = indices(x - reach_x, x + reach_x, side, grid.columns);
  const auto rows = indices(y - reach_y, y + reach_y, side, grid.rows);
  const double half_diagonal = grid.resolution * std::sqrt(0.5);
  for (std::int32_t row = rows[0]; row <= rows[1]; ++row) {
    for (std::int32_t column = columns[0]; column <= columns[1]; ++column) {
      column += hidden_run(grid, column, row, columns[1]);
      if (!is_blocked(grid, column, row) || !shows(grid, column, row)) continue;
      const Point centre = seen((column + Real{0.5}) * side, (row + Real{0.5}) * side);
      if (distance_to_rectangle(centre, body) - half_diagonal >= least) continue;
      Point a = seen(column * side, (row + 1) * side);
      for (const auto& [right, up] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        const Point b = seen((column + right) * side, (row + up) * side);
        least = std::min(least, distance_of_side(a, b, body));
        a = b;
      }
    }
  }
  return least;
}

}  // namespace

double clearance(const Position& position, const Rectangle& body, const OccupancyGrid& grid) {
  constexpr double first_look = 1.0;  // how far it looks at first [m]
  const double to_origin =
      static_cast<double>(std::hypot(position.x - grid.origin.x, position.y - grid.origin.y));
  const double furthest = to_origin + (grid.columns + grid.rows + 2.0) * grid.resolution;
  for (double most = first_look;; most *= 2) {
    const double distance = clearance_within(position, body, grid, most);
    if (distance < most) return distance;
    if (most > furthest) return std::numeric_limits<double>::infinity();
  }
}

}  // namespace vandplan::judge

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a test make a costmap and a robot?

#include <cstdint>
#include <string>
#include <vector>

#include "ros/adapter/planner.h"
#include "vandplan/random.h"

namespace vandplan::ros {

/// A costmap that owns its costs: free at first, with the corner of cell (0, 0) at `origin`.
class OwnedCostmap {
 public:
  OwnedCostmap(std::int32_t columns, std::int32_t rows, double resolution, const Pose& origin = {})
      : costs_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0),
        shape_{.columns = columns, .rows = rows, .resolution = resolution, .origin = origin} {}

  /// Sets the cost of all cells in a range.
  void fill(const CellRange& range, std::uint8_t cost) {
    for (std::int32_t row = range.row; row < range.row + range.rows; ++row) {
      for (std::int32_t column = range.column; column < range.column + range.columns; ++column) {
        at(column, row) = cost;
      }
    }
  }
  [[nodiscard]] std::uint8_t& at(std::int32_t column, std::int32_t row) {
    return costs_[static_cast<std::size_t>(row) * static_cast<std::size_t>(shape_.columns) +
                  static_cast<std::size_t>(column)];
  }
  [[nodiscard]] std::vector<std::uint8_t>& costs() { return costs_; }
  [[nodiscard]] Costmap view() const {
    Costmap costmap = shape_;
    costmap.costs = costs_;
    return costmap;
  }

 private:
  std::vector<std::uint8_t> costs_;
  Costmap shape_;
};

/// A room of 20 x 12 m in cells of 0.1 m. A wall from below up to y = 8 m stands at x = 10 m.
inline OwnedCostmap walled_room() {
  OwnedCostmap room(200, 120, 0.1);
  room.fill({98, 0, 4, 80}, nav2_lethal_cost);
  return room;
}

/// Poses in that room, on either side of the wall.
inline constexpr Pose left{3, 3, 0};
inline constexpr Pose right{17, 3, 0};

/// A robot of 0.6 x 0.4 m, whose base_link is the midpoint of its rear axle.
inline Robot small_robot() {
  return {.footprint = {{0.5, 0.2}, {-0.1, 0.2}, {-0.1, -0.2}, {0.5, -0.2}}};
}

/// A wish that is answered after so many iterations, with equal bits each time.
inline Request small_request(const Pose& start, const Pose& goal, std::int64_t iterations = 2000,
                             Parameters::Values values = {}) {
  values.emplace("max_iterations", iterations);
  Parameters parameters;
  parameters.set(values);
  Request request = request_of(parameters, small_robot());
  request.start = start;
  request.goals = {goal};
  return request;
}

/// Any range within a map, at times of a whole side of it.
inline CellRange any_range(std::int32_t columns, std::int32_t rows, Rng& rng) {
  const auto any = [&](std::int32_t count) {
    const double share = uniform01(rng) < 0.1 ? 1.0 : uniform01(rng);
    return std::max<std::int32_t>(1, static_cast<std::int32_t>(share * count));
  };
  CellRange range{.columns = any(columns), .rows = any(rows)};
  range.column = static_cast<std::int32_t>(uniform01(rng) * (columns - range.columns + 1));
  range.row = static_cast<std::int32_t>(uniform01(rng) * (rows - range.rows + 1));
  return range;
}

}  // namespace vandplan::ros

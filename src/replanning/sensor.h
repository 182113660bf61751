// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a vehicle see of its surroundings?
//
// Rays go from the middle of the vehicle in all directions, up to a range. Each ends at the first
// cell or obstacle in its way. A cell is seen if a ray passes it or ends at it. An obstacle is seen
// as a whole if a ray ends at it.

#include <memory>
#include <vector>

#include "vandplan/replanner.h"

namespace vandplan::replanning {

/// The scenario before anything is seen: all cells are unknown, and there are no obstacles,
/// standing or moving. Kerbs are known, as every map shows them.
[[nodiscard]] Scenario unseen(const Scenario& scenario);

class Sensor {
 public:
  /// `scenario` is kept by reference. `range` is the length of the rays [m].
  Sensor(const Scenario& scenario, double range);

  /// Cells and obstacles that are seen from `pose` (scenario's frame) and were unknown until then.
  [[nodiscard]] WorldPatch look(const Pose& pose);

 private:
  struct Side {
    Point from, to;
    std::size_t polygon;
  };
  struct Ray {
    Point from;
    Point along;  // unit vector of the direction
  };
  [[nodiscard]] double mark_cells(const Ray& ray);
  void mark(std::int32_t column, std::int32_t row);
  [[nodiscard]] CellPatch new_cells();

  const Scenario& scenario_;
  double range_;
  std::vector<Side> sides_;
  std::vector<bool> is_known_;  // whether each obstacle is known
  std::vector<Cell> known_;     // cells of the map as they are known
  // Range of the cells that became known since the last patch; empty if `last_column_` is less than
  // `first_column_`.
  std::int32_t first_column_ = 0, last_column_ = -1, first_row_ = 0, last_row_ = -1;
};

/// Moving obstacles that are seen from `pose` at time `t` [s], with predicted trajectories.
/// `options` has the range and the prediction.
[[nodiscard]] std::vector<MovingObstacle> predicted(const std::vector<MovingObstacle>& moving,
                                                    const Pose& pose, double t,
                                                    const LiveDriveOptions& options);

}  // namespace vandplan::replanning

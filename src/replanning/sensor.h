// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a vehicle see of its surroundings?
//
// Rays in all directions from the middle of the vehicle, up to a range: they end at the first cell
// or obstacle in their way. A cell that a ray passes or ends at is seen; of an obstacle all of it.

#include <memory>
#include <vector>

#include "vandplan/live_drive.h"

namespace vandplan::replanning {

/// The scenario to someone who has seen nothing yet: cells are unknown, obstacles and movers not
/// there. Kerbs are known: they are drawn in every map.
[[nodiscard]] Scenario unseen(const Scenario& scenario);

class Sensor {
 public:
  /// The scenario stays where it is as long as the sensor is used.
  Sensor(const Scenario& scenario, double range);

  /// What is seen from a pose for the first time.
  [[nodiscard]] WorldPatch look(const Pose& pose);

 private:
  struct Side {
    Point from, to;
    std::size_t polygon;
  };
  struct Ray {
    Point from;
    Point along;  // unit vector
  };
  [[nodiscard]] double mark_cells(const Ray& ray);
  void mark(std::int32_t column, std::int32_t row);
  [[nodiscard]] CellPatch new_cells();

  const Scenario& scenario_;
  double range_;
  std::vector<Side> sides_;
  std::vector<bool> is_known_;  // of the obstacles
  std::vector<Cell> known_;     // of the map
  std::int32_t first_column_ = 0, last_column_ = -1, first_row_ = 0, last_row_ = -1;  // new ones
};

/// What of all that moves is seen from a pose at a time, and how it is thought to go on.
[[nodiscard]] std::vector<MovingObstacle> predicted(const std::vector<MovingObstacle>& moving,
                                                    const Pose& pose, double t,
                                                    const LiveDriveOptions& options);

}  // namespace vandplan::replanning

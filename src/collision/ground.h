// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What can a vehicle hit? The part of collision checks that all vehicles share.

#include <memory>
#include <vector>

#include "collision/grid_obstacles.h"
#include "collision/obstacles.h"
#include "vandplan/collision.h"

namespace vandplan::collision {

/// Obstacles of the surroundings, indexed for fast queries.
struct Ground {
  explicit Ground(const Surroundings& surroundings)
      : bounds(surroundings.bounds), walls(surroundings.obstacles), kerbs(surroundings.kerbs) {
    for (const Polygon& area : surroundings.inside) inside.emplace_back(std::vector<Polygon>{area});
    if (surroundings.map) map = std::make_shared<GridObstacles>(*surroundings.map);
  }

  Bounds bounds;
  Obstacles walls;  ///< Obstacles for the body.
  Obstacles kerbs;  ///< Obstacles for the wheels alone.
  /// Areas, one of which must contain the start; empty: anywhere.
  std::vector<Obstacles> inside = {};
  std::shared_ptr<GridObstacles> map = {};  ///< Map shared by all checkers; null: no map.
};

}  // namespace vandplan::collision

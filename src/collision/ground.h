// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What can be hit, whoever drives? The part of collision checks that vehicles share.

#include <memory>
#include <vector>

#include "collision/grid_obstacles.h"
#include "collision/obstacles.h"
#include "vandplan/collision.h"

namespace vandplan::collision {

/// Surroundings, ready to be asked quickly.
struct Ground {
  explicit Ground(const Surroundings& surroundings)
      : bounds(surroundings.bounds), walls(surroundings.obstacles), kerbs(surroundings.kerbs) {
    for (const Polygon& area : surroundings.inside) inside.emplace_back(std::vector<Polygon>{area});
    if (surroundings.map) map = std::make_shared<GridObstacles>(*surroundings.map);
  }

  Bounds bounds;
  Obstacles walls;                          ///< the body keeps clear of them
  Obstacles kerbs;                          ///< the wheels do
  std::vector<Obstacles> inside = {};       ///< areas, in one of which all begins; none: anywhere
  std::shared_ptr<GridObstacles> map = {};  ///< that all who have it share; none: there is no map
};

}  // namespace vandplan::collision

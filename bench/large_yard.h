// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// A yard of 200 m with ten obstacles, as polygons and as 4000 x 4000 cells.

#include <algorithm>
#include <vector>

#include "support/collision_oracle.h"
#include "vandplan/geometry.h"
#include "vandplan/random.h"
#include "vandplan/vehicle.h"

namespace vandplan {

inline constexpr double side = 200.0;  // [m]
inline constexpr std::int32_t cells = 4000;
inline constexpr Bounds yard{0, side, 0, side};

inline std::vector<Polygon> ten_obstacles() {
  Rng rng(7);
  std::vector<Polygon> obstacles;
  for (int i = 0; i < 10; ++i) {
    const Pose middle = uniform_pose({20, side - 20, 20, side - 20}, rng);
    const double length = uniform(5, 40, rng);
    const double width = uniform(3, 15, rng);
    const Footprint box{length / 2, length / 2, width / 2};
    const auto outline = corners(box, middle);
    obstacles.emplace_back(outline.begin(), outline.end());
  }
  return obstacles;
}

inline OccupancyGrid drawn(const std::vector<Polygon>& obstacles) {
  std::vector<Cell> ground(std::size_t{cells} * cells, Cell::free);
  const double resolution = side / cells;
  for (const Polygon& obstacle : obstacles) {
    const Bounds box = bounding_box(obstacle);
    const auto index = [&](double x) {
      return std::clamp(static_cast<std::int32_t>(x / resolution), 0, cells - 1);
    };
    for (std::int32_t y = index(box.y_min); y <= index(box.y_max); ++y) {
      for (std::int32_t x = index(box.x_min); x <= index(box.x_max); ++x) {
        if (!contains(obstacle, {(x + 0.5) * resolution, (y + 0.5) * resolution})) continue;
        ground[static_cast<std::size_t>(y) * cells + static_cast<std::size_t>(x)] = Cell::occupied;
      }
    }
  }
  return {.resolution = resolution, .columns = cells, .rows = cells, .cells = std::move(ground)};
}

}  // namespace vandplan

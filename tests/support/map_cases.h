// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which vehicles, edges and maps do the laws of maps run through?

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/collision_oracle.h"
#include "support/draws.h"
#include "support/grids.h"
#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan {

inline Path any_edge(Rng& rng) { return any_edge({-10, 10, -10, 10}, rng); }

/// Turned, around the origin, with few blocked cells.
inline OccupancyGrid any_grid(Rng& rng) {
  const auto side = [&] { return static_cast<std::int32_t>(any_size(1, 120, rng)); };
  const std::int32_t columns = side();
  const std::int32_t rows = side();
  OccupancyGrid grid = random_grid(columns, rows, any_size(0.3, 6, rng) / columns / rows, rng);
  grid.unknown_is_free = true;
  grid.resolution = any_size(0.02, 4, rng);
  const double turn = chance(0.3, rng) ? 0 : uniform(-std::numbers::pi, std::numbers::pi, rng);
  const Pose turned{uniform(-12, 12, rng), uniform(-12, 12, rng), turn};
  grid.origin = compose(turned, {-columns * grid.resolution / 2, -rows * grid.resolution / 2, 0});
  return grid;
}

/// Moves the map so that the edge just touches or just misses what is nearest.
inline void graze(OccupancyGrid& grid, const OracleBody& body, const Path& path, Rng& rng,
                  double margin = 0.0) {
  const Gap gap = least_gap(body, squares_of(grid), path, 1e-3);
  if (gap.distance == 0 || std::isinf(gap.distance)) return;
  const double wanted = chance(0.7, rng) ? uniform(-2e-3, 4e-3, rng) : any_size(1e-5, 1, rng);
  const double part = 1 - (margin + wanted) / gap.distance;
  grid.origin.x += part * (gap.on_body.x - gap.on_obstacle.x);
  grid.origin.y += part * (gap.on_body.y - gap.on_obstacle.y);
}

}  // namespace vandplan

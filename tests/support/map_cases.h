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

inline Vehicle any_vehicle(Rng& rng) {
  Vehicle vehicle;
  if (chance(0.7, rng)) {
    vehicle = {.wheelbase = any_size(0.3, 8, rng),
               .front_overhang = chance(0.2, rng) ? 0 : any_size(0.1, 3, rng),
               .rear_overhang = chance(0.2, rng) ? 0 : any_size(0.1, 5, rng),
               .width = any_size(0.2, 4, rng)};
  }
  vehicle.min_turning_radius = 1e-3;
  return vehicle;
}

inline Segment any_segment(Rng& rng) {
  const double kind = uniform01(rng);
  Segment segment;
  if (kind < 0.6) segment.curvature = any_sign(1 / uniform(2, 12, rng), rng);
  if (kind < 0.1) segment.curvature = any_sign(1 / any_size(0.02, 2, rng), rng);
  if (kind > 0.8) segment.curvature = any_sign(any_size(1e-12, 0.1, rng), rng);
  const double most = std::min(30.0, 9 / std::abs(segment.curvature));
  const double length = chance(0.05, rng) ? 0 : any_size(chance(0.1, rng) ? 1e-6 : 0.02, most, rng);
  segment.length = any_sign(length, rng);
  return segment;
}

inline Path any_edge(Rng& rng) {
  Path path{uniform_pose({-10, 10, -10, 10}, rng), {}};
  const int count = chance(0.7, rng) ? 1 : 3;
  for (int i = 0; i < count; ++i) path.segments.push_back(any_segment(rng));
  return path;
}

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
inline void graze(OccupancyGrid& grid, const Footprint& body, const Path& path, Rng& rng) {
  const Gap gap = least_gap(body, squares_of(grid), path, 1e-3);
  if (gap.distance == 0 || std::isinf(gap.distance)) return;
  const double wanted = chance(0.7, rng) ? uniform(-2e-3, 4e-3, rng) : any_size(1e-5, 1, rng);
  const double part = 1 - wanted / gap.distance;
  grid.origin.x += part * (gap.on_body.x - gap.on_obstacle.x);
  grid.origin.y += part * (gap.on_body.y - gap.on_obstacle.y);
}

}  // namespace vandplan

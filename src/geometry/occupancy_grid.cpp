// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/geometry.h"

namespace vandplan {

Polygon outline(const OccupancyGrid& grid) {
  const double width = grid.columns * grid.resolution;
  const double height = grid.rows * grid.resolution;
  Polygon corners;
  for (const Point& p : {Point{0, 0}, {width, 0}, {width, height}, {0, height}}) {
    const Pose corner = compose(grid.origin, {p.x, p.y, 0});
    corners.push_back({corner.x, corner.y});
  }
  return corners;
}

}  // namespace vandplan

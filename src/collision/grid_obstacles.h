// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does the footprint touch a blocked cell while one segment is driven?
//
// The distance field decides where obstacles are far away. Elsewhere the cells nearby are tested in
// closed form, whole blocks first. Theory and proof: docs/algorithms/occupancy_grid.md.

#include "collision/disc_trace.h"
#include "collision/sweep.h"
#include "geometry/blocked_cells.h"
#include "geometry/distance_field.h"
#include "vandplan/geometry.h"
#include "vandplan/vehicle.h"

namespace vandplan::collision {

using geometry::BitGrid, geometry::BlockedCells, geometry::CellBox, geometry::DistanceField;

/// Body, and discs that cover it.
struct CoveredShape {
  const Shape& shape;
  const DiscRow& slim;
};

/// Blocked cells of a grid as obstacles.
class GridObstacles {
 public:
  explicit GridObstacles(const OccupancyGrid& grid);

  /// Updates the cells in `changed` from the grid. Equal to a new object, and much faster.
  void update(const OccupancyGrid& grid, const CellRange& changed);

  /// Whether a point lies in a blocked cell.
  [[nodiscard]] bool contain(const Point& point) const noexcept;

  /// Whether no edge cell comes within `margin` [m] of the body while the segment is driven. If the
  /// rear axle also starts in no blocked cell, the segment is free: the body enters an area only
  /// across its edge. `discs` must cover the body with its margin.
  [[nodiscard]] bool is_clear(const Shape& body, double margin, const DiscRows& discs,
                              const PlacedSegment& placed) const noexcept;

  /// Distance of the body from the nearest edge cell, at most `most` [m]. If it is at least
  /// `enough`, the result is some number from `enough` to it.
  [[nodiscard]] double clearance(const CoveredShape& body, const Placement& placement, double most,
                                 double enough) const noexcept;

  /// Bounds on the distance of a point from the nearest blocked cell [m].
  [[nodiscard]] DistanceField::Range distance(const Point& point) const noexcept;

  /// Whether a blocked cell is within `distance` [m] of a point.
  [[nodiscard]] bool is_within(const Point& point, double distance) const noexcept;

 private:
  class Neighbourhood;
  class Search;

  /// Converts to the frame of the cells [m].
  [[nodiscard]] Point in_frame(const Point& point) const noexcept;
  [[nodiscard]] PlacedSegment in_frame(const PlacedSegment& placed) const noexcept;
  [[nodiscard]] CellBox cells_in(const Bounds& box) const noexcept;

  Point origin_;  // Origin of the frame of the cells.
  Point along_;   // Unit vector of the frame's x axis.
  double side_;   // Side of a cell [m].
  BlockedCells cells_;
  DistanceField field_;
  int block_shift_;  // A block has 2^block_shift_ cells along a side.
  BitGrid blocks_;   // Blocks that contain an edge cell.
};

}  // namespace vandplan::collision

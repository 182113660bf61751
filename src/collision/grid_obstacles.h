// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does the footprint touch a blocked cell while one segment is driven?
//
// The distance field frees what is far from everything; for the rest, cells nearby are tested in
// closed form, blocks of them at once. Theory and proof: docs/algorithms/occupancy_grid.md.

#include "collision/disc_trace.h"
#include "collision/sweep.h"
#include "geometry/blocked_cells.h"
#include "geometry/distance_field.h"
#include "vandplan/occupancy_grid.h"
#include "vandplan/vehicle.h"

namespace vandplan::collision {

using geometry::BitGrid, geometry::BlockedCells, geometry::CellBox, geometry::DistanceField;

/// A body, and discs that cover it.
struct CoveredShape {
  const Shape& shape;
  const DiscRow& slim;
};

/// The blocked cells of a grid as obstacles.
class GridObstacles {
 public:
  explicit GridObstacles(const OccupancyGrid& grid);

  /// Some cells of the grid have become others: as if made anew, and much faster.
  void update(const OccupancyGrid& grid, const CellRange& changed);

  /// Whether the point lies in a blocked cell.
  [[nodiscard]] bool contain(const Point& point) const noexcept;

  /// Whether no edge cell comes within a margin of the body [m] while the segment is driven.
  /// Together with a start whose rear axle is in no blocked cell that is all: whatever is entered
  /// later is entered there. `discs` are those of the body with its margin.
  [[nodiscard]] bool is_clear(const Shape& body, double margin, const DiscRows& discs,
                              const PlacedSegment& placed) const noexcept;

  /// Distance of the body from the nearest edge cell, no more than `most` [m]; if it is at least
  /// `enough`, any number from `enough` to it.
  [[nodiscard]] double clearance(const CoveredShape& body, const Placement& placement, double most,
                                 double enough) const noexcept;

  /// Between which two numbers the distance of the point from the nearest blocked cell lies [m].
  [[nodiscard]] DistanceField::Range distance(const Point& point) const noexcept;

  /// Whether a blocked cell is at most this far from the point [m].
  [[nodiscard]] bool is_within(const Point& point, double distance) const noexcept;

 private:
  class Neighbourhood;
  class Search;

  /// Into the frame of the cells, in metres.
  [[nodiscard]] Point in_frame(const Point& point) const noexcept;
  [[nodiscard]] PlacedSegment in_frame(const PlacedSegment& placed) const noexcept;
  [[nodiscard]] CellBox cells_in(const Bounds& box) const noexcept;

  Point origin_;  // of the frame of the cells
  Point along_;   // unit vector of its x axis
  double side_;   // of a cell [m]
  BlockedCells cells_;
  DistanceField field_;
  int block_shift_;  // a block has 2^block_shift_ cells to a side
  BitGrid blocks_;   // with an edge cell
};

}  // namespace vandplan::collision

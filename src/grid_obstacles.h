// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does the footprint touch a blocked cell while one segment is driven?
//
// The distance field frees most of the way; where it cannot, the cells nearby are tested in closed
// form. Theory and proof: docs/algorithms/occupancy_grid.md.

#include <array>
#include <vector>

#include "blocked_cells.h"
#include "distance_field.h"
#include "sweep.h"
#include "vandplan/occupancy_grid.h"
#include "vandplan/vehicle.h"

namespace vandplan {

/// The blocked cells of a grid as obstacles for one footprint. Immutable.
class GridObstacles {
 public:
  GridObstacles(const OccupancyGrid& grid, const Footprint& body);

  /// Whether the point lies in a blocked cell.
  [[nodiscard]] bool contain(const Point& point) const noexcept;

  /// Whether no edge cell is touched while the segment is driven. Together with a start whose
  /// rear axle is in no blocked cell that is all: whatever is entered later is entered there.
  [[nodiscard]] bool is_clear(const PlacedSegment& placed) const noexcept;

  /// Whether a blocked cell is at most this far from the point [m].
  [[nodiscard]] bool is_within(const Point& point, double distance) const noexcept;

 private:
  /// A part of the footprint from its left to its right side, in a disc.
  struct Slice {
    double x;       // of its middle, ahead of the rear axle [m]
    double radius;  // of the disc around it [m]
    double inner;   // of the largest disc around its middle in the footprint [m]
  };
  class Drive;

  /// The same in the frame of the cells, in metres.
  [[nodiscard]] Point in_frame(const Point& point) const noexcept;
  [[nodiscard]] PlacedSegment in_frame(const PlacedSegment& placed) const noexcept;
  [[nodiscard]] DistanceField::Range distance(const Point& point) const noexcept;
  [[nodiscard]] DistanceField::Range rough_distance(const Point& point) const noexcept;
  [[nodiscard]] CellBox cells_in(const Bounds& box) const noexcept;
  [[nodiscard]] bool is_near(const Point& from, const Sweep& sweep) const noexcept;
  [[nodiscard]] std::vector<Slice> sliced(double length) const;

  Point origin_;  // of the frame of the cells
  Point along_;   // unit vector of its x axis
  double side_;   // of a cell [m]
  Footprint body_;
  Slice whole_;  // all of the footprint
  std::vector<Slice> slices_;
  std::vector<Slice> halves_;  // two for each slice
  BlockedCells cells_;
  BitGrid blocks_;  // with an edge cell
  int shift_ = 0;   // a block has 2^shift cells to a side
  DistanceField field_;
  double rough_error_;  // no rough bound of a distance is further from an exact one [m]
};

}  // namespace vandplan

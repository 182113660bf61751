// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where can the centre of a disc be? Rows of square cells, each computed when asked for.
//
// A cell is closed if an obstacle is within `near` of its middle. If `near` is at most the disc's
// radius less half the diagonal of a cell, the centre cannot be in a closed cell. Kerbs are
// ignored, as the body may swing over them.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "vandplan/problem.h"

namespace vandplan::search {

/// Disc inside the body: distance of its centre ahead of the rear axle, and radius [m].
struct Disc {
  double ahead, radius;
};

/// Widest disc inside the body; of several, the one with its centre nearest to the rear axle.
[[nodiscard]] Disc widest_disc(const Vehicle& vehicle);

/// Disc for lower bounds on lengths: the widest one if its centre hardly moves further than the
/// rear axle. Otherwise the disc around the rear axle, unless that has no radius.
[[nodiscard]] Disc bound_disc(const Vehicle& vehicle);

/// Metres that the centre of a disc moves for each metre of the rear axle, at most.
[[nodiscard]] double stretch_of(const Disc& disc, double turning_radius) noexcept;

/// Centre of a disc at a pose of the vehicle.
[[nodiscard]] Point centre_of(const Disc& disc, const Pose& pose) noexcept;

/// An area that a point, such as the centre of a disc, cannot be near: its distance from the area
/// is at least `near`. A negative number counts from the edge inwards, so the point may be in the
/// area, but not as deep.
struct ClosedArea {
  Polygon area;
  double near;  // [m]
};

/// Lattice over a box. Row 0 is the lowest, column 0 the leftmost.
class OpenRows {
 public:
  /// Open cells side by side, with columns `begin` to `end` - 1.
  struct Run {
    std::int32_t begin, end;
  };
  using Row = std::vector<Run>;

  /// Lattice without cells.
  OpenRows() = default;
  /// The task must outlive the lattice. `side`: side of a cell [m]; `near`: distance from a cell's
  /// middle to obstacles that close it [m]. The box must be shorter than 2^30 cells. Cells whose
  /// points are all too near to an area of `closed` are closed, too.
  OpenRows(const Task& task, const Bounds& box, double side, double near,
           std::vector<ClosedArea> closed = {});

  [[nodiscard]] std::int32_t columns() const noexcept { return columns_; }
  [[nodiscard]] std::int32_t rows() const noexcept { return rows_; }

  /// Runs of open cells of a row, from left to right. The reference stays valid.
  [[nodiscard]] const Row& row(std::int32_t y);
  [[nodiscard]] bool is_known(std::int32_t y) const { return known_.contains(y); }
  /// Work for all rows so far: number of sides and map places looked at.
  [[nodiscard]] std::int64_t looks() const noexcept { return looks_; }

  /// Coordinates of a point in cells, from the lattice's lower left corner.
  [[nodiscard]] Point in_cells(const Point& point) const noexcept {
    return {(point.x - box_.x_min) / side_, (point.y - box_.y_min) / side_};
  }

 private:
  /// Side of an obstacle, and the range of heights within `near` of it.
  struct Side {
    Point a, b;
    double y_min, y_max;
  };

  [[nodiscard]] double place_of(double x) const noexcept;
  void close(double low, double high);
  void sort_into_bands();
  [[nodiscard]] std::size_t band_of(double y) const noexcept;
  void close_near_sides(double y);
  void close_near_map(double y);
  void close_area(const ClosedArea& closed, double y);

  const Task* task_ = nullptr;
  Bounds box_ = {};
  double side_ = 1.0;
  double near_ = 0.0;
  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  std::vector<ClosedArea> areas_;  // `near` counts from middles of cells
  std::vector<Side> sides_;
  // Horizontal bands of the box from below, with the sides that reach into each in their order. A
  // row then looks at few sides.
  std::size_t bands_ = 1;
  /// First place of each band in `band_sides_`, and the end.
  std::vector<std::uint32_t> band_begins_;
  std::vector<std::uint32_t> band_sides_;
  Bounds map_box_ = {};  // Box around all cells that the map can close.
  std::unordered_map<std::int32_t, Row> known_;
  Row closed_;  // Closed cells of the row being computed, in any order.
  std::int64_t looks_ = 0;
};

}  // namespace vandplan::search

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where may the centre of a disc be? Rows of square cells, each worked out when it is asked for.
//
// A cell is open unless something is within `near` of its middle. With `near` at most the radius of
// the disc less half the diagonal of a cell, a closed cell holds no place for the centre. Kerbs are
// left out, as a body may swing over them.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "vandplan/problem.h"

namespace vandplan::search {

/// A disc that the body holds: its centre is so far ahead of the rear axle [m].
struct Disc {
  double ahead, radius;
};

/// The widest one that the body holds, and its centre as near to the rear axle as may be.
[[nodiscard]] Disc widest_disc(const Vehicle& vehicle);

/// The disc that bounds of lengths are made with: the widest one where its centre goes hardly
/// further than the rear axle, or where the other one, around the rear axle, is nothing.
[[nodiscard]] Disc bound_disc(const Vehicle& vehicle);

/// How far the centre of a disc goes at most while the rear axle goes a metre [m].
[[nodiscard]] double stretch_of(const Disc& disc, double turning_radius) noexcept;

/// Where the centre of a disc is.
[[nodiscard]] Point centre_of(const Disc& disc, const Pose& pose) noexcept;

/// A lattice over a box. Row 0 is the lowest, column 0 the leftmost.
class OpenRows {
 public:
  /// Open cells side by side, from column `begin` to before `end`.
  struct Run {
    std::int32_t begin, end;
  };
  using Row = std::vector<Run>;

  /// A lattice without cells.
  OpenRows() = default;
  /// The task outlives the lattice. `side` is that of a cell [m], `near` the distance from its
  /// middle [m]; there are fewer than 2^30 cells along the box.
  OpenRows(const Task& task, const Bounds& box, double side, double near);

  [[nodiscard]] std::int32_t columns() const noexcept { return columns_; }
  [[nodiscard]] std::int32_t rows() const noexcept { return rows_; }

  /// The runs of a row from left to right; the reference stays valid.
  [[nodiscard]] const Row& row(std::int32_t y);
  [[nodiscard]] bool is_known(std::int32_t y) const { return known_.contains(y); }
  /// How many looks at sides of polygons and at the map it took to work out all rows so far.
  [[nodiscard]] std::int64_t looks() const noexcept { return looks_; }

  /// A point in cells from the corner of the lattice.
  [[nodiscard]] Point in_cells(const Point& point) const noexcept {
    return {(point.x - box_.x_min) / side_, (point.y - box_.y_min) / side_};
  }

 private:
  /// A side of an obstacle, and the heights at which it is near to something.
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

  const Task* task_ = nullptr;
  Bounds box_ = {};
  double side_ = 1.0;
  double near_ = 0.0;
  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  std::vector<Side> sides_;
  // The box in bands from below: the sides of each, in their order, so that a row asks few.
  std::size_t bands_ = 1;
  std::vector<std::uint32_t> band_begins_;  // in `band_sides_`, and the end
  std::vector<std::uint32_t> band_sides_;
  Bounds map_box_ = {};  // around all cells that the map can close
  std::unordered_map<std::int32_t, Row> known_;
  Row closed_;  // of the row that is being worked out, in any order
  std::int64_t looks_ = 0;
};

}  // namespace vandplan::search

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is a path at least that passes through a box of poses?
//
// A box is a cell of a lattice, for the centre of a disc in the body, and an interval of headings.
// A box is closed if no path, or none short enough, passes through it. Proof:
// docs/proofs/anytime_bounds.md.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "search/geodesic_field.h"
#include "search/one_way.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// Boxes of poses around all paths up to a length, each with a lower bound on the paths through it.
class PoseBoxes {
 public:
  using Id = std::uint32_t;
  struct Range {
    double least, most;
  };
  /// Bounds for all poses of a box [m]. Ways: of the disc's centre, from the start and to the goal.
  /// `from_start`, `to_goal`: lower bounds on paths, by ways around obstacles and by turning.
  struct Box {
    Pose middle;
    Range way_from_start, way_to_goal;
    double from_start, to_goal;
  };
  /// Cell where the disc's centre can be at some distance from the start, and its way to the goal
  /// [m].
  struct Crossing {
    std::int32_t x, y;
    Range way_to_goal;
  };

  /// Boxes of cells with side `side` [m] around all ways up to `longest` [m]. `only`: gear of all
  /// paths, 0 for both. If `is_usable` is false afterwards, the boxes are too many or too coarse to
  /// prove anything, and nothing may be asked.
  PoseBoxes(const Task& task, double side, double longest, GearSign only = 0);
  PoseBoxes(const PoseBoxes&) = delete;
  PoseBoxes& operator=(const PoseBoxes&) = delete;

  [[nodiscard]] bool is_usable() const noexcept { return is_usable_; }
  /// Does some of the work of measuring ways around obstacles, which must be finished before
  /// queries. True when it is finished.
  bool prepare(std::int64_t work);

  /// Box that contains a pose of the task.
  [[nodiscard]] Id box_of(const Pose& pose);
  /// Boxes in which paths may begin or end at a pose of the task, as far as the judge's tolerance
  /// tells. Without one-way streets it does not matter which, and there is one.
  [[nodiscard]] std::array<Id, 4> boxes_of_end(const Pose& pose);
  /// The six boxes that share a face with a box; the box itself where the lattice ends, or where no
  /// path crosses the face: `is_onward`: from the box, else into it.
  [[nodiscard]] std::array<Id, 6> neighbours(Id box, bool is_onward);
  /// Lower bound on the length of all paths through a box [m]; infinite if it is closed.
  [[nodiscard]] float length_lower_bound(Id box);
  /// Number of boxes so far, above all their ids. Neighbours add boxes.
  [[nodiscard]] std::size_t size() const noexcept { return length_bounds_.size(); }
  [[nodiscard]] bool is_full() const noexcept;
  /// Number of boxes whose length was computed so far.
  [[nodiscard]] std::int64_t looks() const noexcept { return looks_; }

  [[nodiscard]] Id headings() const noexcept { return headings_; }
  [[nodiscard]] double side() const noexcept { return side_; }
  [[nodiscard]] double longest() const noexcept { return longest_; }
  /// Largest distance of a box's poses from its middle: of the rear axle [m], and in heading [rad].
  [[nodiscard]] double shift() const noexcept { return shift_; }
  [[nodiscard]] double half_turn() const noexcept { return half_turn_; }

  /// Bounds of a box, which must have an id already.
  [[nodiscard]] Box box(Id id) const;
  [[nodiscard]] Range way_from_start(Id id) const { return columns_[id / headings_].from_start; }
  /// Pose halfway between the middles of two boxes of one cell, which differ in heading.
  [[nodiscard]] Pose between(Id first, Id last) const;
  /// First box of a cell; one box for each heading follows.
  [[nodiscard]] Id first_of(std::int32_t x, std::int32_t y) { return column_at(x, y) * headings_; }
  [[nodiscard]] std::int32_t rows() const noexcept { return rows_; }
  /// Cells of a row that a path crosses at `distance` from the start [m].
  [[nodiscard]] std::vector<Crossing> crossings(std::int32_t y, double distance);
  /// Distances from the start of some places in a row of cells, where short enough ways pass [m].
  [[nodiscard]] std::vector<double> distances(std::int32_t y);

 private:
  /// All boxes of one cell, one for each heading.
  struct Column {
    std::int32_t x, y;
    Range from_start, to_goal;  // Ways of the disc's centre [m]; infinite if closed.
    double in_all;              // Lower bound on the sum of both ways [m].
    // Whether one-way streets bar each side of the cell: along x, then quarters of a turn.
    std::array<bool, 4> bars_out, bars_in;
  };

  [[nodiscard]] Id column_at(std::int32_t x, std::int32_t y);
  void bar_sides(Column& column) const;
  [[nodiscard]] double turning_length(const Pose& end, const Pose& middle, bool is_start) const;
  [[nodiscard]] double length_in_gear(const Pose& end, const Pose& middle, bool is_start) const;
  [[nodiscard]] bool is_hit(const Pose& middle) const;
  [[nodiscard]] bool is_astray(const Pose& middle) const;
  [[nodiscard]] Range way(GeodesicField& field, const Point& part) const;
  [[nodiscard]] Pose middle_of(const Column& column, double heading) const;
  [[nodiscard]] double find_least_length(Id id) const;

  const Task& task_;
  Disc disc_;
  double stretch_;  // Metres that the disc's centre moves for each metre of the rear axle, at most.
  double side_;     // Side of a cell [m].
  double longest_;  // Longest paths of interest [m].
  GearSign only_;   // Gear of all paths; 0: both.
  Bounds box_;
  OneWay one_way_;
  Id headings_;
  double half_turn_ = 0.0;  // Half an interval of headings [rad].
  double shift_ = 0.0;      // Largest distance of a rear axle in a box from that of its middle [m].
  double ahead_ = 0.0;      // Distance from the vehicle's rear axle to that of the core [m].
  /// Checker of the core, the part of the body that is covered at all poses of a box.
  std::shared_ptr<const CollisionChecker> core_;
  bool is_usable_ = false;
  GeodesicField from_start_, to_goal_;
  std::int32_t columns_of_row_ = 0, rows_ = 0;
  std::vector<std::int32_t> index_;  // Column of each cell; -1: not looked at.
  std::vector<Column> columns_;
  std::int64_t looks_ = 0;
  std::vector<float> length_bounds_;  // Lower bounds of boxes [m]; negative: not computed.
};

}  // namespace vandplan::search

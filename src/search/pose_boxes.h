// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is a path at least that passes through a box of poses?
//
// A box is a cell of a lattice, for the centre of a disc that the body holds, and an interval of
// headings. It is closed if no path comes by, or none that is short enough.
// docs/algorithms/anytime.md, "The bound", says why.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "search/geodesic_field.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::search {

class PoseBoxes {
 public:
  using Id = std::uint32_t;
  struct Range {
    double least, most;
  };
  /// What is known of all poses of a box [m]: ways of the disc's centre from the start and to the
  /// goal, and what a path needs from the start and to the goal, as far as ways and turns tell.
  struct Box {
    Pose middle;
    Range way_from_start, way_to_goal;
    double from_start, to_goal;
  };
  /// A cell where the disc's centre may be at some distance from the start, and how far it is from
  /// there to the goal [m].
  struct Crossing {
    std::int32_t x, y;
    Range way_to_goal;
  };

  /// Boxes of cells of `side` [m] around all ways up to `longest` [m]. The paths are in the gear
  /// `only`; 0: in both gears. Where `is_usable` is false nothing is to be asked: such boxes prove
  /// nothing, or are too many.
  PoseBoxes(const Task& task, double side, double longest, GearSign only = 0);
  PoseBoxes(const PoseBoxes&) = delete;
  PoseBoxes& operator=(const PoseBoxes&) = delete;

  [[nodiscard]] bool is_usable() const noexcept { return is_usable_; }
  /// Measures the ways around, which it takes before anything is asked: some work. True when that
  /// is done.
  bool prepare(std::int64_t work);

  /// The box that holds a pose of the task.
  [[nodiscard]] Id box_of(const Pose& pose);
  /// The six boxes that share a side with one; its own number where the lattice ends.
  [[nodiscard]] std::array<Id, 6> neighbours(Id box);
  /// No path through the box is shorter [m]; infinite if it is closed.
  [[nodiscard]] float least_length(Id box);
  /// Boxes so far have numbers below this; more come with their neighbours.
  [[nodiscard]] std::size_t size() const noexcept { return least_lengths_.size(); }
  [[nodiscard]] bool is_full() const noexcept;
  /// How many boxes were looked at so far.
  [[nodiscard]] std::int64_t looks() const noexcept { return looks_; }

  [[nodiscard]] Id headings() const noexcept { return headings_; }
  [[nodiscard]] double side() const noexcept { return side_; }
  [[nodiscard]] double longest() const noexcept { return longest_; }
  /// How far a pose of a box is from its middle, at most: the rear axle [m] and the heading [rad].
  [[nodiscard]] double shift() const noexcept { return shift_; }
  [[nodiscard]] double half_turn() const noexcept { return half_turn_; }

  /// A box that was looked at.
  [[nodiscard]] Box box(Id id) const;
  [[nodiscard]] Range way_from_start(Id id) const { return columns_[id / headings_].from_start; }
  /// The pose in the midst of two boxes of a cell, by their headings.
  [[nodiscard]] Pose between(Id first, Id last) const;
  /// The first of the boxes of a cell, one for each heading.
  [[nodiscard]] Id first_of(std::int32_t x, std::int32_t y) { return column_at(x, y) * headings_; }
  [[nodiscard]] std::int32_t rows() const noexcept { return rows_; }
  /// All cells of a row where a path crosses that distance from the start [m].
  [[nodiscard]] std::vector<Crossing> crossings(std::int32_t y, double distance);
  /// How far some places of a row of cells are from the start: those on ways that are short enough.
  [[nodiscard]] std::vector<double> distances(std::int32_t y);

 private:
  /// Boxes of one cell.
  struct Column {
    std::int32_t x, y;
    Range from_start, to_goal;  // for the disc's centre [m]; infinite if it is closed
    double in_all;              // of both, at least
  };

  [[nodiscard]] Id column_at(std::int32_t x, std::int32_t y);
  [[nodiscard]] double turning_length(const Pose& end, const Pose& middle, bool is_start) const;
  [[nodiscard]] double length_in_gear(const Pose& end, const Pose& middle, bool is_start) const;
  [[nodiscard]] bool is_hit(const Pose& middle) const;
  [[nodiscard]] Range way(GeodesicField& field, const Point& part) const;
  [[nodiscard]] Pose middle_of(const Column& column, double heading) const;
  [[nodiscard]] double find_least_length(Id id) const;

  const Task& task_;
  Disc disc_;
  double stretch_;  // the centre goes so much further than the rear axle
  double side_;     // of a cell [m]
  double longest_;  // [m]
  GearSign only_;   // gear of all paths; 0: both
  Bounds box_;
  Id headings_;
  double half_turn_ = 0.0;  // half of an interval of headings [rad]
  double shift_ = 0.0;      // of the rear axle in a box from that of its middle, at most [m]
  double ahead_ = 0.0;      // the core begins so far ahead of the rear axle [m]
  std::shared_ptr<const CollisionChecker> core_;  // of what the body covers at all poses of a box
  bool is_usable_ = false;
  GeodesicField from_start_, to_goal_;
  std::int32_t columns_of_row_ = 0, rows_ = 0;
  std::vector<std::int32_t> index_;  // of the column of a cell; -1: not looked at
  std::vector<Column> columns_;
  std::int64_t looks_ = 0;
  std::vector<float> least_lengths_;  // below 0: not looked at
};

}  // namespace vandplan::search

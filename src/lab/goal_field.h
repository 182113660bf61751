// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it to the goal, around the obstacles, from any pose?
//
// Distances between the corners of a lattice's cells, for a disc inside the footprint. They spread
// from the goal as far as queries need them. Proof: docs/algorithms/estimates.md.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "search/open_rows.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Method that gives the distances of a field.
enum class FieldKind : std::uint8_t {
  grid,       ///< Steps in eight directions; ways are up to 8.2 % longer than any-angle ways.
  any_angle,  ///< Steps in sixteen directions, divided by their largest excess: a lower bound.
  choi        ///< Out of the goal's sight: to the border of sight, then open ground.
};

/// Distances to the goal of one task. A query changes the object, so threads must not share it.
class GoalField {
 public:
  /// Computes nothing yet. The task must outlive the field.
  GoalField(const Task& task, FieldKind kind);

  /// Distance from a pose to the goal [m]; a lower bound on a path's length if the field is
  /// `any_angle`. Infinite where the goal is cut off. One call works at most a millisecond or two;
  /// a place it does not reach gets the distance reached so far.
  [[nodiscard]] double at(const Pose& pose);

  /// Number of corners whose distance is final.
  [[nodiscard]] std::int64_t settled() const noexcept { return settled_; }

 private:
  /// Corner of cells. The cell with its column and row lies above it to the right.
  struct Corner {
    std::int32_t x, y;
  };
  /// State of a corner.
  struct Label {
    double cost;   // Distance to the goal [cells].
    bool is_seen;  // Whether the goal sees the corner; only set for `choi`.
  };
  struct Entry {
    Corner corner;
    double cost;
    bool is_border;  // Whether it spreads from the border of sight.
  };
  static constexpr std::size_t block_size = 64;
  using Block = std::unique_ptr<std::array<Label, block_size>>;  // Corners side by side.
  /// Cells of a row, 1: open; with two closed cells at each end.
  using Cells = std::vector<std::uint8_t>;

  [[nodiscard]] const std::uint8_t* cells(std::int32_t y);
  [[nodiscard]] Label& label(const Corner& corner);
  void push(const Entry& entry);
  void reach(const Entry& from, const Corner& to, double step);
  void spread(const Entry& from);
  bool settle(int& work);
  [[nodiscard]] double of_corner(const Corner& corner, const Point& place, int& work);
  [[nodiscard]] double beyond_border(const Corner& corner) const;
  [[nodiscard]] double to_start(const Corner& corner) const noexcept;
  [[nodiscard]] double on_open_ground(const Corner& corner) const noexcept;
  [[nodiscard]] double around(const Pose& pose, const Point& place);

  const Task& task_;
  FieldKind kind_;
  double too_long_;  // Largest factor by which ways of steps are too long.
  Disc disc_;
  double stretch_;  // Metres that the disc's centre moves for each metre of the rear axle, at most.
  double side_ = 1.0;  // Side of a cell [m].
  Bounds box_ = {};
  OpenRows lattice_;
  Corner goal_ = {};
  Point start_ = {};  // Disc's centre at the task's start [cells]; ways to it are spread first.
  Cells closed_;      // Row of closed cells, for rows outside the lattice.
  std::vector<Cells> cells_;  // Rows of cells; empty: not computed yet.
  std::size_t blocks_of_row_ = 0;
  std::vector<Block> blocks_;             // Labels of corners; null: not reached yet.
  std::vector<std::vector<Entry>> open_;  // Buckets by cost plus way to the start.
  std::size_t front_ = 0;                 // Corners in buckets below are settled.
  std::int64_t settled_ = 0;
};

}  // namespace vandplan::search

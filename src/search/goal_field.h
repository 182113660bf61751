// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it to the goal, around the obstacles, from wherever one asks?
//
// Distances between the corners of a lattice's cells, for a disc that the footprint holds. They
// spread from the goal as far as they are asked for. docs/algorithms/estimates.md has the proof.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "search/open_rows.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// What a field of distances is made of.
enum class FieldKind : std::uint8_t {
  grid,       ///< ways with steps in eight directions: up to 8.2 % longer than ways in any one
  any_angle,  ///< ways with steps in sixteen directions, shortened by what those are too long
  choi  ///< out of sight of the goal: to the border of what it sees, and open ground from there
};

/// Distances to the goal of one task. A call spreads them further, so threads do not share it.
class GoalField {
 public:
  /// The task outlives the field. Nothing is computed yet.
  GoalField(const Task& task, FieldKind kind);

  /// Length of a way to the goal [m]: never above it if the field is `any_angle`. Infinite where
  /// the goal is cut off. One call does a millisecond or two of work at most; what it does not get
  /// to counts as being as far as it got.
  [[nodiscard]] double at(const Pose& pose);

  /// How many corners have their distance.
  [[nodiscard]] std::int64_t settled() const noexcept { return settled_; }

 private:
  /// A corner of cells: that of column x and row y has the cell of that column and row above it to
  /// the right.
  struct Corner {
    std::int32_t x, y;
  };
  /// What is known of a corner. All costs are in cells.
  struct Label {
    double cost;
    bool is_seen;  // from the goal; only `choi` tells
  };
  struct Entry {
    Corner corner;
    double cost;
    bool is_border;  // to be spread to what the goal does not see
  };
  static constexpr std::size_t block_size = 64;
  using Block = std::unique_ptr<std::array<Label, block_size>>;  // corners side by side
  using Cells = std::vector<std::uint8_t>;  // of a row, 1: open; two closed ones at either end

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
  double too_long_;  // ways along the steps, by at most this factor
  Disc disc_;
  double stretch_;  // the centre of the disc goes at most so many metres for one of the rear axle
  double side_ = 1.0;  // of a cell [m]
  Bounds box_ = {};
  OpenRows lattice_;
  Corner goal_ = {};
  Point start_ = {};          // of the task [cells]: ways that lead there come first
  Cells closed_;              // a row beside the lattice
  std::vector<Cells> cells_;  // empty: not asked for yet
  std::size_t blocks_of_row_ = 0;
  std::vector<Block> blocks_;             // null: likewise
  std::vector<std::vector<Entry>> open_;  // by cost and way to the start
  std::size_t front_ = 0;                 // all below is settled
  std::int64_t settled_ = 0;
};

}  // namespace vandplan::search

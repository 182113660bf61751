// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Are start and goal separated by obstacles? A proof, on lattices, that there is no path.
//
// The footprint holds a disc as wide as itself. The disc's centre moves with the vehicle and keeps
// the disc's radius plus the margin from every obstacle. So it stays in the open cells of a lattice
// (open_rows.h), and moves from cell to cell across their sides: where it passes a corner, all four
// cells are open. If the cells of start and goal are not connected, there is no path.

#include <array>
#include <cstdint>
#include <queue>
#include <span>
#include <unordered_map>
#include <vector>

#include "search/open_rows.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Floods open cells from the start and from the goal in turn, so that the smaller side is finished
/// first. Where the floods meet, a lattice of half the cell size follows, which shows narrower
/// gaps.
class Enclosure {
 public:
  /// `goals`: poses, in one of which paths end; none: the task's goal. The task must outlive the
  /// object.
  explicit Enclosure(const Task& task, std::span<const LocalPose> goals = {});

  /// Does some ten microseconds of work. False when nothing is left to do.
  bool step();

  /// Whether it is proven that no path leads from the start to any goal.
  [[nodiscard]] bool is_proven() const noexcept { return is_proven_; }

 private:
  enum End : std::uint8_t { start, goal };
  /// Run of open cells that a flood has reached.
  struct Node {
    std::int32_t row, index;
    double rank;  // Distance of the run from the other end [cells].
    bool operator<(const Node& other) const { return rank > other.rank; }
  };
  struct Flood {
    Point root;         // One place where the flood begins [cells].
    std::int64_t work;  // Work done so far.
    std::priority_queue<Node> front;
  };
  static constexpr std::uint8_t nobody = 2;

  bool next_lattice();
  [[nodiscard]] bool begin(End end);
  [[nodiscard]] bool begin_at(End end, const Point& root);
  [[nodiscard]] bool advance(End end);
  [[nodiscard]] bool reach(End end, std::int32_t row, std::int32_t index);

  const Task& task_;
  double disc_;                             // Radius plus margin [m].
  std::array<std::vector<Point>, 2> ends_;  // Centres of the disc at start and goals [m].
  Bounds box_;   // If start and goal are connected, they are within this box.
  double side_;  // Side of a cell [m].
  OpenRows rows_;
  /// Flood that owns each run, by row.
  std::unordered_map<std::int32_t, std::vector<std::uint8_t>> owners_;
  std::array<Flood, 2> floods_;
  bool is_proven_ = false;
};

}  // namespace vandplan::search

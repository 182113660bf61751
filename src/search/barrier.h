// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Do the rules of zones separate start and goal? A proof, on lattices, that there is no path.
//
// The midpoint of the rear axle moves from cell to cell across their sides, in a direction that
// points out of the cell or along the side. A cell is closed if a rule closes all of it, or if all
// of it is nearer to an obstacle than the body allows. A side cannot be crossed in a sense if a
// one-way street contains all of it and none of its directions has that sense. If the goal's cell
// is not reached from that of the start, there is no path. docs/lab/zones.md.

#include <array>
#include <cstdint>
#include <vector>

#include "search/one_way.h"
#include "search/open_rows.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// Floods cells from the start, and from the goal against the direction of travel. Where the floods
/// meet, a lattice of half the cell size follows.
class Barrier {
 public:
  /// `only`: gear of all paths, 0 for both. The task must outlive the object.
  Barrier(const Task& task, GearSign only);

  /// Does some ten microseconds of work. False when nothing is left to do.
  bool step();

  /// Whether it is proven that no path leads from the start to the goal.
  [[nodiscard]] bool is_proven() const noexcept { return is_proven_; }

 private:
  enum End : std::uint8_t { start, goal };

  [[nodiscard]] bool next_lattice();
  [[nodiscard]] bool root(End end, const LocalPose& pose);
  [[nodiscard]] Point middle_of(std::int64_t cell) const;
  [[nodiscard]] bool is_open(std::int64_t cell);
  [[nodiscard]] bool find_open(std::int64_t cell);
  [[nodiscard]] bool is_barred(std::int64_t cell, int side, int sense) const;
  [[nodiscard]] bool expand(End end);

  const Task& task_;
  Bounds box_ = {};
  double side_ = 0.0;       // Side of a cell [m]; 0: nothing is left to do.
  double clearance_ = 0.0;  // Least distance of the rear axle from obstacles [m].
  std::vector<ClosedArea> closed_;
  OneWay one_way_;
  std::int64_t columns_ = 0, rows_ = 0;
  bool uses_obstacles_ = false;
  OpenRows open_rows_;
  /// What is known of each cell: bits 0 and 1 for the floods that reached it, 2 for open, 3 for
  /// closed.
  std::vector<std::uint8_t> cells_;
  std::array<std::vector<std::int64_t>, 2> fronts_;
  bool is_proven_ = false;
};

}  // namespace vandplan::search

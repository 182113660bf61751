// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is the start or the goal walled in? A proof, on lattices, that there is no path.
//
// The footprint holds a disc that is as wide as itself. Its centre goes with the vehicle, keeps the
// disc's radius and the margin from every obstacle, and so stays in the open cells of a lattice
// (open_rows.h). It goes from cell to cell across their sides: where it passes a corner, all four
// cells are open. If those of the start and those of the goal are not connected, there is no path.

#include <array>
#include <cstdint>
#include <queue>
#include <unordered_map>
#include <vector>

#include "search/open_rows.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Floods open cells from the start and from the goal in step, so that the smaller side is done
/// first. Where they meet, a lattice of half the size follows, which knows narrower gaps.
class Enclosure {
 public:
  explicit Enclosure(const Task& task);

  /// Goes on, some ten microseconds of work. False when there is no more to do.
  bool step();

  /// Proven: no path gets from the start to the goal.
  [[nodiscard]] bool is_proven() const noexcept { return is_proven_; }

 private:
  enum End : std::uint8_t { start, goal };
  /// A run of open cells that one of the floods has reached.
  struct Node {
    std::int32_t row, index;
    double rank;  // its distance from the other end [cells]
    bool operator<(const Node& other) const { return rank > other.rank; }
  };
  struct Flood {
    Point root;         // in cells
    std::int64_t work;  // done so far
    std::priority_queue<Node> front;
  };
  static constexpr std::uint8_t nobody = 2;

  bool next_lattice();
  [[nodiscard]] bool begin(End end);
  [[nodiscard]] bool advance(End end);
  [[nodiscard]] bool reach(End end, std::int32_t row, std::int32_t index);

  const Task& task_;
  double disc_;                // radius and margin [m]
  std::array<Point, 2> ends_;  // where the centre is at start and goal [m]
  Bounds box_;                 // whoever gets from end to end can do so in here
  double side_;                // of a cell [m]
  OpenRows rows_;
  std::unordered_map<std::int32_t, std::vector<std::uint8_t>> owners_;  // of the runs of a row
  std::array<Flood, 2> floods_;
  bool is_proven_ = false;
};

}  // namespace vandplan::search

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it for a tractor with a trailer, answered from a table?
//
// What the thesis' heuristic look-up table is for a vehicle alone: docs/algorithms/trailers.md.

#include <cstddef>
#include <span>
#include <vector>

#include "vandplan/rig.h"

namespace vandplan {

/// How states around a rig are cut into cells.
struct RigTableOptions {
  double reach = 30.0;   ///< of |x| and |y| [m]; 1e-3 to 1e6
  int cells = 12;        ///< squares from 0 to `reach`; 1 to 100
  int headings = 24;     ///< of one full turn; 1 to 360
  int hitch_angles = 5;  ///< of each state; odd, 1 to 25
  bool operator==(const RigTableOptions&) const = default;
};

/// Lengths of the paths of `RigSteering` between states of one rig on open ground, one for each
/// cell of relative place and heading and each pair of hitch angles. Only the left half is stored:
/// the mirrored states have the mirrored path. Immutable.
class RigTable {
 public:
  /// Works all lengths out, on so many threads: of the usual options 172 800, some 2 s on one core.
  /// The same lengths on any number of threads. Throws InputError if an option is out of range, or
  /// as `RigSteering` does.
  explicit RigTable(const Vehicle& vehicle, const RigTableOptions& options = {}, int threads = 1);

  /// About how far it is from one state to another [m]: the length of the cell, from its middle to
  /// its middle; beyond the table that of the last cell on the way there, and the straight line
  /// from there on. Infinite where steering found no path. The hitch angles are within the limit.
  [[nodiscard]] double distance(const RigState& from, const RigState& to) const noexcept;

  [[nodiscard]] const RigTableOptions& options() const noexcept { return options_; }
  /// All lengths [m], row-major [x][y][heading][first hitch angle][last hitch angle].
  [[nodiscard]] std::span<const float> entries() const noexcept { return entries_; }

 private:
  /// A cell of both states, whose y is not negative.
  struct Cell {
    int x, y, heading, first, last;
  };
  [[nodiscard]] std::size_t index_of(const Cell& cell) const noexcept;
  [[nodiscard]] double hitch_angle(int index) const noexcept;
  [[nodiscard]] int hitch_index(double angle) const noexcept;

  RigTableOptions options_;
  double most_hitch_angle_;
  std::vector<float> entries_;
};

}  // namespace vandplan

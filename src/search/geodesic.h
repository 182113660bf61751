// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is every path at least, around the obstacles? A proven lower bound, on lattices.
//
// The body holds a disc whose centre keeps the radius from every obstacle of the body. A cell of a
// lattice is closed if each of its points is nearer to an obstacle than that. So the centre stays
// in open cells, and its way is at least as long as the shortest any-angle way through them. If the
// centre is q ahead of the rear axle, it moves at most sqrt(1 + q^2 / R^2) times as far. Kerbs are
// ignored. Zones that are closed keep the centre away, too (closed_areas.h).

#include <algorithm>

#include "search/closed_areas.h"
#include "search/taut_ways.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// Bounding box of the disc's centre on all paths up to `longest` [m], within the bounds.
[[nodiscard]] Bounds box_of_paths(const Task& task, const Disc& disc, double longest);

/// Lower bound on the length of a path: the shortest taut way on a sequence of lattices, each with
/// half the cell size of the one before. The bound only rises.
class Geodesic {
 public:
  /// Bound for paths from the task's start, which must be free, to its goal. Paths longer than
  /// `longest` [m] are ignored. `only`: gear of all paths, 0 for both.
  Geodesic(const Task& task, double longest, GearSign only = 0);

  /// Expands some intervals, about 20 microseconds of work. False when the bound is final.
  bool step();

  /// Lower bound on the length of all paths [m].
  [[nodiscard]] double bound() const { return std::min(bound_ / stretch_, longest_); }

 private:
  bool next_lattice();

  const Task& task_;
  double longest_;   // Length of the longest path of interest [m].
  double disc_;      // Radius of the disc plus margin [m].
  double stretch_;   // Metres that the centre moves for each metre of the rear axle, at most.
  Point from_, to_;  // Centre of the disc at start and goal [m].
  std::vector<ClosedArea> closed_;  // What zones keep the centre away from.
  Bounds box_;                      // Box of the centre on paths up to `longest_`.
  double side_ = 0.0;               // Side of a cell [m].
  TautWays ways_;
  bool is_settled_ = true;  // Whether the shortest way on this lattice is known.
  double bound_ = 0.0;      // Lower bound on the way of the centre [m].
};

}  // namespace vandplan::search

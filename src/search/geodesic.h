// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it at least, around the obstacles? A proven bound, on lattices.
//
// The centre of a disc that the footprint holds keeps its radius away from every obstacle of the
// body. A cell of a lattice is open unless every point of it is nearer than that to something. So
// the centre stays in the open cells, and its way is no shorter than the shortest one through them,
// with any straight line and any turn at a corner. Where it is not on the rear axle, but q ahead of
// it, it goes at most sqrt(1 + q^2 / R^2) times as far. Kerbs are left out.

#include <algorithm>

#include "search/taut_ways.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Where paths up to that length keep the centre of the disc: around an ellipse, and within the
/// bounds.
[[nodiscard]] Bounds box_of_paths(const Task& task, const Disc& disc, double longest);

/// The shortest of the taut ways on lattices that follow each other, each of half the size. The
/// bound only rises.
class Geodesic {
 public:
  /// From the task's start, which is free, to its goal. Takes no notice of paths that are longer
  /// than `longest` [m].
  Geodesic(const Task& task, double longest);

  /// Goes on from some intervals, about 20 microseconds of work. False when the bound is final.
  bool step();

  /// Length of no path is below this [m].
  [[nodiscard]] double bound() const { return std::min(bound_ / stretch_, longest_); }

 private:
  bool next_lattice();

  const Task& task_;
  double longest_;     // [m]
  double disc_;        // its radius and the margin [m]
  double stretch_;     // the centre goes so much further than the rear axle
  Point from_, to_;    // of the centre [m]
  Bounds box_;         // paths up to that length keep the centre in it
  double side_ = 0.0;  // of a cell [m]
  TautWays ways_;
  bool is_settled_ = true;  // nothing is left to be found on this lattice
  double bound_ = 0.0;      // of the way of the centre [m]
};

}  // namespace vandplan::search

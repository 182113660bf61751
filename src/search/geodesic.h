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
#include <cstdint>
#include <queue>
#include <unordered_map>
#include <vector>

#include "search/open_rows.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// A* over intervals of the lattice's horizontal lines, with the runs of open cells in its rows as
/// convex polygons: Cui, Harabor and Grastien, "Compromise-free pathfinding on a navigation mesh"
/// (2017). Lattices follow each other, each of half the size. The bound only rises.
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
  /// Open cells side by side, from the lattice line `begin` to `end`, by its row and its place
  /// there.
  struct RunId {
    std::int32_t row, index;
    bool operator==(const RunId&) const = default;
  };
  /// Part of what two runs share: from `left` to `right` on a lattice line. At an end that is a
  /// corner a way may turn.
  struct Interval {
    double left, right;
    bool turns_left, turns_right;
  };
  /// Ways from the start by a straight line from `root` through an interval into a run.
  struct Node {
    Point root;
    double cost;  // of the way to the root
    double rank;  // what any way through here costs at least
    Interval interval;
    std::int32_t line;
    RunId from, into;
  };
  struct IsWorse {
    bool operator()(const Node& a, const Node& b) const { return a.rank > b.rank; }
  };

  bool next_lattice();
  [[nodiscard]] const OpenRows::Row& runs(std::int32_t row);
  [[nodiscard]] RunId run_at(const Point& point);
  [[nodiscard]] double rank(const Node& node) const;
  void push(Node node);
  void cross(const Node& node, const Point& root, double cost, double left, double right);
  void turn(const Node& node, double limit, bool to_left);
  bool reaches(const Point& corner, double cost);

  /// Calls `visit(interval, other)` for each run that shares part of a line with `id`.
  template <typename Visit>
  void for_neighbours(const RunId& id, std::int32_t line, Visit visit);
  void expand(const Node& node);
  void spread(const Point& root, double cost, const RunId& in, const RunId& from);

  const Task& task_;
  double longest_;     // [m]
  double disc_;        // its radius and the margin [m]
  double stretch_;     // the centre goes so much further than the rear axle
  Point from_, to_;    // of the centre [m]
  Bounds box_;         // paths up to that length keep the centre in it
  double side_ = 0.0;  // of a cell [m]
  OpenRows lattice_;
  Point goal_;  // this and all below in cells
  RunId goal_run_{};
  std::priority_queue<Node, std::vector<Node>, IsWorse> open_;
  std::unordered_map<std::int64_t, double> turn_costs_;  // least cost of a way to a corner
  double bound_ = 0.0;                                   // of the way of the centre [m]
  int work_ = 0;                                         // done in this step
};

}  // namespace vandplan::search

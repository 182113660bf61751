// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which are the shortest ways of a point through the open cells of a lattice?
//
// A* over intervals of the lattice's horizontal lines, with the runs of open cells in its rows as
// convex polygons: Cui, Harabor and Grastien, "Compromise-free pathfinding on a navigation mesh"
// (2017).

#include <cstdint>
#include <optional>
#include <queue>
#include <unordered_map>
#include <vector>

#include "search/open_rows.h"
#include "vandplan/geometry.h"

namespace vandplan::search {

/// Ways from one point towards another one; lengths and places are in cells of the lattice.
class TautWays {
 public:
  /// Open cells side by side, by their row and their place there.
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
    double rank;  // what any way through here costs at least, to the goal or to the interval
    Interval interval;
    std::int32_t line;
    RunId from, into;
  };
  /// More than rounding does to a length.
  static constexpr double rounding = 1e-9;

  TautWays() = default;
  /// Both points, in cells from the corner of the lattice, are in open cells. Without `longest`
  /// ways lead to the goal, best first; else to all places that lie on ways to the goal which are
  /// no longer, the nearest place first.
  TautWays(OpenRows lattice, const Point& start, const Point& goal,
           std::optional<double> longest = {});

  [[nodiscard]] OpenRows& lattice() noexcept { return lattice_; }
  [[nodiscard]] const RunId& start_run() const noexcept { return start_run_; }
  [[nodiscard]] const RunId& goal_run() const noexcept { return goal_run_; }
  [[nodiscard]] const Point& start() const noexcept { return start_; }

  /// The run that holds the point; none if that is in a closed cell or beside the lattice.
  [[nodiscard]] std::optional<RunId> run_at(const Point& point);

  /// Removes the open node of the least rank; none when there is none, or when there are too many.
  [[nodiscard]] std::optional<Node> take();
  /// Whether there are too many open nodes.
  [[nodiscard]] bool is_full() const noexcept;
  /// Whether no shorter way to the node's root became known since the node was made.
  [[nodiscard]] bool is_current(const Node& node);
  /// Opens the nodes behind one.
  void expand(const Node& node);

  /// Work done so far, in nodes: looking at many cells counts as well.
  [[nodiscard]] std::int64_t work() const noexcept { return work_; }

 private:
  struct IsWorse {
    bool operator()(const Node& a, const Node& b) const { return a.rank > b.rank; }
  };
  [[nodiscard]] const OpenRows::Row& runs(std::int32_t row);
  [[nodiscard]] double way_to_goal(const Node& node) const;
  [[nodiscard]] std::int64_t key_of(const Point& corner) const noexcept;
  void push(Node node);
  void cross(const Node& node, const Point& root, double cost, double left, double right);
  void turn(const Node& node, double limit, bool to_left);
  [[nodiscard]] bool reaches(const Point& corner, double cost);

  /// Calls `visit(interval, other)` for each run that shares part of a line with `id`.
  template <typename Visit>
  void for_neighbours(const RunId& id, std::int32_t line, Visit visit);
  void spread(const Point& root, double cost, const RunId& in, const RunId& from);

  OpenRows lattice_;
  Point start_, goal_;
  RunId start_run_{}, goal_run_{};
  std::optional<double> longest_;  // none: only the goal counts
  std::priority_queue<Node, std::vector<Node>, IsWorse> open_;
  std::unordered_map<std::int64_t, double> corner_costs_;  // least cost of a way to a corner
  std::unordered_map<std::int64_t, double> turn_costs_;    // by corner, row entered and side
  std::int64_t work_ = 0;
};

}  // namespace vandplan::search

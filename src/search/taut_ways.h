// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which are the shortest ways of a point through the open cells of a lattice?
//
// A* over intervals on the lattice's horizontal lines. The runs of open cells in its rows are the
// convex polygons of: Cui, Harabor and Grastien, "Compromise-free pathfinding on a navigation mesh"
// (2017).

#include <cstdint>
#include <optional>
#include <queue>
#include <unordered_map>
#include <vector>

#include "search/open_rows.h"
#include "vandplan/geometry.h"

namespace vandplan::search {

/// Ways from one point towards another. Lengths and places are in cells of the lattice.
class TautWays {
 public:
  /// Run of open cells side by side: row, and index within the row.
  struct RunId {
    std::int32_t row, index;
    bool operator==(const RunId&) const = default;
  };
  /// Part of the border of two runs, from `left` to `right` on a lattice line. The flags say at
  /// which end a way may turn, because it is a corner.
  struct Interval {
    double left, right;
    bool turns_left, turns_right;
  };
  /// Ways from the start that go straight from `root` through an interval into a run.
  struct Node {
    Point root;
    double cost;  // Length of the way to the root.
    double rank;  // Lower bound on all ways through here, to the goal or to the interval.
    Interval interval;
    std::int32_t line;
    RunId from, into;

    /// Length of the shortest of its ways to a point of the run it leads into. A point behind the
    /// interval is as far as its mirror image.
    [[nodiscard]] double way_to(const Point& point) const;
  };
  /// Bound on the rounding error of a length.
  static constexpr double rounding = 1e-9;

  TautWays() = default;
  /// Start and goal are in cells from the lattice's corner and lie in open cells. Without `longest`
  /// ways lead to the goal, best first. With `longest` they lead to all places on ways to the goal
  /// up to that length, nearest place first.
  TautWays(OpenRows lattice, const Point& start, const Point& goal,
           std::optional<double> longest = {});

  [[nodiscard]] OpenRows& lattice() noexcept { return lattice_; }
  [[nodiscard]] const RunId& start_run() const noexcept { return start_run_; }
  [[nodiscard]] const RunId& goal_run() const noexcept { return goal_run_; }
  [[nodiscard]] const Point& start() const noexcept { return start_; }

  /// Run that contains a point; empty if the point is in a closed cell or outside the lattice.
  [[nodiscard]] std::optional<RunId> run_at(const Point& point);

  /// Removes the open node of least rank. Empty if there is none, or if there are too many.
  [[nodiscard]] std::optional<Node> take();
  /// Whether there are too many open nodes.
  [[nodiscard]] bool is_full() const noexcept;
  /// Whether no shorter way to the node's root was found since the node was made.
  [[nodiscard]] bool is_current(const Node& node);
  /// Opens the successors of a node.
  void expand(const Node& node);

  /// Work done so far [nodes]; looking at many cells counts too.
  [[nodiscard]] std::int64_t work() const noexcept { return work_; }

 private:
  struct IsWorse {
    bool operator()(const Node& a, const Node& b) const { return a.rank > b.rank; }
  };
  [[nodiscard]] const OpenRows::Row& runs(std::int32_t row);
  [[nodiscard]] std::int64_t key_of(const Point& corner) const noexcept;
  void push(Node node);
  void cross(const Node& node, const Point& root, double cost, double left, double right);
  void turn(const Node& node, double limit, bool to_left);
  [[nodiscard]] bool reaches(const Point& corner, double cost);

  /// Calls `visit(interval, other)` for each run beyond `line` that borders on run `id`.
  template <typename Visit>
  void for_neighbours(const RunId& id, std::int32_t line, Visit visit);
  void spread(const Point& root, double cost, const RunId& in, const RunId& from);

  OpenRows lattice_;
  Point start_, goal_;
  RunId start_run_{}, goal_run_{};
  std::optional<double> longest_;  // Longest way of interest; empty: only the goal counts.
  std::priority_queue<Node, std::vector<Node>, IsWorse> open_;
  std::unordered_map<std::int64_t, double> corner_costs_;  // Least length of a way to each corner.
  std::unordered_map<std::int64_t, double> turn_costs_;  // Lengths by corner, row entered and side.
  std::int64_t work_ = 0;
};

}  // namespace vandplan::search

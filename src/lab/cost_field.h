// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the cheapest way of a point to a target cost, if a metre costs more in some cells than
// in others?

#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan::search {

/// A grid of square cells over a box, with a cost per metre in each cell.
struct CostCells {
  Bounds box = {};    ///< box that the grid covers [m]
  double side = 1.0;  ///< side of a cell [m]; > 0
  /// Cost of a metre at the centre of a cell; >= 1, infinite in a closed cell.
  std::function<double(const Point&)> cost = {};
};

/// Costs of the cheapest ways to a target, by Field D* (Ferguson and Stentz 2006). Each node, a
/// corner of cells, has a cost; between two neighbours the cost is linear. An A* from the target to
/// the root settles nodes, so the costs of far nodes stay unknown.
class CostField {
 public:
  /// A field without settled nodes. Target and root lie in the box; their cells are never closed.
  CostField(CostCells cells, const Point& target, const Point& root);

  /// Settles up to 64 nodes, some ten microseconds of work. False when the search has ended.
  bool step();

  /// Cost of the cheapest way from a point to the target [m]; infinite where it is not known.
  [[nodiscard]] double at(const Point& point) const;

  /// Corners of the cheapest way from the root to the target, both included; empty if there is
  /// none.
  [[nodiscard]] std::vector<Point> route() const;

  /// Number of settled nodes.
  [[nodiscard]] std::int64_t settled() const noexcept { return settled_; }

 private:
  /// A node, or the cell to its upper right.
  struct Place {
    std::int32_t x, y;
  };
  /// A node in the open list.
  struct Open {
    double rank;  // cost plus distance to the root [m]
    std::int32_t index;
    bool operator<(const Open& other) const {
      return other.rank < rank || (other.rank == rank && other.index < index);
    }
  };
  /// First line of the way from a point: its end, and the cost of the whole way to the target [m].
  struct Step {
    Point to = {};
    double cost = std::numeric_limits<double>::infinity();
  };

  [[nodiscard]] bool holds(const Place& node) const;
  [[nodiscard]] std::size_t index_of(const Place& node) const;
  [[nodiscard]] Place place_of(std::size_t index) const;
  [[nodiscard]] Point point_of(const Place& node) const;
  [[nodiscard]] Place cell_of(const Point& point) const;
  [[nodiscard]] double cost_of(const Place& cell) const;
  [[nodiscard]] double node_cost(const Place& node) const;
  void reach(const Place& node, double cost);
  void update(const Place& node, int towards);
  /// Replaces `best` by a cheaper step from a point through the cell, if there is one.
  void consider(const Point& from, const Place& cell, Step& best) const;
  [[nodiscard]] Step best_step(const Point& from) const;

  CostCells cells_;
  Point target_, root_;
  std::int32_t columns_, rows_;  // numbers of nodes along x and y
  std::vector<double> costs_;    // costs of the ways from all nodes [m]
  std::vector<bool> is_settled_;
  mutable std::vector<float> cell_costs_;  // cost of a metre in each cell; negative: not computed
  std::priority_queue<Open> open_;
  std::int64_t settled_ = 0;
  int missing_ = 4;  // unsettled corners of the root's cell
};

}  // namespace vandplan::search

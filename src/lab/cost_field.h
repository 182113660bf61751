// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the cheapest way to a target cost from anywhere, in any direction, past things that one
// does not like to be near to?

#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan::search {

/// What the way of a point costs, on cells of a lattice over a box.
struct CostCells {
  Bounds box = {};
  double side = 1.0;  ///< of a cell [m]; > 0
  /// Of a metre at the centre of a cell: >= 1, infinite where one may not be.
  std::function<double(const Point&)> cost = {};
};

/// Costs of ways to a target by Field D* (Ferguson and Stentz 2006): those of the lattice's nodes,
/// and between two neighbours a line. Found by A* from the target, so only where a way from the
/// root is likely to come.
class CostField {
 public:
  /// Nothing is settled yet. Target and root lie in the box; their cells are never closed.
  CostField(CostCells cells, const Point& target, const Point& root);

  /// Settles some nodes, a few ten microseconds of work. False when there is no more to do.
  bool step();

  /// What the way from a point costs [m]; infinite where it is not known.
  [[nodiscard]] double at(const Point& point) const;

  /// The cheapest way from the root to the target, corners and all; empty if there is none.
  [[nodiscard]] std::vector<Point> route() const;

  [[nodiscard]] std::int64_t settled() const noexcept { return settled_; }

 private:
  /// A node, or the cell to its upper right.
  struct Place {
    std::int32_t x, y;
  };
  struct Open {
    double rank;
    std::int32_t index;
    bool operator<(const Open& other) const {
      return other.rank < rank || (other.rank == rank && other.index < index);
    }
  };
  /// Where the way from a point goes on, and what it costs from the point [m].
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
  /// The best way on from a point, through the cell.
  void consider(const Point& from, const Place& cell, Step& best) const;
  [[nodiscard]] Step best_step(const Point& from) const;

  CostCells cells_;
  Point target_, root_;
  std::int32_t columns_, rows_;  // of nodes
  std::vector<double> costs_;    // of ways from nodes [m]
  std::vector<bool> is_settled_;
  mutable std::vector<float> cell_costs_;  // of a metre; negative: not asked yet
  std::priority_queue<Open> open_;
  std::int64_t settled_ = 0;
  int missing_ = 4;  // nodes of the root's cell that are not settled
};

}  // namespace vandplan::search

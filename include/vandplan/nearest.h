// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which of many nodes is nearest by Reeds-Shepp length?
//
// The answer is that of comparing all exact lengths; few of them are computed:
// docs/algorithms/nearest.md.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan {

/// The answer to a query.
struct NearestNode {
  std::int32_t node = 0;          ///< counted from 0 in the order of `add`
  double length = 0.0;            ///< `reeds_shepp_length` between it and the sample [m]
  std::int64_t exact_solves = 0;  ///< lengths that were computed to find it
};

/// Nodes in a grid over x and y, remade whenever their number has doubled. Queries allocate nothing
/// and may run in many threads at once.
class NearestNodes {
 public:
  /// `radius` of turning > 0 [m].
  explicit NearestNodes(double radius) : radius_(radius) {}

  /// Adds a node. Its numbers are finite.
  void add(const Pose& pose);

  /// The node with the least exact length to the sample; ties go to the older node. None if there
  /// are no nodes.
  [[nodiscard]] std::optional<NearestNode> nearest(const Pose& sample) const;

  [[nodiscard]] std::size_t size() const noexcept { return poses_.size(); }

 private:
  /// Of the grid; beyond its edge the outermost cells go on for ever.
  struct Cell {
    std::int32_t x, y;
  };
  /// Some nodes of a cell, and where there are more.
  struct Block {
    static constexpr std::size_t capacity = 8;
    double x[capacity], y[capacity];
    float heading[capacity];
    std::int32_t node[capacity];
    std::size_t count = 0;
    std::int32_t next = -1;
  };
  class Search;

  [[nodiscard]] Cell cell_of(const Pose& pose) const noexcept;
  [[nodiscard]] std::size_t index_of(Cell cell) const noexcept;
  void make_grid();
  void put_into_grid(std::int32_t node);

  double radius_;
  std::vector<Pose> poses_;
  std::size_t grid_limit_ = 0;  // number of nodes from which on the grid is too coarse
  double x_min_ = 0.0, y_min_ = 0.0, cell_size_ = 1.0;  // [m]
  std::int32_t columns_ = 0, rows_ = 0;
  std::vector<std::int32_t> first_block_;  // of each cell, or -1
  std::vector<Block> blocks_;
};

}  // namespace vandplan

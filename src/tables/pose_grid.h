// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which nodes lie in which cell of a grid over x and y?

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan::tables {

/// Column and row of a cell of the grid. The outermost cells reach to infinity.
struct GridCell {
  std::int32_t x, y;
};

/// Up to `capacity` nodes of one cell, and the number of the cell's next block (-1: none).
struct Block {
  static constexpr std::size_t capacity = 8;
  double x[capacity], y[capacity];
  float heading[capacity];
  std::int32_t node[capacity];
  std::size_t count = 0;
  std::int32_t next = -1;
};

/// Nodes with their poses in a grid over x and y. Nodes are numbered from 0 in the order of `add`.
struct PoseGrid {
  [[nodiscard]] GridCell cell_of(const Pose& pose) const noexcept;
  [[nodiscard]] std::size_t index_of(GridCell cell) const noexcept;
  void add(const Pose& pose);
  /// Whether node `node` was added and not removed.
  [[nodiscard]] bool holds(std::int32_t node) const noexcept {
    const auto at = static_cast<std::size_t>(node);
    return node >= 0 && at < poses.size() && (at >= removed.size() || !removed[at]);
  }
  /// Removes a node, which must be there. Its number is not used again.
  void remove(std::int32_t node);
  [[nodiscard]] const Pose& pose(std::int32_t node) const noexcept {
    return poses[static_cast<std::size_t>(node)];
  }
  [[nodiscard]] Block& block(std::int32_t number) noexcept {
    return blocks[static_cast<std::size_t>(number)];
  }

  std::vector<Pose> poses = {};  // Pose of each node ever added.
  /// Whether each node was removed; may be shorter than `poses`, then false.
  std::vector<bool> removed = {};
  std::size_t count = 0;  // Number of nodes in the grid.
  std::size_t limit = 0;  // Number of nodes above which the grid is rebuilt with smaller cells.
  double x_min = 0.0, y_min = 0.0, cell_size = 1.0;  // Lower left corner and side of a cell [m].
  std::int32_t columns = 0, rows = 0;
  std::vector<std::int32_t> first_block = {};  // First block of each cell, or -1.
  std::vector<Block> blocks = {};
  std::int32_t free_block = -1;  // First block of the list of unused ones, or -1.

 private:
  void remake();
  void put(std::int32_t node);
};

}  // namespace vandplan::tables

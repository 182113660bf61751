// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which nodes lie in which cell of a grid over x and y?

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan::tables {

/// Column and row of the grid; beyond its edge the outermost cells go on for ever.
struct GridCell {
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

/// Nodes with their poses. A node is counted from 0 in the order of `add`.
struct PoseGrid {
  [[nodiscard]] GridCell cell_of(const Pose& pose) const noexcept;
  [[nodiscard]] std::size_t index_of(GridCell cell) const noexcept;
  void add(const Pose& pose);
  /// Whether a node of that number was added and not taken out.
  [[nodiscard]] bool holds(std::int32_t node) const noexcept {
    const auto at = static_cast<std::size_t>(node);
    return node >= 0 && at < poses.size() && (at >= removed.size() || !removed[at]);
  }
  /// Takes out a node that is there; its number is not used again.
  void remove(std::int32_t node);
  [[nodiscard]] const Pose& pose(std::int32_t node) const noexcept {
    return poses[static_cast<std::size_t>(node)];
  }
  [[nodiscard]] Block& block(std::int32_t number) noexcept {
    return blocks[static_cast<std::size_t>(number)];
  }

  std::vector<Pose> poses = {};    // of all nodes ever added
  std::vector<bool> removed = {};  // some last ones, if not removed, may be missing
  std::size_t count = 0;           // of the nodes that are there
  std::size_t limit = 0;           // number of nodes from which on it is too coarse
  double x_min = 0.0, y_min = 0.0, cell_size = 1.0;  // [m]
  std::int32_t columns = 0, rows = 0;
  std::vector<std::int32_t> first_block = {};  // of each cell, or -1
  std::vector<Block> blocks = {};
  std::int32_t free_block = -1;  // the first of those in no cell

 private:
  void remake();
  void put(std::int32_t node);
};

}  // namespace vandplan::tables

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "tables/pose_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

namespace vandplan::tables {
namespace {

// Mean number of nodes in a cell. Measured: 3 and 10 are slower.
constexpr double nodes_per_cell = 6.0;
constexpr std::size_t fewest_nodes_for_a_grid = 32;

}  // namespace

GridCell PoseGrid::cell_of(const Pose& pose) const noexcept {
  const double x = std::clamp((pose.x - x_min) / cell_size, 0.0, columns - 0.5);
  const double y = std::clamp((pose.y - y_min) / cell_size, 0.0, rows - 0.5);
  return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
}

std::size_t PoseGrid::index_of(GridCell cell) const noexcept {
  return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns) +
         static_cast<std::size_t>(cell.x);
}

void PoseGrid::add(const Pose& pose) {
  poses.push_back(pose);
  if (++count > limit) {
    remake();
  } else {
    put(static_cast<std::int32_t>(poses.size()) - 1);
  }
}

void PoseGrid::remove(std::int32_t node) {
  std::int32_t& first = first_block[index_of(cell_of(pose(node)))];
  for (std::int32_t next = first; next >= 0; next = block(next).next) {
    Block& holder = block(next);
    const std::span<const std::int32_t> there(holder.node, holder.count);
    const auto at = static_cast<std::size_t>(std::ranges::find(there, node) - there.begin());
    if (at == holder.count) continue;
    // The last node of the cell's first block fills the gap, since only that block may be
    // incomplete.
    Block& source = block(first);
    const std::size_t last = --source.count;
    holder.x[at] = source.x[last];
    holder.y[at] = source.y[last];
    holder.heading[at] = source.heading[last];
    holder.node[at] = source.node[last];
    if (last == 0) {
      const std::int32_t emptied = first;
      first = source.next;
      source.next = free_block;
      free_block = emptied;
    }
    removed.resize(poses.size());
    removed[static_cast<std::size_t>(node)] = true;
    --count;
    return;
  }
  assert(false);  // the node is not there
}

void PoseGrid::remake() {
  limit = std::max(fewest_nodes_for_a_grid, 2 * count);
  removed.resize(poses.size());
  x_min = y_min = std::numeric_limits<double>::infinity();
  double x_max = -std::numeric_limits<double>::infinity();
  double y_max = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (removed[i]) continue;
    const Pose& pose = poses[i];
    x_min = std::min(x_min, pose.x);
    y_min = std::min(y_min, pose.y);
    x_max = std::max(x_max, pose.x);
    y_max = std::max(y_max, pose.y);
  }
  const double width = x_max - x_min;
  const double height = y_max - y_min;
  const double cells = 0.75 * static_cast<double>(limit) / nodes_per_cell;
  cell_size = std::max(std::sqrt(width / cells) * std::sqrt(height), width / cells);
  cell_size = std::max(cell_size, height / cells);
  if (cell_size == 0.0) cell_size = 1.0;
  columns = static_cast<std::int32_t>(width / cell_size) + 1;
  rows = static_cast<std::int32_t>(height / cell_size) + 1;
  first_block.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), -1);
  blocks.clear();
  free_block = -1;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!removed[i]) put(static_cast<std::int32_t>(i));
  }
}

void PoseGrid::put(std::int32_t node) {
  const Pose& at = pose(node);
  std::int32_t& first = first_block[index_of(cell_of(at))];
  if (first < 0 || block(first).count == Block::capacity) {
    std::int32_t fresh = free_block;
    if (fresh < 0) {
      fresh = static_cast<std::int32_t>(blocks.size());
      blocks.emplace_back();
    } else {
      free_block = block(fresh).next;
    }
    block(fresh).next = first;
    first = fresh;
  }
  Block& holder = block(first);
  holder.x[holder.count] = at.x;
  holder.y[holder.count] = at.y;
  holder.heading[holder.count] = static_cast<float>(wrap_angle(at.heading));
  holder.node[holder.count] = node;
  ++holder.count;
}

}  // namespace vandplan::tables

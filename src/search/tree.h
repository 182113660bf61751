// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which nodes does a search tree have?

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/path.h"
#include "vandplan/planner.h"

namespace vandplan {

/// Position of a node in its tree; the root is 0 and parents come before their children.
using NodeId = std::int32_t;

/// Nodes as structure of arrays. What decides is double; the float copies are for kernels that
/// rank. An edge is not stored: it is the Reeds-Shepp path from the parent's pose to the node's.
class Tree {
 public:
  /// Reserves room for `capacity` nodes, so that `add` does not allocate.
  Tree(const Pose& root, std::size_t capacity);

  NodeId add(const Pose& pose, NodeId parent, double cost_to_come);

  [[nodiscard]] std::size_t size() const noexcept { return poses_.size(); }
  [[nodiscard]] const Pose& pose(NodeId id) const noexcept { return poses_[index(id)]; }
  [[nodiscard]] NodeId parent(NodeId id) const noexcept { return parents_[index(id)]; }
  /// Length of the path from the root [m].
  [[nodiscard]] double cost_to_come(NodeId id) const noexcept { return costs_[index(id)]; }

  [[nodiscard]] std::span<const float> x() const noexcept { return x_; }
  [[nodiscard]] std::span<const float> y() const noexcept { return y_; }
  /// In [-pi, pi).
  [[nodiscard]] std::span<const float> heading() const noexcept { return heading_; }
  [[nodiscard]] std::span<const float> cost_to_come() const noexcept { return ranking_cost_; }

  /// The poses from the root to the node, both included.
  [[nodiscard]] std::vector<Pose> branch(NodeId id) const;

  [[nodiscard]] TreeSnapshot snapshot() const { return {poses_, parents_}; }

 private:
  static std::size_t index(NodeId id) noexcept { return static_cast<std::size_t>(id); }

  std::vector<Pose> poses_;
  std::vector<NodeId> parents_;
  std::vector<double> costs_;
  std::vector<float> x_, y_, heading_, ranking_cost_;
};

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// A search tree whose nodes may get better parents.

#include <vector>

#include "vandplan/search.h"

namespace vandplan::search {

/// A tree that knows the cost of every edge. When a node gets another parent, the costs-to-come of
/// all nodes below it follow.
class RewiredTree {
 public:
  explicit RewiredTree(const LocalPose& root);

  /// Adds a node below `parent`, at the end of an edge that costs `edge_cost` [m].
  NodeId add(const LocalPose& pose, NodeId parent, double edge_cost);

  /// Moves a node, with all nodes below it, to another parent, which is not below the node. The new
  /// edge costs `edge_cost` [m].
  void move(NodeId node, NodeId parent, double edge_cost);

  [[nodiscard]] std::size_t size() const noexcept { return nodes_.size(); }
  [[nodiscard]] const LocalPose& pose(NodeId id) const noexcept { return at(id).pose; }
  [[nodiscard]] NodeId parent(NodeId id) const noexcept { return at(id).parent; }
  /// Cost of the path from the root [m].
  [[nodiscard]] double cost_to_come(NodeId id) const noexcept { return at(id).cost_to_come; }

  /// The poses from the root to the node, both included.
  [[nodiscard]] std::vector<LocalPose> branch(NodeId id) const;

  /// The nodes in the order of `add`, except that each node follows its parent.
  [[nodiscard]] TreeSnapshot snapshot() const;

 private:
  /// A node. Its children form a doubly linked list by `next` and `previous`; -1: none.
  struct Node {
    LocalPose pose;
    double edge_cost;
    double cost_to_come = 0.0;
    NodeId parent = -1, first_child = -1, next = -1, previous = -1;
  };

  [[nodiscard]] const Node& at(NodeId id) const noexcept {
    return nodes_[static_cast<std::size_t>(id)];
  }
  Node& at(NodeId id) noexcept { return nodes_[static_cast<std::size_t>(id)]; }
  void take_out(NodeId id);
  void put_in(NodeId id, NodeId parent, double edge_cost);

  std::vector<Node> nodes_;
  std::vector<NodeId> below_;  // buffer of `move`: nodes whose children are updated next
};

}  // namespace vandplan::search

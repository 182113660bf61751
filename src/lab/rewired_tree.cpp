// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/rewired_tree.h"

#include <algorithm>

namespace vandplan::search {

RewiredTree::RewiredTree(const LocalPose& root) { nodes_.push_back({root, 0.0}); }

NodeId RewiredTree::add(const LocalPose& pose, NodeId parent, double edge_cost) {
  const auto id = static_cast<NodeId>(nodes_.size());
  nodes_.push_back({pose, edge_cost});
  put_in(id, parent, edge_cost);
  return id;
}

void RewiredTree::move(NodeId node, NodeId parent, double edge_cost) {
  take_out(node);
  put_in(node, parent, edge_cost);
  below_.assign(1, node);
  while (!below_.empty()) {
    const Node& above = at(below_.back());
    below_.pop_back();
    for (NodeId child = above.first_child; child >= 0; child = at(child).next) {
      at(child).cost_to_come = above.cost_to_come + at(child).edge_cost;
      below_.push_back(child);
    }
  }
}

void RewiredTree::take_out(NodeId id) {
  const Node& node = at(id);
  (node.previous >= 0 ? at(node.previous).next : at(node.parent).first_child) = node.next;
  if (node.next >= 0) at(node.next).previous = node.previous;
}

void RewiredTree::put_in(NodeId id, NodeId parent, double edge_cost) {
  Node& node = at(id);
  node.parent = parent;
  node.edge_cost = edge_cost;
  node.cost_to_come = at(parent).cost_to_come + edge_cost;
  node.previous = -1;
  node.next = at(parent).first_child;
  if (node.next >= 0) at(node.next).previous = id;
  at(parent).first_child = id;
}

std::vector<LocalPose> RewiredTree::branch(NodeId id) const {
  std::vector<LocalPose> poses;
  for (NodeId i = id; i >= 0; i = parent(i)) poses.push_back(pose(i));
  std::ranges::reverse(poses);
  return poses;
}

TreeSnapshot RewiredTree::snapshot() const {
  TreeSnapshot tree;
  std::vector<std::int32_t> place(nodes_.size(), -1);
  std::vector<NodeId> waiting;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (auto id = static_cast<NodeId>(i); id >= 0 && place[static_cast<std::size_t>(id)] < 0;
         id = parent(id)) {
      waiting.push_back(id);
    }
    for (; !waiting.empty(); waiting.pop_back()) {
      const NodeId id = waiting.back();
      place[static_cast<std::size_t>(id)] = static_cast<std::int32_t>(tree.poses.size());
      tree.poses.push_back(pose(id));
      const NodeId above = parent(id);
      tree.parents.push_back(above < 0 ? -1 : place[static_cast<std::size_t>(above)]);
    }
  }
  return tree;
}

}  // namespace vandplan::search

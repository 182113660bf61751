// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>

#include "vandplan/search.h"

namespace vandplan::search {

Tree::Tree(const LocalPose& root, std::size_t capacity) {
  poses_.reserve(capacity);
  parents_.reserve(capacity);
  costs_.reserve(capacity);
  for (auto* floats : {&x_, &y_, &heading_, &ranking_cost_}) floats->reserve(capacity);
  add(root, -1, 0.0);
}

NodeId Tree::add(const LocalPose& pose, NodeId parent, double cost_to_come) {
  const auto id = static_cast<NodeId>(poses_.size());
  poses_.push_back(pose);
  parents_.push_back(parent);
  costs_.push_back(cost_to_come);
  x_.push_back(static_cast<float>(pose.x));
  y_.push_back(static_cast<float>(pose.y));
  heading_.push_back(static_cast<float>(wrap_angle(pose.heading)));
  ranking_cost_.push_back(static_cast<float>(cost_to_come));
  return id;
}

std::vector<LocalPose> Tree::branch(NodeId id) const {
  std::vector<LocalPose> poses;
  for (NodeId i = id; i >= 0; i = parent(i)) poses.push_back(pose(i));
  std::reverse(poses.begin(), poses.end());
  return poses;
}

}  // namespace vandplan::search

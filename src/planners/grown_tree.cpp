// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/grown_tree.h"

#include "planners/tree_parts.h"

namespace vandplan::planning {

using namespace search;

GrownTree::GrownTree(const Task& task, const PlanOptions& options, Estimate estimate, RankBy by)
    : task_(task),
      max_nodes_(static_cast<std::size_t>(options.planner.integer("max_nodes"))),
      profile_(options.planner.flag("profile")),
      connector_(task, {}, profile_),
      tree_(task.start, max_nodes_),
      ranking_(tree_, connector_.radius(), max_nodes_, estimate, by),
      ranking_time_(profile_) {}

const std::vector<Candidate>& GrownTree::first(std::size_t count, const Pose& sample) {
  ranking_time_.start();
  const std::vector<Candidate>& candidates = ranking_.first(count, sample);
  ranking_time_.stop();
  return candidates;
}

std::optional<Adoption> GrownTree::try_edge(NodeId node, const Pose& to, double cutoff) {
  const auto edge =
      edge_between(connector_, tree_.pose(node), to, tree_.cost_to_come(node), cutoff);
  if (!edge) return std::nullopt;
  return Adoption{node, edge->cost};
}

NodeId GrownTree::add(const Pose& pose, const Adoption& adoption) {
  const NodeId added = tree_.add(pose, adoption.parent, adoption.cost_to_come);
  ranking_.add_last();
  return added;
}

void GrownTree::report(const PlanOptions& options, const Adoption& best, PlanStatus unsolved,
                       PlannerAnswer& answer) {
  answer.status = unsolved;
  if (best.parent >= 0) {
    std::vector<Pose> poses = tree_.branch(best.parent);
    poses.push_back(task_.goal);
    answer.status = PlanStatus::solved;
    answer.segments = segments_along(connector_, poses);
  }
  answer.counters = counters_of(tree_.size(), connector_, ranking_.exact_solves());
  if (profile_) {
    answer.phases = {{"ranking", ranking_time_.seconds()},
                     {"steering", connector_.steering_time()},
                     {"checking", connector_.checking_time()}};
  }
  if (options.planner.flag("keep_tree")) answer.tree = tree_.snapshot();
}

}  // namespace vandplan::planning

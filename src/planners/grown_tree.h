// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do planners share that grow one tree from the start, sample by sample?

#include <limits>
#include <optional>
#include <vector>

#include "search/ranking.h"
#include "vandplan/outcome.h"
#include "vandplan/plan_options.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// A parent for a pose, and what the pose then costs.
struct Adoption {
  search::NodeId parent = -1;
  double cost_to_come = std::numeric_limits<double>::infinity();
};

/// A tree, how its edges are made, and which of its nodes are tried first.
class GrownTree {
 public:
  /// Of the start alone. The task outlives it.
  GrownTree(const Task& task, const PlanOptions& options, search::Estimate estimate,
            search::RankBy by);

  /// The first `count` nodes in order; valid until the next call.
  const std::vector<search::Candidate>& first(std::size_t count, const Pose& sample);
  /// The edge from a node to a pose, if it is free and reaches the pose below the cutoff of cost.
  std::optional<Adoption> try_edge(search::NodeId node, const Pose& to,
                                   double cutoff = std::numeric_limits<double>::infinity());
  search::NodeId add(const Pose& pose, const Adoption& adoption);
  [[nodiscard]] bool is_full() const { return tree_.size() >= max_nodes_; }
  [[nodiscard]] const search::Tree& nodes() const { return tree_; }

  /// Fills in what was found, counted and measured, and the tree if it is wanted; `best` is the
  /// node before the goal, if there is one, and `unsolved` the status if there is none.
  void report(const PlanOptions& options, const Adoption& best, PlanStatus unsolved,
              PlannerAnswer& answer);

 private:
  const Task& task_;
  std::size_t max_nodes_;
  bool profile_;
  search::Connector connector_;
  search::Tree tree_;
  search::Ranking ranking_;
  search::PhaseTimer ranking_time_;
};

}  // namespace vandplan::planning

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do planners share that grow one tree from the start, sample by sample?

#include <limits>
#include <optional>
#include <vector>

#include "lab/ranking.h"
#include "vandplan/outcome.h"
#include "vandplan/plan_options.h"
#include "vandplan/rig_steering.h"
#include "vandplan/rig_table.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// A parent for a state, and what the state then costs.
struct Adoption {
  search::NodeId parent = -1;
  double cost_to_come = std::numeric_limits<double>::infinity();
};

/// A tree, how its edges are made, and which of its nodes are tried first. With a trailer nodes are
/// states of the rig, and edges those of `RigSteering`; nodes are ranked by their states where the
/// estimate is a table of the thesis, which is the table of rigs then, and else by their poses.
class GrownTree {
 public:
  /// Of the start alone. The task outlives it.
  GrownTree(const Task& task, const PlanOptions& options, search::Estimate estimate,
            search::RankBy by);

  /// The first `count` nodes in order; valid until the next call.
  const std::vector<search::Candidate>& first(std::size_t count, const RigState& sample);
  /// The edge from a node to a state, if it is free and reaches the state below the cutoff of cost.
  std::optional<Adoption> try_edge(search::NodeId node, const RigState& to,
                                   double cutoff = std::numeric_limits<double>::infinity());
  search::NodeId add(const RigState& state, const Adoption& adoption);
  /// Whether the edge to the goal makes a way that can be driven, which is kept then. Without a
  /// trailer any does. A trailer in reverse runs away from rounding, edge after edge: its way is
  /// bent until it ends at the goal, and looked at again.
  bool keep_way(const Adoption& to_goal);
  /// What the task wants to reach.
  [[nodiscard]] RigState goal() const { return {task_.goal, task_.hitch_angles.goal}; }
  [[nodiscard]] bool is_full() const { return tree_.size() >= max_nodes_; }
  [[nodiscard]] const search::Tree& nodes() const { return tree_; }

  /// Fills in what was found, counted and measured, and the tree if it is wanted; `best` is the
  /// node before the goal whose way was kept last, if there is one, and `unsolved` the status if
  /// there is none.
  void report(const PlanOptions& options, const Adoption& best, PlanStatus unsolved,
              PlannerAnswer& answer);

 private:
  void rank_by_table(const RigState& sample);
  std::optional<Adoption> try_rig_edge(search::NodeId node, const RigState& to, double cutoff);
  [[nodiscard]] RigState state(search::NodeId node) const;

  const Task& task_;
  std::size_t max_nodes_;
  bool profile_;
  search::Connector connector_;
  search::Tree tree_;
  search::Ranking ranking_;
  search::PhaseTimer ranking_time_;
  // With a trailer:
  std::optional<RigSteering> rig_;
  std::optional<RigTable> rig_table_;    // if it ranks,
  std::vector<RigTable::Place> places_;  // all nodes,
  std::vector<float> lengths_;           // and their lengths to a sample [m]
  std::vector<double> hitch_angles_;     // of all nodes [rad]
  std::vector<Segment> way_;             // to the goal, if one is kept
  std::int64_t rig_solves_ = 0, rig_checks_ = 0;
  search::PhaseTimer rig_steering_time_, rig_checking_time_;
};

}  // namespace vandplan::planning

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do the planners share that grow one tree from the start, sample by sample?

#include <limits>
#include <optional>
#include <vector>

#include "lab/ranking.h"
#include "sites/estimate.h"
#include "tables/rig_table.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan::planning {

/// A parent for a state, and the state's cost-to-come through this parent [m].
struct Adoption {
  search::NodeId parent = -1;
  double cost_to_come = std::numeric_limits<double>::infinity();
};

/// A search tree, with its edges and the ranking of its nodes. With a trailer nodes are states of
/// the rig, and edges are pieces of `RigSteering`. If the estimate is a table of the thesis, the
/// table of rigs ranks states instead. Other estimates rank the poses of the vehicle. The estimate
/// `site` needs `PlanOptions::site`.
class GrownTree {
 public:
  /// A tree of the start alone. The task outlives the tree. Throws InputError naming "site" if the
  /// table of the estimate does not serve the task.
  GrownTree(const Task& task, const PlanOptions& options, search::Estimate estimate,
            search::RankBy by);

  /// The first `count` nodes in the ranking for a sample; valid until the next call.
  const std::vector<search::Candidate>& first(std::size_t count, const State& sample);
  /// The edge from a node to a state. None if it is not free, or the state's cost-to-come is not
  /// below `cutoff` [m].
  std::optional<Adoption> try_edge(search::NodeId node, const State& to,
                                   double cutoff = std::numeric_limits<double>::infinity());
  /// Adds a state as a node below its parent.
  search::NodeId add(const State& state, const Adoption& adoption);
  /// Keeps the way over an edge to the goal. False if the way cannot be driven, which only happens
  /// with a trailer: in reverse, rounding errors grow from edge to edge. So the way is bent until
  /// it ends exactly at the goal, and checked again.
  bool keep_way(const Adoption& to_goal);
  /// State at the goal of the task.
  [[nodiscard]] State goal() const { return goal_state(task_); }
  [[nodiscard]] bool is_full() const { return tree_.size() >= max_nodes_; }
  [[nodiscard]] const search::Tree& nodes() const { return tree_; }

  /// Fills in status, segments, counters, times, and the tree if the options ask for it. `best`:
  /// the parent of the goal on the last kept way; -1 if there is none. `unsolved`: status without a
  /// way.
  void report(const PlanOptions& options, const Adoption& best, PlanStatus unsolved,
              PlannerAnswer& answer);

 private:
  void rank_by_table(const State& sample);
  void rank_by_site(const Pose& sample);
  std::optional<Adoption> try_rig_edge(search::NodeId node, const State& to, double cutoff);
  [[nodiscard]] State state(search::NodeId node) const;

  const Task& task_;
  std::size_t max_nodes_;
  bool profile_;
  search::Connector connector_;
  search::Tree tree_;
  search::Ranking ranking_;
  search::PhaseTimer ranking_time_;
  std::optional<sites::CostDifferences> site_;  // differences that raise lengths; or none
  std::vector<float> lengths_;                  // length from each node to a sample [m]
  // The members below are used with a trailer only.
  std::optional<RigSteering> rig_;
  std::optional<RigTable> rig_table_;    // table that ranks the nodes; none: poses rank them
  std::vector<RigTable::Place> places_;  // place of each node in the table
  std::vector<double> hitch_angles_;     // hitch angle of each node [rad]
  std::vector<Segment> way_;             // segments of the kept way; empty: there is none
  std::int64_t rig_solves_ = 0, rig_checks_ = 0;
  search::PhaseTimer rig_steering_time_, rig_checking_time_;
};

}  // namespace vandplan::planning

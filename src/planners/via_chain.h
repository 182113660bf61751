// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// At which poses does a path pass its vias, and what joins them?

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "planners/goal_poses.h"
#include "planners/path_search.h"
#include "vandplan/path.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// A pose at which a path passes a via.
struct ViaNode {
  GoalPoint point = {};
  LocalState state = {};
  search::GearSign gear = 0;  ///< gear in which the vehicle goes on; 0: in any
  bool stands = false;        ///< whether the vehicle stands there
  double curvature = 0.0;     ///< curvature with which it drives through [1/m]
  std::size_t number = 0;     ///< number among the nodes of its via
};

/// The nodes of all vias, and which of them a path should take.
class ViaNodes {
 public:
  /// Free poses of each via that zones let the vehicle pass, evenly spread. The task outlives the
  /// nodes. `rule`: prices. Once the budget is interrupted no further pose is looked at.
  ViaNodes(const Task& task, const search::CostRule& rule, const search::Budget& budget);

  /// Index of the first via without a free pose; none if each has one.
  [[nodiscard]] std::optional<std::size_t> empty_via() const;
  /// Whether the budget was interrupted before all poses were looked at.
  [[nodiscard]] bool is_cut_short() const { return is_cut_short_; }
  /// Whether it is proven that no path passes a via.
  [[nodiscard]] bool is_closed(std::size_t via) const { return is_closed_[via]; }
  /// Whether it is proven that no path leads from the start to any place of a via, or to the goal,
  /// which follows the last via. It is looked at once for each; after that the answer is false.
  [[nodiscard]] bool is_out_of_reach(std::size_t via, const search::Budget& budget);
  /// Number of poses of a via that were looked at.
  [[nodiscard]] std::size_t looked_at(std::size_t via) const { return looked_at_[via]; }
  /// Why a via has no free pose, as a reason.
  [[nodiscard]] std::string why_empty(std::size_t via) const;
  /// Whether all vias are single poses, all of which are nodes.
  [[nodiscard]] bool are_all() const;

  /// The chain of one node of each via that seems shortest, without the legs that were given up.
  /// None if there is none.
  [[nodiscard]] std::optional<std::vector<ViaNode>> best_chain() const;
  /// Nodes at which a path passes the vias, as further ones; none if one is not in its via or not
  /// free. `passed`: the driven distance to each via [m].
  [[nodiscard]] std::optional<std::vector<ViaNode>> along(const Path& path,
                                                          std::span<const double> passed);
  /// Gives up the leg that leads to node `to` of a via from node `from` of the via before.
  void give_up(std::size_t via, std::size_t from, std::size_t to) { lost_.insert({via, from, to}); }
  /// Says that such a leg was looked for in vain, so far. Chains with one of its nodes come later.
  void doubt(std::size_t via, std::size_t from, std::size_t to);

  /// Free nodes beside `chain[via]`: by `share` of the intervals of its region, in the other gear,
  /// and with other curvatures.
  [[nodiscard]] std::vector<ViaNode> beside(const std::vector<ViaNode>& chain, std::size_t via,
                                            double share) const;
  /// Other nodes of a via, the most promising ones first: those with less than `slack` times the
  /// straight way through `chain[via]`.
  [[nodiscard]] std::vector<ViaNode> others(const std::vector<ViaNode>& chain, std::size_t via,
                                            double slack) const;

 private:
  using LegKey = std::tuple<std::size_t, std::size_t, std::size_t>;

  /// The node of a via at a state, as a further one; none if the state is not in the via or not
  /// free. `gear`: gear in which the vehicle goes on.
  [[nodiscard]] std::optional<ViaNode> added(std::size_t via, const LocalState& state,
                                             search::GearSign gear, double curvature);
  [[nodiscard]] double doubt_of(std::size_t via, std::size_t node) const;
  [[nodiscard]] double estimate(const LocalState& from, const LocalState& to) const;
  [[nodiscard]] double way_through(const std::vector<ViaNode>& chain, std::size_t via,
                                   const LocalState& state) const;
  [[nodiscard]] bool is_free(const ViaNode& node) const;
  [[nodiscard]] double sharpest_through() const;
  void add_gears(std::size_t via, const ViaNode& node, std::vector<ViaNode>& nodes) const;
  void look_closer(std::size_t via, const search::Budget& budget);

  const Task& task_;
  search::CostRule rule_;
  std::vector<Task> tasks_;  // of each via: a task with the via as its set of goals
  std::vector<std::vector<ViaNode>> nodes_;
  std::vector<std::size_t> looked_at_;
  std::vector<bool> is_closed_;  // of each via: whether it is proven that none of it is free
  bool is_cut_short_ = false;
  std::set<std::size_t> looked_for_;                           // vias for which a proof was tried
  std::set<LegKey> lost_;                                      // legs that were given up
  std::map<std::pair<std::size_t, std::size_t>, int> doubts_;  // of the nodes of each via
};

}  // namespace vandplan::planning

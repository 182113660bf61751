// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/grown_tree.h"

#include <utility>

#include "lab/tree_parts.h"
#include "planners/commands/closer.h"
#include "sites/way.h"

namespace vandplan::planning {

using namespace search;

namespace {

/// Whether the estimate is a table of the thesis.
bool is_table(Estimate estimate) {
  return estimate == Estimate::hlut_1 || estimate == Estimate::hlut_2 ||
         estimate == Estimate::hlut_3 || estimate == Estimate::hlut_4;
}

}  // namespace

GrownTree::GrownTree(const Task& task, const PlanOptions& options, Estimate estimate, RankBy by)
    : task_(task),
      max_nodes_(static_cast<std::size_t>(options.planner.integer("max_nodes"))),
      profile_(options.planner.flag("profile")),
      connector_(task, search::length_rule(search::cost_rule(options.cost)), profile_),
      tree_(task.start, max_nodes_),
      ranking_(tree_, connector_.radius(), max_nodes_, estimate, by, connector_.rule().only_gear()),
      ranking_time_(profile_),
      rig_steering_time_(profile_),
      rig_checking_time_(profile_) {
  if (estimate == Estimate::site) {
    sites::expect_serves(*options.site, task, options);
    site_.emplace(*options.site, task, connector_.rule().only_gear() != 0, max_nodes_);
    site_->add(task.start);
    lengths_.reserve(max_nodes_);
  }
  if (!task.vehicle.trailer) return;
  rig_.emplace(task.vehicle);
  hitch_angles_.reserve(max_nodes_);
  hitch_angles_.push_back(task.hitch_angles.start);
  if (!is_table(estimate)) return;
  rig_table_ = embedded_rig_table(task.vehicle);
  places_.push_back(rig_table_->place_of(state(0)));
}

State GrownTree::state(NodeId node) const {
  return {tree_.pose(node), rig_ ? hitch_angles_[static_cast<std::size_t>(node)] : 0.0};
}

const std::vector<Candidate>& GrownTree::first(std::size_t count, const State& sample) {
  ranking_time_.start();
  if (rig_table_) rank_by_table(sample);
  if (site_) rank_by_site(sample.pose);
  const std::vector<Candidate>& candidates =
      rig_table_ || site_ ? ranking_.first(count, lengths_) : ranking_.first(count, sample.pose);
  ranking_time_.stop();
  return candidates;
}

void GrownTree::rank_by_table(const State& sample) {
  const RigTable::Place to = rig_table_->place_of(sample);
  lengths_.clear();
  for (const RigTable::Place& from : places_) {
    lengths_.push_back(static_cast<float>(rig_table_->look_up(from, to)));
  }
}

void GrownTree::rank_by_site(const Pose& sample) {
  lengths_.resize(tree_.size());
  estimate_lengths(Estimate::site, tree_, sample, connector_.radius(), lengths_);
  site_->raise(Local(sample), lengths_);
}

std::optional<Adoption> GrownTree::try_edge(NodeId node, const State& to, double cutoff) {
  if (rig_) return try_rig_edge(node, to, cutoff);
  const auto edge =
      edge_between(connector_, tree_.pose(node), Local(to.pose), tree_.cost_to_come(node), cutoff);
  if (!edge) return std::nullopt;
  return Adoption{node, edge->cost};
}

// Steers without a cutoff, because `keep_way` steers the edge again and must find the same piece.
std::optional<Adoption> GrownTree::try_rig_edge(NodeId node, const State& to, double cutoff) {
  rig_steering_time_.start();
  ++rig_solves_;
  const std::optional<Piece> piece = rig_->steer(state(node), to);
  rig_steering_time_.stop();
  if (!piece || !search::may_drive(connector_.rule(), piece->view())) return std::nullopt;
  const double cost = tree_.cost_to_come(node) + piece->length;
  if (cost >= cutoff) return std::nullopt;
  rig_checking_time_.start();
  ++rig_checks_;
  const bool is_free = task_.checker->is_free(Local(state(node)), piece->view());
  rig_checking_time_.stop();
  if (!is_free) return std::nullopt;
  return Adoption{node, cost};
}

NodeId GrownTree::add(const State& state, const Adoption& adoption) {
  const NodeId added = tree_.add(Local(state.pose), adoption.parent, adoption.cost_to_come);
  if (rig_) hitch_angles_.push_back(state.hitch_angle);
  if (site_) site_->add(Local(state.pose));
  if (rig_table_) places_.push_back(rig_table_->place_of(state));
  ranking_.add_last();
  return added;
}

bool GrownTree::keep_way(const Adoption& to_goal) {
  if (!rig_) return true;
  std::vector<State> states = {goal()};
  for (NodeId node = to_goal.parent; node >= 0; node = tree_.parent(node)) {
    states.push_back(state(node));
  }
  std::vector<Segment> way;
  for (std::size_t i = states.size() - 1; i > 0; --i) {
    const std::optional<Piece> piece = rig_->steer(states[i], states[i - 1]);
    way.insert(way.end(), piece->view().begin(), piece->view().end());
  }
  const commands::Wheels wheels(task_.vehicle, Steering::reeds_shepp);
  std::vector<commands::Command> chain = wheels.commands(way, {});
  if (!commands::Closer(task_.vehicle).close(state(0), chain, goal())) return false;
  way = wheels.driven(chain, {});
  if (!task_.checker->is_free(Local(state(0)), way)) return false;
  way_ = std::move(way);
  return true;
}

void GrownTree::report(const PlanOptions& options, const Adoption& best, PlanStatus unsolved,
                       PlannerAnswer& answer) {
  answer.status = unsolved;
  if (best.parent >= 0) {
    answer.status = PlanStatus::solved;
    if (rig_) {
      answer.segments = way_;
    } else {
      std::vector<LocalPose> poses = tree_.branch(best.parent);
      poses.push_back(task_.goal);
      answer.segments = segments_along(connector_, poses);
    }
  }
  answer.counters =
      counters_of(tree_.size(), connector_.solves() + rig_solves_ + ranking_.exact_solves(),
                  connector_.checks() + rig_checks_);
  if (profile_) {
    answer.phases = {{"ranking", ranking_time_.seconds()},
                     {"steering", connector_.steering_time() + rig_steering_time_.seconds()},
                     {"checking", connector_.checking_time() + rig_checking_time_.seconds()}};
  }
  if (options.planner.flag("keep_tree")) answer.tree = tree_.snapshot();
}

}  // namespace vandplan::planning

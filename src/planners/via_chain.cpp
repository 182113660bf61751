// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/via_chain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/free_parts.h"
#include "planners/out_of_reach.h"
#include "planners/zone_exits.h"
#include "search/route.h"
#include "vandplan/steering.h"

namespace vandplan::planning {
namespace {

constexpr double no_way = std::numeric_limits<double>::infinity();
constexpr std::size_t max_nodes_of_region = 16;  // poses of a region with intervals
constexpr std::size_t max_nodes_of_via = 64;     // poses of all regions of a via, but two of each
constexpr double share_of_doubt = 0.1;           // of the length of a leg, for each search in vain
/// Change of a curvature beside, in shares of the tightest curvature, for a share of intervals.
constexpr double share_of_curvature = 4.0;

}  // namespace

ViaNodes::ViaNodes(const Task& task, const search::CostRule& rule, const search::Budget& budget)
    : task_(task), rule_(rule) {
  for (const Via& via : task.via) {
    Task& alone = tasks_.emplace_back(task);
    alone.via.clear();
    alone.goal_set = via.any_of;
    const std::size_t index = nodes_.size();
    std::vector<ViaNode>& nodes = nodes_.emplace_back();
    std::size_t& looked_at = looked_at_.emplace_back(0);
    const std::size_t regions = via.any_of.size();
    const std::size_t most =
        std::clamp<std::size_t>(max_nodes_of_via / regions, 2, max_nodes_of_region);
    for (std::size_t region = 0; region < regions; ++region) {
      spread(alone, region, most, [&](const GoalPoint& point) {
        is_cut_short_ = is_cut_short_ || budget.is_interrupted();
        if (is_cut_short_) return false;
        ++looked_at;
        const ViaNode node{.point = point, .state = state_of(alone, point)};
        if (!is_free(node)) return false;
        add_gears(index, node, nodes);
        return true;
      });
    }
    is_closed_.push_back(false);
    if (nodes.empty() && !is_cut_short_) look_closer(index, budget);
  }
}

/// Looks for nodes in ever smaller parts of a via.
void ViaNodes::look_closer(std::size_t via, const search::Budget& budget) {
  const auto node_at = [&](const GoalPoint& point) {
    return ViaNode{.point = point, .state = state_of(tasks_[via], point)};
  };
  const auto fits = [&](const GoalPoint& point) {
    ++looked_at_[via];
    return is_free(node_at(point));
  };
  const auto [points, is_proof] = free_points(tasks_[via], rule_.only_gear(), budget, fits);
  is_cut_short_ = budget.is_interrupted();
  is_closed_[via] = is_proof && task_.via[via].any_of.size() <= max_nodes_of_via / 2;
  for (const GoalPoint& point : points) add_gears(via, node_at(point), nodes_[via]);
}

bool ViaNodes::is_free(const ViaNode& node) const {
  return task_.checker->is_free(node.state) && may_leave(task_, rule_, node.state, node.gear);
}

/// Adds a node for each gear in which the vehicle may go on; one if it stands there and a gear
/// change costs nothing.
void ViaNodes::add_gears(std::size_t via, const ViaNode& node, std::vector<ViaNode>& nodes) const {
  const bool stands = task_.via[via].stop;
  const bool is_any = stands && rule_.gear_change_cost == 0.0;
  for (const search::GearSign gear : {1, -1}) {
    const search::GearSign goes_on = is_any ? 0 : gear;
    if (!may_leave(task_, rule_, node.state, goes_on)) continue;
    ViaNode& added = nodes.emplace_back(node);
    added.number = nodes.size() - 1;
    added.gear = goes_on;
    added.stands = stands;
    if (is_any) return;
  }
}

std::optional<ViaNode> ViaNodes::added(std::size_t via, const LocalState& state,
                                       search::GearSign gear, double curvature) {
  const std::optional<GoalPoint> point = point_at(tasks_[via], state);
  if (!point) return std::nullopt;
  ViaNode node{.point = *point, .state = state_of(tasks_[via], *point)};
  node.stands = task_.via[via].stop;
  node.gear = node.stands && rule_.gear_change_cost == 0.0 ? 0 : gear;
  if (!is_free(node)) return std::nullopt;
  if (task_.steering != Steering::reeds_shepp) {
    const double sharpest = sharpest_through();
    node.curvature = std::clamp(curvature, -sharpest, sharpest);
  }
  node.number = nodes_[via].size();
  nodes_[via].push_back(node);
  return node;
}

std::optional<std::vector<ViaNode>> ViaNodes::along(const Path& path,
                                                    std::span<const double> passed) {
  constexpr double end = std::numeric_limits<double>::infinity();
  std::vector<ViaNode> chain;
  chain.reserve(passed.size());
  for (std::size_t via = 0; via < passed.size(); ++via) {
    const std::vector<Segment> before = search::part_of(path.segments, 0.0, passed[via]);
    std::vector<Segment> behind = search::part_of(path.segments, passed[via], end);
    LocalState there = start_state(task_);
    for (const Segment& segment : before) there = advance(task_.vehicle, there, segment);
    if (behind.empty()) {
      if (before.empty()) return std::nullopt;
      const Segment& last = before.back();
      behind.push_back(part_of(last, std::abs(last.length), std::abs(last.length)));
    }
    const Segment& next = behind.front();
    const auto node = added(via, there, search::gear_of(next), next.curvature);
    if (!node) return std::nullopt;
    chain.push_back(*node);
  }
  return chain;
}

/// Tightest curvature with which a via is driven through [1/m].
double ViaNodes::sharpest_through() const {
  return (1 - 1e-9) / search::continuous_radius(task_.vehicle);
}

std::optional<std::size_t> ViaNodes::empty_via() const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].empty()) return i;
  }
  return std::nullopt;
}

std::string ViaNodes::why_empty(std::size_t via) const {
  const std::size_t poses = looked_at_[via];
  const std::string of_via = "of via[" + std::to_string(via) + "] ";
  const bool has_zones = !task_.world->local().zones.empty();
  const std::string taken = poses == 1        ? "the pose " + of_via + "is not free"
                            : is_closed_[via] ? "no pose " + of_via + "is free"
                                              : "none of the " + std::to_string(poses) + " poses " +
                                                    of_via + "that were looked at is free";
  return taken + (has_zones ? ", or zones do not let the vehicle pass there" : "");
}

bool ViaNodes::is_out_of_reach(std::size_t via, const search::Budget& budget) {
  if (!looked_for_.insert(via).second) return false;
  const State goal = goal_state(task_);
  const std::vector<GoalRegion> places =
      via < task_.via.size() ? task_.via[via].any_of : std::vector{region_of_pose(goal.pose)};
  return planning::is_out_of_reach(task_, places, rule_.only_gear(), budget);
}

bool ViaNodes::are_all() const {
  return !is_cut_short_ && std::ranges::all_of(task_.via, [](const Via& via) {
    return via.any_of.size() <= max_nodes_of_via / 2 &&
           std::ranges::none_of(via.any_of, is_continuous);
  });
}

void ViaNodes::doubt(std::size_t via, std::size_t from, std::size_t to) {
  if (via > 0) ++doubts_[{via - 1, from}];
  if (via < nodes_.size()) ++doubts_[{via, to}];
}

/// What the doubts about a node add to the legs to it and from it, as a share of their lengths.
double ViaNodes::doubt_of(std::size_t via, std::size_t node) const {
  const auto found = doubts_.find({via, node});
  return found == doubts_.end() ? 0.0 : share_of_doubt * found->second;
}

double ViaNodes::estimate(const LocalState& from, const LocalState& to) const {
  const State& begin = from;
  const State& end = to;
  return reeds_shepp_length(begin.pose, end.pose, task_.vehicle.min_turning_radius);
}

// Dynamic programming, via by via.
std::optional<std::vector<ViaNode>> ViaNodes::best_chain() const {
  std::vector<double> lengths = {0.0};
  std::vector<LocalState> before = {start_state(task_)};
  std::vector<std::vector<std::size_t>> from;
  for (std::size_t via = 0; via <= nodes_.size(); ++via) {
    const bool is_goal = via == nodes_.size();
    const std::size_t count = is_goal ? 1 : nodes_[via].size();
    std::vector<double> next(count, no_way);
    std::vector<LocalState> states;
    from.emplace_back(count, 0);
    for (std::size_t to = 0; to < count; ++to) {
      states.push_back(is_goal ? goal_state(task_) : nodes_[via][to].state);
      const double of_end = doubt_of(via, to);
      for (std::size_t i = 0; i < before.size(); ++i) {
        if (lost_.contains({via, i, to})) continue;
        const double doubts = (via > 0 ? doubt_of(via - 1, i) : 0.0) + of_end;
        const double length = lengths[i] + (1.0 + doubts) * estimate(before[i], states[to]);
        if (length >= next[to]) continue;
        next[to] = length;
        from.back()[to] = i;
      }
    }
    lengths = std::move(next);
    before = std::move(states);
  }
  if (!(lengths[0] < no_way)) return std::nullopt;
  std::vector<ViaNode> chain(nodes_.size());
  std::size_t at = 0;
  for (std::size_t via = nodes_.size(); via > 0; --via) {
    at = from[via][at];
    chain[via - 1] = nodes_[via - 1][at];
  }
  return chain;
}

/// Way from the node before through a state to the node behind [m].
double ViaNodes::way_through(const std::vector<ViaNode>& chain, std::size_t via,
                             const LocalState& state) const {
  const LocalState before = via == 0 ? start_state(task_) : chain[via - 1].state;
  const LocalState behind = via + 1 == chain.size() ? goal_state(task_) : chain[via + 1].state;
  return estimate(before, state) + estimate(state, behind);
}

std::vector<ViaNode> ViaNodes::beside(const std::vector<ViaNode>& chain, std::size_t via,
                                      double share) const {
  const ViaNode& node = chain[via];
  std::vector<ViaNode> found;
  for (const GoalPoint& point : planning::beside(tasks_[via], node.point, share)) {
    ViaNode other = node;
    other.point = point;
    other.state = state_of(tasks_[via], point);
    if (is_in_region(tasks_[via], point) && is_free(other)) found.push_back(other);
  }
  if (node.gear != 0 && rule_.allows(-node.gear)) {
    found.push_back(node);
    found.back().gear = -node.gear;
  }
  if (node.stands) return found;
  if (task_.steering != Steering::reeds_shepp) {
    const double sharpest = sharpest_through();
    for (const double step : {share, -share}) {
      ViaNode other = node;
      other.curvature =
          std::clamp(node.curvature + share_of_curvature * step * sharpest, -sharpest, sharpest);
      if (other.curvature != node.curvature) found.push_back(other);
    }
  }
  return found;
}

std::vector<ViaNode> ViaNodes::others(const std::vector<ViaNode>& chain, std::size_t via,
                                      double slack) const {
  const ViaNode& node = chain[via];
  const double most = slack * way_through(chain, via, node.state);
  std::vector<std::pair<double, ViaNode>> ranked;
  for (const ViaNode& other : nodes_[via]) {
    const bool is_same = other.point == node.point && other.gear == node.gear;
    const double way = way_through(chain, via, other.state);
    if (!is_same && way <= most) ranked.emplace_back(way, other);
  }
  std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
  std::vector<ViaNode> found;
  found.reserve(ranked.size());
  for (const auto& [way, other] : ranked) found.push_back(other);
  return found;
}

}  // namespace vandplan::planning

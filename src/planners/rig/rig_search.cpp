// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/rig_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vandplan/reeds_shepp.h"

namespace vandplan::rig {
namespace {

constexpr double usual_angle = 0.7;  // between tractor and trailer in a turn [rad]
constexpr double near_steps = 3;     // from the other end of the drive, about

Bounds around(const Task& task) {
  const Bounds& b = task.world->local().bounds;
  const double apart = std::hypot(task.goal.x - task.start.x, task.goal.y - task.start.y);
  const double margin =
      apart + 8 * task.vehicle.min_turning_radius + 4 * task.vehicle.trailer->wheelbase;
  const auto [left, right] = std::minmax(task.start.x, task.goal.x);
  const auto [low, high] = std::minmax(task.start.y, task.goal.y);
  return {std::max(b.x_min, left - margin), std::min(b.x_max, right + margin),
          std::max(b.y_min, low - margin), std::min(b.y_max, high + margin)};
}

/// Prices of metres and gear changes alone: the arcs of a search say little of others.
CostRule priced(CostRule rule) {
  rule.curvature_change_cost = 0.0;
  return rule;
}

}  // namespace

std::vector<Segment> tidied(std::span<const Segment> segments) {
  std::vector<Segment> result;
  for (const Segment& segment : segments) {
    if (std::abs(segment.length) < 1e-9) continue;
    result.push_back(segment);
  }
  return merged(result);
}

RigSearch::RigSearch(const Task& task, const CostRule& rule, const Fineness& fineness)
    : task_(task),
      closer_(task.vehicle),
      fineness_(fineness),
      trailer_radius_(task.vehicle.trailer->wheelbase /
                      std::tan(std::min(usual_angle, 0.8 * task.vehicle.max_hitch_angle))),
      cell_(0.7 * fineness.step),
      heading_cell_(0.5 * fineness.step / task.vehicle.min_turning_radius),
      angle_cell_(0.5 * fineness.step / task.vehicle.trailer->wheelbase),
      sides_{side_from({task.start, task.hitch_angles.start}, {task.goal, task.hitch_angles.goal},
                       priced(rule)),
             side_from({task.goal, task.hitch_angles.goal}, {task.start, task.hitch_angles.start},
                       search::reversed(priced(rule), 0))} {}

RigSearch::Side RigSearch::side_from(const RigState& root, const RigState& target,
                                     const CostRule& rule) {
  Side side{.rule = rule,
            .root = root,
            .target = target,
            .target_trailer = trailer_pose(task_.vehicle, target),
            .grid = {},
            .nodes = {{root, {}, 0.0, 0.0, -1, true}},
            .open = {{0.0, 0}}};
  side.grid.emplace(task_, around(task_), 0.5, target.pose, root.pose);
  while (side.grid->step()) {
  }
  side.reached[key_of(root)] = 0;
  return side;
}

std::int64_t RigSearch::nodes() const {
  return static_cast<std::int64_t>(sides_[0].nodes.size() + sides_[1].nodes.size());
}

std::uint64_t RigSearch::key_of(const RigState& state) const {
  const auto index = [](double value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value)));
  };
  const double heading = wrap_angle(state.pose.heading) + 4.0;
  std::uint64_t key = index(state.pose.x / cell_) & 0x3fffffU;
  key = (key << 22) | (index(state.pose.y / cell_) & 0x3fffffU);
  key = (key << 10) | (index(heading / heading_cell_) & 0x3ffU);
  return (key << 10) | (index(state.hitch_angle / angle_cell_ + 0.5) & 0x3ffU);
}

/// A guide, no bound: of the tractor and of the trailer on open ground, and around obstacles.
double RigSearch::to_go(const Side& side, const RigState& state, GearSign gear) const {
  const CostRule& rule = side.rule;
  const double cheapest = std::min(rule.forward_weight, rule.reverse_weight);
  const double tractor =
      reeds_shepp_length(state.pose, side.target.pose, task_.vehicle.min_turning_radius);
  const Pose trailer = trailer_pose(task_.vehicle, state);
  const double behind = reeds_shepp_length(trailer, side.target_trailer, trailer_radius_);
  const double folded =
      task_.vehicle.trailer->wheelbase * std::abs(state.hitch_angle - side.target.hitch_angle);
  const double grid = side.grid->at(state.pose.x, state.pose.y);
  (void)gear;
  return cheapest * (std::max({tractor, behind, grid}) + 0.3 * folded);
}

bool RigSearch::step() {
  if (sides_[0].open.empty() && sides_[1].open.empty()) return false;
  if (nodes() >= static_cast<std::int64_t>(fineness_.most_nodes)) return false;
  if (!expand(turn_)) (void)expand(1 - turn_);
  turn_ = 1 - turn_;
  return true;
}

/// [1] to [4]: the state of the least rank, if the way to it is free.
bool RigSearch::expand(std::size_t which) {
  Side& side = sides_[which];
  while (!side.open.empty()) {
    std::pop_heap(side.open.begin(), side.open.end());
    const std::int32_t id = side.open.back().node;
    side.open.pop_back();
    const Node node = side.nodes[static_cast<std::size_t>(id)];
    const std::uint64_t key = key_of(node.state);
    if (node.parent >= 0) {
      if (side.reached.contains(key)) continue;
      const RigState& from = side.nodes[static_cast<std::size_t>(node.parent)].state;
      if (!is_free(from, std::span(&node.segment, 1))) continue;
      side.nodes[static_cast<std::size_t>(id)].is_reached = true;
      side.reached[key] = id;
    }
    meet(which, id);
    add_children(side, id);
    return true;
  }
  return false;
}

void RigSearch::add_children(Side& side, std::int32_t parent) {
  const double sharpest = 1 / task_.vehicle.min_turning_radius;
  const double angle = side.nodes[static_cast<std::size_t>(parent)].state.hitch_angle;
  const double step = fineness_.step;
  for (const double part : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    for (const double length : {step, -step}) add(side, parent, {part * sharpest, length});
  }
  // The circle on which the trailer keeps its angle.
  const double lever = task_.vehicle.trailer->wheelbase - task_.vehicle.hitch * std::cos(angle);
  const double holding = std::sin(angle) / lever;
  if (std::abs(angle) < 0.02 || std::abs(holding) > sharpest) return;
  for (const double length : {step, -step}) add(side, parent, {holding, length});
}

void RigSearch::add(Side& side, std::int32_t parent, const Segment& segment) {
  const Node from = side.nodes[static_cast<std::size_t>(parent)];
  const RigState state = advance(task_.vehicle, from.state, segment);
  if (std::abs(state.hitch_angle) > task_.vehicle.max_hitch_angle) return;
  const std::uint64_t key = key_of(state);
  if (side.reached.contains(key)) return;
  search::Driven driven =
      from.parent < 0 ? search::Driven{side.rule.initial_gear} : search::last_driven(from.segment);
  const double cost = from.cost + search::drive_cost(side.rule, std::span(&segment, 1), driven);
  double& least = side.least.try_emplace(key, 1e300).first->second;
  if (cost >= least) return;
  least = cost;
  const double left = to_go(side, state, search::gear_of(segment));
  side.open.push_back(
      {cost + fineness_.weight * left, static_cast<std::int32_t>(side.nodes.size())});
  std::push_heap(side.open.begin(), side.open.end());
  side.nodes.push_back({state, segment, cost, left, parent, false});
}

/// [5] The root of the other search is near, or a state of it in the same cell or beside it: is
/// there an exact drive by way of both?
void RigSearch::meet(std::size_t which, std::int32_t id) {
  if (found_) return;
  const Side& other = sides_[1 - which];
  const auto& [state, segment, cost, left, parent, is_reached] =
      sides_[which].nodes[static_cast<std::size_t>(id)];
  if (id > 0 && left < near_steps * fineness_.step) {
    which == 0 ? join(id, 0) : join(0, id);
    if (found_) return;
  }
  for (const double angle : {0.0, -0.7, 0.7}) {
    for (const double heading : {0.0, -0.7, 0.7}) {
      RigState beside = state;
      beside.pose.heading += heading * heading_cell_;
      beside.hitch_angle += angle * angle_cell_;
      const auto there = other.reached.find(key_of(beside));
      if (there == other.reached.end()) continue;
      which == 0 ? join(id, there->second) : join(there->second, id);
      if (found_) return;
    }
  }
}

std::vector<Segment> RigSearch::branch(const Side& side, std::int32_t id) const {
  std::vector<Segment> segments;
  for (; id > 0; id = side.nodes[static_cast<std::size_t>(id)].parent) {
    segments.push_back(side.nodes[static_cast<std::size_t>(id)].segment);
  }
  return segments;  // the last one first
}

void RigSearch::join(std::int32_t forward, std::int32_t backward) {
  ++closings_;
  std::vector<Segment> segments = branch(sides_[0], forward);
  std::ranges::reverse(segments);
  for (Segment segment : branch(sides_[1], backward)) {
    segment.length = -segment.length;
    segments.push_back(segment);
  }
  if (segments.empty()) return;
  const RigState from = sides_[0].root;
  if (!closer_.close(from, segments, sides_[1].root)) return;
  segments = tidied(segments);
  if (!closer_.close(from, segments, sides_[1].root)) return;
  if (!is_free(from, segments)) return;
  found_ = std::move(segments);
}

bool RigSearch::is_free(const RigState& from, std::span<const Segment> segments) {
  checks_ += static_cast<std::int64_t>(segments.size());
  return task_.checker->rig_is_free(from, segments);
}

std::optional<std::vector<Segment>> RigSearch::take_found() {
  return std::exchange(found_, std::nullopt);
}

}  // namespace vandplan::rig

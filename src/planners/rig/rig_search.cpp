// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/rig_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/trigonometry.h"
#include "vandplan/steering.h"

namespace vandplan::rig {
namespace {

using search::Driven;

constexpr double usual_angle = 0.7;       // usual hitch angle in a turn [rad]
constexpr double near_steps = 3;          // cost-to-go below which the other root is tried [steps]
constexpr int expansions_per_bridge = 5;  // odd, so that both searches have bridges
constexpr int most_halvings = 2;          // halvings of a step that would fold the rig up
constexpr int steps_changed = 16;         // steps on either side of a gap that change to close it

/// Box around start and goal for the guides.
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

/// The segment driven back from its end to its begin.
Segment backwards(const Segment& segment) {
  if (segment.curvature_rate == 0.0) return {segment.curvature, -segment.length};
  return {search::last_driven(segment).curvature, -segment.length, -segment.curvature_rate};
}

/// Appends what is driven from the end of the segments back to their begin.
void append_backwards(std::vector<Segment>& whole, const std::vector<Segment>& segments) {
  for (auto it = segments.rbegin(); it != segments.rend(); ++it) whole.push_back(backwards(*it));
}

/// Primitives of each level: full lock and a gentle turn to either side, and straight on.
std::vector<std::vector<Primitive>> primitives_of(const Vehicle& vehicle,
                                                  const Fineness& fineness) {
  const double sharpest = 1 / vehicle.min_turning_radius;
  const double gentle = 0.5 / turning_radius(vehicle);
  std::vector<std::vector<Primitive>> all(static_cast<std::size_t>(std::max(fineness.levels, 1)));
  double step = fineness.step;
  for (std::vector<Primitive>& of_level : all) {
    for (const double curvature : {-sharpest, -gentle, 0.0, gentle, sharpest}) {
      for (const double length : {step, -step}) {
        of_level.emplace_back(vehicle, Command{curvature, length});
      }
    }
    step /= 2;
  }
  return all;
}

/// The rule without the price of steering, of which the arcs of a search say little.
CostRule priced(CostRule rule) {
  rule.curvature_change_cost = 0.0;
  return rule;
}

/// Gear and curvature before a drive from the goal back to the start.
Driven before_reversed(const Task& task) {
  const Driven after = search::driven_at_ends(task).after;
  return {-after.gear, after.curvature};
}

}  // namespace

std::optional<RigSteering> steering_of(const Vehicle& vehicle) {
  const bool is_known = std::abs(vehicle.hitch) < vehicle.trailer->wheelbase &&
                        vehicle.max_hitch_angle >= 0.05 && vehicle.max_hitch_angle <= 3.0;
  if (!is_known) return std::nullopt;
  return RigSteering(vehicle);
}

double turning_radius(const Vehicle& vehicle) {
  const double most = std::min(vehicle.max_hitch_angle, std::numbers::pi / 2);
  const auto [sin, cos] = base::sin_cos(most);
  return std::max(vehicle.min_turning_radius,
                  (vehicle.trailer->wheelbase - vehicle.hitch * cos) / sin);
}

/// Side of the cells of both guides [m].
double side_of_guides(const Task& task) { return search::side_over_all(task, around(task), 0.5); }

double search_unit(const Vehicle& vehicle) {
  return 0.3 * std::sqrt(turning_radius(vehicle) * vehicle.trailer->wheelbase);
}

Primitive::Primitive(const Vehicle& vehicle, const Command& of) noexcept
    : command(of),
      moved(advance(Pose{}, of.at_once())),
      hitch({.hitch = vehicle.hitch, .wheelbase = vehicle.trailer->wheelbase}, of.at_once()) {}

Guides::Guides(const Task& task)
    : to_goal(task, around(task), task.goal, task.start, {.side = side_of_guides(task)}),
      to_start(task, around(task), task.start, task.goal, {.side = side_of_guides(task)}) {
  while (to_goal.step()) {
  }
  while (to_start.step()) {
  }
}

RigSearch::RigSearch(const Task& task, const CostRule& rule, const Guides& guides,
                     const Fineness& fineness)
    : task_(task),
      wheels_(task.vehicle, task.steering),
      closer_(task.vehicle, task.steering),
      steering_(steering_of(task.vehicle)),
      fineness_(fineness),
      trailer_radius_(task.vehicle.trailer->wheelbase /
                      std::tan(std::min(usual_angle, 0.8 * task.vehicle.max_hitch_angle))),
      cell_(0.7 * fineness.step),
      heading_cell_(0.5 * fineness.step / turning_radius(task.vehicle)),
      angle_cell_(0.5 * fineness.step / task.vehicle.trailer->wheelbase),
      primitives_(primitives_of(task.vehicle, fineness)),
      sides_{side_from(start_state(task), goal_state(task), search::driven_at_ends(task).before,
                       priced(rule), guides.to_goal),
             side_from(goal_state(task), start_state(task), before_reversed(task),
                       search::reversed(priced(rule), 0), guides.to_start)} {}

RigSearch::Side RigSearch::side_from(const State& root, const State& target, const Driven& before,
                                     const CostRule& rule, const search::GridDistance& grid) const {
  Side side{.rule = rule,
            .root = root,
            .target = target,
            .target_trailer = trailer_pose(task_.vehicle, target),
            .grid = &grid,
            .nodes = {{root, {}, before, 0.0, 0.0, -1, true, 0}}};
  side.open.push({0.0, 0});
  side.nodes.front().to_go = to_go(side, root).guess;
  side.cells[key_of(root, 0)].node = 0;
  return side;
}

std::int64_t RigSearch::nodes() const {
  return static_cast<std::int64_t>(sides_[0].nodes.size() + sides_[1].nodes.size());
}

/// Level of the steps at a state: how many of w, w/2, w/4 and so on are larger than the room there,
/// where w is the width of the vehicle.
int RigSearch::level_at(const State& state) const {
  if (fineness_.levels <= 1) return 0;
  double least = task_.vehicle.width;
  const double room = task_.checker->clearance(Local(state), least, least);
  int level = 0;
  for (; room < least && level + 1 < fineness_.levels; least /= 2) ++level;
  return level;
}

std::uint64_t RigSearch::key_of(const State& state, int level) const {
  const auto index = [](double value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value)));
  };
  const double heading = wrap_angle(state.pose.heading) + 4.0;
  const double finer = std::ldexp(1.0, level);
  std::uint64_t key = index(state.pose.x / cell_ * finer) & 0x1fffffU;
  key = (key << 21) | (index(state.pose.y / cell_ * finer) & 0x1fffffU);
  key = (key << 10) | (index(heading / heading_cell_ * finer) & 0x3ffU);
  key = (key << 10) | (index(state.hitch_angle / angle_cell_ * finer + 0.5) & 0x3ffU);
  return (key << 2) | static_cast<std::uint64_t>(level);
}

/// Cost-to-go: the largest of the lengths of tractor and trailer on open ground and the way around
/// obstacles, and something for the change of the hitch angle.
RigSearch::ToGo RigSearch::to_go(const Side& side, const State& state) const {
  const CostRule& rule = side.rule;
  const double cheapest = std::min(rule.forward_weight, rule.reverse_weight);
  const double tractor =
      reeds_shepp_length(state.pose, side.target.pose, task_.vehicle.min_turning_radius);
  const Pose trailer = trailer_pose(task_.vehicle, state);
  const double behind = reeds_shepp_length(trailer, side.target_trailer, trailer_radius_);
  const double folded =
      task_.vehicle.trailer->wheelbase * std::abs(state.hitch_angle - side.target.hitch_angle);
  const double grid = side.grid->at(state.pose.x, state.pose.y);
  return {cheapest * (std::max({tractor, behind, grid}) + 0.3 * folded), cheapest * tractor};
}

bool RigSearch::step() {
  if (sides_[0].open.empty() && sides_[1].open.empty()) return false;
  if (nodes() >= static_cast<std::int64_t>(fineness_.most_nodes)) return false;
  if (!expand(turn_)) (void)expand(1 - turn_);
  turn_ = 1 - turn_;
  return true;
}

/// [2] Expands the state of the least rank if the command to it is free, or else the next state.
/// False if no state is left.
bool RigSearch::expand(std::size_t which) {
  Side& side = sides_[which];
  while (!side.open.empty()) {
    const std::int32_t id = side.open.top().node;
    side.open.pop();
    const Node node = side.nodes[static_cast<std::size_t>(id)];
    const std::uint64_t key = key_of(node.state, node.level);
    if (node.parent >= 0) {
      Cell& cell = side.cells[key];
      if (cell.node >= 0) continue;
      const Node& parent = side.nodes[static_cast<std::size_t>(node.parent)];
      Driven driven = parent.driven;
      if (!is_free(side, parent.state, wheels_.obey(node.command, driven).view())) continue;
      side.nodes[static_cast<std::size_t>(id)].is_reached = true;
      cell.node = id;
    }
    side.nodes[static_cast<std::size_t>(id)].level = level_at(node.state);
    side.latest = id;
    meet(which, id);
    bridge(which, id);
    if (node.to_go < side.nodes[static_cast<std::size_t>(side.nearest)].to_go) side.nearest = id;
    add_children(side, id);
    return true;
  }
  return false;
}

RigSearch::Parent::Parent(std::int32_t of, const Node& with)
    : id(of),
      node(with),
      heading(base::sin_cos(with.state.pose.heading)),
      fold(base::sin_cos(with.state.hitch_angle)) {}

void RigSearch::add_children(Side& side, std::int32_t id) {
  const Parent parent(id, side.nodes[static_cast<std::size_t>(id)]);
  const auto level = static_cast<std::size_t>(parent.node.level);
  for (const Primitive& primitive : primitives_[level]) add(side, parent, primitive);
  // The circle on which the trailer keeps its angle.
  const Vehicle& vehicle = task_.vehicle;
  const double holding =
      parent.fold.sin / (vehicle.trailer->wheelbase - vehicle.hitch * parent.fold.cos);
  const bool is_straight = std::abs(parent.node.state.hitch_angle) < 0.02;
  if (is_straight || std::abs(holding) > 1 / vehicle.min_turning_radius) return;
  const double step = std::ldexp(fineness_.step, -parent.node.level);
  for (const double length : {step, -step}) add(side, parent, {vehicle, {holding, length}});
}

/// The state behind a primitive, whose command is driven as `obeyed`.
State RigSearch::after(const Parent& parent, const Primitive& primitive,
                       const Obeyed& obeyed) const {
  State state = parent.node.state;
  if (obeyed.count > 1 || obeyed.segments[0].curvature_rate != 0.0) {
    for (const Segment& segment : obeyed.view()) state = advance(task_.vehicle, state, segment);
    return state;
  }
  const auto [sin, cos] = parent.heading;
  const auto& [x, y, turn] = primitive.moved;
  return {{state.pose.x + x * cos - y * sin, state.pose.y + x * sin + y * cos,
           wrap_angle(state.pose.heading + turn)},
          wrap_angle(state.hitch_angle + primitive.hitch.change(parent.fold))};
}

void RigSearch::add(Side& side, const Parent& parent, Primitive primitive) {
  if (!side.rule.allows(gear_of(primitive.command))) return;
  const Node& from = parent.node;
  Driven driven = from.driven;
  Obeyed obeyed = wheels_.obey(primitive.command, driven);
  State state = after(parent, primitive, obeyed);
  for (int i = 0; std::abs(state.hitch_angle) > task_.vehicle.max_hitch_angle; ++i) {
    if (i == most_halvings) return;
    const Command& command = primitive.command;
    primitive = Primitive(task_.vehicle, {command.curvature, command.length / 2});
    driven = from.driven;
    obeyed = wheels_.obey(primitive.command, driven);
    state = after(parent, primitive, obeyed);
  }
  Cell& cell = side.cells[key_of(state, from.level)];
  if (cell.node >= 0) return;
  Driven before = from.parent < 0 ? Driven{side.rule.initial_gear} : from.driven;
  const double cost = from.cost + search::drive_cost(side.rule, obeyed.view(), before);
  if (cost >= cell.least) return;
  cell.least = cost;
  const auto [left, at_least] = to_go(side, state);
  if (cost + at_least >= cutoff_) return;
  side.open.push({cost + fineness_.weight * left, static_cast<std::int32_t>(side.nodes.size())});
  side.nodes.push_back(
      {state, primitive.command, driven, cost, left, parent.id, false, from.level});
}

/// Whether the wheels can turn on one step from the curvature of one side to that of the other
/// side.
bool RigSearch::turn_in_time(const Driven& here, const Driven& there, int level) const {
  if (there.gear == 0 || wheels_.may_jump(here, -there.gear)) return true;
  return wheels_.way(here.curvature, there.curvature) <= std::ldexp(fineness_.step, -level);
}

/// [3] Tries to join a state with the root of the other search if that is near, and with states of
/// the other search in the same cell or beside it.
void RigSearch::meet(std::size_t which, std::int32_t id) {
  if (found_) return;
  const Side& other = sides_[1 - which];
  const auto& [state, command, driven, cost, left, parent, is_reached, level] =
      sides_[which].nodes[static_cast<std::size_t>(id)];
  if (id > 0 && left < near_steps * fineness_.step) {
    which == 0 ? join(id, 0) : join(0, id);
    if (found_) return;
  }
  for (const double angle : {0.0, -0.7, 0.7}) {
    for (const double heading : {0.0, -0.7, 0.7}) {
      State beside = state;
      beside.pose.heading += heading * std::ldexp(heading_cell_, -level);
      beside.hitch_angle += angle * std::ldexp(angle_cell_, -level);
      const auto there = other.cells.find(key_of(beside, level));
      if (there == other.cells.end() || there->second.node < 0) continue;
      const std::int32_t partner = there->second.node;
      const Driven& met = other.nodes[static_cast<std::size_t>(partner)].driven;
      if (!turn_in_time(driven, met, level)) continue;
      which == 0 ? join(id, partner) : join(partner, id);
      if (found_) return;
    }
  }
}

/// The segments of a side from one state to a later one on the same branch.
std::vector<Segment> RigSearch::branch(const Side& side, std::int32_t from, std::int32_t to) const {
  std::vector<Command> commands;
  for (std::int32_t id = to; id != from; id = side.nodes[static_cast<std::size_t>(id)].parent) {
    commands.push_back(side.nodes[static_cast<std::size_t>(id)].command);
  }
  std::ranges::reverse(commands);
  return wheels_.driven(commands, side.nodes[static_cast<std::size_t>(from)].driven);
}

/// Whether the tractor could drive straight from one place to another.
bool RigSearch::is_in_sight(const Pose& from, const Pose& to) {
  ++checks_;
  const double dx = to.x - from.x, dy = to.y - from.y;
  const Segment line{0.0, std::sqrt(dx * dx + dy * dy)};
  const LocalPose there({from.x, from.y, base::atan_2(dy, dx)});
  return task_.checker->tractor_is_free(there, {&line, 1});
}

/// [3] Now and then tries to join a state by exact steering with the latest state of the other
/// search, or with the one nearest to the root of this search. A state out of sight is tried every
/// second time.
void RigSearch::bridge(std::size_t which, std::int32_t id) {
  if (found_ || !steering_ || ++expansions_ % expansions_per_bridge != 0) return;
  const Side& other = sides_[1 - which];
  const std::int32_t partner = bridges_++ / 2 % 2 == 0 ? other.latest : other.nearest;
  const std::int32_t from = which == 0 ? id : partner;
  const std::int32_t to = which == 0 ? partner : id;
  const State& begin = sides_[0].nodes[static_cast<std::size_t>(from)].state;
  const State& end = sides_[1].nodes[static_cast<std::size_t>(to)].state;
  if (!is_in_sight(begin.pose, end.pose) && ++out_of_sight_ % 2 != 0) return;
  const auto piece = steering_->steer_quickly(begin, end);
  if (!piece || !search::may_drive(sides_[0].rule, piece->view())) return;
  if (is_free(sides_[0], begin, piece->view())) join(from, to, piece->view());
}

/// The state some steps before another one on its branch.
std::int32_t RigSearch::steps_before(const Side& side, std::int32_t id, int steps) {
  for (int i = 0; i < steps && id > 0; ++i) id = side.nodes[static_cast<std::size_t>(id)].parent;
  return id;
}

/// [3] Closes the gap between a state of each search, after `between` from the first one. Only the
/// steps near the gap change: the others are free already, and a long branch would swing.
void RigSearch::join(std::int32_t forward, std::int32_t backward,
                     std::span<const Segment> between) {
  ++closings_;
  const auto& [ahead, back] = sides_;
  const std::int32_t first = steps_before(ahead, forward, steps_changed);
  const std::int32_t last = steps_before(back, backward, steps_changed);
  const Node& begin = ahead.nodes[static_cast<std::size_t>(first)];
  const Node& end = back.nodes[static_cast<std::size_t>(last)];
  const search::DrivenBeside ends = {begin.driven, {-end.driven.gear, end.driven.curvature}};

  std::vector<Segment> changed = branch(ahead, first, forward);
  changed.insert(changed.end(), between.begin(), between.end());
  append_backwards(changed, branch(back, last, backward));
  std::vector<Command> commands = wheels_.commands(changed, ends);
  if (!closer_.close(begin.state, commands, end.state, ends)) return;
  changed = wheels_.driven(wheels_.tidied(commands, ends.before), ends.before);
  if (!is_free(ahead, begin.state, changed)) return;

  std::vector<Segment> segments = branch(ahead, 0, first);
  segments.insert(segments.end(), changed.begin(), changed.end());
  append_backwards(segments, branch(back, 0, last));
  found_ = exact_commands(task_, segments);
}

bool RigSearch::is_free(const Side& side, const State& from, std::span<const Segment> segments) {
  checks_ += static_cast<std::int64_t>(segments.size());
  return task_.checker->is_free(Local(from), segments, side.rule.in_time);
}

std::optional<std::vector<Command>> RigSearch::take_found() {
  return std::exchange(found_, std::nullopt);
}

}  // namespace vandplan::rig

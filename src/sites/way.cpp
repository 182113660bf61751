// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "sites/way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "vandplan/input_error.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan::sites {
namespace {

using search::CostRule;

/// Steps after which a way from a state near the start is joined. Joints that replace few steps
/// need shunts, joints that replace many are blocked more often.
constexpr std::array<int, 11> steps_replaced = {1, 2, 3, 4, 6, 8, 11, 14, 18, 23, 28};
constexpr std::size_t most_followed = 16;  // states near the start whose ways are followed
constexpr int most_joints = 64;            // joints tried for one way
constexpr double same_place = 1e-6;        // places and headings of equal goals [m, rad]
constexpr double straight = 1e-3;  // what a straight piece is longer by than the distance [m]

}  // namespace

std::optional<std::size_t> number_of(std::span<const Pose> poses, const Pose& goal) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double away = std::hypot(poses[i].x - goal.x, poses[i].y - goal.y);
    const double turn = std::abs(wrap_angle(poses[i].heading - goal.heading));
    if (away < same_place && turn < same_place) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> goal_in(const SiteTable& table, const Task& task) {
  return number_of(table.goals(), to_scenario(*task.world, task.goal));
}

Ways::Ways(const SiteData& data, const SiteLayer& layer, const Task& task, const CostRule& rule)
    : data_(data),
      layer_(layer),
      task_(task),
      connector_(task, rule),
      tails_(data, layer, task.goal) {}

/// [5] Collects tails on the ways from the states around the start that are nearest to the goal.
void Ways::find_joints(const LocalPose& start) {
  struct Near {
    SiteState state;
    SiteEntry entry;
  };
  const SiteState at = state_at(data_.grid, layer_, to_scenario(*task_.world, start));
  const int headings = data_.grid.headings;
  std::vector<Near> near;
  for (int number = 0; number < 3 * 3 * 3 * 2; ++number) {
    const int turn = number / 9 % 3 - 1;
    const SiteState state{.column = at.column + number % 3 - 1,
                          .row = at.row + number / 3 % 3 - 1,
                          .heading = (at.heading + turn + headings) % headings,
                          .gear = number < 27 ? 1 : -1};
    const auto entry = data_.find(layer_, state);
    if (entry) near.push_back({state, *entry});
  }
  std::ranges::stable_sort(
      near, [](const Near& a, const Near& b) { return a.entry.cost < b.entry.cost; });
  if (near.size() > most_followed) near.resize(most_followed);
  ++starts_;
  joints_.clear();
  for (const auto& [state, entry] : near) follow(tails_.find(state, entry));
}

/// Collects tails until the way meets one that was followed before.
void Ways::follow(Tails::Id tail) {
  std::size_t next = 0;
  for (int steps = 0; tail != Tails::none && next < steps_replaced.size(); ++steps) {
    const auto number = static_cast<std::size_t>(tail);
    if (met_by_.size() <= number) met_by_.resize(2 * number + 1);
    if (met_by_[number] == starts_) return;
    met_by_[number] = starts_;
    const Tails::Id after = tails_[tail].next;
    if (steps == steps_replaced[next] || after == Tails::none) {
      joints_.push_back({tail, 0.0});
      ++next;
    }
    tail = after;
  }
}

/// [6] Ranks the joints by the table's costs and by lengths on open ground. All pieces but straight
/// ones have three segments, unless poses lie as if made for each other: so the wheels turn twice.
void Ways::rank(const LocalPose& start) {
  const CostRule& rule = connector_.rule();
  const double metre = std::min(rule.forward_weight, rule.reverse_weight);
  const double wheels = 2 * rule.curvature_change_cost / connector_.radius();
  x_.clear();
  y_.clear();
  heading_.clear();
  for (const Joint& joint : joints_) {
    const LocalPose& pose = tails_[joint.tail].pose;
    x_.push_back(static_cast<float>(pose.x));
    y_.push_back(static_cast<float>(pose.y));
    heading_.push_back(static_cast<float>(pose.heading));
  }
  lengths_.resize(joints_.size());
  reeds_shepp_lengths({x_, y_, heading_}, start, connector_.radius(), lengths_);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const double away =
        std::hypot(static_cast<double>(x_[i]) - start.x, static_cast<double>(y_[i]) - start.y);
    const auto length = static_cast<double>(lengths_[i]);
    joints_[i].bound = tails_[joints_[i].tail].roughly + metre * length +
                       (length > away + straight ? wheels : 0.0);
  }
  // Numbers of tails depend on other starts, so they must not decide.
  std::ranges::stable_sort(joints_,
                           [](const Joint& a, const Joint& b) { return a.bound < b.bound; });
}

/// [7] The costs of tails are the table's until a way is chosen: few tails have to be priced.
std::optional<Ways::Found> Ways::find(const LocalPose& start) {
  find_joints(start);
  rank(start);
  const CostRule& rule = connector_.rule();
  std::vector<Found> ways;
  double least = std::numeric_limits<double>::infinity();
  int tried = 0;
  for (const Joint& joint : joints_) {
    if (joint.bound >= least || tried++ == most_joints) break;
    const Tails::Tail& tail = tails_[joint.tail];
    const search::DrivenBeside beside{rule.initial_gear, tails_.first(joint.tail, rule)};
    const auto piece = connector_.connect(Local(State{start, 0.0}), tail.pose,
                                          {0.0, least - tail.roughly, beside});
    if (!piece) continue;
    least = tail.roughly + piece->cost;
    ways.push_back({piece->piece, joint.tail, piece->cost});
  }
  for (; !ways.empty(); ways.pop_back()) {
    Found& way = ways.back();
    way.cost += tails_.cost(way.tail, connector_);
    if (way.cost < std::numeric_limits<double>::infinity()) return way;
  }
  return std::nullopt;
}

std::vector<Segment> Ways::segments(const Found& way) const {
  std::vector<Segment> all(way.piece.view().begin(), way.piece.view().end());
  for (Tails::Id id = way.tail; tails_[id].next != Tails::none; id = tails_[id].next) {
    all.push_back(tails_[id].step);
  }
  return merged(all);
}

SiteState state_at(const SiteGrid& grid, const SiteLayer& layer, const Pose& pose) noexcept {
  const auto cell = [&grid](double x, double least) {
    constexpr double most = 1e9;
    return static_cast<std::int32_t>(std::clamp(std::floor((x - least) / grid.cell), -most, most));
  };
  const double turn = wrap_angle(pose.heading - layer.goal.heading);
  const auto heading = static_cast<int>(std::lround(turn / (2 * std::numbers::pi) * grid.headings));
  return {.column = cell(pose.x, grid.corner.x),
          .row = cell(pose.y, grid.corner.y),
          .heading = (heading + grid.headings) % grid.headings};
}

void expect_serves(const SiteTable& table, const Task& task, const PlanOptions& options) {
  expect_equal(table.data().key, site_key(*task.world, task.vehicle, options));
  if (!task.moving.empty()) {
    throw InputError("site", "expected no moving obstacles: a table knows none");
  }
  if (task.goal_set.empty()) table.expect_goal(to_scenario(*task.world, task.goal));
}

std::optional<SiteWay> way_in_world(const SiteTable& table, const Task& task,
                                    const CostOptions& cost) {
  const std::optional<std::size_t> goal = goal_in(table, task);
  if (!goal) return std::nullopt;
  SiteWay way{.goal = *goal};
  Task relaxed = task;
  relaxed.steering = Steering::reeds_shepp;
  const CostRule rule = search::cost_rule(cost, relaxed);
  Ways ways(table.data(), table.data().layers[way.goal], relaxed, rule);
  const std::optional<Ways::Found> found = ways.find(task.start);
  if (!found) return std::nullopt;
  way.path = {task.start, ways.segments(*found)};
  way.cost = found->cost;
  if (!task.checker->is_free(task.start, way.path.segments)) return std::nullopt;
  return way;
}

}  // namespace vandplan::sites

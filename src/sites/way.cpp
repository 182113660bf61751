// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "sites/way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "vandplan/input_error.h"
#include "vandplan/search.h"

namespace vandplan::sites {
namespace {

using search::Connector, search::CostRule;

/// Steps after which a way from a state near the start is joined. Joints that replace few steps
/// need shunts, joints that replace many are blocked more often.
constexpr std::array<int, 8> steps_replaced = {1, 2, 3, 4, 6, 8, 12, 18};
constexpr int most_joints = 48;        // joints tried for one way
constexpr int most_steps = 1'000'000;  // steps of a way; only an altered table has more
constexpr double same_place = 1e-6;    // places and headings of equal goals [m, rad]

/// State of a table where a joint may end.
struct Joint {
  SiteState state;
  double cost;   // from there to the goal [m]
  double bound;  // approximate lower bound of the cost by way of the state [m]
};

/// Finds the way of one layer from the start of a task.
class WaySearch {
 public:
  WaySearch(const SiteData& data, const SiteLayer& layer, const Task& task, const CostRule& rule)
      : data_(data), layer_(layer), task_(task), connector_(task, rule) {}

  [[nodiscard]] std::optional<std::vector<Segment>> segments() {
    find_joints();
    int tried = 0;
    for (const Joint& joint : joints_) {
      if (joint.bound >= cost_ || tried++ == most_joints) break;
      try_joint(joint);
    }
    return std::move(best_);
  }

 private:
  void find_joints();
  void follow(SiteState state);
  void add(const SiteState& state, const SiteEntry& entry);
  [[nodiscard]] std::vector<Segment> steps_from(SiteState state) const;
  void try_joint(const Joint& joint);

  const SiteData& data_;
  const SiteLayer& layer_;
  const Task& task_;
  Connector connector_;
  std::vector<Joint> joints_;
  std::optional<std::vector<Segment>> best_;
  double cost_ = std::numeric_limits<double>::infinity();
};

/// [4] [5] Collects states on the ways from all states around the start, the most promising ones
/// first.
void WaySearch::find_joints() {
  const SiteState start = state_at(data_.grid, layer_, to_scenario(*task_.world, task_.start));
  const int headings = data_.grid.headings;
  for (int number = 0; number < 3 * 3 * 3 * 2; ++number) {
    const int turn = number / 9 % 3 - 1;
    follow({.column = start.column + number % 3 - 1,
            .row = start.row + number / 3 % 3 - 1,
            .heading = (start.heading + turn + headings) % headings,
            .gear = number < 27 ? 1 : -1});
  }
  const auto rank = [](const Joint& joint) {
    const SiteState& state = joint.state;
    return std::tuple(joint.bound, state.column, state.row, state.heading, state.gear);
  };
  std::ranges::sort(joints_, [&rank](const Joint& a, const Joint& b) { return rank(a) < rank(b); });
  const auto is_same = [](const Joint& a, const Joint& b) { return a.state == b.state; };
  joints_.erase(std::unique(joints_.begin(), joints_.end(), is_same), joints_.end());
}

void WaySearch::follow(SiteState state) {
  std::optional<SiteEntry> entry = data_.find(layer_, state);
  std::size_t next = 0;
  for (int steps = 0; entry && next < steps_replaced.size(); ++steps) {
    if (steps == steps_replaced[next]) {
      add(state, *entry);
      ++next;
    }
    if (entry->is_goal) return add(state, *entry);
    state = data_.after(state, *entry);
    entry = data_.find(layer_, state);
  }
}

void WaySearch::add(const SiteState& state, const SiteEntry& entry) {
  const Point& origin = task_.world->origin();
  const double cell = data_.grid.cell;
  const double x = data_.grid.corner.x - origin.x + (state.column + 0.5) * cell;
  const double y = data_.grid.corner.y - origin.y + (state.row + 0.5) * cell;
  const double away = std::hypot(task_.start.x - x, task_.start.y - y) - cell / std::sqrt(2.0);
  joints_.push_back({state, entry.cost, entry.cost + std::max(0.0, away)});
}

/// The steps from a state to the goal; none if the table leads nowhere.
std::vector<Segment> WaySearch::steps_from(SiteState state) const {
  std::vector<Segment> steps;
  for (int i = 0; i < most_steps; ++i) {
    const std::optional<SiteEntry> entry = data_.find(layer_, state);
    if (!entry) break;
    if (entry->is_goal) return steps;
    steps.push_back(site_step(data_.grid, state.gear, entry->arc));
    state = data_.after(state, *entry);
  }
  return {};
}

/// [6] Drives to the pose that a state keeps, and from there the steps of the table. The pose
/// follows from the goal, whose steps are driven backwards.
void WaySearch::try_joint(const Joint& joint) {
  const std::vector<Segment> steps = steps_from(joint.state);
  if (steps.empty() && joint.cost > 0.0) return;
  LocalPose pose = task_.goal;
  for (std::size_t i = steps.size(); i > 0; --i) {
    pose = advance(pose, Segment{steps[i - 1].curvature, -steps[i - 1].length});
  }
  search::DrivenBeside beside{connector_.rule().initial_gear, 0};
  if (!steps.empty()) beside.after = {search::gear_of(steps.front()), steps.front().curvature};
  const auto to_joint =
      connector_.connect(Local(State{task_.start, 0.0}), pose, {0.0, cost_ - joint.cost, beside});
  if (!to_joint) return;
  std::vector<Segment> all(to_joint->piece.view().begin(), to_joint->piece.view().end());
  all.insert(all.end(), steps.begin(), steps.end());
  all = merged(all);
  if (!task_.checker->is_free(task_.start, all)) return;
  cost_ = to_joint->cost + joint.cost;
  best_ = std::move(all);
}

}  // namespace

std::optional<std::size_t> goal_in(const SiteTable& table, const Task& task) {
  for (std::size_t i = 0; i < table.goals().size(); ++i) {
    const LocalPose goal = to_local(*task.world, table.goals()[i]);
    const double away = std::hypot(goal.x - task.goal.x, goal.y - task.goal.y);
    const double turn = std::abs(wrap_angle(goal.heading - task.goal.heading));
    if (away < same_place && turn < same_place) return i;
  }
  return std::nullopt;
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
  if (task.goal_set.empty() && !goal_in(table, task)) {
    throw InputError("site", "the table has no such goal, expected one of its " +
                                 std::to_string(table.goals().size()));
  }
}

std::optional<SiteWay> way_in_world(const SiteTable& table, const Task& task,
                                    const CostOptions& cost) {
  const std::optional<std::size_t> goal = goal_in(table, task);
  if (!goal) return std::nullopt;
  SiteWay way{.goal = *goal};
  Task relaxed = task;
  relaxed.steering = Steering::reeds_shepp;
  const CostRule rule = search::cost_rule(cost, relaxed);
  std::optional<std::vector<Segment>> segments =
      WaySearch(table.data(), table.data().layers[way.goal], relaxed, rule).segments();
  if (!segments) return std::nullopt;
  way.path = {task.start, *std::move(segments)};
  way.cost = drive_cost(rule, way.path.segments) +
             clearance_cost(relaxed, rule, start_state(relaxed), way.path.segments,
                            search::ClearanceSampling::search);
  return way;
}

}  // namespace vandplan::sites

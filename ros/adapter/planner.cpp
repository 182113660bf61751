// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/planner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "ros/adapter/goals.h"
#include "vandplan/input_error.h"

namespace vandplan::ros {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Whether the point of a pose lies on the costmap.
bool is_on(const Costmap& costmap, const Pose& pose) {
  const Pose at = relative(costmap.origin, pose);
  return at.x >= 0.0 && at.y >= 0.0 && at.x <= costmap.columns * costmap.resolution &&
         at.y <= costmap.rows * costmap.resolution;
}

/// The rest of a path from its place that is nearest to a pose, of places at most `step` apart.
Path rest_of(const Path& path, const Pose& from, double step) {
  const double whole = length(path);
  double begin = 0.0;
  double least = std::hypot(path.start.x - from.x, path.start.y - from.y);
  for (const PathPoint& point : sampled(path, std::max(step, 1e-4 * whole))) {
    const double distance = std::hypot(point.pose.x - from.x, point.pose.y - from.y);
    if (distance >= least) continue;
    least = distance;
    begin = point.s;
  }
  if (begin == 0.0) return path;
  Path rest{pose_at(path, begin), {}};
  double s = 0.0;
  for (const Segment& segment : path.segments) {
    const double end = s + std::abs(segment.length);
    if (end > begin) {
      rest.segments.push_back(begin > s ? part_of(segment, begin - s, end - s) : segment);
    }
    s = end;
  }
  return rest;
}

/// The gear of the last segment; `any` without one.
InitialGear last_gear(const Path& path, InitialGear before) {
  if (path.segments.empty()) return before;
  return path.segments.back().gear() == Gear::forward ? InitialGear::forward : InitialGear::reverse;
}

/// The problem from a start to goals: one pose is the goal, several or a region are a set.
Problem problem_to(const std::shared_ptr<const World>& world, const Vehicle& vehicle,
                   const Pose& start, const std::vector<GoalRegion>& regions) {
  const GoalRegion& first = regions.front();
  if (regions.size() > 1 || is_continuous(first)) {
    return with_goal_set(make_problem(world, vehicle, start, start), regions);
  }
  return make_problem(world, vehicle, start, some_pose(first));
}

/// What the outcome of a part says of the whole path: a via point is the goal of its part.
std::string message_of(const Request& request, std::size_t part, const PlanResult& result) {
  std::string message = "to via point " + std::to_string(part + 1) + ": ";
  if (part == request.viapoints.size()) message.clear();
  message += name_of(result.status);
  if (!result.reason.empty()) message += ": " + result.reason;
  return message;
}

}  // namespace

Request request_of(const Parameters& parameters, const Robot& robot) {
  const Chassis chassis = parameters.chassis();
  const double tolerance = parameters.tolerance();
  return {.heading = parameters.goal_heading(),
          .slack = {.ahead = tolerance, .aside = tolerance},
          .vehicle = vehicle_of(robot, chassis),
          .rear_axle = chassis.rear_axle,
          .cost_rule = parameters.cost_rule(),
          .options = parameters.options()};
}

// Whether the world is that of the costmap. Otherwise the call was cancelled.
bool Planner::renew_world(const CostRule& rule, const Point& near, const std::stop_token& stop) {
  if (building_.valid() && !is_built(stop)) return false;
  const Costmap costmap = costmap_.now();
  if (costmap.costs.empty()) throw InputError("costmap", "is missing, expected one to plan on");
  const auto changes = costmap_.changes();
  if (world_ && changes && rule == rule_) {
    WorldPatch patch;
    for (const CellRange& range : *changes) {
      patch.cells.push_back(
          {range.column, range.row, range.columns, range.rows, cells_of(costmap, rule, range)});
      if (rule.cost_penalty == 0.0) continue;
      patch.masks.push_back({.range = range, .percents = percents_of(costmap, rule, range)});
    }
    world_->patch(patch);
    return true;
  }
  world_.reset();
  rule_ = rule;
  building_ = std::async(std::launch::async, [ground = ground_of(costmap, rule), near] {
    return ChangingWorld(ground, near);
  });
  return is_built(stop);
}

// Waits until the world is built, or the call is cancelled.
bool Planner::is_built(const std::stop_token& stop) {
  while (building_.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) {
    if (stop.stop_requested()) return false;
  }
  world_.emplace(building_.get());
  return true;
}

Answer Planner::plan(const Request& request) {
  try {
    return planned(request);
  } catch (const InputError& error) {
    return {.outcome = Outcome::invalid, .message = error.what()};
  }
}

Answer Planner::planned(const Request& request) {
  // 1. Is what was asked for in order?
  if (request.goals.empty()) throw InputError("goals", "are none, expected at least one");
  for (const Pose& pose : request.viapoints) check_poses(request.start, pose);
  for (const Pose& pose : request.goals) check_poses(request.start, pose);
  const Answer cancelled{Outcome::cancelled, "cancelled before planning"};
  if (request.stop.stop_requested()) return cancelled;
  // 2. Do all poses lie on the costmap?
  const Pose start = axle_pose(request.start, request.rear_axle);
  if (!renew_world(request.cost_rule, {start.x, start.y}, request.stop)) return cancelled;
  const Costmap costmap = costmap_.now();
  const auto is_off = [&](const Pose& pose) { return !is_on(costmap, pose); };
  if (is_off(request.start)) return {Outcome::start_outside_map, "the start is off the costmap"};
  if (std::any_of(request.viapoints.begin(), request.viapoints.end(), is_off)) {
    return {Outcome::goal_outside_map, "a via point is off the costmap"};
  }
  if (std::all_of(request.goals.begin(), request.goals.end(), is_off)) {
    return {Outcome::goal_outside_map, "the goal is off the costmap"};
  }
  // 3. Each part in turn, in its share of the time that is left.
  Answer answer;
  const auto begin = Clock::now();
  const BudgetOptions& budget = request.options.budget;
  std::optional<double> time = budget.time_limit;
  if (!time && !budget.max_iterations) time = default_time_limit;
  for (std::size_t part = 0; part <= request.viapoints.size(); ++part) {
    PlanOptions options = request.options;
    options.budget.stop = request.stop;
    if (time) {
      const auto parts_left = static_cast<double>(request.viapoints.size() + 1 - part);
      options.budget.time_limit = std::max(0.0, *time - seconds_since(begin)) / parts_left;
    }
    if (!add_part(request, part, options, answer)) return answer;
  }
  // 4. The whole path.
  answer.outcome = Outcome::solved;
  answer.message.clear();
  answer.poses = poses_of(answer.parts, costmap.resolution, request.rear_axle);
  parts_ = answer.parts;
  return answer;
}

bool Planner::add_part(const Request& request, std::size_t part, PlanOptions options,
                       Answer& answer) {
  const bool is_last = part == request.viapoints.size();
  Pose from = axle_pose(request.start, request.rear_axle);
  if (part > 0) {
    from = end_pose(answer.parts.back());
    options.cost.initial_gear = last_gear(answer.parts.back(), options.cost.initial_gear);
  }
  vandplan::Planner planner = default_planner();
  if (parts_.size() == request.viapoints.size() + 1 && !parts_[part].segments.empty()) {
    planner = warm_started(rest_of(parts_[part], from, costmap_.now().resolution));
  }
  const auto planned_to = [&](const std::vector<GoalRegion>& regions) {
    return vandplan::plan(problem_to(world_->world(), request.vehicle, from, regions), planner,
                          options);
  };
  Goals goals;
  if (is_last) {
    goals = goals_of(request);
  } else {
    goals.regions = {region_of_pose(axle_pose(request.viapoints[part], request.rear_axle))};
  }
  PlanResult result = planned_to(goals.regions);
  answer.planning_time += result.time_total;
  if (is_last && result.status == PlanStatus::goal_in_collision && request.slack != GoalSlack{}) {
    goals = goals_beside(request);
    result = planned_to(goals.regions);
    answer.planning_time += result.time_total;
    answer.used_slack = true;
  }
  answer.outcome = outcome_of(result.status);
  // Whoever cancels has no use for a path.
  if (request.stop.stop_requested()) answer.outcome = Outcome::cancelled;
  if (answer.outcome != Outcome::solved) {
    answer.message = message_of(request, part, result);
    answer.parts.clear();
    return false;
  }
  answer.cost += result.cost;
  if (is_last) answer.goal = goals.origins[result.goal ? result.goal->index : 0];
  answer.parts.push_back(*std::move(result.path));
  return true;
}

bool Planner::is_blocked(std::span<const Pose> poses, const Vehicle& vehicle,
                         const CostRule& rule) {
  const Costmap costmap = costmap_.now();
  const Pose& near = poses.empty() ? costmap.origin : poses[0];
  renew_world(rule, {near.x, near.y}, {});
  const World& world = *world_->world();
  const auto checker = world.checker(vehicle);
  return std::any_of(poses.begin(), poses.end(), [&](const Pose& pose) {
    return !checker->is_free(to_local(world, State(pose)));
  });
}

void Planner::forget() {
  building_ = {};
  world_.reset();
  parts_.clear();
}

std::shared_ptr<const World> Planner::world() const noexcept {
  return world_ ? world_->world() : nullptr;
}

}  // namespace vandplan::ros

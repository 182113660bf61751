// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/planner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "ros/adapter/goals.h"
#include "vandplan/input_error.h"

namespace vandplan::ros {
namespace {

constexpr int headings_at_via = 16;  // headings that are tried at a via point with any heading
constexpr double any_gap = 1000.0;   // proven gap that every path has

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

double distance(const Pose& a, const Pose& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// The rest of the last path, if it begins and ends so near to start and goal that it is worth a
/// trial. Trials of other paths would make each call longer.
std::optional<Path> known_way(const Path& last, const Request& request, const Pose& start,
                              double step) {
  if (last.segments.empty()) return std::nullopt;
  const Pose end = pose_at(last, length(last));
  const auto spare = [&](const Pose& goal) { return distance(start, goal) - distance(end, goal); };
  double most = 0.0;
  for (const Pose& goal : request.goals) most = std::max(most, spare(goal));
  if (most == 0.0) return std::nullopt;
  Path rest = rest_of(last, start, step);
  if (distance(rest.start, start) >= most) return std::nullopt;
  return rest;
}

/// What the path passes on its way, as poses of the rear axle, and whether the robot stands there.
std::vector<Via> vias_of(const Request& request, bool stop) {
  std::vector<Via> vias;
  vias.reserve(request.viapoints.size());
  for (const auto& [pose, any_heading] : request.viapoints) {
    GoalRegion region = region_of_pose(any_heading ? pose : axle_pose(pose, request.rear_axle));
    if (any_heading) region.heading = vandplan::any_heading;
    vias.push_back({.any_of = {region}, .stop = stop});
  }
  return vias;
}

/// The problem from a start to goals: one pose is the goal, several or a region are a set.
Problem problem_to(const std::shared_ptr<const World>& world, const Request& request,
                   const Pose& start, const std::vector<GoalRegion>& regions) {
  const GoalRegion& first = regions.front();
  const bool is_set = regions.size() > 1 || is_continuous(first);
  const Pose goal = is_set ? start : some_pose(first);
  Problem problem = make_problem(world, request.vehicle, start, goal);
  if (is_set) return with_goal_set(problem, regions);
  return problem;
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
  for (const ViaPoint& via : request.viapoints) check_poses(request.start, via.pose);
  for (const Pose& pose : request.goals) check_poses(request.start, pose);
  Answer cancelled{Outcome::cancelled, "cancelled before planning"};
  if (request.stop.stop_requested()) return cancelled;
  // 2. Can the robot be where it has to be?
  const Pose start = axle_pose(request.start, request.rear_axle);
  if (!renew_world(request.cost_rule, {start.x, start.y}, request.stop)) return cancelled;
  if (const std::optional<Answer> refused = refusal(request)) return *refused;
  // 3. The path, to the goals or beside them.
  Answer answer;
  Goals goals = goals_of(request);
  PlanResult result = patient_result_to(request, goals.regions);
  answer.planning_time = result.time_total;
  if (result.status == PlanStatus::goal_in_collision && request.slack != GoalSlack{}) {
    goals = goals_beside(request);
    result = patient_result_to(request, goals.regions);
    answer.planning_time += result.time_total;
    answer.used_slack = true;
  }
  answer.outcome = outcome_of(result.status);
  // Whoever cancels has no use for a path.
  if (request.stop.stop_requested()) answer.outcome = Outcome::cancelled;
  if (answer.outcome != Outcome::solved) {
    answer.message = name_of(result.status);
    if (!result.reason.empty()) answer.message += ": " + result.reason;
    return answer;
  }
  last_ = *result.path;
  answer.cost = result.cost;
  answer.goal = goals.origins[result.goal ? result.goal->index : 0];
  answer.poses = poses_of(*result.path, costmap_.now().resolution, request.rear_axle);
  answer.path = std::move(result.path);
  return answer;
}

// Why there is no path, if a pose of the request says so alone; or none.
std::optional<Answer> Planner::refusal(const Request& request) const {
  const Costmap costmap = costmap_.now();
  const auto is_off = [&](const Pose& pose) { return !is_on(costmap, pose); };
  if (is_off(request.start)) {
    return Answer{Outcome::start_outside_map, "the start is off the costmap"};
  }
  if (std::all_of(request.goals.begin(), request.goals.end(), is_off)) {
    return Answer{Outcome::goal_outside_map, "the goal is off the costmap"};
  }
  const std::vector<Via> vias = vias_of(request, false);
  if (vias.empty()) return std::nullopt;
  const World& world = *world_->world();
  const auto checker = world.checker(request.vehicle, {.wanted = request.options.clearance.margin});
  for (std::size_t i = 0; i < vias.size(); ++i) {
    const std::string name = "via point " + std::to_string(i + 1);
    if (is_off(request.viapoints[i].pose)) {
      return Answer{Outcome::goal_outside_map, name + " is off the costmap"};
    }
    Pose pose = some_pose(vias[i].any_of.front());
    const int headings = request.viapoints[i].any_heading ? headings_at_via : 1;
    int taken = 0;
    for (; taken < headings && !checker->is_free(to_local(world, State(pose))); ++taken) {
      pose.heading = wrap_angle(pose.heading + 2 * std::numbers::pi / headings_at_via);
    }
    if (taken == headings) return Answer{Outcome::goal_occupied, name + " is not free"};
  }
  return std::nullopt;
}

// Drives through the via points, or stands there if no such way is found.
PlanResult Planner::result_to(const Request& request, const std::vector<GoalRegion>& goals) const {
  const Pose start = axle_pose(request.start, request.rear_axle);
  const Problem problem = problem_to(world_->world(), request, start, goals);
  const std::optional<Path> way = known_way(last_, request, start, costmap_.now().resolution);
  const vandplan::Planner planner = way ? warm_started(*way) : default_planner();
  PlanOptions options = request.options;
  BudgetOptions& budget = options.budget;
  budget.stop = request.stop;
  if (request.viapoints.empty()) return vandplan::plan(problem, planner, options);
  if (!budget.time_limit && !budget.max_iterations) budget.time_limit = default_time_limit;
  if (budget.time_limit) *budget.time_limit /= 2;
  PlanResult through = vandplan::plan(with_via(problem, vias_of(request, false)), planner, options);
  const bool is_at_fault = through.status == PlanStatus::start_in_collision ||
                           through.status == PlanStatus::goal_in_collision;
  if (through.path || is_at_fault || request.stop.stop_requested()) return through;
  PlanResult with_stops =
      vandplan::plan(with_via(problem, vias_of(request, true)), planner, options);
  with_stops.time_total += through.time_total;
  return with_stops;
}

// Plans until the time limit, and then, if there is no path, to the first one.
PlanResult Planner::patient_result_to(const Request& request,
                                      const std::vector<GoalRegion>& goals) const {
  PlanResult result = result_to(request, goals);
  const bool is_late = result.status == PlanStatus::time_limit && request.patience > 0.0;
  if (!is_late || request.stop.stop_requested()) return result;
  Request longer = request;
  longer.options.budget.time_limit = request.patience;
  longer.options.budget.target_gap = any_gap;
  const double before = result.time_total;
  result = result_to(longer, goals);
  result.time_total += before;
  return result;
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
  last_ = {};
}

std::shared_ptr<const World> Planner::world() const noexcept {
  return world_ ? world_->world() : nullptr;
}

}  // namespace vandplan::ros

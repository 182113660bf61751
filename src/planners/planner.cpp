// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planners/in_time.h"
#include "planners/last_stretch.h"
#include "planners/options.h"
#include "planners/plan_to_set.h"
#include "planners/pricing.h"
#include "planners/reasons.h"
#include "planners/zone_exits.h"
#include "vandplan/input_error.h"
#include "vandplan/search.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

constexpr double rounding = 1e-12;  // relative rounding of a sum of lengths
/// Answer if zones let the vehicle leave the start, or come to the goal, in no gear.
std::optional<PlannerAnswer> kept_by_zones(const Task& task, const CostOptions& costs) {
  const search::CostRule rule = search::cost_rule(costs, task);
  if (!planning::may_leave(task, rule, start_state(task))) {
    return PlannerAnswer{.status = PlanStatus::start_in_collision,
                         .reason = "zones let the vehicle leave the start in no gear"};
  }
  if (!planning::may_come(task, rule, goal_state(task))) {
    return PlannerAnswer{.status = PlanStatus::goal_in_collision,
                         .reason = "zones let the vehicle come to the goal in no gear"};
  }
  return std::nullopt;
}

/// Answer that needs no search: start or goal are not free, zones let the vehicle neither leave the
/// start nor come to the goal, or the goal is the start.
std::optional<PlannerAnswer> settled(const Task& task, const CostOptions& costs) {
  PlannerAnswer answer;
  if (!task.checker->is_free(start_state(task))) {
    answer.status = PlanStatus::start_in_collision;
    return answer;
  }
  if (!task.goal_set.empty()) return std::nullopt;
  if (!task.checker->is_free(goal_state(task))) {
    answer.status = PlanStatus::goal_in_collision;
    return answer;
  }
  if (!planning::is_there(task)) return kept_by_zones(task, costs);
  if (!task.moving.empty()) return std::nullopt;  // an obstacle may come by
  answer.status = PlanStatus::solved;
  answer.segments.emplace();
  answer.anytime.push_back({});
  return answer;
}

/// Whether paths of a task are made of legs that are planned one by one.
bool has_legs(const Task& task) {
  return !task.via.empty() || std::ranges::any_of(task.goal_set, [](const GoalRegion& region) {
    return region.straight > 0.0;
  });
}

/// The claims about a path that the judge checks.
PathClaims claims_of(const PlanResult& result, const PlanOptions& all) {
  return {
      .cost = StatedCost{.cost = result.cost, .rule = all.cost, .lower_bound = result.lower_bound},
      .clearance = all.clearance,
      .steering = *all.steering,
      .gears = all.cost.gears};
}

/// Reason why the times of a path among moving obstacles are wrong; empty if they are right.
std::string fault_of_times(const Problem& problem, const PlanOptions& options, PlanResult& result) {
  if (problem.task().moving.empty()) return "";
  if (!result.speeds) return "the planner gives a path among what moves, and no speeds";
  result.drive_check =
      check_drive(problem, {*result.path, *result.speeds}, {options.clearance.margin});
  return result.drive_check->reason;
}

/// Lets the judge check the path, and takes the path away if he rejects it. A bound above the cost
/// is rejected, too.
void judge(const Problem& problem, const PlanOptions& options, PlanResult& result) {
  result.check = check_path(problem, *result.path, claims_of(result, options));
  result.reason = result.check->reason;
  result.goal = result.check->goal;
  result.via = result.check->via;
  if (result.check->valid) result.reason = fault_of_times(problem, options, result);
  if (result.reason.empty()) {
    if (result.anytime.empty()) {  // the planner keeps no trace
      result.anytime.push_back({result.time_total, result.iterations, result.cost});
    }
    if (result.lower_bound && *result.lower_bound <= result.cost * (1 + rounding)) {
      result.lower_bound = std::min(*result.lower_bound, result.cost);
    }
    return;
  }
  result.status = PlanStatus::rejected;
  result.goal.reset();
  result.via.clear();
  result.path.reset();
  result.speeds.reset();
  result.anytime.clear();
  result.cost = 0.0;
  result.lower_bound.reset();
}

/// Computes the cost of the path to all digits, also for the end of the trace. Planners sum the
/// clearance less finely.
void settle_cost(const Task& task, const CostOptions& options, PlanResult& result) {
  const planning::Pricing pricing(task, options);
  result.cost = pricing.path_cost(result.path->segments, search::ClearanceSampling::answer);
  if (!pricing.is_time() && !pricing.prices().has_surcharge()) return;
  std::vector<CostSample>& trace = result.anytime;
  // Among moving obstacles a better drive may have a dearer path.
  const bool must_fall = !result.speeds;
  while (must_fall && trace.size() > 1 && trace[trace.size() - 2].cost <= result.cost)
    trace.pop_back();
  if (!trace.empty()) trace.back().cost = result.cost;
}

PlanResult result_of(const Problem& problem, PlannerAnswer&& answer, double time) {
  PlanResult result{.status = answer.status,
                    .reason = std::move(answer.reason),
                    .iterations = answer.iterations,
                    .time_total = time,
                    .anytime = std::move(answer.anytime),
                    .counters = std::move(answer.counters),
                    .phases = std::move(answer.phases),
                    .tree = std::move(answer.tree)};
  if (result.tree) {
    for (Pose& pose : result.tree->poses) pose = to_scenario(*problem.world(), Local(pose));
  }
  if (answer.lower_bound > 0.0) result.lower_bound = answer.lower_bound;
  const bool is_solved = answer.status == PlanStatus::solved;
  if (answer.lower_bound && std::isnan(*answer.lower_bound)) {
    result.status = PlanStatus::rejected;
    result.reason = "the planner gives a lower bound that is no number";
  } else if (is_solved != answer.segments.has_value()) {
    result.status = PlanStatus::rejected;
    result.reason =
        is_solved ? "the planner says solved, and gives no path"
                  : "the planner gives a path, and says " + std::string(name_of(answer.status));
  } else if (is_solved) {
    result.path = Path{problem.start(), *std::move(answer.segments)};
    result.speeds = std::move(answer.speeds);
  }
  return result;
}

}  // namespace

std::int64_t counter(const PlanResult& result, std::string_view name) noexcept {
  const auto found = std::ranges::find(result.counters, name, &Counter::name);
  return found == result.counters.end() ? 0 : found->value;
}

PlanResult plan(const Problem& problem, const Planner& planner, const PlanOptions& options) {
  if (problem.world() == nullptr) {
    throw InputError("problem", "is empty, expected one that make_problem returned");
  }
  if (!planner.function) {
    throw InputError("planner",
                     "\"" + planner.name + "\" has no function, expected one that plans");
  }
  if (!problem.task().moving.empty() && !planner.can(Capability::moving)) {
    planning::refuse_moving(planner);
  }
  planning::expect_gears_in_zones(planner, problem.world()->local().zones);
  const PlanOptions all = complete(planner, options, problem.vehicle());
  const search::Budget clock(all.budget);
  Task task = task_of(problem, all.clearance, *all.steering);
  std::optional<PlannerAnswer> answer = settled(task, all.cost);
  task = planning::to_set_behind_vias(std::move(task));
  if (!answer) {
    const bool takes_task = (task.goal_set.empty() || planner.can(Capability::goal_sets)) &&
                            (!has_legs(task) || planner.can(Capability::via));
    const double time_price = task.moving.empty() ? 0.0 : in_time::time_price;
    answer = takes_task ? planner.function(task, all)
                        : planning::plan_to_set(task, all, time_price,
                                                planning::restarted_search(planner.function));
  }
  PlanResult result = result_of(problem, *std::move(answer), clock.elapsed());
  result.rule = all.cost;
  planning::explain_refusal(problem, all.clearance, result);
  const bool is_undecided =
      result.status == PlanStatus::time_limit || result.status == PlanStatus::iteration_limit;
  if (is_undecided && result.reason.empty()) result.reason = planning::likely_reason(task);
  if (!result.path) return result;
  settle_cost(task, all.cost, result);
  judge(problem, all, result);
  return result;
}

PlanResult plan(const Problem& problem, const PlanOptions& options) {
  return plan(problem, default_planner(), options);
}

PlanResult plan(const Scenario& scenario, const PlanOptions& options) {
  return plan(make_problem(scenario), options);
}

}  // namespace vandplan

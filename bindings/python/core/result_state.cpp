// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// State of a result for pickle.

#include <pybind11/stl.h>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/check.h"
#include "bindings/python/core/drive.h"
#include "bindings/python/core/options.h"
#include "bindings/python/core/result.h"
#include "bindings/python/core/value.h"

namespace vandplan::python {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

Settings texts_of(const std::vector<Setting>& settings) {
  Settings texts;
  for (const auto& [name, value] : settings) texts.emplace_back(name, value);
  return texts;
}

/// Options of all planners, with the names and values of `--set`.
Settings common_texts(const PlanOptions& options) {
  PlanOptions common = options;
  common.planner = {};
  return texts_of(settings_of(common));
}

PlanOptions options_from(const py::handle& settings, const py::handle& own) {
  PlanOptions options;
  for (const auto& [name, text] : settings.cast<Settings>()) {
    if (const CommonOption* const known = find_common_option(name)) known->set(options, text);
  }
  for (const auto& [name, value] : own.cast<std::map<std::string, OptionValue>>()) {
    options.planner.set(name, value);
  }
  return options;
}

py::tuple state_of(const StatedCost& cost) {
  return py::make_tuple(cost.cost, common_texts({.cost = cost.rule}), cost.lower_bound, cost.gap);
}

StatedCost cost_from(const py::handle& given) {
  const auto state = py::reinterpret_borrow<py::tuple>(given);
  return {state[0].cast<double>(), options_from(state[1], py::dict()).cost,
          state[2].cast<std::optional<double>>(), state[3].cast<std::optional<double>>()};
}

py::tuple state_of(const PathClaims& claims) {
  py::list poses;
  for (const StatedPose& p : claims.poses) {
    const auto gear = p.gear ? std::optional(direction_of(*p.gear)) : std::nullopt;
    poses.append(py::make_tuple(p.s, p.pose, p.curvature, gear, p.hitch_angle));
  }
  const py::object cost = claims.cost ? py::object(state_of(*claims.cost)) : py::none();
  return py::make_tuple(claims.length, claims.gear_changes, cost, claims.clearance.margin,
                        claims.clearance.margin_ramp, name_of(claims.steering),
                        claims.start_hitch_angle, poses, name_of(claims.gears), claims.goal,
                        claims.via);
}

PathClaims claims_from(const py::handle& given) {
  const auto state = py::reinterpret_borrow<py::tuple>(given);
  PathClaims claims{.length = state[0].cast<std::optional<double>>(),
                    .gear_changes = state[1].cast<std::optional<int>>(),
                    .clearance = {state[3].cast<double>(), state[4].cast<double>()},
                    .steering = steering_named(state[5].cast<std::string>()),
                    .gears = gears_named(state[8].cast<std::string>()),
                    .goal = state[9].cast<std::optional<ReachedGoal>>(),
                    .via = state[10].cast<std::vector<PassedVia>>(),
                    .start_hitch_angle = state[6].cast<std::optional<double>>()};
  if (!state[2].is_none()) claims.cost = cost_from(state[2]);
  for (const py::handle item : state[7]) {
    const auto p = py::reinterpret_borrow<py::tuple>(item);
    claims.poses.push_back({.s = p[0].cast<double>(),
                            .pose = p[1].cast<Pose>(),
                            .curvature = p[2].cast<std::optional<double>>(),
                            .hitch_angle = p[4].cast<std::optional<double>>()});
    if (!p[3].is_none()) claims.poses.back().gear = gear_of(p[3].cast<double>());
  }
  return claims;
}

/// State of trace, counters, phases and tree.
py::tuple state_of_trace(const PlanResult& plan) {
  py::list trace;
  for (const auto& [time, iteration, cost] : plan.anytime) {
    trace.append(py::make_tuple(time, iteration, cost));
  }
  py::list counters;
  for (const auto& [name, value] : plan.counters) counters.append(py::make_tuple(name, value));
  py::list phases;
  for (const auto& [name, seconds] : plan.phases) phases.append(py::make_tuple(name, seconds));
  py::object tree = py::none();
  if (plan.tree) {
    tree = py::make_tuple(array_of(std::span<const Pose>(plan.tree->poses)), plan.tree->parents);
  }
  return py::make_tuple(trace, counters, phases, tree);
}

void set_trace(PlanResult& plan, const py::handle& given) {
  const auto state = py::reinterpret_borrow<py::tuple>(given);
  for (const auto& [time, iteration, cost] :
       state[0].cast<std::vector<std::tuple<double, std::int64_t, double>>>()) {
    plan.anytime.push_back({time, iteration, cost});
  }
  for (const auto& [name, value] :
       state[1].cast<std::vector<std::pair<std::string, std::int64_t>>>()) {
    plan.counters.push_back({name, value});
  }
  for (const auto& [name, seconds] : state[2].cast<std::vector<std::pair<std::string, double>>>()) {
    plan.phases.push_back({name, seconds});
  }
  if (state[3].is_none()) return;
  const auto tree = py::reinterpret_borrow<py::tuple>(state[3]);
  const Poses poses(tree[0], "tree");
  plan.tree = TreeSnapshot{{poses.view().begin(), poses.view().end()},
                           tree[1].cast<std::vector<std::int32_t>>()};
}

py::tuple state_of(const PlanResult& plan) {
  py::object speeds = plan.speeds ? py::object(profile_state(*plan.speeds)) : py::none();
  std::optional<Verdict> check;
  if (plan.check) check = Verdict{*plan.check};
  return py::make_tuple(name_of(plan.status), plan.reason, plan.path, plan.cost, plan.lower_bound,
                        plan.iterations, plan.time_total, state_of_trace(plan), check, speeds,
                        plan.drive_check, plan.hit, plan.goal, plan.via);
}

PlanResult plan_from(const py::handle& given) {
  const auto state = py::reinterpret_borrow<py::tuple>(given);
  PlanResult plan{.reason = state[1].cast<std::string>(),
                  .path = state[2].cast<std::optional<Path>>(),
                  .cost = state[3].cast<double>(),
                  .lower_bound = state[4].cast<std::optional<double>>(),
                  .iterations = state[5].cast<std::int64_t>(),
                  .time_total = state[6].cast<double>()};
  const auto status = state[0].cast<std::string>();
  for (const PlanStatus one : plan_statuses()) {
    if (name_of(one) == status) plan.status = one;
  }
  set_trace(plan, state[7]);
  plan.check = state[8].cast<std::optional<Verdict>>();
  if (!state[9].is_none()) plan.speeds = profile_from(state[9]);
  plan.drive_check = state[10].cast<std::optional<DriveCheck>>();
  plan.hit = state[11].cast<std::optional<Hit>>();
  plan.goal = state[12].cast<std::optional<ReachedGoal>>();
  plan.via = state[13].cast<std::vector<PassedVia>>();
  return plan;
}

py::tuple state_of(const RunResult& run) {
  const ResultRecord& record = run.record;
  std::optional<Settings> stated;
  if (record.stated) stated = texts_of(*record.stated);
  return py::make_tuple(run.scenario, record.scenario, record.planner, common_texts(record.options),
                        record.options.planner.values(), result_options(run), record.distance,
                        state_of(claims_of(run)), state_of(record.result), stated);
}

RunResult run_from(const py::tuple& state) {
  ResultRecord record{.scenario = state[1].cast<std::string>(),
                      .planner = state[2].cast<std::string>(),
                      .options = options_from(state[3], state[4]),
                      .distance = state[6].cast<std::optional<double>>(),
                      .result = plan_from(state[8]),
                      .claims = claims_from(state[7])};
  if (const auto stated = state[9].cast<std::optional<Settings>>()) {
    record.stated.emplace();
    for (const auto& [name, value] : *stated) record.stated->push_back({name, value});
  }
  return {state[0].cast<const CheckedScenario&>(), nullptr, std::move(record), state[5]};
}

}  // namespace

void pickle_result(py::class_<RunResult>& result) {
  result.def(py::pickle([](const RunResult& run) { return state_of(run); }, &run_from));
}

}  // namespace vandplan::python

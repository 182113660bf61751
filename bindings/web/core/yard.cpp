// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "bindings/web/core/yard.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "vandplan/input_error.h"

namespace vandplan::web {
namespace {

/// Planner options from an object of numbers, words and flags; null values are ignored, and the
/// table of the site is left out.
PlanOptions options_from(const Planner& planner, const val& given) {
  PlanOptions options;
  if (given.isUndefined() || given.isNull()) return options;
  const val keys = val::global("Object").call<val>("keys", given);
  const auto count = keys["length"].as<std::size_t>();
  std::vector<std::string> names;
  names.reserve(count);
  for (std::size_t i = 0; i < count; ++i) names.push_back(keys[i].as<std::string>());
  std::stable_sort(names.begin(), names.end(), [](const std::string& a, const std::string& b) {
    return setting_order(a) < setting_order(b);
  });
  for (const std::string& key : names) {
    if (key == site_key || !has(given, key.c_str())) continue;
    set_option(options, planner, key, val::global("String")(given[key]).as<std::string>());
  }
  return options;
}

/// Options of a table of the site, in force.
PlanOptions prices_of_site(const val& query, const Problem& problem) {
  const Planner& planner = default_planner();
  return complete(planner, options_from(planner, query["options"]), problem.vehicle());
}

val rows_of(std::span<const Motion> motions) {
  std::vector<double> rows;
  for (const Motion& motion : motions) {
    rows.insert(rows.end(), {motion.t, motion.s, motion.pose.x, motion.pose.y, motion.pose.heading,
                             motion.curvature, motion.v});
  }
  return array_of(std::span<const double>(rows));
}

/// Rows of the drive among moving obstacles; null if there is none.
val drive_of(const PlanResult& result, const Vehicle& vehicle) {
  if (!result.path || !result.speeds) return val::null();
  return rows_of(sampled(*result.path, vehicle, *result.speeds, 0.05));
}

/// Planner with the given name, or the default one, which may begin with a known path.
Planner planner_of(const val& query) {
  const Planner planner =
      has(query, "planner") ? planner_named(query["planner"].as<std::string>()) : default_planner();
  if (!has(query, "warm_start")) return planner;
  if (planner.name != default_planner().name) {
    throw InputError("warm_start", "is for the planner " + default_planner().name);
  }
  return warm_started(path_from(query["warm_start"]));
}

}  // namespace

val rows_of_drive(const Path& path, const Vehicle& vehicle, const SpeedOptions& options,
                  double step) {
  if (!(step >= 1e-3)) throw InputError("step", "expected at least 0.001 s");
  return rows_of(sampled(path, vehicle, speed_profile(path, vehicle, options), step));
}

Yard::Yard(const val& scenario)
    : scenario_(scenario_from(scenario)),
      problem_(make_problem(scenario_)),
      world_(problem_.world()) {}

val Yard::plan(const val& query) {
  allow_only(query, {"planner", "options", "start", "goal", "via", "vehicle", "warm_start"},
             "query");
  const Planner planner = planner_of(query);
  const Problem problem = problem_of(query);
  PlanOptions options = options_from(planner, query["options"]);
  const val given = query["options"];
  if (!given.isUndefined() && !given.isNull() && has(given, site_key)) {
    options.site = site_.read(given[site_key]);
  }
  options = complete(planner, options, problem.vehicle());
  const PlanResult result = vandplan::plan(problem, planner, options);
  val object = object_of(result);
  object.set("drive", drive_of(result, problem.vehicle()));
  object.set("steering", std::string(name_of(options.steering.value_or(Steering::reeds_shepp))));
  return object;
}

val Yard::check(const val& query) const {
  allow_only(
      query,
      {"path", "margin", "margin_ramp", "steering", "gears", "start", "goal", "via", "vehicle"},
      "query");
  PathClaims claims{
      .clearance = {number_at(query, "margin", "", 0.0), number_at(query, "margin_ramp", "", 0.0)}};
  if (has(query, "steering")) claims.steering = steering_named(query["steering"].as<std::string>());
  if (has(query, "gears")) claims.gears = gears_named(query["gears"].as<std::string>());
  return object_of(check_path(problem_of(query), path_from(query["path"]), claims));
}

val Yard::drive(const val& query) const {
  allow_only(query, {"path", "step", "start", "goal", "via", "vehicle"}, "query");
  const Problem problem = problem_of(query);
  const Path path = path_from(query["path"]);
  return rows_of_drive(path, problem.vehicle(), speed_options(problem, path),
                       number_at(query, "step", "", 0.05));
}

val Yard::is_free(const val& query) const {
  allow_only(query, {"pose", "vehicle", "margin"}, "query");
  const Vehicle vehicle =
      has(query, "vehicle") ? vehicle_from(query["vehicle"]) : problem_.vehicle();
  const Margin margin{.wanted = number_at(query, "margin", "", 0.0)};
  const End end = end_from(query["pose"], "pose", vehicle);
  const LocalState state = to_local(*world_, State{end.pose, end.hitch_angle});
  return val(world_->checker(vehicle, margin)->is_free(state));
}

val Yard::site_table(const val& query, const val& progress) const {
  const Problem problem = site_problem_of(query);
  const PlanOptions options = prices_of_site(query, problem);
  const SiteWish wish = site_wish_from(query, problem, options, progress);
  return bytes_of(make_site_table(problem, wish.goals, options, wish.options).value());
}

ChangingSiteTable Yard::changing_site_table(const val& query, const val& progress) const {
  const Problem problem = site_problem_of(query);
  const PlanOptions options = prices_of_site(query, problem);
  const SiteWish wish = site_wish_from(query, problem, options, progress);
  return {problem, wish.goals, options, wish.options};
}

Problem Yard::site_problem_of(const val& query) const {
  allow_only(query, {"goals", "vehicle", "options", "headings", "cell"}, "query");
  return problem_of(query);
}

Problem Yard::problem_of(const val& query) const {
  const Vehicle vehicle =
      has(query, "vehicle") ? vehicle_from(query["vehicle"]) : scenario_.vehicle;
  const End start = has(query, "start") ? end_from(query["start"], "start", vehicle)
                                        : End{scenario_.start, scenario_.curvatures.start,
                                              scenario_.hitch_angles.start};
  Goal goal = has(query, "goal")
                  ? goal_from(query["goal"], vehicle)
                  : Goal{{scenario_.goal, scenario_.curvatures.goal, scenario_.hitch_angles.goal},
                         scenario_.goal_set};
  if (!goal.set.empty()) goal.end = start;
  const Problem problem = make_problem(world_, vehicle, start.pose, goal.end.pose,
                                       {start.curvature, goal.end.curvature},
                                       {start.hitch_angle, goal.end.hitch_angle});
  const std::vector<Via> via = has(query, "via") ? via_at(query, vehicle) : scenario_.via;
  const Problem ends = goal.set.empty() ? problem : with_goal_set(problem, goal.set);
  return with_moving(with_via(ends, via), scenario_.moving);
}

}  // namespace vandplan::web

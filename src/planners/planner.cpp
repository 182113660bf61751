// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/planner.h"

#include <array>
#include <stdexcept>

#include "base/text.h"
#include "planners/anytime/anytime.h"
#include "planners/rrt.h"
#include "vandplan/input_error.h"
#include "vandplan/path_check.h"
#include "vandplan/reeds_shepp.h"

namespace vandplan {
namespace {

template <Strategy strategy, Estimate estimate>
PlanResult rrt(const Problem& problem, const PlanOptions& options) {
  return plan_rrt(problem, options, strategy, estimate);
}

constexpr auto nearest = Strategy::nearest;
constexpr auto least_total_cost = Strategy::least_total_cost;

constexpr std::array planner_infos = {
    PlannerInfo{"anytime", plan_anytime,
                "lattice searches and random trees, each path shortened: the one to use", true},
    PlannerInfo{"rrt-bsc-euc", rrt<nearest, Estimate::euclid>,
                "RRT, parent = nearest node by Euclid"},
    PlannerInfo{"rrt-bsc-hlut-1", rrt<nearest, Estimate::hlut_1>,
                "RRT, parent = nearest node by table 1 (10 m, pi/4)"},
    PlannerInfo{"rrt-bsc-hlut-2", rrt<nearest, Estimate::hlut_2>,
                "RRT, parent = nearest node by table 2 (20 m, pi/4)"},
    PlannerInfo{"rrt-bsc-hlut-3", rrt<nearest, Estimate::hlut_3>,
                "RRT, parent = nearest node by table 3 (10 m, pi/12)"},
    PlannerInfo{"rrt-bsc-hlut-4", rrt<nearest, Estimate::hlut_4>,
                "RRT, parent = nearest node by table 4 (30 m, pi/12)"},
    PlannerInfo{"rrt-bsc-bound", rrt<nearest, Estimate::bound>,
                "RRT, parent = nearest node by lower bound of its length"},
    PlannerInfo{"rrt-bsc-rs", rrt<nearest, Estimate::reeds_shepp>,
                "RRT, parent = nearest node by exact Reeds-Shepp length"},
    PlannerInfo{"rrt-opt-euc", rrt<least_total_cost, Estimate::euclid>,
                "RRT, parent = least total path cost, ranked by Euclid"},
    PlannerInfo{"rrt-opt-hlut-1", rrt<least_total_cost, Estimate::hlut_1>,
                "RRT, parent = least total path cost, ranked by table 1 (10 m, pi/4)"},
    PlannerInfo{"rrt-opt-hlut-2", rrt<least_total_cost, Estimate::hlut_2>,
                "RRT, parent = least total path cost, ranked by table 2 (20 m, pi/4)"},
    PlannerInfo{"rrt-opt-hlut-3", rrt<least_total_cost, Estimate::hlut_3>,
                "RRT, parent = least total path cost, ranked by table 3 (10 m, pi/12)"},
    PlannerInfo{"rrt-opt-hlut-4", rrt<least_total_cost, Estimate::hlut_4>,
                "RRT, parent = least total path cost, ranked by table 4 (30 m, pi/12)"},
    PlannerInfo{"rrt-opt-bound", rrt<least_total_cost, Estimate::bound>,
                "RRT, parent = least total path cost, ranked by lower bound of the length"},
    PlannerInfo{"rrt-opt-rs", rrt<least_total_cost, Estimate::reeds_shepp>,
                "RRT, parent = least total path cost, ranked by exact Reeds-Shepp length"},
};

bool is_free(const Problem& problem, const Pose& pose) {
  return problem.world->checker().is_free(pose);
}

// What needs no search: a start or goal that cannot be, and a goal that is the start.
std::optional<PlanResult> settled(const Problem& problem) {
  PlanResult result;
  if (!is_free(problem, problem.start)) {
    result.status = PlanStatus::start_in_collision;
    return result;
  }
  if (!is_free(problem, problem.goal)) {
    result.status = PlanStatus::goal_in_collision;
    return result;
  }
  const double radius = problem.world->vehicle().min_turning_radius;
  if (reeds_shepp_length(problem.start, problem.goal, radius) > 0.0) return std::nullopt;
  result.status = PlanStatus::solved;
  result.path = Path{problem.start, {}};
  result.anytime.push_back({});
  return result;
}

// What a planner says about its path.
PathClaims claims_of(const PlanResult& result, const PlannerInfo& planner,
                     const PlanOptions& options) {
  StatedCost cost{.cost = result.cost};
  if (planner.weighs) {
    cost.reverse_weight = options.reverse_weight;
    cost.gear_change_cost = options.gear_change_cost;
    cost.initial_direction = direction_of(options.initial_gear);
  }
  if (result.lower_bound > 0.0) cost.bound = result.lower_bound;
  return {.cost = cost};
}

}  // namespace

std::string_view name_of(PlanStatus status) noexcept {
  constexpr std::array<std::string_view, 7> names = {
      "solved",          "start_in_collision", "goal_in_collision",
      "iteration_limit", "node_limit",         "time_limit",
      "stopped"};
  return names[static_cast<std::size_t>(status)];
}

std::span<const PlannerInfo> planners() noexcept { return planner_infos; }

const PlannerInfo& default_planner() noexcept { return planner_infos.front(); }

const PlannerInfo& planner_named(std::string_view name) {
  for (const PlannerInfo& info : planner_infos) {
    if (info.name == name) return info;
  }
  throw InputError("planner", "\"" + std::string(name) + "\" is unknown, expected one of " +
                                  base::joined(planner_infos, &PlannerInfo::name));
}

PlanResult plan(const Problem& problem, const PlannerInfo& planner, const PlanOptions& options) {
  validate(options);
  const std::optional<PlanResult> early = settled(problem);
  PlanResult result = early ? *early : planner.function(problem, options);
  if (!result.path) return result;
  const PathCheck check = check_path(problem, *result.path, claims_of(result, planner, options));
  if (!check.valid) {
    throw std::logic_error(std::string(planner.name) + ", seed " + std::to_string(options.seed) +
                           ": the judge rejects the path: " + check.reason);
  }
  return result;
}

}  // namespace vandplan

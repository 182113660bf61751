// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/reasons.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/text.h"
#include "problem/map_hit.h"
#include "vandplan/collision.h"
#include "vandplan/judge.h"
#include "vandplan/vehicle.h"

namespace vandplan::planning {
namespace {

/// Why a start or goal is refused.
struct Refusal {
  std::string reason;
  std::optional<Hit> hit = {};
};

/// Reason of the judge why a state is not free; or else that of the planner, or that planning asks
/// for a little more margin.
Refusal refusal_at(const Problem& problem, const State& state, const ClearanceOptions& options,
                   const std::string& of_planner) {
  const auto& [pose, angle] = state;
  const Problem there =
      make_problem(problem.world(), problem.vehicle(), pose, pose, {}, {angle, angle});
  const PathCheck check = check_path(there, Path{pose, {}}, {.clearance = options});
  if (check.hit && check.hit->kind == HitKind::map) {
    const std::optional<problem::CellHit> cell = problem::map_hit(problem, state);
    if (cell) return {check.reason + ": " + cell->text, Hit{HitKind::map, 0, cell->middle}};
  }
  const bool is_free = check.clearance && *check.clearance > 0.0;
  if (!check.reason.empty() && is_free && options.margin_ramp == 0.0) {
    return {check.reason + "; with margin_ramp a start or goal may be nearer", check.hit};
  }
  if (!check.reason.empty()) return {check.reason, check.hit};
  if (!of_planner.empty()) return {of_planner};
  return {"the pose keeps the margin of " + base::shortest_text(options.margin) +
          " m, but planning asks for up to " +
          base::shortest_text(1e3 * CollisionChecker::tolerance) + " mm more"};
}

}  // namespace

void explain_refusal(const Problem& problem, const ClearanceOptions& options, PlanResult& result) {
  const bool is_start = result.status == PlanStatus::start_in_collision;
  if (!is_start && result.status != PlanStatus::goal_in_collision) return;
  // For a set the planner's reason says how many poses were tried. For one pose the judge has a
  // reason.
  const bool is_set = problem.goal_set().size() > 1 ||
                      (problem.goal_set().size() == 1 && is_continuous(problem.goal_set()[0]));
  if (!is_start && is_set) return;
  const auto& [start, goal] = problem.hitch_angles();
  const State at = is_start ? State{problem.start(), start} : State{problem.goal(), goal};
  Refusal refusal = refusal_at(problem, at, options, result.reason);
  result.reason = std::move(refusal.reason);
  result.hit = refusal.hit;
}

std::string likely_reason(const Task& task) {
  if (task.steering != Steering::continuous) return "";  // the wheels turn at a standstill
  const double rate = max_curvature_rate(task.vehicle);
  const double way = 2.0 / (task.vehicle.min_turning_radius * rate);
  const Bounds& b = task.world->local().bounds;
  const double extent = std::max(b.x_max - b.x_min, b.y_max - b.y_min);
  if (!(way > extent)) return "";
  return "likely because of max_curvature_rate: the wheels turn from lock to lock on " +
         base::shortest_text(std::round(way)) + " m, and the bounds are " +
         base::shortest_text(std::round(extent)) + " m long";
}

}  // namespace vandplan::planning

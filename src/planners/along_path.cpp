// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/along_path.h"

#include <cmath>
#include <optional>

#include "planners/goal_poses.h"
#include "vandplan/judge.h"
#include "vandplan/vehicle.h"

namespace vandplan::planning {
namespace {

/// The goal of a set at which a path ends in this state.
std::optional<ReachedGoal> goal_at(const Problem& problem, const State& end) {
  const Task& task = problem.task();
  const std::optional<GoalPoint> point = point_at(task, to_local(*problem.world(), end));
  if (!point || !is_in_region(task, *point)) return std::nullopt;
  const LocalState state = state_of(task, *point);
  const Pose& pose = static_cast<const State&>(state).pose;
  return ReachedGoal{point->region, to_scenario(*problem.world(), Local(pose))};
}

}  // namespace

Along along_path(const Problem& problem, const Path& path) {
  PathCheck check = check_path(problem, path);
  Along along{.problem = problem};
  if (!problem.goal_set().empty() && problem.task().moving.empty()) {
    State end{path.start, problem.hitch_angles().start};
    double last = 0.0;  // length of the last segment that has one [m]
    for (const Segment& segment : path.segments) {
      end = advance(problem.vehicle(), end, segment);
      if (segment.length != 0.0) last = segment.length;
    }
    GoalRegion region = region_of_pose(end.pose);
    if (const auto goal = check.goal ? check.goal : goal_at(problem, end)) {
      region = problem.goal_set()[goal->index];
      end.pose = goal->pose;
    }
    along.last_stretch = std::copysign(region.straight, last);
    along.problem = make_problem(problem.world(), problem.vehicle(), problem.start(), end.pose,
                                 {problem.curvatures().start, region.curvature},
                                 {problem.hitch_angles().start, end.hitch_angle});
    if (!problem.via().empty()) along.problem = with_via(along.problem, problem.via());
    if (!check.goal) check = check_path(along.problem, path);
  }
  if (check.via.size() < problem.via().size()) return along;
  along.passed.reserve(check.via.size());
  for (const PassedVia& there : check.via) along.passed.push_back(there.s);
  return along;
}

}  // namespace vandplan::planning

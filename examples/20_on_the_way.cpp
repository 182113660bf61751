// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I pass other places on the way, and come to the goal straight?

#include <vandplan/planner.h>

#include <cstdio>

int main() {
  vandplan::Scenario depot;
  depot.bounds = {-10, 90, -30, 40};
  depot.obstacles = {{{28, 8}, {32, 8}, {32, 40}, {28, 40}}};

  // Over the weighbridge, where the truck stands, then past the gate, whichever way it points.
  vandplan::Via weighbridge{.any_of = {vandplan::region_of_pose({20, 0, 0})}, .stop = true};
  vandplan::GoalRegion gate = vandplan::region_of_pose({45, 10, 0});
  gate.heading = vandplan::any_heading;
  depot.via = {weighbridge, {.any_of = {gate}}};

  // The last 8 m into the dock are straight, forward or in reverse.
  vandplan::GoalRegion dock = vandplan::region_of_pose({70, 30, 1.5708});
  dock.either_way = true;
  dock.straight = 8;
  depot.goal_set = {dock};

  vandplan::PlanOptions options;
  options.budget.max_iterations = 20'000;
  const vandplan::PlanResult result = vandplan::plan(depot, options);
  if (!result.path) {
    std::printf("%s\n", result.reason.c_str());
    return 1;
  }
  for (const vandplan::PassedVia& via : result.via) {
    std::printf("after %.1f m at (%.1f, %.1f), heading %.2f\n", via.s, via.pose.x, via.pose.y,
                via.pose.heading);
  }
  std::printf("%.1f m in all, the last segment %.1f m\n", vandplan::length(result.path->segments),
              result.path->segments.back().length);
}

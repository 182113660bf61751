// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I plan to any free dock, or to any heading?

#include <vandplan/planner.h>

#include <cstdio>

int main() {
  constexpr double down = -1.5708;  // heading at a dock [rad]: the truck backs in
  vandplan::Scenario depot;
  depot.bounds = {-10, 70, -10, 40};
  depot.start = {0, 5, 0};
  depot.inside = {{{-10, -10}, {70, -10}, {70, 40}, {-10, 40}}};  // the fence around the yard
  for (int i = 0; i < 12; ++i) {
    const double x = 12 + 4.0 * i;
    depot.goal_set.push_back(vandplan::region_of_pose({x, 32, down}));
    depot.obstacles.push_back({{x - 2.1, 28}, {x - 1.9, 28}, {x - 1.9, 36}, {x - 2.1, 36}});
    const bool is_taken = i % 3 != 1;
    if (is_taken) {
      depot.obstacles.push_back({{x - 1, 28}, {x + 1, 28}, {x + 1, 36}, {x - 1, 36}});
    }
  }

  vandplan::PlanOptions options;
  options.budget.max_iterations = 4000;
  const vandplan::PlanResult docked = vandplan::plan(depot, options);
  if (!docked.path || !docked.goal) return 1;
  std::printf("dock %zu at x %.0f m: %.1f m, gear changes: %d\n", docked.goal->index,
              docked.goal->pose.x, vandplan::length(docked.path->segments),
              docked.check->gear_changes);

  // Then to the fuel pump, with any heading of the truck, or to the parking lot, which is an area.
  vandplan::GoalRegion pump = vandplan::region_of_pose({60, 0, 0});
  pump.heading = vandplan::any_heading;
  vandplan::GoalRegion lot{.area = {{20, -8}, {40, -8}, {40, -2}, {20, -2}},
                           .heading = {-0.2, 0.2}};
  for (const vandplan::GoalRegion& region : {pump, lot}) {
    depot.goal_set = {region};
    const vandplan::PlanResult result = vandplan::plan(depot, options);
    if (!result.path || !result.goal) return 1;
    const auto& [x, y, heading] = result.goal->pose;
    std::printf("to (%.1f, %.1f), heading %.2f: %.1f m\n", x, y, heading,
                vandplan::length(result.path->segments));
  }
  return docked.goal->index % 3 == 1 ? 0 : 1;
}

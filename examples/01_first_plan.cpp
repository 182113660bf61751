// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <vandplan/planner.h>

#include <cstdio>

int main() {
  vandplan::Scenario yard;           // metres and radians; the default vehicle is a truck
  yard.bounds = {-50, 50, -50, 50};  // where the midpoint of the rear axle may be
  yard.start = {0, 0, 0};            // x, y, heading
  yard.goal = {0, 12, 0};
  yard.obstacles = {{{-20, 5}, {15, 5}, {15, 7}, {-20, 7}}};

  vandplan::PlanOptions options;
  options.budget.max_iterations = 10000;  // repeats exactly; time_limit = 0.1 would not
  const auto result = vandplan::plan(yard, options);
  if (!result.path) return 1;

  std::printf("%.2f m, gear changes: %d\n", vandplan::length(result.path->segments),
              vandplan::gear_changes(result.path->segments));
  for (const auto& [s, pose, curvature, gear] : vandplan::sampled(*result.path, 5.0)) {
    std::printf("x %7.3f  y %7.3f  heading %6.3f\n", pose.x, pose.y, pose.heading);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How does a path from elsewhere become shorter, and one that the wheels can follow?

#include <vandplan/judge.h>
#include <vandplan/planner.h>
#include <vandplan/steering.h>

#include <cstdio>
#include <vector>

int main() {
  vandplan::Scenario yard;
  yard.bounds = {-10, 60, -30, 30};
  yard.goal = {50, 0, 0};
  yard.obstacles = {{{15, -30}, {17, -30}, {17, 5}, {15, 5}},
                    {{32, -5}, {34, -5}, {34, 30}, {32, 30}}};
  const vandplan::Problem problem = vandplan::make_problem(yard);

  // Somebody has set poses by hand, and joined them by arcs and lines.
  const std::vector<vandplan::Pose> poses = {yard.start,    {10, 12, 1.0}, {18, 15, 0},
                                             {24, 0, -1.5}, {33, -12, 0},  {40, -8, 1.0},
                                             yard.goal};
  vandplan::Path path{yard.start, {}};
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const vandplan::Piece piece =
        vandplan::reeds_shepp(poses[i - 1], poses[i], yard.vehicle.min_turning_radius);
    path.segments.insert(path.segments.end(), piece.view().begin(), piece.view().end());
  }
  const vandplan::PathCheck before = vandplan::check_path(problem, path);
  std::printf("by hand:  %6.2f m, %d gear changes, %.2f m from the walls\n", before.length,
              before.gear_changes, before.clearance.value_or(0));

  vandplan::PlanOptions options;  // the default prices: a driver's
  options.budget.max_iterations = 2000;
  options.clearance.margin = 0.2;
  const vandplan::Smoothed smoothed =
      vandplan::smooth(problem, path, vandplan::SmoothMethod::optimised, options);
  if (!smoothed.result.path) return 1;
  const vandplan::PathCheck& after = *smoothed.result.check;
  std::printf("smoothed: %6.2f m, %d gear changes, %.2f m from the walls\n", after.length,
              after.gear_changes, after.clearance.value_or(0));
  std::printf("cost %.2f m, was %.2f m; fault of the path by hand: %s\n", smoothed.result.cost,
              smoothed.given_cost, smoothed.given_fault.c_str());

  // The judge checks that the curvature of the new path jumps at standstill only.
  const bool can_be_followed =
      vandplan::check_path(problem, *smoothed.result.path,
                           {.clearance = options.clearance,
                            .steering = vandplan::Steering::continuous_between_stops})
          .valid;
  return before.valid && can_be_followed && after.length < before.length ? 0 : 1;
}

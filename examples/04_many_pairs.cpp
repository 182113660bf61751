// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I plan between many pairs of poses in one world, on several threads?

#include <vandplan/planner.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

int main() {
  // The world is built once: its obstacles, and a collision checker for each vehicle.
  const auto world = std::make_shared<const vandplan::World>(
      vandplan::Surroundings{.bounds = {-60, 60, -60, 60},
                             .obstacles = {{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}}},
      vandplan::Point{0, 0});

  const vandplan::Vehicle truck;
  std::vector<vandplan::Problem> problems;
  for (int i = 0; i < 24; ++i) {  // each pair crosses a circle
    const double angle = i * 3.141592653589793 / 12;
    const double x = 30 * std::cos(angle);
    const double y = 30 * std::sin(angle);
    problems.push_back(vandplan::make_problem(world, truck, {x, y, 0}, {-x, -y, 0}));
  }

  vandplan::PlanOptions options;
  options.budget.max_iterations = 2000;  // limit for each pair
  int solved = 0;
  // Results come in the order of the problems, one at a time.
  vandplan::plan_many(problems, vandplan::default_planner(), options, 4,
                      [&](std::size_t i, const vandplan::PlanResult& result) {
                        std::printf("%2zu: %.2f m\n", i, result.cost);
                        solved += result.path ? 1 : 0;
                      });
  return solved == 24 ? 0 : 1;
}

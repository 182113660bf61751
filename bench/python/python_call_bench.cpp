// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The plans of bench/python/figures.py in C++: prints processor seconds for each.

#include <cstdio>
#include <ctime>

#include "vandplan/planner.h"

int main() {
  using namespace vandplan;
  Scenario scenario;
  scenario.bounds = {-50, 50, -50, 50};
  scenario.goal = {20, 0, 0};
  const Problem problem = make_problem(scenario);
  const Planner& planner = planner_named("rrt-bsc-euc");
  constexpr int count = 20'000;
  const std::clock_t begin = std::clock();
  std::int64_t iterations = 0;
  for (int i = 0; i < count; ++i) {
    PlanOptions options;
    options.budget.max_iterations = 1;
    iterations += plan(problem, planner, options).iterations;
  }
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  std::printf("%.9f\n", seconds / count);
  return iterations > 0 ? 0 : 1;
}

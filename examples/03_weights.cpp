// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I say what driving costs: the length alone, what a driver minds, or prices of my own?

#include <vandplan/planner.h>

#include <cstdio>

namespace {

vandplan::PlanResult planned(const vandplan::Scenario& scenario,
                             const vandplan::CostOptions& cost) {
  vandplan::PlanOptions options;
  options.budget.max_iterations = 20000;
  options.cost = cost;
  const vandplan::PlanResult result = vandplan::plan(scenario, options);
  if (result.check) {
    std::printf("cost %6.2f m, length %6.2f m, %6.2f m of it in reverse, %d gear changes\n",
                result.cost, result.check->length, result.check->reverse_length,
                result.check->gear_changes);
  }
  return result;
}

}  // namespace

int main() {
  vandplan::Scenario road;  // a road 16 m wide, on which the truck turns round
  road.bounds = {-60, 60, -10, 10};
  road.start = {0, -3, 0};
  road.goal = {0, 3, 3.141592653589793};
  road.obstacles = {{{-60, 8}, {60, 8}, {60, 10}, {-60, 10}},
                    {{-60, -10}, {60, -10}, {60, -8}, {-60, -8}}};

  const auto by_length = planned(road, vandplan::shortest_style);
  const auto by_driver = planned(road, vandplan::driver_style);  // the default prices
  const auto by_price = planned(road, {.reverse_weight = 5, .gear_change_cost = 10});
  if (!by_length.path || !by_driver.path || !by_price.path) return 1;
  const bool is_longer = by_price.check->length >= by_length.check->length - 1e-6;
  const bool reverses_less =
      by_price.check->reverse_length <= by_length.check->reverse_length + 1e-6;
  return is_longer && reverses_less ? 0 : 1;
}

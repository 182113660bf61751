// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I plan on a map of my own, with a vehicle of my own?

#include <vandplan/planner.h>

#include <cstdio>
#include <utility>
#include <vector>

namespace {

/// 60 m by 40 m of free ground in cells of 0.2 m, with a wall that has a gate.
vandplan::OccupancyGrid yard_with_a_gate() {
  vandplan::OccupancyGrid map{.resolution = 0.2, .columns = 300, .rows = 200};
  std::vector<vandplan::Cell> cells(300 * 200, vandplan::Cell::free);
  for (std::size_t row = 0; row < 200; ++row) {
    const bool is_gate = row >= 150 && row < 170;  // y from 30 m to 34 m
    for (std::size_t column = 148; column < 152 && !is_gate; ++column) {
      cells[row * 300 + column] = vandplan::Cell::occupied;  // x from 29.6 m to 30.4 m
    }
  }
  map.cells = std::move(cells);
  return map;
}

}  // namespace

int main() {
  vandplan::Scenario scenario;
  scenario.vehicle = {.wheelbase = 2.8,
                      .front_overhang = 0.9,
                      .rear_overhang = 1.0,
                      .width = 1.9,
                      .min_turning_radius = 5.5};
  scenario.map = yard_with_a_gate();
  scenario.bounds = {0, 60, 0, 40};
  scenario.start = {10, 10, 0};
  scenario.goal = {50, 10, 0};

  vandplan::PlanOptions options;
  options.budget.max_iterations = 5000;
  const vandplan::PlanResult result = vandplan::plan(scenario, options);
  std::printf("%s: %.2f m, %.1f mm from the map at its closest\n",
              std::string(vandplan::name_of(result.status)).c_str(), result.cost,
              1e3 * (result.check ? result.check->clearance.value_or(0) : 0));
  // Straight ahead it would be 40 m, but the way through the gate is a detour.
  return result.path && result.cost > 50 && result.check->clearance > 0 ? 0 : 1;
}

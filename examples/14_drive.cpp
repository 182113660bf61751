// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How far does a truck stray from its path when it errs, and which margin is enough?

#include <vandplan/drive.h>
#include <vandplan/planner.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace {

struct Drives {
  int contacts = 0;        ///< drives that touch an obstacle
  int arrivals = 0;        ///< drives that end at the goal
  double sideways = 0.0;   ///< largest distance of the rear axle from the path [m]
  double deviation = 0.0;  ///< largest distance of the outline beyond the planned area [m]
};

/// Plans with a margin, and drives the path 20 times, with other noise each time.
Drives driven(const vandplan::Problem& problem, double margin, std::uint64_t first_seed) {
  vandplan::PlanOptions options;
  options.budget.max_iterations = 10000;
  options.style = vandplan::Style::shortest;  // as near to the wall as the margin allows
  options.steering = vandplan::Steering::continuous;
  options.clearance.margin = margin;
  const vandplan::PlanResult result = vandplan::plan(problem, options);
  if (!result.path) return {};
  Drives drives;
  for (std::uint64_t seed = first_seed; seed < first_seed + 20; ++seed) {
    const vandplan::DriveResult drive = vandplan::drive(
        problem, *result.path, {.noise = 1, .delay = 0.1, .spare_steering = 0.1, .seed = seed});
    drives.contacts += drive.contact ? 1 : 0;
    drives.arrivals += drive.has_arrived ? 1 : 0;
    drives.sideways = std::max(drives.sideways, drive.largest_lateral);
    drives.deviation = std::max(drives.deviation, drive.outline_deviation);
  }
  std::printf("margin %.3f m, path %.2f m: the axle strays by %.3f m, the outline by %.3f m; ",
              margin, result.cost, drives.sideways, drives.deviation);
  std::printf("%d of 20 drives touch the wall\n", drives.contacts);
  return drives;
}

}  // namespace

int main() {
  vandplan::Scenario yard;
  yard.bounds = {-50, 50, -50, 50};
  yard.goal = {0, 12, 0};
  yard.obstacles = {{{-20, 5}, {15, 5}, {15, 7}, {-20, 7}}};
  const vandplan::Problem problem = vandplan::make_problem(yard);

  const Drives tight = driven(problem, 0.0, 1);
  const Drives wide = driven(problem, 1.1 * tight.deviation, 1001);  // margin: a tenth more
  return tight.contacts > 0 && wide.contacts == 0 && wide.arrivals == 20 ? 0 : 1;
}

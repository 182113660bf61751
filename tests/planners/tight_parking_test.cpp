// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Are tight parking slots solved by wheels that are never turned at standstill?
#include <gtest/gtest.h>

#include "../support/cases.h"
#include "../support/continuity.h"
#include "../support/problems.h"
#include "../support/shared_files.h"
#include "vandplan/files.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

PlanOptions continuous(std::int64_t iterations) {
  PlanOptions options{.cost = shortest_style, .steering = Steering::continuous};
  options.budget.max_iterations = iterations;
  return options;
}

// A car of 4.69 m in a slot of 6.84 m beside a lane of 4.18 m. Searches with two locks to either
// side find no path after twice as many iterations.
TEST(TightParking, TakesAThirdLockInASlot) {
  if (is_sanitized) GTEST_SKIP() << "too slow with a sanitizer";
  const Problem problem = make_problem(
      {.vehicle = {.wheelbase = 2.8,
                   .front_overhang = 0.96,
                   .rear_overhang = 0.929,
                   .width = 1.942,
                   .min_turning_radius = 4.5},
       .bounds = {-16, 22.842, -3.345, 5.181},
       .start = {-9.6948, 1.8758, 0},
       .goal = {2.3444, -1.2422, -0.0161},
       .obstacles = {box(-15, -2.3447, 0, 0), box(6.842, -2.3447, 21.842, 0),
                     box(-15, -3.3447, 21.842, -2.3447), box(-15, 4.1813, 21.842, 5.1813)}});
  const PlanResult result = plan(problem, continuous(40'000));
  ASSERT_TRUE(result.path);
  expect_continuous(*result.path, problem, Steering::continuous);
}

// With many locks a search looks at every pose too often, with one it misses what a slot needs.
TEST(TightParking, IsSolvedWithoutJumpsOfCurvature) {
  if (is_sanitized) GTEST_SKIP() << "too slow with a sanitizer";
  const PlanOptions options = continuous(60'000);
  for (const char* file : {"case13.yaml", "case19.yaml"}) {
    const auto path = shared_folder() / "scenarios" / "tpcap" / file;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no file " << path;
    const ScenarioProblems read = read_problems(path.string());
    ASSERT_EQ(read.problems.size(), 1U);
    const PlanResult result = plan(read.problems.front(), options);
    ASSERT_TRUE(result.path) << file;
    expect_continuous(*result.path, read.problems.front(), Steering::continuous);
  }
}

}  // namespace
}  // namespace vandplan

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

/// A car of 4.69 m beside a lane along x, from y = 0 to `lane`, with a slot from x = 0 to `length`
/// that is `depth` deep [m].
Problem slot(double length, double depth, double lane, const Pose& start, const Pose& goal) {
  return make_problem({.vehicle = {.wheelbase = 2.8,
                                   .front_overhang = 0.96,
                                   .rear_overhang = 0.929,
                                   .width = 1.942,
                                   .min_turning_radius = 4.5},
                       .bounds = {-16, length + 16, -depth - 1, lane + 1},
                       .start = start,
                       .goal = goal,
                       .obstacles = {box(-15, -depth, 0, 0), box(length, -depth, length + 15, 0),
                                     box(-15, -depth - 1, length + 15, -depth),
                                     box(-15, lane, length + 15, lane + 1)}});
}

// Searches with two locks to either side find no path after three times as many iterations.
TEST(TightParking, TakesAThirdLockInASlot) {
  if (is_sanitized) GTEST_SKIP() << "too slow with a sanitizer";
  const Problem problem =
      slot(6.842, 2.3447, 4.1813, {-9.6948, 1.8758, 0}, {2.3444, -1.2422, -0.0161});
  const PlanResult result = plan(problem, continuous(40'000));
  ASSERT_TRUE(result.path);
  expect_continuous(*result.path, problem, Steering::continuous);
}

// The first route, by length, has twelve gear changes. Where all searches take turns the fine one
// that found it finds nothing better after as many iterations.
TEST(TightParking, SearchesAgainByPriceWhereOnlyAFineSearchFoundARoute) {
  if (is_sanitized) GTEST_SKIP() << "too slow with a sanitizer";
  PlanOptions options = continuous(100'000);
  options.cost = driver_style;
  const PlanResult result =
      plan(slot(6.2278, 2.7192, 4.3507, {-9.7987, 1.8275, 0}, {1.8201, -1.2271, 0.0196}), options);
  ASSERT_TRUE(result.path);
  EXPECT_LT(gear_changes(*result.path), 12);
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

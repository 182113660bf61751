// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Is the bound that comes with a path true? Held against paths that are known to be (nearly) the
// best ones: a bound that is 2 % too high is above the cost of some of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "search/geodesic.h"
#include "support/cases.h"
#include "support/draws.h"
#include "support/problems.h"
#include "vandplan/planner.h"
#include "vandplan/reeds_shepp.h"

namespace vandplan {
namespace {

PlanResult run(const Problem& problem, const CostOptions& cost = {}) {
  PlanOptions options;
  options.budget.max_iterations = 20000;
  options.cost = cost;
  PlanResult result = plan(problem, options);
  EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
  return result;
}

/// Proven to be within `gap` of the best, and solved: the judge takes no bound above the cost.
void expect_tight(const PlanResult& result, double gap) {
  EXPECT_LE(result.lower_bound, result.cost);
  EXPECT_GT(result.lower_bound, (1 - gap) * result.cost);
}

TEST(AnytimeBound, IsTheShortestLengthOnOpenGround) {
  for (const Pose& goal : {Pose{20, 30, 2}, {0, 3, 0}, {-9, 1, 3}, {0.5, 0, 1}}) {
    const PlanResult result = run(problem_of({0, 0, 0}, goal, {}));
    EXPECT_NEAR(result.lower_bound, reeds_shepp_length({}, goal, 7.0), 1e-9);
    expect_tight(result, 1e-9);
  }
}

// A long way with a thin wall across: around its end, hardly longer than the way of the axle.
TEST(AnytimeBound, IsCloseBelowALongDetour) {
  const Problem problem =
      problem_of({0, 0, 0}, {180, 0, 0}, {box(89, -20, 91, 1)}, {-20, 200, -40, 40});
  expect_tight(run(problem), 0.01);
}

// A rear overhang below half the width: with its rear to a wall the axle is nearer than any side.
TEST(AnytimeBound, LetsTheAxleAsNearAsAShortRearOverhangDoes) {
  const Vehicle van{.wheelbase = 2,
                    .front_overhang = 0.5,
                    .rear_overhang = 0.05,
                    .width = 4,
                    .min_turning_radius = 2.5};
  const Problem problem =
      problem_of({0.06, 6, 0}, {0.06, -6, 0}, {box(-9, -1.9, 0, 1.9)}, {-20, 20, -20, 20}, van);
  search::Geodesic geodesic(problem.task(), 1e3);
  while (geodesic.step()) {
  }
  EXPECT_NEAR(geodesic.bound(), 12, 1e-9);  // straight past the wall
}

// The rear axle is at the end of the body: the disc that is led around the wall goes before it.
TEST(AnytimeBound, SeesObstaclesWithoutARearOverhang) {
  Vehicle truck;
  truck.rear_overhang = 0.0;
  const Problem problem =
      problem_of({0, 0, 0}, {60, 0, 0}, {box(29, -40, 31, 20)}, {-200, 200, -200, 200}, truck);
  const PlanResult result = run(problem);
  expect_tight(result, 0.1);
  EXPECT_GT(result.lower_bound, 1.1 * 60);
}

// Whichever disc is led around the obstacles: no path that a planner finds is shorter.
TEST(AnytimeBound, IsBelowEveryPathOfVehiclesWithAnyOverhang) {
  for_each_case(41, 150, [](Rng& rng) {
    Vehicle vehicle;
    vehicle.rear_overhang = chance(0.3, rng) ? 0 : uniform(0, 2, rng);
    vehicle.width = uniform(1, 4, rng);
    std::vector<Polygon> boxes;
    for (int i = 0; i < 4; ++i) {
      const double x = uniform(8, 30, rng);
      const double y = uniform(-20, 10, rng);
      boxes.push_back(box(x, y, x + uniform(0.1, 6, rng), y + uniform(1, 25, rng)));
    }
    const Problem problem =
        problem_of({0, 0, uniform(-3, 3, rng)}, {45, uniform(-15, 15, rng), uniform(-3, 3, rng)},
                   boxes, {-60, 100, -60, 60}, vehicle);
    PlanOptions options;
    options.budget.max_iterations = 3000;
    const PlanResult result = plan(problem, options);
    ASSERT_NE(result.status, PlanStatus::rejected) << result.reason;
    if (!result.path) return;
    search::Geodesic geodesic(problem.task(), result.cost * 1.5);
    while (geodesic.step()) {
    }
    ASSERT_LE(geodesic.bound(), result.cost * (1 + 1e-9)) << as_code(boxes);
  });
}

// Forward is free of charge, reverse is not: open ground knows the price of both ways.
TEST(AnytimeBound, IsTheCostOfTheOnlyWayWithPrices) {
  const PlanResult ahead =
      run(problem_of({0, 0, 0}, {40, 0, 0}, {}), {.reverse_weight = 2, .gear_change_cost = 5});
  EXPECT_NEAR(ahead.lower_bound, 40, 1e-9);
  const PlanResult behind = run(problem_of({0, 0, 0}, {-10, 0, 0}, {}), {.reverse_weight = 1.5});
  expect_tight(behind, 0.4);
}

}  // namespace
}  // namespace vandplan

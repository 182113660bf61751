// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Can the wheels follow what is planned?
#include <gtest/gtest.h>

#include <numbers>

#include "../support/cases.h"
#include "../support/continuity.h"
#include "../support/draws.h"
#include "../support/problems.h"
#include "vandplan/planner.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using std::numbers::pi;
constexpr Steering both_kinds[] = {Steering::continuous_between_stops, Steering::continuous};

PlanOptions iterations(std::int64_t count, Steering steering, const CostOptions& cost) {
  PlanOptions options{.cost = cost, .steering = steering};
  options.budget.max_iterations = count;
  return options;
}

/// The default truck, which turns its wheels from straight to full lock on 0.2 to 8 m.
Vehicle any_truck(Rng& rng) {
  Vehicle truck;
  const double radius = truck.min_turning_radius;
  truck.limits.max_curvature_rate = 1 / (radius * any_size(0.2, 8, rng));
  return truck;
}

/// Two poses in a square, with a few boxes on it.
Problem random_problem_on_a_square(Rng& rng) {
  const Bounds square{-25, 25, -25, 25};
  std::vector<Polygon> boxes;
  for (int i = 0; i < 6; ++i) {
    const Pose corner = uniform_pose(square, rng);
    boxes.push_back(
        box(corner.x, corner.y, corner.x + uniform(1, 8, rng), corner.y + uniform(1, 8, rng)));
  }
  return problem_of(uniform_pose(square, rng), uniform_pose(square, rng), boxes, {-60, 60, -60, 60},
                    any_truck(rng));
}

TEST(ContinuousPlanning, EveryPathCanBeFollowed) {
  int solved = 0;
  for_each_case(1, 300, [&](Rng& rng) {
    const Problem problem = random_problem_on_a_square(rng);
    const Steering steering = both_kinds[rng() % 2];
    const CostOptions costs[] = {shortest_style, by_length_and(2, 5), driver_style};
    PlanOptions options = iterations(400, steering, costs[rng() % 3]);
    options.budget.seed = rng();
    const PlanResult result = plan(problem, options);
    ASSERT_NE(result.status, PlanStatus::rejected) << result.reason;
    if (!result.path) return;
    ++solved;
    expect_continuous(*result.path, problem, steering);
    EXPECT_GE(length(*result.path), reeds_shepp_length(problem.start(), problem.goal(),
                                                       problem.vehicle().min_turning_radius) -
                                        1e-6);
  });
  EXPECT_GE(solved, cases(300) / 2);
}

// The path may go on from a bend, and end in one.
TEST(ContinuousPlanning, KeepsTheCurvaturesOfStartAndGoal) {
  for_each_case(2, 100, [](Rng& rng) {
    const Problem drawn = random_problem_on_a_square(rng);
    const double full_lock = 1 / drawn.vehicle().min_turning_radius;
    const EndCurvatures ends{uniform(-full_lock, full_lock, rng),
                             uniform(-full_lock, full_lock, rng)};
    const Problem problem =
        make_problem(drawn.world(), drawn.vehicle(), drawn.start(), drawn.goal(), ends);
    const PlanResult result = plan(problem, iterations(2000, Steering::continuous, shortest_style));
    ASSERT_NE(result.status, PlanStatus::rejected) << result.reason;
    if (result.path) expect_continuous(*result.path, problem, Steering::continuous);
  });
}

// Standing still does not turn the wheels, and a whole loop back to the start may.
TEST(ContinuousPlanning, DrivesRoundToAGoalThatIsTheStartWithOtherCurvature) {
  const Problem open = problem_of({}, {}, {});
  const Problem problem =
      make_problem(open.world(), open.vehicle(), open.start(), open.goal(), {0.05, -0.05});
  const PlanResult result = plan(problem, iterations(100, Steering::continuous, shortest_style));
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_GT(length(*result.path), 1.0);
  expect_continuous(*result.path, problem, Steering::continuous);
}

TEST(ContinuousPlanning, TreesOfTheThesisSteerSo) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, {box(14, -8, 16, 8)});
  for (const Steering steering : both_kinds) {
    for (const char* name : {"rrt-bsc-euc", "rrt-opt-hlut-2", "rrt-bsc-rs-goal"}) {
      PlanOptions options = iterations(600, steering, shortest_style);
      options.planner.set("region", "scene");
      const PlanResult result = plan(problem, planner_named(name), options);
      ASSERT_TRUE(result.path) << name << ": " << result.reason;
      expect_continuous(*result.path, problem, steering);
    }
  }
}

// The way around the box is that of a driver who turns his wheels early: longer than with jumps,
// and by no more than some metres.
TEST(ContinuousPlanning, TheKindsCostMoreTheLessMayJump) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, {box(14, -8, 16, 8)});
  double before = 0.0;
  for (const Steering steering :
       {Steering::reeds_shepp, Steering::continuous_between_stops, Steering::continuous}) {
    const PlanResult result = plan(problem, iterations(6000, steering, shortest_style));
    ASSERT_TRUE(result.path);
    EXPECT_GE(result.cost, 0.999 * before);
    EXPECT_TRUE(before == 0 || result.cost <= 1.1 * before);
    before = result.cost;
  }
}

TEST(ContinuousPlanning, AnyNumberOfThreadsGivesTheSameAnswer) {
  const Problem problem =
      problem_of({0, -2, 0}, {0, 2, pi}, {box(-60, 8, 60, 9), box(-60, -9, 60, -8)});
  for (const Steering steering : both_kinds) {
    PlanOptions options = iterations(4000, steering, by_length_and(2, 5));
    const PlanResult one = plan(problem, options);
    ASSERT_TRUE(one.path);
    options.budget.threads = 3;
    const PlanResult many = plan(problem, options);
    EXPECT_EQ(many.path, one.path);
    EXPECT_EQ(many.iterations, one.iterations);
  }
}

// A kerb-side slot: into it and out of it the vehicle goes by many strokes.
TEST(ContinuousPlanning, FindsTheWayOutOfASlot) {
  const Problem problem = problem_of(
      {0, 0, 0}, {20, 4, 0}, {box(-4.2, -2, -2.2, 2), box(7.7, -2, 9.7, 2), box(-20, -4, 40, -2)});
  for (const Steering steering : both_kinds) {
    const PlanResult result = plan(problem, iterations(40000, steering, shortest_style));
    ASSERT_TRUE(result.path) << static_cast<int>(steering);
    EXPECT_GE(gear_changes(*result.path), 2);
    expect_continuous(*result.path, problem, steering);
  }
}

}  // namespace
}  // namespace vandplan

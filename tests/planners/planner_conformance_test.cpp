// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What every planner in the table owes its caller.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stop_token>

#include "../support/planner_names.h"
#include "../support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

using std::numbers::pi;

class PlannerConformance : public testing::TestWithParam<Planner> {
 protected:
  // No path is ever rejected by the judge.
  static PlanResult run(const Problem& problem, const PlanOptions& options) {
    PlanResult result = plan(problem, GetParam(), options);
    EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
    return result;
  }

  static PlanOptions iterations(std::int64_t count) {
    PlanOptions options;
    options.budget.max_iterations = count;
    if (honours(GetParam(), "region")) options.planner.set("region", "scene");
    return options;
  }
};

// A wall between start and goal, to be driven around.
std::vector<Polygon> easy_wall() { return {box(14, -8, 16, 8)}; }

Problem around_the_wall() { return problem_of({0, 0, 0}, {30, 0, 0}, easy_wall()); }

// The goal lies in a closed room.
Problem walled_in() {
  return problem_of(
      {0, 0, 0}, {60, 0, 0},
      {box(40, -20, 80, -18), box(40, 18, 80, 20), box(40, -20, 42, 20), box(78, -20, 80, 20)});
}

TEST_P(PlannerConformance, SolvesAnEasyProblem) {
  PlanOptions options = iterations(600);
  options.cost = shortest_style;
  const PlanResult result = run(around_the_wall(), options);
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_NEAR(result.cost, length(result.path->segments), 1e-9);
  EXPECT_GT(result.cost, 30.0);
}

TEST_P(PlannerConformance, TheTraceFallsAndEndsAtTheCost) {
  const PlanResult result = run(around_the_wall(), iterations(600));
  ASSERT_FALSE(result.anytime.empty());
  for (std::size_t i = 1; i < result.anytime.size(); ++i) {
    EXPECT_LT(result.anytime[i].cost, result.anytime[i - 1].cost);
    EXPECT_GE(result.anytime[i].iteration, result.anytime[i - 1].iteration);
  }
  EXPECT_NEAR(result.anytime.back().cost, result.cost, 1e-6);
  EXPECT_LE(result.anytime.back().iteration, result.iterations);
}

TEST_P(PlannerConformance, RepeatsBitForBit) {
  const PlanOptions options = iterations(400);
  const PlanResult first = run(around_the_wall(), options);
  const PlanResult second = run(around_the_wall(), options);
  EXPECT_EQ(first.path, second.path);
  EXPECT_EQ(first.iterations, second.iterations);
  EXPECT_EQ(first.counters, second.counters);
  ASSERT_EQ(first.anytime.size(), second.anytime.size());
  for (std::size_t i = 0; i < first.anytime.size(); ++i) {
    EXPECT_EQ(first.anytime[i].cost, second.anytime[i].cost);
    EXPECT_EQ(first.anytime[i].iteration, second.anytime[i].iteration);
  }
}

TEST_P(PlannerConformance, KeepsToTheIterations) {
  for (const std::int64_t count : {0, 1, 7, 100}) {
    const PlanResult result = run(walled_in(), iterations(count));
    EXPECT_FALSE(result.path);
    EXPECT_LE(result.iterations, count);
    if (result.status == PlanStatus::no_path) continue;  // proven before
    EXPECT_EQ(result.status, PlanStatus::iteration_limit);
    EXPECT_EQ(result.iterations, count);
  }
}

TEST_P(PlannerConformance, MoreIterationsAreNeverWorse) {
  double cost = std::numeric_limits<double>::infinity();
  for (const std::int64_t count : {200, 400, 800}) {
    const PlanResult result = run(around_the_wall(), iterations(count));
    if (!result.path) continue;
    EXPECT_LE(result.cost, cost + 1e-9);
    cost = result.cost;
  }
  EXPECT_TRUE(std::isfinite(cost));
}

TEST_P(PlannerConformance, ATimeLimitOfZeroEndsAtOnce) {
  PlanOptions options;
  options.budget.time_limit = 0.0;
  const PlanResult result = run(walled_in(), options);
  EXPECT_EQ(result.status, PlanStatus::time_limit);
  EXPECT_FALSE(result.path);
}

TEST_P(PlannerConformance, StopsWhenTold) {
  std::stop_source stop;
  stop.request_stop();
  PlanOptions options;
  options.budget.stop = stop.get_token();
  const PlanResult result = run(walled_in(), options);
  EXPECT_EQ(result.status, PlanStatus::stopped);
  EXPECT_FALSE(result.path);
}

TEST_P(PlannerConformance, FindsNothingWhereThereIsNothing) {
  const PlanResult result = run(walled_in(), iterations(400));
  EXPECT_NE(result.status, PlanStatus::solved);
  EXPECT_FALSE(result.path);
  EXPECT_TRUE(result.anytime.empty());
}

TEST_P(PlannerConformance, StartEqualsGoal) {
  const PlanResult result = run(problem_of({3, 4, 1}, {3, 4, 1}, easy_wall()), iterations(10));
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_TRUE(result.path->segments.empty());
  EXPECT_EQ(result.cost, 0.0);
}

TEST_P(PlannerConformance, NamesABlockedStart) {
  const Problem problem = problem_of({15, 0, 0}, {40, 0, 0}, easy_wall());
  EXPECT_EQ(run(problem, iterations(10)).status, PlanStatus::start_in_collision);
}

TEST_P(PlannerConformance, NamesABlockedGoal) {
  const Problem problem = problem_of({0, 0, 0}, {15, 0, 0}, easy_wall());
  EXPECT_EQ(run(problem, iterations(10)).status, PlanStatus::goal_in_collision);
}

TEST_P(PlannerConformance, NamesAGoalOutOfBounds) {
  const Problem problem = problem_of({0, 0, 0}, {300, 0, 0}, easy_wall());
  EXPECT_EQ(run(problem, iterations(10)).status, PlanStatus::goal_in_collision);
}

// The same scene seen from elsewhere: `move` is applied to every point and pose.
template <typename Move>
Problem moved(Move move) {
  std::vector<Polygon> obstacles = easy_wall();
  for (Polygon& polygon : obstacles) {
    for (Point& p : polygon) {
      const Pose q = move(Pose{p.x, p.y, 0});
      p = {q.x, q.y};
    }
  }
  return problem_of(move(Pose{0, 0, 0}), move(Pose{30, 0, 0}), obstacles);
}

TEST_P(PlannerConformance, SolvesTheSceneTurnedAndMoved) {
  for (const double turn : {0.3, pi / 2, 2.0, -3.0}) {
    const Problem problem = moved([&](const Pose& p) { return compose({20, -30, turn}, p); });
    EXPECT_EQ(run(problem, iterations(600)).status, PlanStatus::solved) << "turned by " << turn;
  }
}

TEST_P(PlannerConformance, SolvesTheSceneMirrored) {
  const Problem problem = moved([](const Pose& p) { return Pose{-p.x, p.y, pi - p.heading}; });
  EXPECT_EQ(run(problem, iterations(600)).status, PlanStatus::solved);
}

INSTANTIATE_TEST_SUITE_P(All, PlannerConformance,
                         testing::ValuesIn(planners().begin(), planners().end()), name_of_test);

}  // namespace
}  // namespace vandplan

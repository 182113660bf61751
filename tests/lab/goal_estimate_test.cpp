// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What do estimates know, and are those that say so never above the length of a path?
#include "vandplan/graphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../support/cases.h"
#include "../support/problems.h"
#include "search/geodesic.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using search::GoalEstimate;
using search::make_goal_estimate;

using std::numbers::pi;

std::vector<Polygon> wall() { return {box(14, -8, 16, 8)}; }

/// The goal lies in a room without a door.
Problem walled_in() {
  return problem_of(
      {0, 0, 0}, {60, 0, 0},
      {box(40, -20, 80, -18), box(40, 18, 80, 20), box(40, -20, 42, 20), box(78, -20, 80, 20)});
}

/// One call does not do all of the work.
double settled(const GoalEstimate& estimate, const Pose& pose) {
  for (int i = 0; i < 100; ++i) (void)estimate.length(Local(pose));
  return estimate.length(Local(pose));
}

double at_start(std::string_view name, const Problem& problem) {
  return settled(make_goal_estimate(name, problem.task()), problem.task().start);
}

/// How far two lengths are apart; two that are infinite are equal.
double apart(double a, double b) { return a == b ? 0.0 : std::abs(a - b); }

TEST(GoalEstimate, OfFieldsIsTheDistanceOnOpenGround) {
  const Problem problem = problem_of({0, 0, 0}, {30, 40, 0}, {});
  EXPECT_DOUBLE_EQ(at_start("any-angle", problem), 50.0);
  EXPECT_GT(at_start("grid", problem), 52.0);
  EXPECT_LE(at_start("grid", problem), 50.0 * 1.0824);
  const double length = reeds_shepp_length(problem.start(), problem.goal(), 7.0);
  EXPECT_EQ(at_start("choi", problem), length);
}

// Around the corners (14, 8) and (16, 8), a disc of half the width away from them.
TEST(GoalEstimate, OfFieldsGoesAroundAWall) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, wall());
  search::Geodesic geodesic(problem.task(), 1000.0);
  while (geodesic.step()) {
  }
  const double way = geodesic.bound();
  ASSERT_GT(way, 33.0);
  EXPECT_LE(at_start("any-angle", problem), way * 1.001);
  EXPECT_GT(at_start("any-angle", problem), way / 1.0275 * 0.99);
  EXPECT_GT(at_start("grid", problem), way * 0.98);
  EXPECT_LT(at_start("grid", problem), way * 1.0824);
  EXPECT_GT(at_start("choi", problem), way / 1.0275 * 0.99);
}

// 2 m between two walls are too narrow for the truck, 3 m are not.
TEST(GoalEstimate, OfFieldsKnowsWhichGapsAreTooNarrow) {
  for (const char* const name : {"grid", "any-angle", "choi"}) {
    const auto through = [&](double gap) {
      return at_start(name, problem_of({0, 0, 0}, {30, 0, 0},
                                       {box(14, -40, 16, -gap / 2), box(14, gap / 2, 16, 40)}));
    };
    EXPECT_GT(through(2.0), 60.0) << name;
    EXPECT_LT(through(3.0), 33.0) << name;
  }
}

TEST(GoalEstimate, OfFieldsIsInfiniteWhereTheGoalIsCutOff) {
  const Problem problem = walled_in();
  for (const char* const name : {"grid", "any-angle", "choi"}) {
    const GoalEstimate estimate = make_goal_estimate(name, problem.task());
    EXPECT_FALSE(std::isfinite(settled(estimate, {0, 0, 0}))) << name;
    EXPECT_TRUE(std::isfinite(estimate.length(LocalPose({50, 3, 1})))) << name;
  }
}

// Beside the border of what the goal sees one still has to turn: a grid does not know that.
TEST(GoalEstimate, OfChoiKnowsTheHeadingOfTheGoal) {
  const Problem problem = problem_of({0, -20, 0}, {20, 0, pi / 2}, {box(10, -60, 11, 5)});
  EXPECT_GT(at_start("choi", problem), at_start("any-angle", problem) + 0.5);
}

TEST(GoalEstimate, NamesWhatIsUnknown) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, {});
  EXPECT_THROW((void)make_goal_estimate("guess", problem.task()), InputError);
  EXPECT_THROW((void)make_goal_estimate("table", problem.task()), InputError);
  EXPECT_THROW((void)make_goal_estimate("site", problem.task()), InputError);
  const HeuristicTable table = thesis_table(2);
  const GoalEstimate estimate = make_goal_estimate("table", problem.task(), &table);
  EXPECT_EQ(estimate.name, "table");
  EXPECT_FALSE(estimate.is_admissible);
  EXPECT_EQ(estimate.length(LocalPose({12, 3, 1})),
            table.distance({12, 3, 1}, problem.goal(), 7.0));
}

TEST(GoalEstimate, OfTwoIsTheLargerOne) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, wall());
  const GoalEstimate both = search::max_of(make_goal_estimate("any-angle", problem.task()),
                                           make_goal_estimate("reeds-shepp", problem.task()));
  EXPECT_TRUE(both.is_admissible);
  EXPECT_EQ(both.name, "max-any-angle-reeds-shepp");
  for (const auto& pose : {LocalPose({0, 0, 0}), LocalPose({28, 1, 2})}) {
    EXPECT_EQ(both.length(pose),
              std::max(make_goal_estimate("any-angle", problem.task()).length(pose),
                       make_goal_estimate("reeds-shepp", problem.task()).length(pose)));
  }
}

// ---- Laws ----

Scenario random_scenario(Rng& rng) {
  Scenario scenario;
  scenario.bounds = {-40, 40, -40, 40};
  const int count = static_cast<int>(uniform(1, 14, rng));
  for (int i = 0; i < count; ++i) {
    const double x = uniform(-36, 36, rng);
    const double y = uniform(-36, 36, rng);
    scenario.obstacles.push_back(
        box(x, y, x + uniform(0.2, 25, rng), y + uniform(0.2, i % 2 == 0 ? 2 : 25, rng)));
  }
  if (uniform01(rng) < 0.3) scenario.vehicle.rear_overhang = 0.0;  // a disc ahead of the axle
  if (uniform01(rng) < 0.5) scenario.vehicle.min_turning_radius = 3.0;
  scenario.start = uniform_pose(scenario.bounds, rng);
  scenario.goal = uniform_pose(scenario.bounds, rng);
  return scenario;
}

// Every pose on a path is no further from the goal than what is left of the path.
TEST(GoalEstimateLaw, AdmissibleOnesAreNeverAboveAPath) {
  int poses = 0;
  for_each_case(3, 400, [&](Rng& rng) {
    const Problem problem = make_problem(random_scenario(rng));
    PlanOptions options{.cost = shortest_style};
    options.budget.max_iterations = 60;
    const PlanResult result = plan(problem, options);
    if (!result.path) return;
    const double length = result.cost;
    for (const std::string_view name : search::goal_estimate_names()) {
      if (name == search::user_table || name == search::site_estimate) continue;
      const GoalEstimate estimate = make_goal_estimate(name, problem.task());
      if (!estimate.is_admissible) continue;
      for (const PathPoint& sample : sampled(*result.path, length / 50)) {
        const LocalPose local = to_local(*problem.world(), sample.pose);
        ASSERT_LE(estimate.length(local), (length - sample.s) * (1 + 1e-9) + 1e-4)
            << name << " at " << as_code(local);
        ++poses;
      }
    }
  });
  EXPECT_GE(poses, cases(10'000));
}

// In whole metres nothing is rounded.
TEST(GoalEstimateLaw, IsTheSameInAMovedScenario) {
  for_each_case(4, 40, [](Rng& rng) {
    Scenario scenario = random_scenario(rng);
    scenario.start = {};
    const Problem here = make_problem(scenario);
    const Problem there = make_problem(moved_by(scenario, 3000, -70));
    const LocalPose pose(uniform_pose(scenario.bounds, rng));
    for (const std::string_view name : search::goal_estimate_names()) {
      if (name == search::user_table || name == search::site_estimate) continue;
      EXPECT_LT(apart(make_goal_estimate(name, here.task()).length(pose),
                      make_goal_estimate(name, there.task()).length(pose)),
                1e-9)
          << name;
    }
  });
}

Pose mirrored(const Pose& pose) { return {pose.x, -pose.y, -pose.heading}; }

// The goal is a corner of the lattice, whichever way one looks at it.
TEST(GoalEstimateLaw, IsTheSameInAMirror) {
  for_each_case(5, 40, [](Rng& rng) {
    Scenario scenario = random_scenario(rng);
    scenario.start = {};
    const Pose pose = uniform_pose(scenario.bounds, rng);
    const Problem here = make_problem(scenario);
    scenario.goal = mirrored(scenario.goal);
    for (Polygon& polygon : scenario.obstacles) {
      for (Point& corner : polygon) corner.y = -corner.y;
    }
    const Problem there = make_problem(scenario);
    for (const char* const name : {"euclid", "bound", "reeds-shepp", "grid", "any-angle"}) {
      EXPECT_LT(apart(settled(make_goal_estimate(name, here.task()), pose),
                      settled(make_goal_estimate(name, there.task()), mirrored(pose))),
                1e-4)
          << name;
    }
  });
}

}  // namespace
}  // namespace vandplan

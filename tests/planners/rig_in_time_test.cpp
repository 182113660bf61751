// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Rigs among what moves: where the trailer stands is never forgotten.
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/motion.h"
#include "vandplan/path.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

/// A car of 4 m by 2 m.
const Polygon other_car = box(-2, -1, 2, 1);

PlanOptions few_rig_iterations() {
  PlanOptions options;
  options.budget.max_iterations = 1500;
  return options;
}

/// A rig on open ground, its trailer at these angles at the start and at the goal.
Problem rig_among(const Pose& goal, const EndHitchAngles& angles,
                  const std::vector<MovingObstacle>& moving) {
  return with_moving(
      make_problem(world_of({.bounds = wide_bounds}), semitrailer(), {0, 0, 0}, goal, {}, angles),
      moving);
}

TEST(RigInTime, KnowsWhereATrailerStandsAtBothEnds) {
  // Where the trailer is if it stands a radian to the left of its tractor.
  const MovingObstacle at_start{.outline = box(-0.2, -0.2, 0.2, 0.2),
                                .trajectory = {{0, {-4, 6, 0}}}};
  MovingObstacle at_goal = at_start;
  at_goal.trajectory[0].pose.x += 60;
  EXPECT_EQ(plan(rig_among({60, 0, 0}, {1, 0}, {at_start}), few_rig_iterations()).reason,
            "moving[0] is where the start is, or nearer to it than the margin");
  EXPECT_EQ(plan(rig_among({60, 0, 0}, {0, 1}, {at_goal}), few_rig_iterations()).reason,
            "moving[0] stays where the goal is, or nearer to it than the margin");
  EXPECT_EQ(plan(rig_among({60, 0, 0}, {0, 0}, {at_start, at_goal}), few_rig_iterations()).status,
            PlanStatus::solved);
}

TEST(RigInTime, ATrailerThatStandsOtherwiseIsNotAtTheGoal) {
  const MovingObstacle far{.outline = other_car, .trajectory = {{0, {100, 100, 0}}}};
  const PlanResult result = plan(rig_among({0, 0, 0}, {0, 0.3}, {far}), few_rig_iterations());
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_GT(length(result.path->segments), 0);
}

TEST(RigInTimeLaw, DrivesOfRigsAreGoodInTheEyesOfTheJudge) {
  int solved = 0, waits = 0;
  for_each_case(3, 60, [&](Rng& rng) {
    const Pose goal{uniform(15, 45, rng), uniform(-15, 15, rng), uniform(-1, 1, rng)};
    std::vector<MovingObstacle> moving;
    for (int k = 0; k < 3; ++k) {
      MovingObstacle& mover = moving.emplace_back(MovingObstacle{.outline = other_car});
      mover.trajectory = {{0, {uniform(-10, 40, rng), uniform(-30, 30, rng), 0}},
                          {uniform(5, 30, rng), {uniform(-10, 40, rng), uniform(-30, 30, rng), 2}}};
      if (rng() % 2 == 0) mover.after = Afterwards::leaves;
    }
    const EndHitchAngles angles{uniform(-1, 1, rng), uniform(-0.5, 0.5, rng)};
    PlanOptions options = few_rig_iterations();
    options.budget.max_iterations = 600;
    const PlanResult result = plan(rig_among(goal, angles, moving), options);
    EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
    if (!result.path) return;
    ++solved;
    waits += result.speeds->duration > speed_profile(*result.path, semitrailer()).duration + 1e-6;
  });
  if (!is_sanitized) {
    EXPECT_GT(solved, cases(60) / 2);
    EXPECT_GT(waits, cases(60) / 20);
  }
}

TEST(RigInTime, WaitsInALayByUntilWhoComesTowardsItIsPast) {
  Vehicle rig{3.6, 1.4, 0.9, 2.55, 5.9};
  rig.hitch = -0.2;
  rig.trailer = Trailer{5.0, 1.0, 2.0, 2.55};
  const Problem alone = problem_of(
      {0, 0, 0}, {90, 0, 0},
      {box(-60, -3, 150, -2.5), box(-60, 2.5, 10, 3), box(65, 2.5, 150, 3), box(10, 7.5, 65, 8)},
      {-60, 150, -9, 9}, rig);
  const MovingObstacle oncoming{
      .outline = box(-2, -1, 2, 1),
      .trajectory = {{0, {110, 0, std::numbers::pi}}, {130, {-58, 0, std::numbers::pi}}},
      .after = Afterwards::leaves};
  PlanOptions options;
  options.budget.max_iterations = 12'000;
  const PlanResult result = plan(with_moving(alone, std::vector{oncoming}), options);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(result.drive_check->valid);
  EXPECT_LT(result.speeds->duration, 110);
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Arrival, new goals and limits of time: what a caller and a replanner tell each other.
#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>
#include <vector>

#include "support/numbers.h"
#include "support/place_of_error.h"
#include "support/problems.h"
#include "support/replans.h"

namespace vandplan {
namespace {

TEST(Replanner, SaysThatItHasArrived) {
  const Scenario scenario = lane();
  Replanner replanner(scenario);
  const double end = replanner.tick(0).drive->speeds.duration;
  EXPECT_FALSE(replanner.tick(end - 0.1).has_arrived);
  EXPECT_TRUE(replanner.tick(end).has_arrived);
  EXPECT_FALSE(replanner.tick(end, {.pose = scenario.goal, .v = 0.1}).has_arrived);
  EXPECT_TRUE(replanner.tick(end + 1, {.pose = scenario.goal}).has_arrived);
  EXPECT_TRUE(replanner.answer().has_arrived);
}

TEST(Replanner, HasNotArrivedWhereItStopsOnItsWay) {
  Replanner replanner(lane());
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  replanner.patch({.added = {{7, box(30, -28, 31, 28)}}});  // from wall to wall
  const ReplanAnswer stop = replanner.tick(6);
  ASSERT_EQ(stop.outcome, TickOutcome::stop);
  EXPECT_FALSE(replanner.tick(6 + stop.drive->speeds.duration).has_arrived);
}

TEST(Replanner, DrivesOnUntilItKnowsTheWayToANewGoal) {
  Scenario scenario = lane();
  Replanner replanner(scenario);
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  const ReplanAnswer before = replanner.answer();
  scenario.goal = {55, 12, 0};
  replanner.set_goal(scenario.goal);
  EXPECT_EQ(replanner.answer().drive, before.drive);
  ReplanAnswer answer = replanner.tick(6);
  double t = 6;
  for (; !answer.reaches_goal && t < 10; answer = replanner.tick(t += tick_period)) {
    EXPECT_EQ(answer.outcome, TickOutcome::kept);
    EXPECT_EQ(answer.drive, before.drive);
    EXPECT_TRUE(answer.is_safe);
    EXPECT_EQ(answer.reason, "no drive to the goal was found");
  }
  EXPECT_TRUE(answer.reaches_goal);
  EXPECT_EQ(answer.outcome, TickOutcome::new_way);
  EXPECT_EQ(fault_of(answer, scenario, t), "");
  EXPECT_NEAR(end_pose(answer.drive->path).y, 12, 1e-6);
  EXPECT_NEAR(pose_at(answer, scenario.vehicle, t + 0.9).x,
              pose_at(before, scenario.vehicle, t + 0.9).x, 1e-6);
}

/// Limits of a tick that has no time left.
std::vector<TickLimit> no_time() {
  std::stop_source source;
  source.request_stop();
  return {{.time_limit = 0.0}, {.stop = source.get_token()}};
}

TEST(Replanner, StopsSafelyIfThereIsNoTimeToLookForAWay) {
  for (const TickLimit& limit : no_time()) {
    Scenario scenario = lane();
    Replanner replanner(scenario);
    for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
    scenario.obstacles.push_back(box(30, -4, 33, 4));
    replanner.patch({.added = {{7, scenario.obstacles.back()}}});
    const ReplanAnswer answer = replanner.tick(6, limit);
    EXPECT_EQ(answer.outcome, TickOutcome::stop);
    EXPECT_TRUE(answer.is_safe) << answer.reason;
    EXPECT_EQ(fault_of(answer, scenario, 6), "");
    EXPECT_EQ(replanner.tick(6.1).outcome, TickOutcome::new_way);
  }
}

TEST(Replanner, KeepsItsDriveAndFindsNoFirstOneWithoutTime) {
  for (const TickLimit& limit : no_time()) {
    Replanner replanner(lane());
    const ReplanAnswer first = replanner.tick(0, limit);
    EXPECT_EQ(first.outcome, TickOutcome::stop);
    EXPECT_TRUE(first.is_safe);
    const ReplanAnswer second = replanner.tick(0.1, {.time_limit = 1000.0});
    EXPECT_EQ(second.outcome, TickOutcome::new_way);
    replanner.patch({.removed = {0}});
    const ReplanAnswer third = replanner.tick(0.2, VehicleState{}, limit);
    EXPECT_EQ(third.outcome, TickOutcome::kept);
    EXPECT_EQ(third.drive, second.drive);
  }
}

TEST(Replanner, SearchesAllTheSameWithATokenThatNobodyUses) {
  const auto driven = [](const TickLimit& limit) {
    Replanner replanner(lane());
    std::vector<Pose> poses;
    for (double t = 0; t < 8; t += tick_period) {
      if (std::abs(t - 4) < 1e-9) replanner.patch({.added = {{7, box(30, -4, 33, 4)}}});
      poses.push_back(pose_at(replanner.tick(t, limit), lane().vehicle, t + 5));
    }
    return poses;
  };
  const std::stop_source source;
  EXPECT_EQ(driven({}), driven({.stop = source.get_token()}));
}

TEST(Replanner, DrivesOnIfItsNewGoalCannotBeReached) {
  Replanner replanner(lane());
  const ReplanAnswer before = replanner.tick(0);
  replanner.set_goal({40, 25.5, 0});  // in a wall
  for (double t = 1; t < 2; t += tick_period) {
    const ReplanAnswer answer = replanner.tick(t);
    EXPECT_EQ(answer.outcome, TickOutcome::kept);
    EXPECT_EQ(answer.drive, before.drive);
    EXPECT_FALSE(answer.reaches_goal);
    EXPECT_TRUE(answer.is_safe);
    EXPECT_EQ(answer.reason.find("the goal cannot be reached: the footprint hits "), 0U)
        << answer.reason;
  }
  replanner.set_goal(lane().goal);
  EXPECT_TRUE(replanner.tick(2).reaches_goal);
  EXPECT_EQ(replanner.answer().drive, before.drive);
}

TEST(Replanner, DrivesFromOneGoalToTheNext) {
  Scenario scenario = lane();
  scenario.obstacles.push_back(box(30, 3, 33, 24));
  Replanner replanner(scenario);
  const double end = replanner.tick(0).drive->speeds.duration;
  ASSERT_TRUE(replanner.tick(end).has_arrived);
  scenario.goal = {0, 12, 0.5};
  replanner.set_goal(scenario.goal);
  const ReplanAnswer answer = replanner.tick(end + 1);
  EXPECT_TRUE(answer.reaches_goal);
  EXPECT_FALSE(answer.has_arrived);
  EXPECT_EQ(fault_of(answer, scenario, end + 1), "");
  EXPECT_TRUE(replanner.tick(end + 1 + answer.drive->speeds.duration).has_arrived);
}

TEST(Replanner, KeepsItsDriveIfThatEndsInTheNewSet) {
  const Scenario scenario = lane();
  Replanner replanner(scenario);
  const ReplanAnswer before = replanner.tick(0);
  replanner.set_goal({{.x = {58, 62}, .y = {-1, 1}, .heading = {-0.1, 0.1}}});
  const ReplanAnswer answer = replanner.tick(before.drive->speeds.duration - 1);
  EXPECT_TRUE(answer.reaches_goal);
  EXPECT_EQ(answer.drive, before.drive);
}

TEST(Replanner, RefusesAGoalThatIsNone) {
  Replanner replanner(lane());
  const ReplanAnswer before = replanner.tick(0);
  EXPECT_EQ(place_of_error([&] { replanner.set_goal(Pose{nan, 0, 0}); }), "goal.x");
  EXPECT_EQ(place_of_error([&] { replanner.set_goal(std::vector<GoalRegion>{}); }), "goal.any_of");
  const ReplanAnswer after = replanner.tick(0.1);
  EXPECT_EQ(after.drive, before.drive);
  EXPECT_TRUE(after.reaches_goal);
}

TEST(Replanner, StopsWhereItIsIfThatIsNotOnTheWay) {
  ReplanOptions options;
  options.tick_iterations = 0;  // no way on is found
  Replanner replanner(lane(), options);
  (void)replanner.tick(0);
  const VehicleState aside{.pose = {0, 1, 0}};
  const ReplanAnswer answer = replanner.tick(0, aside);
  EXPECT_EQ(answer.outcome, TickOutcome::stop);
  EXPECT_TRUE(answer.is_safe);
  EXPECT_EQ(answer.drive->path.start, aside.pose);
}

TEST(Replanner, AnAnswerStaysAsItWas) {
  Replanner replanner(lane());
  const ReplanAnswer first = replanner.tick(0);
  replanner.patch({.added = {{7, box(30, -4, 33, 4)}}});
  const ReplanAnswer second = replanner.tick(1);
  EXPECT_EQ(first.begin, 0.0);
  EXPECT_EQ(second.begin, 1.0);
  EXPECT_NE(first.drive, second.drive);
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/replanner.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "replanning/timed_path.h"
#include "speed/moving_start.h"
#include "support/problems.h"
#include "support/replans.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/search.h"

namespace vandplan {
namespace {

using replanning::CutDrive;

MovingObstacle car(std::vector<TimedPose> trajectory, Afterwards after = Afterwards::leaves) {
  return {box(-1, -0.95, 3.5, 0.95), std::move(trajectory), after};
}

TEST(TimedPath, IsTheSameCutAndJoinedAgain) {
  const Vehicle vehicle = lane().vehicle;
  const Path path{{0, 0, 0}, {{0, 6}, {1.0 / 7, 5}, {0, -4}, {-1.0 / 7, 3}}};
  const TimedPath whole{path, speed_profile(path, vehicle)};
  for (double t = 0; t <= whole.speeds.duration; t += 0.13) {
    const TimedPath first = replanning::before(whole, vehicle, t);
    const CutDrive then = replanning::rest_of(whole, vehicle, t);
    EXPECT_NEAR(then.drive.speeds.duration, whole.speeds.duration - t, 1e-9);
    const TimedPath both = replanning::joined(first, then.drive);
    for (double at = 0; at <= whole.speeds.duration; at += 0.31) {
      const Motion a = motion_at(path, vehicle, whole.speeds, at);
      const Motion b = motion_at(both.path, vehicle, both.speeds, at);
      ASSERT_NEAR(a.pose.x, b.pose.x, 1e-6) << "cut at " << t << ", looked at " << at;
      ASSERT_NEAR(a.pose.y, b.pose.y, 1e-6) << "cut at " << t << ", looked at " << at;
      ASSERT_NEAR(a.v, b.v, 1e-5) << "cut at " << t << ", looked at " << at;
      ASSERT_NEAR(a.steering_angle, b.steering_angle, 1e-6) << "cut " << t << ", at " << at;
    }
  }
}

TEST(MovingStart, IsDrivenOnFromItsSpeed) {
  const Vehicle vehicle = lane().vehicle;  // brakes with 1 m/s^2
  const Path path{{0, 0, 0}, {{0, 10}}};
  const auto profile = speed::profile_from(path, vehicle, {.speed = 2.0});
  ASSERT_TRUE(profile);
  EXPECT_DOUBLE_EQ(profile->knots.front().v, 2.0);
  // From 2 m/s to 2.5 m/s, on, and down to 0: 0.5 s + 5.75 m at 2.5 m/s + 2.5 s.
  EXPECT_NEAR(profile->duration, 0.5 + 5.75 / 2.5 + 2.5, 1e-9);
}

TEST(MovingStart, IsNoneForWhoComesTooFast) {
  const Vehicle vehicle = lane().vehicle;
  EXPECT_TRUE(speed::profile_from({{}, {{0, 2.01}}}, vehicle, {.speed = 2.0}));
  EXPECT_FALSE(speed::profile_from({{}, {{0, 1.99}}}, vehicle, {.speed = 2.0}));
  EXPECT_FALSE(speed::profile_from({{}, {{0, 1.99}, {0, -5}}}, vehicle, {.speed = 2.0}));
  EXPECT_FALSE(speed::profile_from({{}, {{0.1, 9}}}, vehicle, {.speed = 2.0}));  // wheels jump
}

TEST(MovingStart, IsJudged) {
  Scenario scenario = lane();
  scenario.goal = {10, 0, 0};
  const Problem problem = make_problem(scenario);
  const Path path{{0, 0, 0}, {{0, 10}}};
  const auto profile = speed::profile_from(path, scenario.vehicle, {.speed = 2.0});
  EXPECT_EQ(check_drive(problem, {path, *profile}, {.start_speed = 2.0}).reason, "");
  EXPECT_EQ(check_drive(problem, {path, *profile}, {.start_speed = 1.0}).reason,
            "the drive begins at 2 m/s, the vehicle comes at 1 m/s");
  EXPECT_EQ(check_drive(problem, {path, *profile}).reason,
            "the vehicle does not stand at both ends of the drive");
}

TEST(Replanner, KeepsItsMindInAWorldThatStays) {
  const Scenario scenario = lane();
  Replanner replanner(scenario);
  const double end = replanner.tick(0).drive->speeds.duration;
  for (double t = tick_period; t < end; t += tick_period) {
    EXPECT_EQ(replanner.tick(t).outcome, TickOutcome::kept) << t;
  }
  const Pose last = pose_at(replanner.answer(), scenario.vehicle, end);
  EXPECT_NEAR(last.x, 60, 1e-5);
}

TEST(Replanner, GoesRoundWhatComesUpAndKeepsTheNextSecond) {
  Scenario scenario = lane();
  Replanner replanner(scenario);
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  const ReplanAnswer before = replanner.answer();
  scenario.obstacles.push_back(box(30, -4, 33, 4));
  replanner.patch({.added = {{7, scenario.obstacles.back()}}});
  const ReplanAnswer after = replanner.tick(6);
  EXPECT_EQ(after.outcome, TickOutcome::new_way);
  EXPECT_TRUE(after.reaches_goal);
  EXPECT_TRUE(after.is_safe);
  EXPECT_EQ(fault_of(after, scenario, 6), "");
  for (double t = 6; t <= 7; t += tick_period) {
    EXPECT_NEAR(pose_at(after, scenario.vehicle, t).x, pose_at(before, scenario.vehicle, t).x,
                1e-6);
  }
}

TEST(Replanner, PassesViasOnceWhateverComesUp) {
  Scenario scenario = lane();
  GoalRegion gate{.x = {14, 16}, .y = {2, 6}, .heading = any_heading};
  GoalRegion stop = region_of_pose({48, -4, 0});
  stop.heading = any_heading;
  scenario.via = {{{gate}}, {{stop}, true}};
  Replanner replanner(scenario);
  ASSERT_TRUE(replanner.tick(0).reaches_goal);
  double at_gate = 0, at_stop = 0;
  bool has_new_way = false;
  for (double t = 0; t < 80 && !replanner.answer().has_arrived; t += tick_period) {
    if (std::abs(t - 6) < tick_period / 2) {
      replanner.patch({.added = {{7, box(30, -4, 33, 4)}}});
    }
    const ReplanAnswer answer = replanner.tick(t);
    has_new_way = has_new_way || (t > 5 && answer.outcome == TickOutcome::new_way);
    EXPECT_TRUE(answer.reaches_goal) << t << ": " << answer.reason;
    const Motion motion =
        motion_at(answer.drive->path, scenario.vehicle, answer.drive->speeds, t - answer.begin);
    const Pose& pose = motion.pose;
    if (at_gate == 0 && std::abs(pose.x - 15) < 1.3 && pose.y > 1.7) at_gate = t;
    const bool stands = std::abs(motion.v) < 0.2;
    if (stands && std::hypot(pose.x - 48, pose.y + 4) < 0.1) at_stop = t;
  }
  EXPECT_TRUE(has_new_way);
  EXPECT_GT(at_gate, 0);
  EXPECT_GT(at_stop, at_gate);
  EXPECT_TRUE(replanner.answer().has_arrived);
}

/// What a drive costs by its prices and its seconds, but for being near things.
double cost_of(const TimedPath& drive) {
  const search::CostRule prices = search::cost_rule({});
  search::Driven driven = prices.initial_gear;
  return search::drive_cost(prices, drive.path.segments, driven) + 2 * drive.speeds.duration;
}

TEST(Replanner, FirstPlanCountsTheSecondsOfTheWholeDrive) {
  Scenario scenario = lane();
  scenario.obstacles.push_back(box(18, -20, 19, 3));
  scenario.obstacles.push_back(box(34, -3, 35, 20));
  PlanOptions options;
  options.budget.max_iterations = 4000;
  const Problem problem = make_problem(scenario);
  const PlanResult by_prices = plan(problem, options);
  ASSERT_EQ(by_prices.status, PlanStatus::solved) << by_prices.reason;
  const Path& path = *by_prices.path;
  ReplanOptions replan{.plan = options};
  replan.reserve = 0.01;
  Replanner replanner(scenario, replan);
  const ReplanAnswer first = replanner.tick(0);
  ASSERT_TRUE(first.reaches_goal);
  EXPECT_LT(cost_of(*first.drive), 0.97 * cost_of({path, speed_profile(path, problem.vehicle())}));
}

// Without looks on the way, only the first plan can find one.
TEST(Replanner, TriesTheFirstPlanAgainWithMoreIterations) {
  Scenario scenario = lane();
  scenario.obstacles.push_back(box(18, -20, 19, 3));
  scenario.obstacles.push_back(box(34, -3, 35, 20));
  ReplanOptions options;
  options.plan.budget.max_iterations = 10;
  options.tick_iterations = 0;
  Replanner replanner(scenario, options);
  unsigned tick = 1;
  for (; tick < 100 && !replanner.tick(tick).reaches_goal; ++tick) {
    EXPECT_TRUE(replanner.answer().is_safe);
  }
  EXPECT_GT(tick, 1U);
  EXPECT_LT(tick, 100U);
  EXPECT_TRUE(std::has_single_bit(tick)) << tick;
}

TEST(Replanner, TakesABetterWayAfterTheNextSecond) {
  Scenario scenario = lane();
  scenario.obstacles.push_back(box(30, -20, 33, 24));  // a long way round
  Replanner replanner(scenario);
  for (double t = 0; t < 3; t += tick_period) (void)replanner.tick(t);
  replanner.patch({.removed = {2}});
  scenario.obstacles.pop_back();
  ReplanAnswer before = replanner.answer();
  double t = 3;
  while (replanner.tick(t).outcome != TickOutcome::new_way && t < 6) {
    before = replanner.answer();
    t += tick_period;
  }
  const ReplanAnswer after = replanner.answer();
  ASSERT_EQ(after.outcome, TickOutcome::new_way);
  EXPECT_EQ(fault_of(after, scenario, t), "");
  const auto costs = [&](const ReplanAnswer& answer) {
    return cost_of(rest(answer, scenario.vehicle, t).drive);
  };
  EXPECT_LT(costs(after), 0.9 * costs(before));
  for (double later = t; later <= t + 1; later += tick_period) {
    EXPECT_NEAR(pose_at(after, scenario.vehicle, later).y,
                pose_at(before, scenario.vehicle, later).y, 1e-6);
    EXPECT_NEAR(pose_at(after, scenario.vehicle, later).x,
                pose_at(before, scenario.vehicle, later).x, 1e-6);
  }
}

TEST(Replanner, StaysOnItsWayWhereOtherTimesDo) {
  Scenario scenario = lane();
  scenario.obstacles.push_back(box(30, -20, 33, 24));  // a long way round
  Replanner replanner(scenario);
  for (double t = 0; t < 3; t += tick_period) (void)replanner.tick(t);
  // The straight way is free from now on, and somebody stands in the old one for a while.
  const Pose there = pose_at(replanner.answer(), scenario.vehicle, 15);
  replanner.patch({.removed = {2}});
  replanner.set_moving(std::vector{car({{0, there}, {14, there}})});
  EXPECT_EQ(replanner.tick(3).outcome, TickOutcome::new_times);
  bool has_new_way = false;
  for (double t = 3.1; t < 4; t += tick_period) {
    has_new_way |= replanner.tick(t).outcome == TickOutcome::new_way;
  }
  EXPECT_TRUE(has_new_way);
}

TEST(Replanner, LooksForTheGoalAgainWhenWhoIsTooNearHasGone) {
  Scenario scenario = lane();
  ReplanOptions options;
  options.plan.clearance.margin = 0.3;
  Replanner replanner(scenario, options);
  (void)replanner.tick(0);
  // 0.2 m beside the vehicle, which stands: no drive keeps the margin.
  const double side = scenario.vehicle.width / 2 + 0.2 + 0.95;
  replanner.set_moving(std::vector{car({{0, {0, side, 0}}}, Afterwards::stays)});
  EXPECT_FALSE(replanner.tick(0.1).reaches_goal);
  replanner.set_moving({});
  EXPECT_TRUE(replanner.tick(0.2).reaches_goal);
}

TEST(Replanner, PlansFromTheSpeedThatIsMeasured) {
  const Scenario scenario = lane();
  Replanner replanner(scenario);
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  const Pose here = pose_at(replanner.answer(), scenario.vehicle, 6);
  const ReplanAnswer answer = replanner.tick(6, {.pose = here, .v = 1.0});  // not 2.5 m/s
  EXPECT_EQ(answer.begin, 6);
  EXPECT_EQ(answer.start_speed, 1.0);
  EXPECT_EQ(fault_of(answer, scenario, 6), "");
}

TEST(Replanner, GivesUpWhatWasCommittedIfItMust) {
  Scenario scenario = lane();
  Replanner replanner(scenario, {.committed = 6});
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  const Pose here = pose_at(replanner.answer(), scenario.vehicle, 6);
  scenario.obstacles.push_back(box(here.x + 5.9 + 8, -4, here.x + 5.9 + 9, 4));
  replanner.patch({.added = {{7, scenario.obstacles.back()}}});
  const ReplanAnswer answer = replanner.tick(6);
  EXPECT_TRUE(answer.is_safe) << answer.reason;
  EXPECT_EQ(fault_of(answer, scenario, 6), "");
}

TEST(Replanner, GoesOnWhereItIsMetLaterThanStanding) {
  const Scenario scenario = lane();
  Replanner replanner(scenario);
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  const double x = pose_at(replanner.answer(), scenario.vehicle, 6).x;
  // One comes from aside to where the vehicle can stand, 3.3 s from now and for good. Another one
  // stands so near that there is no place between the two.
  const MovingObstacle comes{box(x + 2.5, -30, x + 6.5, -1.3),
                             {{6, {0, -33, 0}}, {9.3, {0, 0, 0}}, {12, {0, 27, 0}}},
                             Afterwards::stays};
  const MovingObstacle stands{box(x + 16, -24, x + 18, 24), {{0, {0, 0, 0}}}, Afterwards::stays};
  replanner.set_moving(std::vector{comes, stands});
  const ReplanAnswer answer = replanner.tick(6);
  EXPECT_EQ(answer.outcome, TickOutcome::none);
  EXPECT_FALSE(answer.is_safe);
  EXPECT_NE(answer.reason, "");
  EXPECT_NEAR(
      motion_at(answer.drive->path, scenario.vehicle, answer.drive->speeds, 7 - answer.begin).v,
      2.5, 1e-6);
  replanner.set_moving({});
  EXPECT_TRUE(replanner.tick(6.1).is_safe);
}

TEST(Replanner, StopsBeforeAWallAndGoesOnWhenItIsGone) {
  Scenario scenario = lane();
  Replanner replanner(scenario);
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  const Scenario open = scenario;
  scenario.obstacles.push_back(box(30, -28, 31, 28));  // from wall to wall
  replanner.patch({.added = {{7, scenario.obstacles.back()}}});
  for (double t = 6; t < 20; t += tick_period) {
    const ReplanAnswer answer = replanner.tick(t);
    ASSERT_FALSE(answer.reaches_goal);
    ASSERT_TRUE(answer.is_safe) << t << ": " << answer.reason;
    ASSERT_EQ(fault_of(answer, scenario, t), "") << t;
  }
  EXPECT_LT(pose_at(replanner.answer(), scenario.vehicle, 20).x, 30 - 5.9);
  replanner.patch({.removed = {7}});
  const ReplanAnswer answer = replanner.tick(20);
  EXPECT_TRUE(answer.reaches_goal);
  EXPECT_EQ(fault_of(answer, open, 20), "");
}

TEST(Replanner, BrakesAndSaysSoWhenItIsTooLate) {
  const Scenario scenario = lane();
  Replanner replanner(scenario);
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  const Pose here = pose_at(replanner.answer(), scenario.vehicle, 6);
  const double bumper = here.x + 5.9;
  replanner.patch({.added = {{7, box(bumper + 0.5, -20, bumper + 1, 20)}}});
  const ReplanAnswer answer = replanner.tick(6);
  EXPECT_EQ(answer.outcome, TickOutcome::none);
  EXPECT_FALSE(answer.is_safe);
  EXPECT_EQ(answer.reason.find("the footprint hits obstacles["), 0) << answer.reason;
  // 2.5 m/s, 1 m/s^2, the reserve used up.
  EXPECT_NEAR(answer.drive->speeds.duration, 2.5, 1e-6);
}

TEST(Replanner, AnswersAreSafeAmongMoversThatAppear) {
  Scenario scenario = lane();
  int new_answers = 0;
  for (int seed = 1; seed <= 6; ++seed) {
    ReplanOptions options;
    options.plan.budget.seed = static_cast<std::uint64_t>(seed);
    Scenario now = scenario;
    Replanner replanner(now, options);
    for (double t = 0; t < 30; t += tick_period) {
      if (std::abs(t - 3) < 1e-9 || std::abs(t - 12) < 1e-9) {
        const double x = pose_at(replanner.answer(), now.vehicle, t).x + 20 + seed;
        now.moving.push_back(car({{t, {x, -20, 1.5708}}, {t + 13 + seed, {x, 24, 1.5708}}}));
        replanner.set_moving(now.moving);
      }
      const ReplanAnswer answer = replanner.tick(t);
      new_answers += answer.outcome == TickOutcome::kept ? 0 : 1;
      ASSERT_TRUE(answer.is_safe) << "seed " << seed << " at " << t << ": " << answer.reason;
      ASSERT_EQ(fault_of(answer, now, t), "") << "seed " << seed << " at " << t;
    }
    EXPECT_TRUE(replanner.answer().reaches_goal) << seed;
  }
  EXPECT_GT(new_answers, 6);  // the first ones are no news
}

TEST(Replanner, TakesPatchesOfCells) {
  Scenario scenario = lane();
  scenario.obstacles.clear();
  OccupancyGrid map{.origin = {-20, -30, 0}, .resolution = 0.5, .columns = 200, .rows = 120};
  map.cells = std::vector<Cell>(200 * 120, Cell::free);
  scenario.map = map;
  Replanner replanner(scenario);
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  const CellPatch wall{100, 50, 4, 20, std::vector<Cell>(80, Cell::occupied)};
  replanner.patch({.cells = {wall}});
  const ReplanAnswer answer = replanner.tick(6);
  auto cells = *map.cells;
  for (std::size_t row = 50; row < 70; ++row) {
    for (std::size_t column = 100; column < 104; ++column)
      cells[row * 200 + column] = Cell::occupied;
  }
  scenario.map->cells = cells;
  EXPECT_EQ(answer.outcome, TickOutcome::new_way);
  EXPECT_EQ(fault_of(answer, scenario, 6), "");
  EXPECT_THROW(replanner.patch({.cells = {{198, 0, 3, 1, {}}}}), InputError);
}

TEST(Replanner, PlansFromWhereTheVehicleIs) {
  const Scenario scenario = lane();
  Replanner replanner(scenario);
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  const Pose here{12, 3, 0.2};
  const ReplanAnswer answer = replanner.tick(6, {here, 1.0, 0.0});
  EXPECT_EQ(fault_of(answer, scenario, 6), "");
  EXPECT_EQ(pose_at(answer, scenario.vehicle, 6), here);
  EXPECT_TRUE(answer.reaches_goal);
}

TEST(Replanner, RepeatsBitForBit) {
  const auto poses = [] {
    std::vector<Pose> result;
    Scenario scenario = lane();
    Replanner replanner(scenario);
    for (double t = 0; t < 12; t += tick_period) {
      if (std::abs(t - 4) < 1e-9) replanner.patch({.added = {{7, box(30, -4, 33, 4)}}});
      result.push_back(pose_at(replanner.tick(t), scenario.vehicle, t + 5));
    }
    return result;
  };
  EXPECT_EQ(poses(), poses());
}

TEST(Replanner, RefusesWhatItDoesNotHonour) {
  Scenario scenario = lane();
  scenario.vehicle.limits.max_jerk = 2.0;
  EXPECT_THROW(Replanner{scenario}, InputError);
  EXPECT_THROW(Replanner(lane(), {.better = 2}), InputError);
}

TEST(Actions, AreWhatTheAnswerAsksFor) {
  const Scenario scenario = lane();
  Replanner replanner(scenario);
  (void)replanner.tick(3);
  const Action action = action_at(replanner.answer(), scenario.vehicle, 4);
  EXPECT_DOUBLE_EQ(action.t, 4);
  EXPECT_NEAR(action.v, 0.9, 1e-9);  // a second at 1 m/s^2 less the reserve
  EXPECT_NEAR(action.a, 0.9, 1e-9);
  EXPECT_NEAR(action.steering_angle, 0, 1e-9);
}

}  // namespace
}  // namespace vandplan

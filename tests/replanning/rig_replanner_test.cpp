// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does a rig plan anew while it drives? Answers are judged from outside.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/numbers.h"
#include "support/place_of_error.h"
#include "support/problems.h"
#include "support/replans.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

/// A truck with a centre-axle trailer on a drawbar, whose hitch is behind the rear axle.
Vehicle truck_with_drawbar() {
  Vehicle vehicle{4.5, 1.4, 1.6, 2.55, 7.0};
  vehicle.hitch = -1.6;
  vehicle.max_hitch_angle = 0.9;
  vehicle.trailer = Trailer{5.8, -1.0, 3.6, 2.55};
  return vehicle;
}

Scenario lane_for(const Vehicle& rig) {
  Scenario scenario = lane();
  scenario.vehicle = rig;
  scenario.bounds = {-40, 100, -30, 30};
  return scenario;
}

ReplanOptions quick() {
  ReplanOptions options;
  options.plan.budget.max_iterations = 1000;
  return options;
}

double end_hitch_angle(const ReplanAnswer& answer, const Vehicle& vehicle) {
  return replanning::hitch_angle_after(vehicle, answer.start_hitch_angle,
                                       answer.drive->path.segments);
}

class RigReplanner : public testing::TestWithParam<int> {
 protected:
  /// Ticks from `t` on until the rig has arrived, and judges all answers. Returns the time.
  double drive_on(Replanner& replanner, const Scenario& scenario, double t) {
    for (; t < 200; t += tick_period) {
      const ReplanAnswer answer = replanner.tick(t);
      EXPECT_TRUE(answer.is_safe) << t << ": " << answer.reason;
      if (answer.outcome != TickOutcome::kept) {
        EXPECT_EQ(fault_of(answer, scenario, t), "") << t;
      }
      if (answer.has_arrived) break;
    }
    return t;
  }

  Vehicle rig_ = GetParam() == 0 ? semitrailer() : truck_with_drawbar();
  Scenario scenario_ = lane_for(rig_);
};

INSTANTIATE_TEST_SUITE_P(Rigs, RigReplanner, testing::Values(0, 1));

TEST_P(RigReplanner, DrivesALaneAndArrives) {
  scenario_.hitch_angles.start = 0.4;
  Replanner replanner(scenario_, quick());
  const double end = drive_on(replanner, scenario_, 0);
  const ReplanAnswer& last = replanner.answer();
  ASSERT_TRUE(last.has_arrived);
  EXPECT_GT(end, 20);
  EXPECT_EQ(fault_of(last, scenario_, end), "");
  EXPECT_NEAR(rest(last, rig_, end).begin.hitch_angle, 0, 1e-6);
  EXPECT_EQ(replanner.tick(end + 1).outcome, TickOutcome::kept);
}

TEST_P(RigReplanner, GoesRoundWhatComesUp) {
  Replanner replanner(scenario_, quick());
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  const ReplanAnswer before = replanner.answer();
  scenario_.obstacles.push_back(box(45, -4, 48, 4));
  EXPECT_NE(fault_of(before, scenario_, 6), "");
  replanner.patch({.added = {{7, scenario_.obstacles.back()}}});
  const double end = drive_on(replanner, scenario_, 6);
  EXPECT_TRUE(replanner.answer().has_arrived) << end;
  EXPECT_EQ(fault_of(replanner.answer(), scenario_, end), "");
}

TEST_P(RigReplanner, StopsWhereThereIsNoWayAndGoesOnWhenThereIs) {
  Replanner replanner(scenario_, quick());
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  Scenario blocked = scenario_;
  blocked.obstacles.push_back(box(45, -28, 46, 28));
  replanner.patch({.added = {{7, blocked.obstacles.back()}}});
  const ReplanAnswer stop = replanner.tick(6);
  EXPECT_EQ(stop.outcome, TickOutcome::stop);
  EXPECT_TRUE(stop.is_safe);
  EXPECT_FALSE(stop.reaches_goal);
  EXPECT_EQ(fault_of(stop, blocked, 6), "");
  replanner.patch({.removed = {7}});
  (void)drive_on(replanner, scenario_, 7);
  EXPECT_TRUE(replanner.answer().has_arrived);
}

TEST_P(RigReplanner, ReachesTheHitchAngleOfTheGoal) {
  scenario_.hitch_angles.goal = 0.2;
  Replanner replanner(scenario_, quick());
  const ReplanAnswer answer = replanner.tick(0);
  ASSERT_TRUE(answer.reaches_goal) << answer.reason;
  EXPECT_EQ(fault_of(answer, scenario_, 0), "");
  EXPECT_NEAR(end_hitch_angle(answer, rig_), 0.2, 1e-6);
}

TEST_P(RigReplanner, TakesAnotherGoalWhileItDrives) {
  scenario_.hitch_angles.goal = 0.2;
  Replanner replanner(scenario_, quick());
  for (double t = 0; t < 4; t += tick_period) (void)replanner.tick(t);
  scenario_.goal = {80, 8, 0};
  scenario_.hitch_angles.goal = 0.0;  // straight, as `set_goal` says
  replanner.set_goal(scenario_.goal);
  (void)drive_on(replanner, scenario_, 4);
  EXPECT_TRUE(replanner.answer().has_arrived);
  EXPECT_NEAR(end_hitch_angle(replanner.answer(), rig_), 0, 1e-6);
}

TEST_P(RigReplanner, StopsSafelyIfThereIsNoTime) {
  scenario_.hitch_angles.start = -0.5;
  Replanner replanner(scenario_, quick());
  for (double t = 0; t < 3; t += tick_period) (void)replanner.tick(t);
  scenario_.obstacles.push_back(box(40, -20, 43, 20));
  replanner.patch({.added = {{7, scenario_.obstacles.back()}}});
  const ReplanAnswer answer = replanner.tick(3, {.time_limit = 0.0});
  EXPECT_EQ(answer.outcome, TickOutcome::stop);
  EXPECT_TRUE(answer.is_safe) << answer.reason;
  EXPECT_LT(answer.start_hitch_angle, -0.05);
  EXPECT_EQ(fault_of(answer, scenario_, 3), "");
}

TEST_P(RigReplanner, PlansFromAHitchAngleThatIsNotThePlannedOne) {
  Replanner replanner(scenario_, quick());
  for (double t = 0; t < 6; t += tick_period) (void)replanner.tick(t);
  const ReplanAnswer before = replanner.answer();
  const replanning::RigMotion now = rest(before, rig_, 6).begin;
  VehicleState state{.pose = now.pose, .v = now.v, .curvature = now.curvature};
  EXPECT_EQ(replanner.tick(6, state).drive, before.drive);  // whoever measures none is believed
  state.hitch_angle = 0.17;
  EXPECT_EQ(replanner.tick(6, state).drive, before.drive);
  state.hitch_angle = 0.4;
  const ReplanAnswer after = replanner.tick(6, state);
  EXPECT_NE(after.drive, before.drive);
  EXPECT_EQ(after.begin, 6);
  EXPECT_EQ(after.start_hitch_angle, 0.4);
  EXPECT_TRUE(after.is_safe) << after.reason;
  EXPECT_EQ(fault_of(after, scenario_, 6), "");
  (void)drive_on(replanner, scenario_, 6.1);
  EXPECT_TRUE(replanner.answer().has_arrived);
}

/// State of a rig that stands at the start of the lane, with a measured hitch angle.
VehicleState standing(double hitch_angle) {
  return {.pose = lane().start, .hitch_angle = hitch_angle};
}

TEST(ReplannedRig, SaysWhatTheTrailerTouches) {
  for (const double side : {-1.0, 1.0}) {
    Scenario scenario = lane_for(semitrailer());
    // With a hitch angle of 0.6 rad the trailer's rear is 6.8 m to the left.
    scenario.obstacles.push_back(box(-10, side * 6 - 1, -8, side * 6 + 1));
    Replanner replanner(scenario, quick());
    ASSERT_TRUE(replanner.tick(0).is_safe);
    const ReplanAnswer free = replanner.tick(0, standing(side * -0.6));
    EXPECT_TRUE(free.is_safe) << free.reason;
    EXPECT_EQ(fault_of(free, scenario, 0), "");
    const ReplanAnswer touching = replanner.tick(0, standing(side * 0.6));
    EXPECT_FALSE(touching.is_safe);
    EXPECT_EQ(touching.outcome, TickOutcome::none);
    EXPECT_NE(touching.reason.find("trailer's footprint hits obstacles[2]"), std::string::npos)
        << touching.reason;
  }
}

TEST(ReplannedRig, DoesNotDriveWhenFoldedUp) {
  for (const double side : {-1.0, 1.0}) {
    const Scenario scenario = lane_for(semitrailer());
    Replanner replanner(scenario, quick());
    (void)replanner.tick(0);
    for (const double t : {1.0, 2.0}) {
      const ReplanAnswer folded = replanner.tick(t, standing(side * 1.5));
      EXPECT_FALSE(folded.is_safe);
      EXPECT_FALSE(folded.reaches_goal);
      EXPECT_EQ(folded.outcome, TickOutcome::none);
      EXPECT_EQ(folded.drive->speeds.duration, 0);
      EXPECT_EQ(folded.reason.find("the rig is folded up (jackknife): its hitch angle is "), 0U)
          << folded.reason;
    }
    ReplanAnswer unfolded = replanner.tick(3, standing(side));
    for (double t = 3; t < 6 && !unfolded.reaches_goal; t += tick_period) {
      unfolded = replanner.tick(t, standing(side));
      EXPECT_TRUE(unfolded.is_safe) << unfolded.reason;
    }
    EXPECT_TRUE(unfolded.reaches_goal) << unfolded.reason;
    EXPECT_EQ(unfolded.start_hitch_angle, side);
  }
}

TEST(ReplannedRig, BeginsAtTheLimitIfALittleBeyondIsMeasured) {
  const Scenario scenario = lane_for(semitrailer());
  Replanner replanner(scenario, quick());
  (void)replanner.tick(0);
  const ReplanAnswer answer = replanner.tick(1, standing(-1.25));
  EXPECT_TRUE(answer.is_safe) << answer.reason;
  EXPECT_EQ(answer.start_hitch_angle, -1.2);
  EXPECT_EQ(fault_of(answer, scenario, 1), "");
}

TEST(ReplannedRig, DrivesOnAfterBrakingHasFoldedItALittleTooFar) {
  const Scenario scenario = lane_for(semitrailer());
  Replanner replanner(scenario, quick());
  (void)replanner.tick(0);
  const ReplanAnswer braking =
      replanner.tick(1, VehicleState{.pose = scenario.start, .v = -1.5, .hitch_angle = 1.19});
  EXPECT_EQ(braking.outcome, TickOutcome::none);
  EXPECT_FALSE(braking.is_safe);
  EXPECT_GT(end_hitch_angle(braking, scenario.vehicle), 1.25);
  ReplanAnswer answer = replanner.tick(3);
  EXPECT_TRUE(answer.is_safe) << answer.reason;
  EXPECT_EQ(answer.start_hitch_angle, 1.2);
  EXPECT_EQ(fault_of(answer, scenario, 3), "");
  for (double t = 3.1; t < 6 && !answer.reaches_goal; t += tick_period) answer = replanner.tick(t);
  EXPECT_TRUE(answer.reaches_goal) << answer.reason;
  EXPECT_EQ(answer.start_hitch_angle, 1.2);
}

TEST(ReplannedRig, RefusesAHitchAngleWithoutATrailer) {
  Replanner replanner(lane());
  const ReplanAnswer before = replanner.tick(0);
  EXPECT_EQ(place_of_error([&] { (void)replanner.tick(0, standing(1.0)); }), "state.hitch_angle");
  const ReplanAnswer after = replanner.tick(0, standing(0.0));
  EXPECT_EQ(after.drive, before.drive);
  EXPECT_EQ(after.start_hitch_angle, 0);
  EXPECT_TRUE(after.is_safe);
}

TEST(ReplannedRig, RefusesAHitchAngleThatCannotBe) {
  Replanner replanner(lane_for(semitrailer()), quick());
  const ReplanAnswer before = replanner.tick(0);
  for (const double angle : {nan, 3.15, -3.15, 1e300}) {
    EXPECT_EQ(place_of_error([&] { (void)replanner.tick(1, standing(angle)); }),
              "state.hitch_angle");
  }
  EXPECT_EQ(replanner.tick(0.1).drive, before.drive);
}

TEST(ReplannedRig, WaitsForWhoCrossesBehindTheTractor) {
  Scenario scenario = lane_for(semitrailer());
  // At 2.5 m/s the tractor has passed x = 25 after 13 s, the trailer's rear after 17 s.
  const double up = std::numbers::pi / 2;
  scenario.moving = {{box(-1, -1, 1, 1), {{0, {25, -24, up}}, {30, {25, 24, up}}}}};
  Replanner replanner(scenario, quick());
  for (double t = 0; t < 60; t += tick_period) {
    const ReplanAnswer answer = replanner.tick(t);
    ASSERT_TRUE(answer.is_safe) << answer.reason;
    if (answer.outcome != TickOutcome::kept) {
      ASSERT_EQ(fault_of(answer, scenario, t), "");
    }
    if (answer.has_arrived) break;
  }
  EXPECT_TRUE(replanner.answer().has_arrived);
}

TEST(ReplannedRig, RepeatsBitForBit) {
  const auto driven = [] {
    const Vehicle rig = truck_with_drawbar();
    Replanner replanner(lane_for(rig), quick());
    std::vector<Pose> poses;
    for (int i = 0; i < 100; ++i) {
      if (i == 40) replanner.patch({.added = {{7, box(45, -4, 48, 4)}}});
      poses.push_back(pose_at(replanner.tick(i * tick_period), rig, i * tick_period + 5));
    }
    return poses;
  };
  EXPECT_EQ(driven(), driven());
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "drive/plant.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drive/stroke.h"

namespace vandplan::driving {
namespace {

Vehicle truck() {
  Vehicle vehicle;
  vehicle.limits.max_acceleration = 1.0;
  vehicle.limits.max_braking = 0.7;
  return vehicle;
}

TEST(Plant, GainsAndLosesSpeedNoFasterThanItCan) {
  const MovingState moving{.v = 1.0};
  EXPECT_NEAR(after_period(moving, {.acceleration = 5.0}, truck()).v, 1.02, 1e-12);
  EXPECT_NEAR(after_period(moving, {.acceleration = -5.0}, truck()).v, 1 - 0.014, 1e-12);
  EXPECT_NEAR(after_period(moving, {.acceleration = 0.5}, truck()).v, 1.01, 1e-12);
}

TEST(Plant, DrivesAsFarAsItsSpeedsSay) {
  const MovingState after = after_period({.v = 1.0}, {.acceleration = 0.5}, truck());
  EXPECT_NEAR(after.pose.x, 0.02 + 0.5 * 0.02 * 0.02 / 2, 1e-12);
}

TEST(Plant, ComesToStandWithinAPeriodAndStays) {
  const MovingState after = after_period({.v = 0.007}, {.acceleration = -0.7}, truck());
  EXPECT_EQ(after.v, 0);
  EXPECT_NEAR(after.pose.x, 0.007 * 0.007 / 1.4, 1e-12);
}

TEST(Plant, TheGearChangesAtStandstillOnly) {
  const Command back{.acceleration = 1.0, .direction = -1};
  MovingState state = after_period({.v = 0.05}, back, truck());
  EXPECT_NEAR(state.v, 0.05 - 0.014, 1e-12);
  EXPECT_EQ(state.direction, 1);
  EXPECT_GT(state.pose.x, 0);
  for (int i = 0; i < 5; ++i) state = after_period(state, back, truck());
  EXPECT_EQ(state.direction, -1);
  const double x = state.pose.x;
  EXPECT_LT(after_period(state, back, truck()).pose.x, x);
}

TEST(Plant, TheWheelsReachWhatIsWantedAtTheEndOfThePeriod) {
  EXPECT_NEAR(after_period({}, {.steering_angle = 0.004}, truck()).steering_angle, 0.004, 1e-15);
  EXPECT_NEAR(after_period({}, {.steering_angle = -1}, truck()).steering_angle, -0.01, 1e-15);
  const double full = std::atan(4.5 / 7);
  const MovingState at_the_stop =
      after_period({.steering_angle = full}, {.steering_angle = 1}, truck());
  EXPECT_NEAR(at_the_stop.steering_angle, full, 1e-15);
}

TEST(Plant, ErrorsBendAndStretchTheArc) {
  const Segment arc = arc_of({0.1, -2}, truck(), {0.01, 0.02, 0.03});
  EXPECT_NEAR(arc.curvature, std::tan(0.1 * 1.02 + 0.01) / 4.5, 1e-15);
  EXPECT_NEAR(arc.length, -2.06, 1e-15);
  EXPECT_NEAR(arc_of({0.1, -2}, truck()).curvature, std::tan(0.1) / 4.5, 1e-15);
}

TEST(Stroke, FindsThePlaceBesideAPose) {
  for (const double gear : {1.0, -1.0}) {
    SCOPED_TRACE(gear);
    Stroke stroke({0, 0, 0}, 3);
    stroke.add({0.1, gear * 8});
    EXPECT_EQ(stroke.direction(), gear);
    // On the circle around (0, 10), 3 m from its centre and a third of the way.
    const double turn = gear * 0.3;
    const Pose inside{3 * std::sin(turn), 10 - 3 * std::cos(turn), turn + 0.05};
    const Offset offset = stroke.offset_of(inside, 1);
    EXPECT_NEAR(offset.place.s, 3, 1e-7);
    EXPECT_NEAR(offset.lateral, 7, 1e-7);
    EXPECT_NEAR(offset.heading, 0.05, 1e-7);
  }
}

TEST(Stroke, GoesOnBeyondItsEnds) {
  Stroke stroke({0, 0, 0}, 0);
  stroke.add({0, -2});
  EXPECT_NEAR(stroke.at(3).pose.x, -3, 1e-12);
  EXPECT_NEAR(stroke.at(-1).pose.x, 1, 1e-12);
  EXPECT_EQ(stroke.speed_at(2), 0);
}

TEST(Stroke, IsExactBetweenItsSamples) {
  const Segment clothoid{-0.1, -4, 0.09};
  Stroke stroke({1, 2, 3}, 0);
  stroke.add(clothoid);
  for (double s = 0; s <= 4; s += 0.017) {
    const Pose exact = advance({1, 2, 3}, part_of(clothoid, 0, s));
    EXPECT_NEAR(stroke.at(s).pose.x, exact.x, 1e-6);
    EXPECT_NEAR(stroke.at(s).pose.y, exact.y, 1e-6);
    EXPECT_NEAR(stroke.at(s).curvature, curvature_at(clothoid, s), 1e-12);
  }
}

}  // namespace
}  // namespace vandplan::driving

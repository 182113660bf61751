// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/drive_oracle.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

/// The car of the parking competition: 2.5 m/s, 1 m/s^2, wheels that turn by 0.5 rad/s.
Vehicle car() {
  Vehicle car{.wheelbase = 2.8, .min_turning_radius = 2.8 / std::tan(0.75)};
  car.limits.max_steering_rate = 0.5;
  car.limits.max_speed = {2.5, 2.5};
  car.limits.max_acceleration = 1.0;
  car.limits.max_lateral_acceleration = 100.0;
  return car;
}

Path path_of(std::vector<Segment> segments) { return {{0, 0, 0}, std::move(segments)}; }

double duration_of(const std::vector<Segment>& segments, const Vehicle& vehicle) {
  return speed_profile(path_of(segments), vehicle).duration;
}

TEST(Speed, ALineIsDrivenWithFullAccelerationSpeedAndBraking) {
  const SpeedProfile profile = speed_profile(path_of({{0, 10}}), car());
  // 2.5 s and 3.125 m up, as much down, and 3.75 m at 2.5 m/s in between.
  ASSERT_EQ(profile.knots.size(), 4U);
  EXPECT_DOUBLE_EQ(profile.duration, 6.5);
  EXPECT_DOUBLE_EQ(profile.knots[1].t, 2.5);
  EXPECT_DOUBLE_EQ(profile.knots[1].s, 3.125);
  EXPECT_DOUBLE_EQ(profile.knots[1].v, 2.5);
  EXPECT_DOUBLE_EQ(profile.knots[2].t, 4.0);
  EXPECT_EQ(profile.knots[0].bound, SpeedBound::acceleration);
  EXPECT_EQ(profile.knots[1].bound, SpeedBound::max_speed);
  EXPECT_EQ(profile.knots[2].bound, SpeedBound::braking);
  EXPECT_TRUE(profile.stops.empty());
}

TEST(Speed, AShortLineNeverReachesFullSpeed) {
  EXPECT_DOUBLE_EQ(duration_of({{0, 1}}, car()), 2.0);  // up and down, half a metre each
}

TEST(Speed, BrakingMayBeHarder) {
  Vehicle vehicle = car();
  vehicle.limits.max_braking = 2.5;
  // 3.125 m up in 2.5 s, 1.25 m down in 1 s, 5.625 m in between.
  EXPECT_DOUBLE_EQ(duration_of({{0, 10}}, vehicle), 2.5 + 1 + 5.625 / 2.5);
}

TEST(Speed, EachGearHasItsOwnSpeed) {
  Vehicle vehicle = car();
  vehicle.limits.max_speed = {2.5, 1.0};
  EXPECT_DOUBLE_EQ(duration_of({{0, -10}}, vehicle), 10 / 1.0 + 1.0);
}

TEST(Speed, AGearChangeIsAStopWithoutAPause) {
  const SpeedProfile profile = speed_profile(path_of({{0, 1}, {0, -1}}), car());
  ASSERT_EQ(profile.stops.size(), 1U);
  EXPECT_DOUBLE_EQ(profile.stops[0].t, 2.0);
  EXPECT_EQ(profile.stops[0].s, 1.0);
  EXPECT_EQ(profile.stops[0].pause, 0.0);
  EXPECT_DOUBLE_EQ(profile.duration, 4.0);
}

TEST(Speed, ItStandsWhereALimitIsAStop) {
  const auto with_stops = [](const std::vector<Segment>& segments, std::vector<SpeedLimit> stops) {
    return speed_profile(path_of(segments), car(), {.limits = std::move(stops)});
  };
  const SpeedProfile profile = with_stops({{0, 10}}, {{4, 4, 0.0}});
  EXPECT_DOUBLE_EQ(profile.duration, duration_of({{0, 4}}, car()) + duration_of({{0, 6}}, car()));
  ASSERT_EQ(profile.stops.size(), 1U);
  EXPECT_DOUBLE_EQ(profile.stops[0].s, 4.0);
  EXPECT_EQ(profile.stops[0].pause, 0.0);
  // Where two segments meet, at the ends, or where it stands anyway, no time is lost twice.
  const double joint = with_stops({{0, 4}, {0, 6}}, {{4, 4, 0.0}}).duration;
  EXPECT_DOUBLE_EQ(joint, profile.duration);
  EXPECT_DOUBLE_EQ(with_stops({{0, 10}}, {{0, 0, 0.0}, {10, 10, 0.0}}).duration, 6.5);
  const std::vector<Segment> back = {{0, 4}, {0, -6}};
  EXPECT_DOUBLE_EQ(with_stops(back, {{4, 4, 0.0}}).duration, duration_of(back, car()));
  EXPECT_THROW((void)with_stops(back, {{3, 4, 0.0}}), InputError);
}

TEST(Speed, WhereTheCurvatureJumpsItStandsUntilTheWheelsAreTurned) {
  const double full = 1 / car().min_turning_radius;  // 0.75 rad
  const SpeedProfile profile = speed_profile(path_of({{0, 1}, {full, 1}, {-full, 1}}), car());
  ASSERT_EQ(profile.stops.size(), 2U);
  EXPECT_DOUBLE_EQ(profile.stops[0].pause, 0.75 / 0.5);
  EXPECT_DOUBLE_EQ(profile.stops[1].pause, 1.5 / 0.5);
  EXPECT_DOUBLE_EQ(profile.stops[1].curvature_before, full);
  EXPECT_DOUBLE_EQ(profile.stops[1].curvature_after, -full);
  EXPECT_DOUBLE_EQ(profile.standing, 4.5);
  EXPECT_DOUBLE_EQ(profile.duration, 3 * 2.0 + 4.5);
}

TEST(Speed, BeforeTheStartTheWheelsAreStraightUnlessSaidOtherwise) {
  const double full = 1 / car().min_turning_radius;
  const Path path = path_of({{full, 1}});
  const SpeedProfile profile = speed_profile(path, car());
  ASSERT_EQ(profile.stops.size(), 1U);
  EXPECT_EQ(profile.stops[0].s, 0.0);
  EXPECT_DOUBLE_EQ(profile.duration, 2.0 + 1.5);
  EXPECT_DOUBLE_EQ(speed_profile(path, car(), {.start_curvature = full}).duration, 2.0);
  EXPECT_TRUE(speed_profile(path, car(), {.start_curvature = full}).stops.empty());
}

TEST(Speed, JumpsThatAreNothingButRoundingAreDrivenThrough) {
  const double full = 1 / car().min_turning_radius;
  EXPECT_EQ(speed_profile(path_of({{full, 1}, {full + 1e-8, 1}}), car()).stops.size(), 1U);
  EXPECT_EQ(speed_profile(path_of({{full, 1}, {full + 1e-5, 1}}), car()).stops.size(), 2U);
}

TEST(Speed, TurnsAreDrivenNoFasterThanTheLateralAccelerationAllows) {
  Vehicle vehicle = car();
  vehicle.limits.max_lateral_acceleration = 0.3;
  const SpeedProfile profile = speed_profile(path_of({{0.3, 20}}), vehicle, {0.3});
  EXPECT_DOUBLE_EQ(profile.knots[1].v, 1.0);  // 1^2 * 0.3
  EXPECT_EQ(profile.knots[1].bound, SpeedBound::lateral_acceleration);
  EXPECT_DOUBLE_EQ(profile.duration, 20.0 / 1.0 + 1.0);
}

TEST(Speed, OnAClothoidTheWheelsTurnNoFasterThanTheyCan) {
  Vehicle vehicle = car();
  vehicle.limits.max_acceleration = 1000;  // nothing else holds it back
  vehicle.limits.max_speed = {1000, 1000};
  vehicle.limits.max_lateral_acceleration = 1000;
  const double full = 1 / vehicle.min_turning_radius;
  const SpeedProfile profile = speed_profile(path_of({{0, 4, full / 4}}), vehicle);
  // 0.75 rad at 0.5 rad/s: the wheels turn all the time, but for milliseconds at either end.
  EXPECT_NEAR(profile.duration, 1.5, 5e-3);
  EXPECT_GE(profile.duration, 1.5);
  EXPECT_EQ(profile.knots[1].bound, SpeedBound::steering_rate);
}

TEST(Speed, SlowsDownInTimeForWhatComes) {
  Vehicle vehicle = car();
  vehicle.limits.max_lateral_acceleration = 0.25 * 0.25 * 0.3;
  const std::vector<Segment> segments = {{0, 5}, {0, 0.1, 3}, {0.3, 1}, {0.3, 0.1, -3}, {0, 5}};
  const SpeedProfile profile = speed_profile(path_of(segments), vehicle);
  EXPECT_TRUE(profile.stops.empty());
  EXPECT_EQ(fault_of(path_of(segments), vehicle, profile), "");
  EXPECT_LE(profile.duration, dense_duration(path_of(segments), vehicle) * (1 + 1e-3));
}

TEST(Speed, TheJerkRoundsTheCornersOfALine) {
  Vehicle vehicle = car();
  vehicle.limits.max_jerk = 2.0;
  const SpeedProfile profile = speed_profile(path_of({{0, 20}}), vehicle);
  EXPECT_NEAR(profile.duration, 20 / 2.5 + 2.5 / 1.0 + 1.0 / 2.0, 1e-9);  // distance, ramps, bends
  EXPECT_EQ(profile.knots.front().a, 0.0);
  EXPECT_EQ(profile.knots.front().jerk, 2.0);
  EXPECT_EQ(fault_of(path_of({{0, 20}}), vehicle, profile), "");
  // A line so short that neither full speed nor full acceleration is reached: four bends.
  EXPECT_NEAR(duration_of({{0, 0.1}}, vehicle), 4 * std::cbrt(0.1 / 2 / 2.0), 1e-9);
}

TEST(Speed, WithMuchJerkItIsNearTheFastestDrive) {
  Vehicle vehicle = car();
  const std::vector<Segment> segments = {{0, 5}, {0, 3, 0.1}, {0.3, 4}, {0.3, 3, -0.1}, {0, 5}};
  const double fastest = duration_of(segments, vehicle);
  vehicle.limits.max_jerk = 1000;
  EXPECT_LE(duration_of(segments, vehicle), 1.005 * fastest);
}

TEST(Speed, NoPathTakesNoTime) {
  const SpeedProfile profile = speed_profile(path_of({}), car());
  EXPECT_EQ(profile.duration, 0.0);
  ASSERT_EQ(profile.knots.size(), 1U);
  const std::vector<Motion> motions = sampled(path_of({}), car(), profile, 0.05);
  ASSERT_EQ(motions.size(), 1U);
  EXPECT_EQ(motions[0].v, 0.0);
}

TEST(Speed, WhatIsShorterThanAWheelTurnsIsDrivenAsItIs) {
  const SpeedProfile profile = speed_profile(path_of({{0, 1}, {0.3, 1e-10}, {0, 1}}), car());
  EXPECT_TRUE(profile.stops.empty());
  EXPECT_NEAR(profile.duration, duration_of({{0, 2}}, car()), 1e-8);
}

TEST(Speed, SharpClothoidsTakeAsLongAsTheWheels) {
  const double full = 1 / car().min_turning_radius;
  const double duration = duration_of({{0, 1e-6, full * 1e6}, {full, 1}}, car());
  EXPECT_NEAR(duration, 1.5 + 2.0, 0.01);
}

TEST(Speed, RefusesLimitsOutOfRangeAndPathsThatAreNotFinite) {
  Vehicle vehicle = car();
  vehicle.limits.max_jerk = 0.0;
  try {
    (void)speed_profile(path_of({{0, 1}}), vehicle);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "max_jerk: is 0, expected 0.001 to 1000 m/s^3");
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Segment& segment :
       {Segment{infinity, 1}, Segment{0, infinity}, Segment{0, 1, std::nan("")}}) {
    EXPECT_THROW((void)speed_profile(path_of({{0, 1}, segment}), car()), InputError);
  }
}

TEST(Motion, ReverseIsNegative) {
  const Path path = path_of({{0, -10}});
  const SpeedProfile profile = speed_profile(path, car());
  const Motion motion = motion_at(path, car(), profile, 1.0);
  EXPECT_DOUBLE_EQ(motion.v, -1.0);
  EXPECT_DOUBLE_EQ(motion.a, -1.0);
  EXPECT_DOUBLE_EQ(motion.s, 0.5);
  EXPECT_DOUBLE_EQ(motion.pose.x, -0.5);
  EXPECT_EQ(motion.gear, Gear::reverse);
  EXPECT_DOUBLE_EQ(motion_at(path, car(), profile, 6.0).a, 1.0);
  EXPECT_FALSE(std::signbit(motion_at(path, car(), profile, 0.0).v));  // no -0 in files
  EXPECT_FALSE(std::signbit(motion_at(path, car(), profile, 3.0).a));
}

TEST(Motion, TheWheelsTurnEvenlyWhileItStands) {
  const double full = 1 / car().min_turning_radius;
  const Path path = path_of({{0, 1}, {full, -1}});
  const SpeedProfile profile = speed_profile(path, car());
  const Motion middle = motion_at(path, car(), profile, 2.0 + 0.75);
  EXPECT_EQ(middle.s, 1.0);
  EXPECT_EQ(middle.v, 0.0);
  EXPECT_EQ(middle.a, 0.0);
  EXPECT_EQ(middle.gear, Gear::reverse);  // what comes next
  EXPECT_DOUBLE_EQ(middle.steering_angle, 0.375);
  EXPECT_NEAR(std::tan(middle.steering_angle), 2.8 * middle.curvature, 1e-15);
  const Motion start = motion_at(path, car(), profile, 3.5);
  EXPECT_DOUBLE_EQ(start.steering_angle, 0.75);
  EXPECT_DOUBLE_EQ(start.a, -1.0);
}

TEST(Motion, UntilAStopItIsOnTheWayThere) {
  const double full = 1 / car().min_turning_radius;
  const Path path = path_of({{0, 1}, {full, -1}});
  const SpeedProfile profile = speed_profile(path, car());
  const Motion before = motion_at(path, car(), profile, std::nextafter(profile.stops[0].t, 0.0));
  EXPECT_EQ(before.gear, Gear::forward);
  EXPECT_EQ(before.steering_angle, 0.0);
  EXPECT_EQ(motion_at(path, car(), profile, profile.stops[0].t).gear, Gear::reverse);
}

TEST(Motion, FarFromTheOriginNothingIsLost) {
  Path path{{1e9, 0, 0}, {}};
  for (int i = 0; i < 1000; ++i) path.segments.push_back({i % 2 * 1e-9, 0.0123});
  const SpeedProfile profile = speed_profile(path, car());
  EXPECT_NEAR(motion_at(path, car(), profile, profile.duration).pose.x, 1e9 + 12.3, 2e-7);
}

TEST(Motion, TimesAreClampedToTheDrive) {
  const Path path = path_of({{0, 1}});
  const SpeedProfile profile = speed_profile(path, car());
  EXPECT_EQ(motion_at(path, car(), profile, -1).s, 0.0);
  const Motion end = motion_at(path, car(), profile, 100);
  EXPECT_EQ(end.s, 1.0);
  EXPECT_EQ(end.v, 0.0);
  EXPECT_EQ(end.a, 0.0);
}

TEST(Motion, SamplesHaveAGridAndEveryStop) {
  const double full = 1 / car().min_turning_radius;
  // It comes to stand a microsecond behind a multiple of the step, and goes on 1.5 s later.
  const Path path = path_of({{0, 1.000001}, {full, 0.77}});
  const SpeedProfile profile = speed_profile(path, car());
  const std::vector<Motion> motions = sampled(path, car(), profile, 0.05);
  const auto has = [&](double t) {
    return std::ranges::any_of(motions, [&](const Motion& m) { return m.t == t; });
  };
  EXPECT_TRUE(has(0.05));
  EXPECT_TRUE(has(21 * 0.05));
  EXPECT_TRUE(has(profile.stops[0].t));
  EXPECT_TRUE(has(profile.stops[0].t + profile.stops[0].pause));
  EXPECT_TRUE(has(profile.duration));
  for (std::size_t i = 1; i < motions.size(); ++i) {
    EXPECT_GT(motions[i].t - motions[i - 1].t, 1e-5);
    EXPECT_LE(motions[i].t - motions[i - 1].t, 0.05 + 1e-4);
  }
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drive/outline.h"
#include "support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/motion.h"

namespace vandplan {
namespace {

using std::numbers::pi;

/// A truck whose wheels follow clothoids of 0.1 1/m^2.
Vehicle truck() {
  Vehicle vehicle;
  vehicle.limits.max_curvature_rate = 0.1;
  return vehicle;
}

/// A turn of clothoid, arc, clothoid, a line, and a turn to the other side: no jump anywhere.
std::vector<Segment> two_turns(double gear) {
  const double full = 1 / 7.5;
  const double bend = full / 0.1;
  return {{0, gear * 3},  {0, gear * bend, 0.1},  {full, gear * 4},  {full, gear * bend, -0.1},
          {0, gear * 2},  {0, gear * bend, -0.1}, {-full, gear * 5}, {-full, gear * bend, 0.1},
          {0, gear * 2.5}};
}

/// Ahead and back again.
Path there_and_back() {
  Path path{{1, 2, 0.3}, two_turns(1)};
  const std::vector<Segment> back = two_turns(-1);
  path.segments.insert(path.segments.end(), back.begin(), back.end());
  return path;
}

DriveResult driven(const Path& path, const DriveOptions& options = {}, Surroundings things = {},
                   const Vehicle& vehicle = truck()) {
  things.bounds = wide_bounds;
  return drive(problem_of_path(things, path, vehicle), path, options);
}

class EveryController : public testing::TestWithParam<std::string> {};

TEST(Outline, TheFurthestCornerCounts) {
  const Polygon body{{-1, -1}, {4, -1}, {4, 1}, {-1, 1}};
  EXPECT_EQ(driving::deviation_of(body, {0, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(driving::deviation_of(body, {0.3, 0.4, 0}), 0.5);
  // Turned on the spot the corner at (4, 1) comes to (-1, 4), the one at (-1, -1) to (1, -1).
  EXPECT_DOUBLE_EQ(driving::deviation_of(body, {0, 0, pi / 2}), 3);
}

INSTANTIATE_TEST_SUITE_P(Drive, EveryController,
                         testing::Values("rear-axle-feedback", "lqr", "pure-pursuit", "stanley"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(Drive, ListsItsControllers) {
  std::vector<std::string_view> names;
  for (const ControllerInfo& info : controllers()) names.push_back(info.name);
  EXPECT_EQ(names, (std::vector<std::string_view>{"rear-axle-feedback", "lqr", "pure-pursuit",
                                                  "stanley"}));
  EXPECT_EQ(usual_controller({}), names.front());
}

TEST_P(EveryController, ALineIsDrivenAsTheSpeedsSay) {
  const Path path{{1, 2, 0.3}, {{0, 10}}};
  const DriveResult result =
      driven(path, {.controller = GetParam(), .reserve = 0, .keep_log = true});
  EXPECT_TRUE(result.has_arrived);
  // 2.5 s up to 2.5 m/s, 1.5 s at that, 2.5 s down; control periods are not cut.
  EXPECT_DOUBLE_EQ(result.planned_duration, 6.5);
  EXPECT_NEAR(result.duration, 6.5, 0.04);
  EXPECT_LT(result.largest_lateral, 1e-9);
  EXPECT_LT(result.end_distance, 1e-6);
  for (const DriveMoment& moment : result.log) {
    // The closed form, but for the period in which a corner of it lies.
    const double t = moment.t;
    const double v = std::min({t, 2.5, std::max(result.duration - t, 0.0)});
    EXPECT_NEAR(moment.v, v, 0.04) << t;
    EXPECT_NEAR(moment.pose.x, 1 + moment.s * std::cos(0.3), 1e-9);
  }
}

TEST_P(EveryController, ACircleIsDrivenRound) {
  const Path path{{0, 0, 0}, {{0.1, 20 * pi}}};
  const DriveResult result = driven(path, {.controller = GetParam(), .keep_log = true});
  EXPECT_TRUE(result.has_arrived);
  EXPECT_LT(result.largest_lateral, 1e-6);
  EXPECT_LT(result.largest_heading, 1e-6);
  EXPECT_LT(result.end_distance, 1e-5);
  for (const DriveMoment& moment : result.log) {
    EXPECT_NEAR(std::hypot(moment.pose.x, moment.pose.y - 10), 10, 1e-6);
  }
}

TEST(Drive, ContinuousPathsAreFollowedWithinMillimetres) {
  for (const char* controller : {"rear-axle-feedback", "lqr"}) {
    SCOPED_TRACE(controller);
    const DriveResult result = driven(there_and_back(), {.controller = controller});
    EXPECT_TRUE(result.has_arrived);
    // What looks ahead begins to turn before the path does.
    const double most = controller == std::string("lqr") ? 5e-3 : 1e-4;
    EXPECT_LT(result.largest_lateral, most);
    EXPECT_LT(result.largest_heading, most);
    EXPECT_LT(result.end_distance, most);
    EXPECT_LT(result.outline_deviation, 6 * most);
    EXPECT_GT(result.outline_deviation, result.largest_lateral);
    EXPECT_LE(result.rms_lateral, result.largest_lateral);
    EXPECT_NEAR(result.duration, result.planned_duration, 1);
  }
}

TEST_P(EveryController, NoiseIsSteeredAgainst) {
  const Path path{{0, 0, 0}, {{0, 40}}};
  const DriveResult result = driven(path, {.controller = GetParam(), .noise = 1, .seed = 3});
  EXPECT_TRUE(result.has_arrived);
  EXPECT_GT(result.largest_lateral, 1e-3);
  EXPECT_LT(result.largest_lateral, 0.1);
  EXPECT_LT(result.end_distance, 0.1);
}

// In reverse through turns that leave the wheels little room, the wheels get so late that at full
// speed one drive of twenty swings out by metres.
TEST(Drive, SlowsDownForWheelsThatAreLate) {
  const Vehicle robot{.wheelbase = 1.2,
                      .front_overhang = 0.35,
                      .rear_overhang = 0.35,
                      .width = 0.95,
                      .min_turning_radius = 1.5};
  constexpr double rate = 0.4166;
  const double bent = 2 * rate * 0.8;
  const double last = rate * 2.6845 - bent;  // to the other side
  const Path path{{0, 0, 0},
                  {{0, -0.8, rate},
                   {bent / 2, -2.356, 0},
                   {bent / 2, -0.8, rate},
                   {bent, -2.6845, -rate},
                   {-last, -last / rate, rate},
                   {0, -8, 0}}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const DriveResult result =
        driven(path, {.noise = 2, .delay = 0.1, .spare_steering = 0.05, .seed = seed}, {}, robot);
    EXPECT_TRUE(result.has_arrived);
    EXPECT_LT(result.largest_lateral, 0.2) << seed;
    EXPECT_LT(result.duration, result.planned_duration + 1) << seed;
  }
}

TEST_P(EveryController, ADelayIsBridged) {
  const Path path{{0, 0, 0}, two_turns(1)};
  const DriveResult prompt = driven(path, {.controller = GetParam()});
  const DriveResult late = driven(path, {.controller = GetParam(), .delay = 0.3});
  EXPECT_TRUE(late.has_arrived);
  EXPECT_NEAR(late.duration, prompt.duration + 0.3, 1e-9);
  EXPECT_NEAR(late.largest_lateral, prompt.largest_lateral, 1e-9);
}

TEST(Drive, WheelsAreTurnedAtStandstill) {
  const double full = 1 / 7.0;
  const Path path{{0, 0, 0}, {{0, 5}, {full, 4}, {-full, -4}}};
  const DriveResult result = driven(path, {.keep_log = true});
  EXPECT_TRUE(result.has_arrived);
  EXPECT_LT(result.largest_lateral, 3e-3);
  EXPECT_NEAR(result.duration, result.planned_duration, 0.5);
  int standing = 0;
  for (std::size_t i = 1; i < result.log.size(); ++i) {
    const DriveMoment& now = result.log[i];
    if (now.gear != result.log[i - 1].gear) {
      EXPECT_EQ(result.log[i - 1].v, 0) << now.t;
    }
    if (now.v != 0) continue;
    standing += now.steering_angle != result.log[i - 1].steering_angle ? 1 : 0;
  }
  // 0.57 rad before the arc and 1.14 rad before it goes back, at 0.5 rad/s in periods of 0.02 s.
  EXPECT_NEAR(standing, 3 * std::atan(4.5 / 7) / 0.5 / 0.02, 4);
}

TEST_P(EveryController, EveryLimitIsKeptAtEveryStep) {
  const bool forward_only = GetParam() == "stanley";
  const Path path = forward_only ? Path{{0, 0, 0}, two_turns(1)} : there_and_back();
  Vehicle vehicle = truck();
  vehicle.limits.max_braking = 0.7;
  vehicle.limits.max_speed = {2, 1};
  const DriveResult result = driven(
      path, {.controller = GetParam(), .noise = 2, .delay = 0.1, .keep_log = true}, {}, vehicle);
  ASSERT_GT(result.log.size(), 500U);
  constexpr double slack = 1 + 1e-9;
  for (std::size_t i = 1; i < result.log.size(); ++i) {
    const DriveMoment& last = result.log[i - 1];
    const DriveMoment& now = result.log[i];
    const double dt = now.t - last.t;
    EXPECT_NEAR(dt, 0.02, 1e-9);
    EXPECT_LE(std::abs(now.steering_angle - last.steering_angle), 0.5 * dt * slack);
    EXPECT_LE(std::abs(now.steering_angle), std::atan(4.5 / 7) * slack);
    const double gained = std::abs(now.v) - std::abs(last.v);
    EXPECT_LE(gained, 1.0 * dt * slack);
    EXPECT_GE(gained, -0.7 * dt * slack);
    EXPECT_LE(now.v, 2 * slack);
    EXPECT_GE(now.v, -1 * slack);
  }
}

TEST(Drive, AContactIsReported) {
  const Path path{{0, 0, 0}, {{0, 20}}};
  // The front bumper, 5.9 m ahead of the rear axle, meets the wall after 6.1 m.
  const Surroundings wall{.obstacles = {box(-30, -9, -29, 9), box(12, -9, 13, 9)}};
  const DriveResult result = driven(path, {.reserve = 0}, wall);
  EXPECT_TRUE(result.has_arrived);
  ASSERT_TRUE(result.contact);
  EXPECT_NEAR(result.contact->s, 6.1, 0.02);
  EXPECT_NEAR(result.contact->pose.x, 6.1, 0.02);
  // 2.5 s and 3.125 m up to 2.5 m/s.
  EXPECT_NEAR(result.contact->t, 2.5 + (6.1 - 3.125) / 2.5, 0.03);
  EXPECT_EQ(result.contact->what, "the footprint hits obstacles[1]");
  EXPECT_EQ(result.clearance, 0);
}

TEST(Drive, OneAlreadyStandsInContact) {
  const Path path{{0, 0, 0}, {{0, 2}}};
  const DriveResult result = driven(path, {}, {.kerbs = {box(1, 1, 2, 2)}});
  ASSERT_TRUE(result.contact);
  EXPECT_EQ(result.contact->t, 0);
  EXPECT_EQ(result.contact->what, "the wheels hit kerbs[0]");
}

TEST(Drive, WhatIsPassedNearlyIsNoContact) {
  const Path path{{0, 0, 0}, {{0, 20}}};
  const DriveResult result = driven(path, {}, {.obstacles = {box(8, 1.275 + 2e-3, 9, 3)}});
  EXPECT_FALSE(result.contact);
  EXPECT_NEAR(result.clearance, 2e-3, 1e-9);
  EXPECT_TRUE(std::isinf(driven(path).clearance));
}

TEST(Drive, TheLeastClearanceIsSeen) {
  // The outer corner of the front passes a post at half a metre, and nothing else comes near it.
  const double full = 1 / 7.0;
  const Path path{{0, 0, 0}, {{full, 20}}};
  const double corner = std::hypot(5.9, 7 + 1.275);
  const Surroundings post{.obstacles = {box(corner + 0.5, 6.99, corner + 0.7, 7.01)}};
  EXPECT_NEAR(driven(path, {}, post).clearance, 0.5, 1e-3);
}

TEST(Drive, OutOfBoundsNothingIsTouched) {
  const Path path{{0, 0, 0}, {{0, 20}}};
  const Surroundings beside{.bounds = {-1, 19, -1, 1}, .obstacles = {box(10, 1.276, 40, 3)}};
  const Problem problem = problem_of_path(beside, path);
  const DriveResult result = drive(problem, path);
  EXPECT_FALSE(result.contact);
  EXPECT_NEAR(result.out_of_bounds, 1, 1e-6);
}

TEST(Drive, GearChangesAreMadeWhereverNoiseStopsTheVehicle) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const DriveResult result = driven(there_and_back(), {.noise = 3, .delay = 0.1, .seed = seed});
    EXPECT_TRUE(result.has_arrived) << seed;
    EXPECT_LT(result.duration, result.planned_duration + 10) << seed;
  }
}

TEST(Drive, AMarginOfTheOutlineDeviationIsEnough) {
  const Path path{{0, 0, 0}, two_turns(1)};
  const auto wall_below = [](double y) {
    return Surroundings{wide_bounds, {box(-50, -99, 50, y)}};
  };
  const auto planned_clearance = [&](const Surroundings& wall) {
    return check_path(problem_of_path(wall, path, truck()), path).clearance.value();
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const DriveOptions options{.noise = 5, .seed = seed};
    const double needed = driven(path, options).outline_deviation;
    EXPECT_GT(needed, 0.01);
    // The wall stands as far from what is planned as noise brings the vehicle out somewhere.
    const double y = -20 + planned_clearance(wall_below(-20)) - needed - 2e-3;
    EXPECT_NEAR(planned_clearance(wall_below(y)), needed + 2e-3, 1.1e-3);
    EXPECT_FALSE(driven(path, options, wall_below(y)).contact) << seed;
  }
}

TEST(Drive, WithSpareSteeringTheTightestTurnsAreKept) {
  const double full = 1 / 7.0;
  const Path path{{0, 0, 0}, {{full, 40}}};
  double tight = 0;
  double spare = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    tight = std::max(tight, driven(path, {.noise = 1, .seed = seed}).largest_lateral);
    const DriveOptions options{.noise = 1, .spare_steering = 0.1, .seed = seed};
    spare = std::max(spare, driven(path, options).largest_lateral);
  }
  EXPECT_GT(tight, 0.2);
  EXPECT_LT(spare, 0.05);
}

TEST(Drive, AtTheStartTheWheelsMayBeTurned) {
  const double full = 1 / 7.0;
  const Path path{{0, 0, 0}, {{full, 4}}};
  const std::shared_ptr<const World> world = world_of({.bounds = wide_bounds});
  const Problem turned = make_problem(world, truck(), path.start, end_pose(path), {full, full});
  const DriveResult result = drive(turned, path, {.keep_log = true});
  EXPECT_DOUBLE_EQ(result.log.front().steering_angle, std::atan(4.5 * full));
  const double pause = std::atan(4.5 * full) / (0.9 * 0.5);
  EXPECT_NEAR(driven(path).planned_duration - result.planned_duration, pause, 1e-9);
}

TEST(Drive, TheSeedDecides) {
  const auto with_seed = [](std::uint64_t seed) {
    return driven(there_and_back(), {.noise = 1, .delay = 0.1, .seed = seed, .keep_log = true});
  };
  const DriveResult one = with_seed(1);
  const DriveResult again = with_seed(1);
  ASSERT_EQ(one.log.size(), again.log.size());
  for (std::size_t i = 0; i < one.log.size(); ++i) {
    EXPECT_EQ(one.log[i].pose, again.log[i].pose);
    EXPECT_EQ(one.log[i].steering_angle, again.log[i].steering_angle);
  }
  EXPECT_NE(one.largest_lateral, with_seed(2).largest_lateral);
}

TEST(Drive, FarFromTheOriginItIsTheSame) {
  const Path path{{0.25, 0.5, 0.3}, two_turns(1)};
  Path far = path;
  far.start.x += 1e6;
  far.start.y -= 1e6;
  const Surroundings things{.bounds = {999900, 1000100, -1000100, -999900}};
  const auto world = std::make_shared<const World>(things, Point{far.start.x, far.start.y});
  const Problem problem = make_problem(world, truck(), far.start, end_pose(far));
  const DriveResult there = drive(problem, far, {.noise = 1, .keep_log = true});
  const DriveResult here = driven(path, {.noise = 1, .keep_log = true});
  EXPECT_EQ(there.largest_lateral, here.largest_lateral);
  EXPECT_NEAR(there.log.back().pose.x - 1e6, here.log.back().pose.x, 1e-6);
}

TEST(Drive, AJerkLimitIsFollowed) {
  Vehicle vehicle = truck();
  vehicle.limits.max_jerk = 1.0;
  const DriveResult result = driven(there_and_back(), {}, {}, vehicle);
  EXPECT_TRUE(result.has_arrived);
  EXPECT_NEAR(result.duration, result.planned_duration, 1);
  EXPECT_LT(result.largest_lateral, 3e-3);
}

TEST(Drive, APathWithoutLengthIsDriven) {
  const DriveResult result = driven({{1, 2, 3}, {}});
  EXPECT_TRUE(result.has_arrived);
  EXPECT_EQ(result.duration, 0);
  EXPECT_EQ(result.end_distance, 0);
}

std::string complaint(const Path& path, const DriveOptions& options) {
  try {
    (void)driven(path, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Drive, SaysWhatItCannotDo) {
  const Path line{{0, 0, 0}, {{0, 2}, {0, -1.25}}};
  EXPECT_EQ(complaint(line, {.controller = "stanley"}),
            "controller: stanley drives forward only, the path has 1.25 m in reverse");
  EXPECT_EQ(
      complaint(line, {.controller = "hope"}),
      "controller: \"hope\" is unknown, expected one of rear-axle-feedback, lqr, pure-pursuit, "
      "stanley");
  EXPECT_EQ(complaint(line, {.noise = -1}), "noise: is -1, expected 0 to 10");
  EXPECT_EQ(complaint(line, {.noise = std::nan("")}), "noise: is nan, expected 0 to 10");
  EXPECT_EQ(complaint(line, {.spare_steering = -1}), "spare_steering: is -1, expected 0 to 0.5");
  EXPECT_EQ(complaint(line, {.reserve = 1}), "reserve: is 1, expected 0 to 0.5");
  EXPECT_EQ(complaint(line, {.delay = 2}), "delay: is 2, expected 0 to 1 s");
  EXPECT_EQ(complaint({{0, 0, 0}, {{0, 2}, {0.2, 1}}}, {}),
            "segments[1].curvature: is 0.2, expected at most 1 / min_turning_radius, "
            "0.143");
  const Problem problem = problem_of({0, 0, 0}, {1, 0, 0}, {});
  EXPECT_THROW((void)drive(problem, {{0, 0, 0}, {{0, std::nan("")}}}), InputError);
  EXPECT_THROW((void)drive(problem, {{0, 0, 0}, {{std::nan(""), 1}}}), InputError);
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// A trailer is driven, steered in reverse and looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drive/watch.h"
#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/drive.h"
#include "vandplan/input_error.h"
#include "vandplan/random.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

/// A tractor with a semitrailer of 8.1 m from the hitch to its axle.
Vehicle rig() {
  Vehicle vehicle;
  vehicle.limits.max_curvature_rate = 0.1;
  vehicle.hitch = 0.3;
  vehicle.trailer = Trailer{};
  return vehicle;
}

Problem problem_of_rig(const Path& path, double hitch_angle, Surroundings things = {},
                       const Vehicle& vehicle = rig()) {
  things.bounds = wide_bounds;
  State end{path.start, hitch_angle};
  for (const Segment& segment : path.segments) end = advance(vehicle, end, segment);
  return make_problem(world_of(things), vehicle, path.start, end.pose, {},
                      {hitch_angle, end.hitch_angle});
}

/// Without a jump of the curvature: a turn to the left, and one to the right.
std::vector<Segment> two_bends(double gear) {
  return {{0, gear * 3, 0},    {0, gear, 0.1},    {0.1, gear * 6, 0},
          {0.1, gear, -0.1},   {0, gear * 2, 0},  {0, gear, -0.1},
          {-0.1, gear * 8, 0}, {-0.1, gear, 0.1}, {0, gear * 2.5, 0}};
}

const Path bends_there_and_back = [] {
  Path path{{1, 2, 0.3}, two_bends(1)};
  std::vector<Segment> back = two_bends(1);
  std::ranges::reverse(back);
  for (Segment& segment : back) {
    segment.curvature = curvature_at(segment, segment.length);
    segment.curvature_rate = -segment.curvature_rate;
    segment.length = -segment.length;
    path.segments.push_back(segment);
  }
  return path;
}();

TEST(Towing, WhoeverKnowsAllDrivesTheTrailerAsPlanned) {
  const Problem problem = problem_of_rig(bends_there_and_back, 0.2);
  const DriveResult result = drive(problem, bends_there_and_back, {.keep_log = true});
  EXPECT_TRUE(result.has_arrived);
  EXPECT_FALSE(result.contact);
  ASSERT_TRUE(result.trailer);
  EXPECT_LT(result.trailer->largest_lateral, 2e-3);
  EXPECT_LT(result.trailer->end_distance, 5e-3);
  EXPECT_LT(result.trailer->hitch_deviation, 1e-3);
  EXPECT_NEAR(result.log.front().hitch_angle.value(), 0.2, 1e-12);
  EXPECT_NEAR(result.log.back().hitch_angle.value(), 0.2, 1e-3);
}

// The tractor steers the trailer by swinging its front, which is what touches things first.
TEST(Towing, TheTractorHardlySwingsOutInReverse) {
  const Problem problem = problem_of_rig(bends_there_and_back, 0.0);
  DriveOptions options{.noise = 1.0, .delay = 0.1, .spare_steering = 0.1};
  double largest = 0.0;
  for (options.seed = 1; options.seed <= 20; ++options.seed) {
    largest = std::max(largest, drive(problem, bends_there_and_back, options).outline_deviation);
  }
  EXPECT_LT(largest, 0.12);  // it was 0.17
}

TEST(Towing, InReverseTheTrailerIsSteered) {
  for (const Path& path : {Path{{0, 0, 0}, {{0, -60}}}, bends_there_and_back}) {
    const Problem problem = problem_of_rig(path, 0.0);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const DriveResult result =
          drive(problem, path, {.noise = 1, .delay = 0.1, .spare_steering = 0.1, .seed = seed});
      EXPECT_TRUE(result.has_arrived);
      EXPECT_FALSE(result.contact);
      ASSERT_TRUE(result.trailer);
      EXPECT_LT(result.trailer->largest_lateral, 0.05);
      EXPECT_GT(result.trailer->largest_lateral, 1e-4);
      EXPECT_LE(result.trailer->rms_lateral, result.trailer->largest_lateral);
      EXPECT_LT(result.trailer->end_distance, 0.1);
      EXPECT_LT(result.largest_lateral, 0.2);
    }
  }
}

TEST(Towing, OthersFollowWithATrailerForwardOnly) {
  const Path ahead{{0, 0, 0}, two_bends(1)};
  const DriveResult result =
      drive(problem_of_rig(ahead, 0.0), ahead, {.controller = "rear-axle-feedback"});
  EXPECT_TRUE(result.has_arrived);
  EXPECT_LT(result.largest_lateral, 1e-3);
  const Path back{{0, 0, 0}, {{0, -10}}};
  try {
    (void)drive(problem_of_rig(back, 0.0), back, {.controller = "rear-axle-feedback"});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "controller");
    EXPECT_EQ(error.problem(),
              "rear-axle-feedback drives a trailer forward only, the path has 10 m in reverse");
  }
  EXPECT_EQ(usual_controller(rig()), "lqr");
}

TEST(Towing, WhatTheTrailerTouchesIsAContact) {
  const Path back{{0, 0, 0}, {{0, -10}}};
  const double rear = -rig().trailer->wheelbase - rig().trailer->rear_overhang + rig().hitch;
  const Problem problem =
      problem_of_rig(back, 0.0, {.obstacles = {box(rear - 6, -1, rear - 5, 1)}});
  const DriveResult result = drive(problem, back);
  ASSERT_TRUE(result.contact);
  EXPECT_EQ(result.contact->what, "the trailer's footprint hits obstacles[0]");
  EXPECT_NEAR(result.contact->s, 5, 0.05);
  EXPECT_EQ(result.clearance, 0);
  const ExecutableCheck check = executable(problem, back);
  EXPECT_FALSE(check.flowing.passes);
  EXPECT_NE(check.flowing.reason.find("the trailer's footprint hits obstacles[0]"),
            std::string::npos);
}

TEST(Towing, ATrailerIsExecutedWithItsAngle) {
  const Path ahead{{0, 0, 0}, {{0, 2}}};
  const Pose axle = trailer_pose(rig(), {ahead.start, 0.8});
  const Surroundings things{.obstacles = {box(axle.x - 0.1, axle.y - 0.1, axle.x, axle.y)}};
  const ExecutableCheck check = executable(problem_of_rig(ahead, 0.8, things), ahead);
  EXPECT_EQ(check.flowing.reason, "after 0.00 s the trailer's footprint hits obstacles[0]");
  EXPECT_TRUE(executable(problem_of_rig(ahead, 0.8), ahead).flowing.passes);
}

// Where the wheels turn while it drives on, the tractor ends a little beside its place; in reverse
// the trailer runs away from that.
TEST(Towing, ATrailerThatEndsElsewhereIsNotExecuted) {
  int beside = 0;
  for (double curvature = 0.02; curvature < 0.13; curvature *= 1.1) {
    const Path path{{0, 0, 0}, {{0, -1}, {curvature, -0.3}, {0, -25}}};
    const Execution flowing = executable(problem_of_rig(path, 0.0), path).flowing;
    if (flowing.passes || !flowing.reason.starts_with("the trailer ends")) continue;
    EXPECT_LE(flowing.end_distance, 0.01);
    ++beside;
  }
  EXPECT_GT(beside, 0);
}

TEST(Towing, TheClearanceIsThatOfBothBodies) {
  const Path ahead{{0, 0, 0}, {{0, 10}}};
  const double side = rig().trailer->width / 2 + 0.5;
  const Problem problem = problem_of_rig(ahead, 0.0, {.obstacles = {box(-9, side, -8, side + 1)}});
  const DriveResult result = drive(problem, ahead);
  EXPECT_FALSE(result.contact);
  EXPECT_NEAR(result.clearance, 0.5, 1e-3);
}

TEST(Towing, ARigThatFoldsUpTooFarTouchesItself) {
  Vehicle vehicle = rig();
  vehicle.max_hitch_angle = 0.5;
  const Path round{{0, 0, 0}, {{0.12, 15}}};
  State state{round.start, 0.0};
  double folded = 0.0;  // after so many metres
  while (state.hitch_angle <= vehicle.max_hitch_angle) {
    state = advance(vehicle, state, {0.12, 0.001});
    folded += 0.001;
  }
  Vehicle wider = vehicle;
  wider.max_hitch_angle = 3;  // which the end of the path needs
  const Path first{round.start, {{0.12, folded - 0.01}}};
  EXPECT_FALSE(drive(problem_of_rig(first, 0.0, {}, vehicle), first).contact);
  const Path more{round.start, {{0.12, folded + 3}, {-0.12, 7}}};
  State end{more.start, 0.0};
  for (const Segment& segment : more.segments) end = advance(vehicle, end, segment);
  const Problem problem = make_problem(world_of({.bounds = wide_bounds}), vehicle, more.start,
                                       end.pose, {}, {0.0, end.hitch_angle});
  const DriveResult result = drive(problem, more);
  ASSERT_TRUE(result.contact);
  EXPECT_EQ(result.contact->what, "the rig folds up (jackknife)");
  EXPECT_NEAR(result.contact->s, folded, 0.05);
  EXPECT_FALSE(drive(problem_of_rig(more, 0.0, {}, wider), more).contact);
}

TEST(Towing, ALessHitchAngleThanAllowedKeepsFromFoldingUp) {
  // A path that uses all of its limit, and what noise adds to that.
  Vehicle vehicle = rig();
  const Path path = bends_there_and_back;
  double most = 0.0;
  State state{path.start, 0.0};
  for (const Segment& segment : path.segments) {
    most = std::max(most, largest_hitch_angle(vehicle, state.hitch_angle, segment));
    state = advance(vehicle, state, segment);
  }
  const DriveOptions options{.noise = 1, .delay = 0.1, .spare_steering = 0.1, .seed = 3};
  const double spare = 1 + options.spare_steering;  // the rig folds up so much further
  vehicle.max_hitch_angle = most / spare;
  const DriveResult tight = drive(problem_of_rig(path, 0.0, {}, vehicle), path, options);
  ASSERT_TRUE(tight.contact);
  vehicle.max_hitch_angle = (most + tight.trailer->hitch_deviation) / spare;
  EXPECT_FALSE(drive(problem_of_rig(path, 0.0, {}, vehicle), path, options).contact);
}

TEST(Towing, OnlyATrailerHasAnAngle) {
  const Path ahead{{0, 0, 0}, {{0, 3}}};
  const DriveResult alone =
      drive(problem_of_path({.bounds = wide_bounds}, ahead), ahead, {.keep_log = true});
  EXPECT_FALSE(alone.trailer);
  EXPECT_FALSE(alone.log.back().hitch_angle);
}

// The rear of this trailer moves more than twice as fast as its tractor.
TEST(Watch, OverlooksNothingThatATrailerTouches) {
  Vehicle vehicle = rig();
  vehicle.trailer->wheelbase = 4;
  vehicle.trailer->rear_overhang = 10;
  int touched = 0;
  for_each_case(11, 2000, [&](Rng& rng) {
    std::vector<Polygon> boxes;
    const State start{{0, 0, 0}, uniform(-1.2, 1.2, rng)};
    const Pose rear = compose(trailer_pose(vehicle, start), {-10, 0, 0});
    for (int i = 0; i < 3; ++i) {
      const double x = rear.x + uniform(-5, 5, rng);
      const double y = rear.y + uniform(-5, 5, rng);
      boxes.push_back(box(x, y, x + uniform(0.05, 3, rng), y + uniform(0.05, 3, rng)));
    }
    const Path none{{0, 0, 0}, {}};
    const Problem problem = problem_of_rig(none, 0.0, {.obstacles = boxes}, vehicle);
    driving::Watch watch(problem);
    State state = start;
    bool has_said = watch.look(state, {}, state).has_value();
    for (int i = 0; i < 400; ++i) {
      const double curvature = uniform(-0.1, 0.1, rng) / vehicle.min_turning_radius;
      const Segment arc{curvature, (i % 100 < 50 ? 1 : -1) * uniform(0.0, 0.05, rng)};
      const State to = advance(vehicle, state, arc);
      has_said = has_said || watch.look(state, arc, to).has_value();
      state = to;
      if (problem.task().checker->clearance(Local(state), 1.0) > 0.0) continue;
      ++touched;
      EXPECT_TRUE(has_said);
      return;
    }
  });
  EXPECT_GT(touched, 20);
}

}  // namespace
}  // namespace vandplan

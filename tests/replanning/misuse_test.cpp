// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What do public functions say to nonsense?

#include <gtest/gtest.h>

#include <cmath>

#include "support/numbers.h"
#include "support/place_of_error.h"
#include "support/problems.h"
#include "vandplan/planner.h"
#include "vandplan/replanner.h"

namespace vandplan {
namespace {

Scenario open_ground() {
  Scenario scenario;
  scenario.bounds = {-50, 50, -50, 50};
  scenario.goal = {20, 0, 0};
  return scenario;
}

/// A scenario whose goal lies inside an obstacle.
Scenario built_over() {
  Scenario scenario = open_ground();
  scenario.obstacles = {{{15, -5}, {30, -5}, {30, 5}, {15, 5}}};
  return scenario;
}

TEST(Misuse, APlannerWithoutAFunctionIsRefused) {
  const Problem problem = make_problem(open_ground());
  EXPECT_EQ(place_of_error([&] { (void)plan(problem, Planner{.name = "empty", .summary = ""}); }),
            "planner");
}

TEST(Misuse, AProblemThatNobodyMadeIsRefused) {
  const Problem none;
  EXPECT_EQ(place_of_error([&] { (void)plan(none); }), "problem");
  EXPECT_EQ(place_of_error([&] { (void)with_moving(none, {}); }), "problem");
  EXPECT_EQ(place_of_error([&] { (void)task_of(none, {}); }), "problem");
  EXPECT_EQ(place_of_error([&] { (void)with_poses(none, {}, {}); }), "world");
  EXPECT_EQ(place_of_error([&] { (void)make_problem(nullptr, {}, {}, {}); }), "world");
}

TEST(Misuse, AnOwnOptionThatIsNotThereIsNamed) {
  PlannerSettings settings;
  settings.set("parts", std::int64_t{3});
  EXPECT_EQ(settings.integer("parts"), 3);
  EXPECT_EQ(place_of_error([&] { (void)settings.integer("part"); }), "part");
  EXPECT_EQ(place_of_error([&] { (void)settings.number("parts"); }), "parts");
  EXPECT_EQ(place_of_error([&] { (void)settings.flag("part"); }), "part");
  EXPECT_EQ(place_of_error([&] { (void)settings.word("part"); }), "part");
}

TEST(Misuse, SpeedsThatAreNoneAreRefused) {
  const Path path{{}, {{0, 10}}};
  const SpeedProfile profile = speed_profile(path, {});
  EXPECT_EQ(place_of_error([&] { (void)motion_at(path, {}, {}, 0.0); }), "profile");
  EXPECT_EQ(place_of_error([&] { (void)motion_at(path, {}, profile, nan); }), "t");
  EXPECT_EQ(place_of_error([&] { (void)sampled(path, {}, {}, 0.1); }), "profile");
  for (const double step : {0.0, -1.0, nan, 1e-300}) {
    EXPECT_EQ(place_of_error([&] { (void)sampled(path, {}, profile, step); }), "step") << step;
  }
  EXPECT_EQ(sampled(path, {}, profile, infinity).size(), 2U);
}

TEST(Misuse, AnAnswerBeforeTheFirstTickHasNoAction) {
  const Replanner replanner(open_ground());
  EXPECT_EQ(place_of_error([&] { (void)action_at(replanner.answer(), {}, 0.0); }), "answer");
}

TEST(Misuse, AReplannerRefusesTimesThatCannotBe) {
  Replanner replanner(open_ground());
  EXPECT_EQ(place_of_error([&] { (void)replanner.tick(nan); }), "t");
  EXPECT_EQ(replanner.tick(1.0).outcome, TickOutcome::new_way);
  for (const double t : {0.9, nan, infinity}) {
    EXPECT_EQ(place_of_error([&] { (void)replanner.tick(t); }), "t") << t;
  }
  EXPECT_EQ(replanner.tick(1.0).outcome, TickOutcome::kept);
}

TEST(Misuse, AReplannerRefusesLimitsThatCannotBe) {
  Replanner replanner(open_ground());
  for (const double limit : {-1.0, nan}) {
    EXPECT_EQ(place_of_error([&] { (void)replanner.tick(0.0, {.time_limit = limit}); }),
              "time_limit");
  }
  EXPECT_FALSE(replanner.answer().drive);
}

// One bad measurement, and the next tick goes on as if it had not been.
TEST(Misuse, AReplannerForgetsStatesThatCannotBe) {
  Replanner replanner(open_ground());
  (void)replanner.tick(0.0);
  const auto drive = replanner.answer().drive;
  for (const VehicleState& state :
       {VehicleState{.pose = {nan, 0, 0}}, VehicleState{.pose = {0, 0, infinity}},
        VehicleState{.pose = {1e300, 0, 0}}, VehicleState{.v = nan}, VehicleState{.v = 1e9},
        VehicleState{.curvature = nan}}) {
    EXPECT_TRUE(place_of_error([&] { (void)replanner.tick(0.1, state); }).starts_with("state."));
    EXPECT_EQ(replanner.answer().drive, drive);
  }
  const ReplanAnswer answer = replanner.tick(0.1);
  EXPECT_TRUE(answer.is_safe);
  EXPECT_TRUE(answer.reaches_goal);
}

TEST(Misuse, AReplannerSaysWhyAGoalIsNotReached) {
  Replanner replanner(built_over());
  for (const double t : {0.0, 0.1}) {
    const ReplanAnswer answer = replanner.tick(t);
    EXPECT_FALSE(answer.reaches_goal);
    EXPECT_TRUE(answer.is_safe);
    EXPECT_EQ(answer.reason.find("the goal cannot be reached: the footprint "), 0U)
        << answer.reason;
  }
}

}  // namespace
}  // namespace vandplan

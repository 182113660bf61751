// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// The judge holds a path to the goal of a set that it ends at.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "support/cases.h"
#include "support/draws.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using std::numbers::pi;

Problem with_set(const std::vector<GoalRegion>& set, const Vehicle& vehicle = {}) {
  return make_problem({.vehicle = vehicle, .bounds = wide_bounds, .goal_set = set});
}

/// So many metres ahead.
Path metres_ahead(double metres) { return {{}, {{0.0, metres}}}; }

GoalRegion strip(Interval x, HeadingRange heading = {}) {
  return {.x = x, .y = {-1, 1}, .heading = heading};
}

TEST(JudgeOfGoals, HoldsPlacesToTheirIntervals) {
  const Problem problem = with_set({strip({10, 12})});
  for (const double metres : {10 - 0.9e-6, 10.0, 11.0, 12.0, 12 + 0.9e-6}) {
    EXPECT_TRUE(check_path(problem, metres_ahead(metres)).valid) << metres;
  }
  for (const double metres : {9.999, 10 - 1.1e-6, 12 + 1.1e-6, 12.001}) {
    const PathCheck check = check_path(problem, metres_ahead(metres));
    EXPECT_FALSE(check.valid) << metres;
    EXPECT_NE(check.reason.find("the path ends"), std::string::npos) << check.reason;
    EXPECT_FALSE(check.goal);
  }
}

TEST(JudgeOfGoals, HoldsHeadingsToTheirRange) {
  const auto is_valid = [](const HeadingRange& range, bool either_way = false) {
    GoalRegion region = strip({10, 12}, range);
    region.either_way = either_way;
    return check_path(with_set({region}), metres_ahead(11)).valid;
  };
  EXPECT_TRUE(is_valid(any_heading));
  EXPECT_TRUE(is_valid({-0.1, 0.1}));
  EXPECT_TRUE(is_valid({0, 0.1}));
  EXPECT_TRUE(is_valid({-0.1, 0}));
  EXPECT_TRUE(is_valid({6.2, 0.1}));                     // through 0, counter-clockwise
  EXPECT_TRUE(is_valid({6.2 + 8 * pi, 0.1 + 10 * pi}));  // whole turns do not count
  EXPECT_FALSE(is_valid({0.1, 6.2}));                    // all but what is around 0
  EXPECT_FALSE(is_valid({0.001, 0.1}));
  EXPECT_FALSE(is_valid({pi - 0.1, pi + 0.1}));
  EXPECT_TRUE(is_valid({pi - 0.1, pi + 0.1}, true));
  EXPECT_TRUE(is_valid({pi, pi}, true));
  EXPECT_FALSE(is_valid({pi / 2, pi / 2}, true));
}

TEST(JudgeOfGoals, HoldsPlacesToAreas) {
  const Polygon notched = {{8, -4}, {16, -4}, {16, 4}, {12, -2}, {8, 4}};
  for (const bool is_reversed : {false, true}) {
    GoalRegion region{.area = notched, .heading = any_heading};
    if (is_reversed) region.area = {notched.rbegin(), notched.rend()};
    const Problem problem = with_set({region});
    // The line y = 0 enters the area at 8, leaves it where the notch begins, 8 + 4 * 4 / 6.
    const double notch = 8 + 4.0 * 4 / 6;
    const double beyond = 12 + 4.0 * 2 / 6;
    for (const double in : {8.0, 9.0, notch - 1e-4, beyond + 1e-4, 16.0}) {
      EXPECT_TRUE(check_path(problem, metres_ahead(in)).valid) << in;
    }
    for (const double out : {7.999, notch + 1e-4, 12.0, beyond - 1e-4, 16.001}) {
      EXPECT_FALSE(check_path(problem, metres_ahead(out)).valid) << out;
    }
  }
}

TEST(JudgeOfGoals, SaysWhichGoalItIs) {
  const Problem problem =
      with_set({region_of_pose({5, 0, 0}), strip({10, 12}), strip({11, 13}), strip({20, 21})});
  EXPECT_EQ(check_path(problem, metres_ahead(5)).goal->index, 0U);
  EXPECT_EQ(check_path(problem, metres_ahead(11.5)).goal->index, 1U);  // the first one that fits
  EXPECT_EQ(check_path(problem, metres_ahead(12.5)).goal->index, 2U);
  EXPECT_EQ(check_path(problem, metres_ahead(20.5)).goal->index, 3U);
  EXPECT_NEAR(check_path(problem, metres_ahead(20.5)).goal->pose.x, 20.5, 1e-9);
  // Somebody says which one it is.
  const auto claimed = [&](double metres, std::size_t index, const Pose& pose) {
    return check_path(problem, metres_ahead(metres), {.goal = ReachedGoal{index, pose}}).valid;
  };
  EXPECT_TRUE(claimed(11.5, 2, {11.5, 0, 0}));
  EXPECT_TRUE(claimed(11.5, 1, {11.5, 0, 2 * pi}));
  EXPECT_FALSE(claimed(11.5, 3, {11.5, 0, 0}));
  EXPECT_FALSE(claimed(11.5, 1, {11.4, 0, 0}));
  EXPECT_FALSE(claimed(11.5, 1, {11.5, 0, 0.1}));
}

TEST(JudgeOfGoals, HoldsWheelsToTheGoalTheyStandAt) {
  GoalRegion straight = strip({10, 12});
  GoalRegion turned = strip({10, 12});
  turned.curvature = 0.1;
  const PathClaims throughout{.steering = Steering::continuous};
  const Path path = metres_ahead(11);
  EXPECT_FALSE(check_path(with_set({turned}), path, throughout).valid);
  EXPECT_TRUE(check_path(with_set({turned}), path).valid);
  const PathCheck check = check_path(with_set({turned, straight}), path, throughout);
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_EQ(check.goal->index, 1U);
}

TEST(JudgeOfGoals, HoldsTheLastStretchToALine) {
  GoalRegion dock = region_of_pose({11, 0, 0});
  dock.straight = 8;
  const auto check = [&](const std::vector<Segment>& segments) {
    const Path path{{}, segments};
    GoalRegion at_end = region_of_pose(end_pose(path));
    at_end.straight = dock.straight;
    return check_path(with_set({at_end}), path);
  };
  EXPECT_TRUE(check({{0.0, 11.0}}).valid);
  EXPECT_TRUE(check({{0.1, 3.0}, {0.0, 8.0}}).valid);
  EXPECT_TRUE(check({{0.1, 3.0}, {0.0, 3.0}, {0.0, 5.0 - 0.9e-6}}).valid);
  EXPECT_TRUE(check({{0.1, 3.0}, {0.0, -8.0}}).valid);
  EXPECT_TRUE(check({{0.0, 3.0}, {0.0, -8.0}}).valid);
  EXPECT_FALSE(check({{0.1, 3.0}, {0.0, 7.99}}).valid);
  EXPECT_FALSE(check({{0.0, -3.0}, {0.0, 5.0}}).valid);  // changes gear on the line
  EXPECT_FALSE(check({{0.0, 8.0}, {0.1, 0.001}}).valid);
  EXPECT_FALSE(check({{0.0, 8.0}, {0.0, 4.0, 1e-4}}).valid);  // the wheels turn
  EXPECT_FALSE(check({}).valid);
  EXPECT_EQ(check({{0.1, 3.0}, {0.0, 5.0}}).reason,
            "the last 5.00001 m before the goal are straight and in one gear, expected 8 m");
  // Another goal of the set asks for less.
  const Path path{{}, {{0.0, 11.0}}};
  GoalRegion longer = region_of_pose({11, 0, 0});
  longer.straight = 12;
  EXPECT_EQ(check_path(with_set({longer, dock}), path).goal->index, 1U);
}

TEST(JudgeOfGoals, HoldsTrailersToTheirRegions) {
  const Vehicle rig = semitrailer();
  const Path path{{}, {{0.0, 6.0}, {0.1, 5.0}}};
  State end{};
  for (const Segment& segment : path.segments) end = advance(rig, end, segment);
  const Pose axle = trailer_pose(rig, end);
  const auto is_valid = [&](double off, Interval angles, bool is_of_trailer) {
    const Pose& pose = is_of_trailer ? axle : end.pose;
    GoalRegion region = region_of_pose(pose);
    region.x = {pose.x + off, pose.x + off + 1};
    region.hitch_angle = angles;
    region.is_of_trailer = is_of_trailer;
    return check_path(with_set({region}, rig), path).valid;
  };
  for (const bool is_of_trailer : {false, true}) {
    EXPECT_TRUE(is_valid(-0.5, {0, 1}, is_of_trailer));
    EXPECT_TRUE(is_valid(-0.5, {end.hitch_angle, end.hitch_angle}, is_of_trailer));
    EXPECT_FALSE(is_valid(-0.5, {end.hitch_angle + 1e-3, 1}, is_of_trailer));
    EXPECT_FALSE(is_valid(-0.5, {-1, end.hitch_angle - 1e-3}, is_of_trailer));
    EXPECT_FALSE(is_valid(1e-3, {0, 1}, is_of_trailer));
  }
}

TEST(JudgeOfGoals, AllowsATrailerToPointALittleBeside) {
  const Vehicle rig = semitrailer();
  const Pose axle = trailer_pose(rig, {{20, 0, 0}, 0});
  GoalRegion bay = region_of_pose({axle.x, axle.y, 5e-7});
  bay.is_of_trailer = true;
  const PathCheck check = check_path(with_set({bay}, rig), metres_ahead(20));
  EXPECT_TRUE(check.valid) << check.reason;
  bay.heading = {2e-6, 2e-6};
  EXPECT_FALSE(check_path(with_set({bay}, rig), metres_ahead(20)).valid);
}

TEST(JudgeOfGoals, HoldsPathsToTheSamePlacesWhereverTheOriginIs) {
  for (const double far : {0.0, 1e5, 1e8}) {
    GoalRegion region{.area = {{far + 10, -1}, {far + 12, -1}, {far + 12, 1}, {far + 10, 1}},
                      .heading = any_heading};
    Scenario scenario{.bounds = {far - 50, far + 50, -50, 50}, .start = {far, 0, 0}};
    scenario.goal_set = {region, strip({far + 20, far + 22})};
    const Problem problem = make_problem(scenario);
    const auto from_there = [&](double metres) { return Path{{far, 0, 0}, {{0.0, metres}}}; };
    EXPECT_EQ(check_path(problem, from_there(11)).goal->index, 0U);
    EXPECT_EQ(check_path(problem, from_there(21)).goal->index, 1U);
    EXPECT_NEAR(check_path(problem, from_there(21)).goal->pose.x, far + 21, 1e-6);
    EXPECT_FALSE(check_path(problem, from_there(15)).valid);
  }
}

}  // namespace
}  // namespace vandplan

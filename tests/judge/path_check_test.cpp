// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "support/numbers.h"
#include "vandplan/judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "support/grids.h"
#include "support/problems.h"

namespace vandplan {
namespace {

// The default truck: from 1.6 m behind the rear axle to 5.9 m before it, 1.275 m to either side,
// turning radius 7 m.
using std::numbers::pi;

/// Ten metres straight ahead from the origin.
const Path ahead{{0, 0, 0}, {{0, 10}}};
const Pose ten_ahead{10, 0, 0};

PathCheck check_ahead(const std::vector<Polygon>& obstacles) {
  return check_path(problem_of({0, 0, 0}, ten_ahead, obstacles), ahead, {});
}

PathCheck check_open(const Path& path, const Pose& goal, const PathClaims& claims = {}) {
  return check_path(problem_of({0, 0, 0}, goal, {}), path, claims);
}

TEST(PathCheck, StraightPathOnOpenGroundIsValid) {
  const PathCheck check = check_ahead({});
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_EQ(check.reason, "");
  EXPECT_FALSE(check.at);
  EXPECT_DOUBLE_EQ(check.length, 10);
  EXPECT_EQ(check.gear_changes, 0);
  EXPECT_EQ(check.clearance, infinity);
}

// ---- the gears that are claimed ----

TEST(ClaimedGears, AMillimetreInAnotherOneIsAFault) {
  const Path path{{0, 0, 0}, {{0, 5}, {0, -0.001}, {0, 5.001}}};
  EXPECT_TRUE(check_open(path, ten_ahead).valid);
  const PathCheck check = check_open(path, ten_ahead, {.gears = AllowedGears::forward});
  EXPECT_EQ(check.reason, "the vehicle is driven in reverse, the allowed gears are: forward");
  ASSERT_TRUE(check.at);
  EXPECT_NEAR(check.at->s, 5, 1e-9);
  const PathCheck other = check_open(path, ten_ahead, {.gears = AllowedGears::reverse});
  EXPECT_EQ(other.reason, "the vehicle is driven forward, the allowed gears are: reverse");
  EXPECT_NEAR(other.at->s, 0, 1e-9);
}

TEST(ClaimedGears, ASegmentOfNoLengthIsNotDriven) {
  const Path path{{0, 0, 0}, {{0, 10}, {0.1, -0.0}}};
  EXPECT_TRUE(check_open(path, ten_ahead, {.gears = AllowedGears::forward}).valid);
}

// ---- the margin that is claimed ----

/// Beside the way ahead, and so far to the left of it.
Polygon wall_beside(double gap) {
  return {{-50, 1.275 + gap}, {50, 1.275 + gap}, {50, 9}, {-50, 9}};
}

std::string reason_of_margin(const std::vector<Polygon>& obstacles,
                             const ClearanceOptions& margin) {
  const Problem problem = problem_of({0, 0, 0}, ten_ahead, obstacles);
  return check_path(problem, ahead, {.clearance = margin}).reason;
}

TEST(PathCheck, AMarginIsKeptEverywhere) {
  EXPECT_EQ(reason_of_margin({wall_beside(0.3)}, {.margin = 0.3}), "");
  EXPECT_EQ(reason_of_margin({wall_beside(0.2994)}, {.margin = 0.3}),
            "the footprint is only 0.299 m from obstacles[0], the margin is 0.3 m");
  // The wall touches nothing, the posts do, one after the other.
  const Polygon near_post{{12, 1.5}, {13, 1.5}, {13, 2}, {12, 2}};
  const Polygon nearer_post{{14, 1.4}, {15, 1.4}, {15, 2}, {14, 2}};
  const Problem problem =
      problem_of({0, 0, 0}, ten_ahead, {wall_beside(1), near_post, nearer_post});
  const PathCheck check = check_path(problem, ahead, {.clearance = {.margin = 0.5}});
  EXPECT_EQ(check.reason, "the footprint is only 0.500 m from obstacles[1], the margin is 0.5 m");
  ASSERT_TRUE(check.at);
  EXPECT_NEAR(check.at->s, 12 - 5.9 - std::sqrt(0.5 * 0.5 - 0.225 * 0.225), 2e-3);
  EXPECT_NEAR(*check.clearance, 0.125, 1e-3);
}

TEST(PathCheck, TheMarginOfKerbsIsKeptByTheWheels) {
  // The front overhang swings over the kerb, and stays 0.4 m behind its far side.
  const Surroundings yard{.bounds = wide_bounds, .kerbs = {{{15, -5}, {16, -5}, {16, 5}, {15, 5}}}};
  const Problem problem = problem_in(yard, {0, 0, 0}, ten_ahead);
  EXPECT_EQ(check_path(problem, ahead, {.clearance = {.margin = 0.49}}).reason, "");
  EXPECT_EQ(check_path(problem, ahead, {.clearance = {.margin = 0.51}}).reason,
            "the wheels are only 0.510 m from kerbs[0], the margin is 0.51 m");
}

TEST(PathCheck, AroundAnEndThatIsNearerTheMarginGrowsWithTheWay) {
  // Beside the start only: 0.1 m there, and from x = -1.6 - 0.001 on 0.1 + 0.2 * 5 / 10 are asked.
  const auto block_to = [](double x) { return Polygon{{-9, 1.375}, {x, 1.375}, {x, 2}, {-9, 2}}; };
  EXPECT_EQ(reason_of_margin({block_to(-1.7)}, {.margin = 0.3, .margin_ramp = 10}), "");
  EXPECT_EQ(reason_of_margin({block_to(-1.7)}, {.margin = 0.3, .margin_ramp = 0}),
            "the footprint is only 0.141 m from obstacles[0], the margin is 0.3 m");
  // Driving along it nothing is gained, and more is asked for with each metre.
  EXPECT_EQ(
      reason_of_margin({block_to(0)}, {.margin = 0.3, .margin_ramp = 10}),
      "the footprint is only 0.100 m from obstacles[0], the ramp of the margin asks for 0.100 m");
}

TEST(PathCheck, QuarterCirclesEndWhereGeometrySays) {
  // Left forward, then right in reverse: the rear axle draws an S of two quarter circles.
  const Path path{{0, 0, 0}, {{1.0 / 7, 7 * pi / 2}, {-1.0 / 7, -7 * pi / 2}}};
  const PathCheck check = check_open(path, {14, 0, pi}, {7 * pi, 1});
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_DOUBLE_EQ(check.length, 7 * pi);
  EXPECT_EQ(check.gear_changes, 1);
}

TEST(PathCheck, FullCircleEndsAtItsStart) {
  const PathCheck check = check_open({{0, 0, 0}, {{-1.0 / 7, -14 * pi}}}, {0, 0, 2 * pi});
  EXPECT_TRUE(check.valid) << check.reason;
}

TEST(PathCheck, EmptyPathIsValidWhereStartIsGoal) {
  EXPECT_TRUE(check_open({{0, 0, 0}, {}}, {0, 0, 0}).valid);
  EXPECT_FALSE(check_open({{0, 0, 0}, {}}, {1, 0, 0}).valid);
}

TEST(PathCheck, EmptyPathIsLookedAt) {
  const Problem problem = problem_of({0, 0, 0}, {0, 0, 0}, {box(5, -1, 7, 1)});
  EXPECT_EQ(check_path(problem, {{0, 0, 0}, {}}, {}).reason, "the footprint hits obstacles[0]");
}

TEST(PathCheck, SegmentsOfLengthZeroAreNoGearChange) {
  const Path path{{0, 0, 0}, {{0, 5}, {0.1, 0}, {0, -0.0}, {0, 5}}};
  EXPECT_TRUE(check_open(path, ten_ahead, {10, 0}).valid);
}

// ---- numbers, start and goal ----

TEST(PathCheck, NumbersThatAreNotFiniteAreNamed) {
  EXPECT_EQ(check_open({{nan, 0, 0}, {{0, 10}}}, ten_ahead).reason,
            "the start of the path is not finite");
  EXPECT_EQ(check_open({{0, 0, infinity}, {{0, 10}}}, ten_ahead).reason,
            "the start of the path is not finite");
  EXPECT_EQ(check_open({{0, 0, 0}, {{0, 10}, {nan, 0}}}, ten_ahead).reason,
            "segments[1] is not finite");
  EXPECT_EQ(check_open({{0, 0, 0}, {{0, -infinity}}}, ten_ahead).reason,
            "segments[0] is not finite");
}

TEST(PathCheck, WrongStartIsSeenAtTwoMicrometres) {
  EXPECT_TRUE(check_open({{5e-7, 0, 0}, {{0, 10}}}, ten_ahead).valid);
  const PathCheck check = check_open({{-2e-6, 0, 0}, {{0, 10 + 2e-6}}}, ten_ahead);
  EXPECT_EQ(check.reason, "the path begins 2e-06 m and 0 rad away");
  ASSERT_TRUE(check.at);
  EXPECT_EQ(check.at->s, 0);
  EXPECT_FALSE(check_open({{0, 0, 2e-6}, {}}, {0, 0, 0}).valid);
}

TEST(PathCheck, WrongGoalIsSeenAtTwoMicrometresAndMicroradians) {
  EXPECT_TRUE(check_open(ahead, {10, 5e-7, 5e-7}).valid);
  const PathCheck check = check_open(ahead, {10, 2e-6, 0});
  EXPECT_EQ(check.reason, "the path ends 2e-06 m and 0 rad away");
  ASSERT_TRUE(check.at);
  EXPECT_EQ(check.at->s, 10);
  EXPECT_EQ(check.at->pose, ten_ahead);
  EXPECT_FALSE(check_open(ahead, {10, 0, -2e-6}).valid);
  EXPECT_FALSE(check_open(ahead, {10, 0, pi}).valid);
}

TEST(PathCheck, HeadingOfTheGoalCountsModuloFullTurns) {
  EXPECT_TRUE(check_open(ahead, {10, 0, 2 * pi}).valid);
  const Path half_turn{{0, 0, 0}, {{1.0 / 7, 7 * pi}}};
  EXPECT_TRUE(check_open(half_turn, {0, 14, pi}).valid);
  EXPECT_TRUE(check_open(half_turn, {0, 14, -pi}).valid);
}

// ---- curvature ----

TEST(PathCheck, CurvatureTighterThanTheTurningRadiusIsRejected) {
  const auto quarter = [](double radius) {
    return Path{{0, 0, 0}, {{0, 3}, {-1 / radius, radius * pi / 2}}};
  };
  EXPECT_TRUE(check_open(quarter(7), {10, -7, -pi / 2}).valid);
  const double tight = 7 * (1 - 1e-6);
  const PathCheck check = check_open(quarter(tight), {3 + tight, -tight, -pi / 2});
  EXPECT_EQ(check.reason,
            "curvature -0.1428572857 is tighter than the turning radius of 7 m allows");
  ASSERT_TRUE(check.at);
  EXPECT_DOUBLE_EQ(check.at->s, 3);
}

// ---- bounds ----

TEST(PathCheck, BoundsAreClosed) {
  const Problem problem = problem_of({0, 0, 0}, ten_ahead, {}, {0, 10, 0, 0.001});
  EXPECT_TRUE(check_path(problem, ahead, {}).valid);
}

TEST(PathCheck, EndBeyondTheBoundsIsRejected) {
  const Problem problem = problem_of({0, 0, 0}, ten_ahead, {}, {-1, 9.999, -1, 1});
  const PathCheck check = check_path(problem, ahead, {});
  EXPECT_EQ(check.reason, "the rear axle is 0.001 m outside the bounds");
  ASSERT_TRUE(check.at);
  EXPECT_EQ(check.at->s, 10);
}

TEST(PathCheck, BulgeOfAnArcBeyondTheBoundsIsRejected) {
  // Half a turn from heading -45 degrees dips 7 (1 - cos 45 degrees) below its start and goal.
  const double dip = 7 * (1 - std::sqrt(0.5));
  const Path path{{0, 0, -pi / 4}, {{1.0 / 7, 7 * pi / 2}}};
  const Pose goal{7 * std::sqrt(2.0), 0, pi / 4};
  const auto bounds = [&](double slack) { return Bounds{-20, 20, -dip - slack, 20}; };
  const Problem roomy = problem_of(path.start, goal, {}, bounds(1e-6));
  EXPECT_TRUE(check_path(roomy, path, {}).valid);
  const Problem tight = problem_of(path.start, goal, {}, bounds(-1e-6));
  const PathCheck check = check_path(tight, path, {});
  EXPECT_EQ(check.reason, "the rear axle is 1e-06 m outside the bounds");
  ASSERT_TRUE(check.at);
  EXPECT_NEAR(check.at->s, 7 * pi / 4, 1e-9);
  EXPECT_NEAR(check.at->pose.y, -dip, 1e-9);
}

TEST(PathCheck, EverySideOfTheBoundsHolds) {
  // A circle around the origin, driven either way in either gear.
  for (const double curvature : {-1.0 / 7, 1.0 / 7}) {
    for (const double length : {-14 * pi, 14 * pi}) {
      const Pose start{4.2, curvature > 0 ? -5.6 : 5.6, std::atan(0.75) * (curvature > 0 ? 1 : -1)};
      const auto stays_in = [&](const Bounds& bounds) {
        const Problem problem = problem_of(start, start, {}, bounds);
        return check_path(problem, {start, {{curvature, length}}}, {}).valid;
      };
      EXPECT_TRUE(stays_in({-7, 7, -7, 7}));
      EXPECT_FALSE(stays_in({-7 + 1e-6, 7, -7, 7}));
      EXPECT_FALSE(stays_in({-7, 7 - 1e-6, -7, 7}));
      EXPECT_FALSE(stays_in({-7, 7, -7 + 1e-6, 7}));
      EXPECT_FALSE(stays_in({-7, 7, -7, 7 - 1e-6}));
    }
  }
}

TEST(PathCheck, EndlessPathsEndQuickly) {
  EXPECT_FALSE(check_open({{0, 0, 0}, {{0, 1e300}}}, ten_ahead).valid);
  EXPECT_FALSE(check_open({{0, 0, 0}, {{1e-300, 1e300}}}, ten_ahead).valid);
  // Round and round, with an obstacle to look at.
  const Problem problem = problem_of({0, 0, 0}, ten_ahead, {box(30, 30, 31, 31)});
  EXPECT_FALSE(check_path(problem, {{0, 0, 0}, {{0.1, 1e300}, {0.1, 1e15}}}, {}).valid);
}

// ---- claims ----

TEST(PathCheck, FalseClaimsAreRejected) {
  EXPECT_TRUE(check_open(ahead, ten_ahead, {10, 0}).valid);
  EXPECT_TRUE(check_open(ahead, ten_ahead, {10 + 5e-7, 0}).valid);
  EXPECT_EQ(check_open(ahead, ten_ahead, {10.5, 0}).reason,
            "the stated length is 10.5 m, the path is 10 m long");
  EXPECT_FALSE(check_open(ahead, ten_ahead, {10 + 2e-6, {}}).valid);
  EXPECT_FALSE(check_open(ahead, ten_ahead, {nan, {}}).valid);
  EXPECT_EQ(check_open(ahead, ten_ahead, {10, 1}).reason,
            "the stated gear changes are 1, the path has 0");
}

using Poses = std::vector<StatedPose>;

Poses true_poses(const Path& path) {
  Poses poses;
  for (const auto& [s, pose, curvature, gear] : sampled(path, 0.1)) {
    poses.push_back({s, pose, curvature, gear});
  }
  return poses;
}

/// What the judge says about the poses that are stated for a left turn and the way back.
std::string complaint_about(const std::function<void(Poses&)>& spoil) {
  const Path path{{0, 0, 0}, {{1.0 / 7, 3}, {0, -1}}};
  PathClaims claims{.poses = true_poses(path)};
  spoil(claims.poses);
  const PathCheck check = check_open(path, end_pose(path), claims);
  EXPECT_EQ(check.valid, check.reason.empty());
  return check.reason;
}

TEST(PathCheck, FalsePosesAreRejected) {
  EXPECT_EQ(complaint_about([](Poses&) {}), "");
  EXPECT_EQ(complaint_about([](Poses& poses) { poses[7].pose.y += 2e-5; }),
            "the stated poses[7] is not on the path");
  EXPECT_EQ(complaint_about([](Poses& poses) { poses[7].pose.heading -= 2e-5; }),
            "the stated poses[7] is not on the path");
  EXPECT_EQ(complaint_about([](Poses& poses) { poses[7].pose.x = nan; }),
            "the stated poses[7] is not on the path");
  EXPECT_EQ(complaint_about([](Poses& poses) { poses[7].curvature = 0; }),
            "the stated poses[7] is not on the path");
  EXPECT_EQ(complaint_about([](Poses& poses) { poses.back().gear = Gear::forward; }),
            "the stated poses[40] is not on the path");
  EXPECT_EQ(complaint_about([](Poses& poses) { poses.erase(poses.begin()); }),
            "the stated poses[0] does not begin at s = 0");
  EXPECT_EQ(complaint_about([](Poses& poses) { poses.erase(poses.begin() + 7); }),
            "the stated poses[7] is not 0 to 0.1 m after the one before");
  EXPECT_EQ(complaint_about([](Poses& poses) { std::swap(poses[7], poses[8]); }),
            "the stated poses[7] is not 0 to 0.1 m after the one before");
  EXPECT_EQ(complaint_about([](Poses& poses) { poses[7].s = nan; }),
            "the stated poses[7] is not 0 to 0.1 m after the one before");
  EXPECT_EQ(complaint_about([](Poses& poses) { poses.pop_back(); }),
            "the stated poses[39] is not the end of the path");
}

TEST(PathCheck, PosesMaySayNothingOfCurvatureAndDirection) {
  EXPECT_EQ(complaint_about([](Poses& poses) {
              for (StatedPose& stated : poses) stated = {stated.s, stated.pose};
            }),
            "");
}

TEST(PathCheck, PosesAtAJointMayBelongToEitherSide) {
  EXPECT_EQ(complaint_about([](Poses& poses) {
              ASSERT_DOUBLE_EQ(poses[30].s, 3);
              poses[30].curvature = 1.0 / 7;
              poses[30].gear = Gear::forward;
            }),
            "");
}

TEST(PathCheck, PoseOfAnEmptyPathIsItsStart) {
  const Path path{{0, 0, 0}, {}};
  EXPECT_TRUE(check_open(path, path.start, {.poses = true_poses(path)}).valid);
}

// ---- collision ----

TEST(PathCheck, ClearanceIsTheDistanceToTheNearestObstacle) {
  // 2 m beside the left side of the truck, and 3 m before the front bumper at the end.
  EXPECT_NEAR(*check_ahead({box(5, 3.275, 6, 4)}).clearance, 2, 1e-3);
  EXPECT_NEAR(*check_ahead({box(5, 13, 6, 14), box(18.9, -1, 20, 1)}).clearance, 3, 1e-3);
}

TEST(PathCheck, ClearanceIsFoundBetweenTheLooks) {
  // Turning right around (0, -7), the front left corner sweeps furthest out.
  const Path path{{0, 0, 0}, {{-1.0 / 7, 7 * pi}}};
  const double outer = std::hypot(5.9, 7 + 1.275);
  const double gap = 0.0375;
  const auto at = [&](double angle) {
    return Point{(outer + gap) * std::sin(angle), -7 + (outer + gap) * std::cos(angle)};
  };
  const Polygon post = {at(2), {at(2).x + 1, at(2).y}, {at(2).x + 1, at(2).y + 0.1}};
  const Problem problem = problem_of({0, 0, 0}, {0, -14, pi}, {post});
  const PathCheck check = check_path(problem, path, {});
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_NEAR(*check.clearance, gap, 1e-3);
}

TEST(PathCheck, TouchingIsACollision) {
  EXPECT_TRUE(check_ahead({box(15.9 + 1e-6, -1, 17, 1)}).valid);
  const PathCheck check = check_ahead({box(50, 50, 51, 51), box(15.9, -1, 17, 1)});
  EXPECT_EQ(check.reason, "the footprint hits obstacles[1]");
  ASSERT_TRUE(check.at);
  EXPECT_NEAR(check.at->s, 10, 1e-9);
  EXPECT_EQ(check.clearance, 0);
}

TEST(PathCheck, TouchingSideBySideIsACollision) {
  EXPECT_TRUE(check_ahead({box(2, 1.275 + 1e-9, 3, 2)}).valid);
  EXPECT_FALSE(check_ahead({box(2, 1.275, 3, 2)}).valid);
}

TEST(PathCheck, ACollisionIsSeenBesideANearMiss) {
  // Half a millimetre beside the truck all the way; the stone lies under it only half-way.
  const Polygon miss = box(5, 1.2755, 6, 2);
  const Polygon stone = box(6.5, -0.1, 7.5, 0.1);
  EXPECT_NEAR(*check_ahead({miss}).clearance, 5e-4, 1e-3);
  EXPECT_EQ(check_ahead({miss, stone}).reason, "the footprint hits obstacles[1]");
  EXPECT_EQ(check_ahead({stone, miss}).reason, "the footprint hits obstacles[0]");
}

TEST(PathCheck, TheFirstCollisionOnTheWayIsReported) {
  const PathCheck check = check_ahead({box(14, -1, 15, 1), box(9, -1, 10, 1), box(12, 0, 13, 9)});
  EXPECT_EQ(check.reason, "the footprint hits obstacles[1]");
  ASSERT_TRUE(check.at);
  EXPECT_NEAR(check.at->s, 3.1, 1e-3);
  EXPECT_NEAR(check.at->pose.x, 3.1, 1e-3);
  EXPECT_EQ(check.at->gear, Gear::forward);
}

TEST(PathCheck, ThePlaceOfACollisionIsWhereTheTouchBegins) {
  for (double x = 6; x < 15; x += 0.0617) {
    const PathCheck check = check_ahead({box(x, -1, 17, 1)});
    ASSERT_TRUE(check.at);
    EXPECT_NEAR(check.at->s, x - 5.9, 1e-11);
  }
}

TEST(PathCheck, CornerClippedByAMillimetreBetweenTwoPosesIsSeen) {
  // Turning left around (0, 7), the front right corner swings past a post: both ends of the
  // path are clear of the post by centimetres.
  const double outer = std::hypot(5.9, 7 + 1.275);
  const Path path{{0, 0, 0}, {{1.0 / 7, 7.0}}};
  const Pose end{7 * std::sin(1.0), 7 - 7 * std::cos(1.0), 1};
  const double swing = std::atan2(5.9, 7 + 1.275);  // of the corner, ahead of the axle
  const auto post = [&](double gap) {
    const double angle = 0.5 + swing;
    const Point tip{(outer + gap) * std::sin(angle), 7 - (outer + gap) * std::cos(angle)};
    return Polygon{tip, {tip.x + 1, tip.y - 0.1}, {tip.x + 1, tip.y + 0.1}};
  };
  const auto judged = [&](const Polygon& polygon) {
    return check_path(problem_of({0, 0, 0}, end, {polygon}), path, {});
  };
  EXPECT_TRUE(judged(post(0.001)).valid);
  const PathCheck check = judged(post(-0.001));
  EXPECT_EQ(check.reason, "the footprint hits obstacles[0]");
  ASSERT_TRUE(check.at);
  EXPECT_NEAR(check.at->s, 3.5, 0.2);
}

TEST(PathCheck, ThinWallAcrossTheWayIsSeen) {
  EXPECT_FALSE(check_ahead({box(9, -100, 9.000001, 100)}).valid);
}

TEST(PathCheck, VehicleWhollyInsideAnObstacleCollides) {
  const Polygon around = box(-50, -50, 50, 50);
  EXPECT_EQ(check_ahead({around}).reason, "the footprint hits obstacles[0]");
  EXPECT_FALSE(check_ahead({{around.rbegin(), around.rend()}}).valid);
}

TEST(PathCheck, ObstacleWhollyInsideTheFootprintCollides) {
  const Polygon stone = box(2, -0.1, 2.1, 0.1);
  EXPECT_FALSE(check_ahead({stone}).valid);
  EXPECT_FALSE(check_ahead({{stone.rbegin(), stone.rend()}}).valid);
}

TEST(PathCheck, ConcaveObstacleLeavesItsNotchFree) {
  // A U that opens backwards around the lane: 0.225 m on either side, 4.1 m before the bumper.
  Polygon u = {{-10, -1.5}, {20, -1.5}, {20, 1.5}, {-10, 1.5},
               {-10, 9},    {30, 9},    {30, -9},  {-10, -9}};
  EXPECT_NEAR(*check_ahead({u}).clearance, 0.225, 1e-3);
  std::reverse(u.begin(), u.end());
  EXPECT_TRUE(check_ahead({u}).valid);
  // The same with a floor 1 m too near.
  const Polygon short_u = {{-10, -1.5}, {14.9, -1.5}, {14.9, 1.5}, {-10, 1.5},
                           {-10, 9},    {30, 9},      {30, -9},    {-10, -9}};
  const PathCheck check = check_ahead({short_u});
  ASSERT_TRUE(check.at);
  EXPECT_NEAR(check.at->s, 9, 1e-3);
}

TEST(PathCheck, ReverseIsLookedAtToo) {
  const Path back{{0, 0, 0}, {{0, -10}}};
  const Problem free = problem_of({0, 0, 0}, {-10, 0, 0}, {box(-13, -1, -11.7, 1)});
  EXPECT_NEAR(*check_path(free, back, {}).clearance, 0.1, 1e-3);
  const Problem blocked = problem_of({0, 0, 0}, {-10, 0, 0}, {box(-13, -1, -11, 1)});
  const PathCheck check = check_path(blocked, back, {});
  ASSERT_TRUE(check.at);
  EXPECT_NEAR(check.at->s, 9.4, 1e-3);
  EXPECT_EQ(check.at->gear, Gear::reverse);
}

PathCheck check_with_kerb(const Polygon& kerb, const Vehicle& vehicle) {
  const Surroundings surroundings{.bounds = {-50, 50, -50, 50}, .kerbs = {kerb}};
  return check_path(problem_in(surroundings, {0, 0, 0}, ten_ahead, vehicle), ahead, {});
}

// Wheels from the rear axle to the front one, at the end from x = 10 to 14.5; the body to 15.9.
TEST(PathCheckWithKerbs, OverhangsMaySwingOverThem) {
  const PathCheck check = check_with_kerb(box(15.0, -2, 17, 2), {});
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_NEAR(*check.clearance, 0.5, 1e-3);
}

TEST(PathCheckWithKerbs, WheelsMayNotEnterThem) {
  const PathCheck check = check_with_kerb(box(14.0, -2, 17, 2), {});
  EXPECT_FALSE(check.valid);
  EXPECT_EQ(check.reason, "the wheels hit kerbs[0]");
  EXPECT_NEAR(check.at->s, 9.5, 2e-3);
}

TEST(PathCheckWithKerbs, TheTrackMayBeNarrowerThanTheBody) {
  const Polygon beside = box(5, 1.2, 8, 3);
  EXPECT_FALSE(check_with_kerb(beside, {}).valid);
  const PathCheck check = check_with_kerb(beside, {.track_width = 2.2});
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_NEAR(*check.clearance, 0.1, 1e-3);
}

// The truck is 7.5 m long: from x = -1.6 to 5.9 at the start, 2.55 m wide. Cells are 1 m.
PathCheck check_on_map(const std::vector<std::string>& rows, const Pose& origin, double metres) {
  OccupancyGrid grid = grid_of(rows, 1.0, origin);
  grid.unknown_is_free = true;
  const Surroundings surroundings{.bounds = {-50, 50, -50, 50}, .map = grid};
  const Path path{{0, 0, 0}, {{0, metres}}};
  return check_path(problem_of_path(surroundings, path), path, {});
}

TEST(PathCheckOnAMap, ClearanceIsToTheSquaresOfCells) {
  // The front comes to x = 15.9, the cell begins at 17.5.
  const PathCheck close = check_on_map({"..#"}, {15.5, -0.5, 0}, 10);
  EXPECT_TRUE(close.valid) << close.reason;
  EXPECT_NEAR(*close.clearance, 1.6, 1e-3);
  // Far away: it has to look further and further.
  const PathCheck far = check_on_map({"#"}, {400, -0.5, 0}, 10);
  EXPECT_NEAR(*far.clearance, 400 - 15.9, 1e-3);
}

TEST(PathCheckOnAMap, TouchingACellIsACollision) {
  const PathCheck check = check_on_map({"#"}, {10.0, 1.0, 0}, 10);
  EXPECT_FALSE(check.valid);
  EXPECT_EQ(check.reason, "the footprint hits the map");
  ASSERT_TRUE(check.at);
  EXPECT_NEAR(check.at->s, 4.1, 2e-3);
}

TEST(PathCheckOnAMap, TurnedCellsAreTurned) {
  // A square on its tip, half a diagonal around (10, 2.1): its lower tip is at 1.393.
  const double half = std::sqrt(0.5);
  const PathCheck check = check_on_map({"#"}, {10.0, 2.1 - half, std::numbers::pi / 4}, 10);
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_NEAR(*check.clearance, 2.1 - half - 1.275, 1e-3);
}

TEST(PathCheckOnAMap, InsideOfBlockedCellsIsACollision) {
  const std::vector<std::string> rows(30, std::string(40, '#'));
  const PathCheck check = check_on_map(rows, {-15, -15, 0}, 1);
  EXPECT_FALSE(check.valid);
  EXPECT_EQ(check.reason, "the footprint hits the map");
}

TEST(PathCheckOnAMap, WithoutBlockedCellsThereIsNoClearance) {
  const PathCheck check = check_on_map({"..?"}, {3, 0, 0}, 10);
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_TRUE(std::isinf(*check.clearance));
}

}  // namespace
}  // namespace vandplan

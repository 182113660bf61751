// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does the judge hold a path to the steering that is claimed?

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

// The default truck: full lock at 1/7 1/m; 0.5 rad/s on a wheelbase of 4.5 m allow 1/9 1/m^2.
constexpr double lock = 1.0 / 7;
constexpr double rate = 0.5 / 4.5;
constexpr double ramp = lock / rate;  // from straight to full lock [m]

const Segment in{0, ramp, rate};
const Segment out{lock, ramp, -rate};

PathCheck check_ends(const std::vector<Segment>& segments, Steering claimed,
                     const EndCurvatures& curvatures, const Vehicle& vehicle = {}) {
  const Path path{{0, 0, 0}, segments};
  const Problem problem = make_problem(world_of({.bounds = wide_bounds}), vehicle, path.start,
                                       end_pose(path), curvatures);
  return check_path(problem, path, {.steering = claimed});
}

PathCheck check(const std::vector<Segment>& segments, Steering claimed,
                const Vehicle& vehicle = {}) {
  return check_ends(segments, claimed, {}, vehicle);
}

std::string reason(const std::vector<Segment>& segments, Steering claimed) {
  return check(segments, claimed).reason;
}

TEST(JudgedSteering, ACurvatureThatNeverJumpsIsContinuous) {
  const std::vector<Segment> there_and_back = {
      in, {lock, 3}, out, {0, 2}, {0, -ramp, -rate}, {-lock, -1}, {-lock, -ramp, rate}};
  for (const Steering claimed :
       {Steering::reeds_shepp, Steering::continuous_between_stops, Steering::continuous}) {
    EXPECT_EQ(reason(there_and_back, claimed), "");
  }
}

TEST(JudgedSteering, AJumpWhereTheVehicleRollsIsNamed) {
  const std::vector<Segment> jumping = {{0, 2}, {lock, 3}, {0, 1}};
  EXPECT_EQ(reason(jumping, Steering::reeds_shepp), "");
  for (const Steering claimed : {Steering::continuous_between_stops, Steering::continuous}) {
    const PathCheck found = check(jumping, claimed);
    EXPECT_FALSE(found.valid);
    EXPECT_EQ(found.reason, "the curvature jumps from 0 to 0.1428571 1/m where the vehicle rolls");
    ASSERT_TRUE(found.at);
    EXPECT_EQ(found.at->s, 2);
  }
  EXPECT_EQ(reason({in, {lock, 3}, {0, 1}}, Steering::continuous),
            "the curvature jumps from 0.1428571 to 0 1/m where the vehicle rolls");
}

TEST(JudgedSteering, AtAGearChangeTheWheelsMayTurnBetweenStops) {
  const std::vector<Segment> turned = {in, {lock, 3}, {-lock, -3}, {-lock, -ramp, rate}};
  EXPECT_EQ(reason(turned, Steering::continuous_between_stops), "");
  const PathCheck found = check(turned, Steering::continuous);
  EXPECT_EQ(found.reason, "the curvature jumps from 0.1428571 to -0.1428571 1/m at a gear change");
  ASSERT_TRUE(found.at);
  EXPECT_NEAR(found.at->s, ramp + 3, 1e-12);
}

TEST(JudgedSteering, AtStartAndGoalTheWheelsMayTurnBetweenStops) {
  EXPECT_EQ(reason({{lock, 3}}, Steering::continuous_between_stops), "");
  const PathCheck at_start = check({{lock, 3}, out}, Steering::continuous);
  EXPECT_EQ(at_start.reason, "the curvature jumps from 0 to 0.1428571 1/m at the start");
  EXPECT_EQ(at_start.at->s, 0);
  const PathCheck at_goal = check({in, {lock, 3}}, Steering::continuous);
  EXPECT_EQ(at_goal.reason, "the curvature jumps from 0.1428571 to 0 1/m at the goal");
  EXPECT_NEAR(at_goal.at->s, ramp + 3, 1e-12);
}

TEST(JudgedSteering, TheProblemsCurvaturesAreThoseAtTheEnds) {
  EXPECT_EQ(check_ends({{lock, 3}}, Steering::continuous, {lock, lock}).reason, "");
  EXPECT_EQ(check_ends({{lock, 3}, out}, Steering::continuous, {lock, 0}).reason, "");
  EXPECT_EQ(check_ends({{0, 3}}, Steering::continuous, {-lock, 0}).reason,
            "the curvature jumps from -0.1428571 to 0 1/m at the start");
  EXPECT_EQ(check_ends({{0, 3}}, Steering::continuous, {0, -lock}).reason,
            "the curvature jumps from 0 to -0.1428571 1/m at the goal");
  EXPECT_EQ(check_ends({{0, 3}}, Steering::continuous_between_stops, {lock, -lock}).reason, "");
}

TEST(JudgedSteering, APathThatGoesNowhereTurnsNoWheels) {
  EXPECT_EQ(check_ends({}, Steering::continuous, {lock, lock}).reason, "");
  EXPECT_EQ(check_ends({}, Steering::continuous, {lock, 0}).reason,
            "the curvature jumps from 0.1428571 to 0 1/m at the goal");
  EXPECT_EQ(check_ends({{lock, 0}}, Steering::continuous, {}).reason, "");
  EXPECT_EQ(check_ends({}, Steering::continuous_between_stops, {lock, 0}).reason, "");
}

TEST(JudgedSteering, TheCurvatureChangesNoFasterThanTheVehicleCan) {
  const auto reason_at_rate = [](double r, Steering claimed, const Vehicle& vehicle) {
    return check({{0, 0.5, r}, {0.5 * r, -0.5, -r}}, claimed, vehicle).reason;
  };
  const auto both = {Steering::continuous_between_stops, Steering::continuous};
  for (const Steering claimed : both) {
    for (const double sign : {1.0, -1.0}) {
      EXPECT_EQ(reason_at_rate(sign * rate * (1 + 1e-10), claimed, {}), "");
      EXPECT_NE(reason_at_rate(sign * rate * (1 + 1e-8), claimed, {}), "");
    }
    Vehicle slower;
    slower.limits.max_curvature_rate = 0.1;
    EXPECT_EQ(reason_at_rate(0.1, claimed, slower), "");
    EXPECT_EQ(reason_at_rate(-0.11, claimed, slower),
              "the curvature changes by -0.11 1/m per metre, the vehicle can 0.1");
  }
  const PathCheck found = check({{0, 2}, {0, 0.1, 0.5}, {0.05, 0.5, -rate}}, Steering::continuous);
  EXPECT_EQ(found.reason, "the curvature changes by 0.5 1/m per metre, the vehicle can 0.1111111");
  EXPECT_EQ(found.at->s, 2);
  EXPECT_EQ(reason_at_rate(0.2, Steering::reeds_shepp, {}), "");
}

TEST(JudgedSteering, WhatIsLessThanAMillionthOfTheLockIsRounding) {
  const auto reason_of_jumps = [](double part, const std::vector<double>& lengths) {
    std::vector<Segment> segments;
    double curvature = 0.0;
    for (const double length : lengths) {
      segments.push_back({curvature, length});
      curvature = part * lock - curvature;
    }
    return check_ends(segments, Steering::continuous_between_stops, {}).reason;
  };
  EXPECT_EQ(reason_of_jumps(0.9e-6, {3, 3}), "");
  EXPECT_NE(reason_of_jumps(1.1e-6, {3, 3}), "");
  // Of many small ones it is the sum, from stop to stop: wheels do not creep.
  EXPECT_EQ(reason_of_jumps(0.4e-6, {1, 1, 1}), "");
  EXPECT_NE(reason_of_jumps(0.4e-6, {1, 1, 1, 1}), "");
  EXPECT_EQ(reason_of_jumps(0.4e-6, {1, 1, 1, -1, -1, -1}), "");
  // At the goal, too.
  EXPECT_EQ(check_ends({{0, 3}}, Steering::continuous, {0, 0.9e-6 * lock}).reason, "");
  EXPECT_NE(check_ends({{0, 3}}, Steering::continuous, {0, 1.1e-6 * lock}).reason, "");
}

TEST(JudgedSteering, SegmentsOfLengthZeroTurnNoWheels) {
  EXPECT_EQ(reason({{0, 3}, {lock, 0}, {0, -0.0}, {0, 3}}, Steering::continuous), "");
}

TEST(JudgedSteeringLaw, WhatContinuousSteeringDrivesIsAccepted) {
  const Vehicle vehicle;
  const ContinuousSteering between(vehicle.min_turning_radius, rate, Continuity::between_stops);
  const ContinuousSteering throughout(vehicle.min_turning_radius, rate, Continuity::throughout);
  for_each_case(1, 300, [&](Rng& rng) {
    const Pose start = uniform_pose({-20, 20, -20, 20}, rng);
    const Pose goal = uniform_pose({-20, 20, -20, 20}, rng);
    const EndCurvatures ends{uniform(-lock, lock, rng), uniform(-lock, lock, rng)};
    const Problem problem =
        make_problem(world_of({.bounds = wide_bounds}), vehicle, start, goal, ends);
    const auto reason_of = [&](const Piece& piece, Steering claimed) {
      const Path path{start, {piece.view().begin(), piece.view().end()}};
      return check_path(problem, path, {.steering = claimed}).reason;
    };
    SCOPED_TRACE(as_code(start) + " to " + as_code(goal));
    EXPECT_EQ(reason_of(between.steer(start, goal), Steering::continuous_between_stops), "");
    ContinuousQuery query;
    query.start_curvature = ends.start;
    query.goal_curvature = ends.goal;
    const std::optional<Piece> piece = throughout.steer(start, goal, query);
    ASSERT_TRUE(piece);
    EXPECT_EQ(reason_of(*piece, Steering::continuous), "");
    // With the wheels straight at both ends it is another path.
    EXPECT_NE(reason_of(throughout.steer(start, goal), Steering::continuous), "");
  });
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// A vehicle with a trailer: the collision checker and the judge against each other and against
// outlines at many poses; and what the judge finds wrong, by name.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/cases.h"
#include "support/collision_oracle.h"
#include "support/draws.h"
#include "vandplan/judge.h"
#include "vandplan/problem.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

Vehicle semitrailer() {
  Vehicle vehicle{3.6, 1.4, 0.9, 2.55, 6.0};
  vehicle.hitch = 0.5;
  vehicle.trailer = Trailer{7.7, 1.6, 4.3, 2.55};
  return vehicle;
}

/// A body that is narrower at one end than its box.
Polygon tapered(const Footprint& box, Rng& rng) {
  const double front = chance(0.5, rng) ? uniform(0.1, 1, rng) : 1;
  const double rear = front < 1 ? 1 : uniform(0.1, 1, rng);
  return {{box.front, front * box.half_width},
          {-box.rear, rear * box.half_width},
          {-box.rear, -rear * box.half_width},
          {box.front, -front * box.half_width}};
}

Vehicle any_rig(Rng& rng) {
  Vehicle vehicle{3.6, 1.4, 0.9, 2.4, 1.0};
  vehicle.hitch = chance(0.3, rng) ? 0.0 : uniform(-2, 1, rng);
  vehicle.max_hitch_angle = 3.1;
  vehicle.trailer = Trailer{uniform(2, 9, rng), uniform(-1.5, 1.5, rng), uniform(0, 4, rng),
                            uniform(1, 2.6, rng)};
  if (chance(0.3, rng)) vehicle.outline = tapered(footprint(vehicle), rng);
  if (chance(0.3, rng)) vehicle.trailer->outline = tapered(footprint(*vehicle.trailer), rng);
  return vehicle;
}

Segment any_part(Rng& rng) {
  const double rate = chance(0.3, rng) ? uniform(-0.05, 0.05, rng) : 0.0;
  return {chance(0.2, rng) ? 0.0 : uniform(-0.2, 0.2, rng), any_sign(any_size(0.1, 9, rng), rng),
          rate};
}

/// The least distance of both bodies from an obstacle at many states of a segment.
double sampled_distance(const Vehicle& vehicle, const State& from, const Segment& segment,
                        const Polygon& obstacle) {
  const OracleBody tractor(vehicle);
  OracleBody trailer(footprint(*vehicle.trailer));
  trailer.corners = body_outline(*vehicle.trailer);
  double least = 1e9;
  const double length = std::abs(segment.length);
  const int count = 1 + static_cast<int>(length / 0.02);
  for (int i = 0; i <= count; ++i) {
    const State state = advance(vehicle, from, part_of(segment, 0, length * i / count));
    least = std::min({least, gap_between(tractor.at(state.pose), obstacle).distance,
                      gap_between(trailer.at(trailer_pose(vehicle, state)), obstacle).distance});
  }
  return least;
}

/// A triangle that the bodies graze somewhere, as often as not.
Polygon any_triangle(const Vehicle& vehicle, const State& from, const Segment& segment, Rng& rng) {
  const double length = std::abs(segment.length);
  const State state = advance(vehicle, from, part_of(segment, 0, uniform(0, length, rng)));
  const Trailer& trailer = *vehicle.trailer;
  const Pose frame = chance(0.3, rng) ? state.pose : trailer_pose(vehicle, state);
  const Footprint body = frame == state.pose ? footprint(vehicle) : footprint(trailer);
  const double off = any_sign(any_size(1e-4, 2, rng), rng);
  const double side = any_sign(1, rng);
  const Pose tip =
      compose(frame, {uniform(-body.rear, body.front, rng), side * (body.half_width + off), 0});
  const Pose left = compose(frame, {uniform(-3, 3, rng), side * (body.half_width + 9), 0});
  const Pose right = compose(frame, {uniform(4, 9, rng), side * (body.half_width + 9), 0});
  return {{tip.x, tip.y}, {left.x, left.y}, {right.x, right.y}};
}

/// The problem of driving those segments, and the path.
struct Drive {
  Problem problem;
  Path path;
};

Drive drive(const Vehicle& vehicle, const State& from, std::vector<Segment> segments,
            const std::vector<Polygon>& obstacles, const std::vector<Polygon>& kerbs = {}) {
  State end = from;
  for (const Segment& segment : segments) end = advance(vehicle, end, segment);
  Scenario scenario{.name = "drive",
                    .vehicle = vehicle,
                    .bounds = {-90, 90, -90, 90},
                    .start = from.pose,
                    .goal = end.pose,
                    .hitch_angles = {from.hitch_angle, end.hitch_angle},
                    .obstacles = obstacles,
                    .kerbs = kerbs};
  return {make_problem(scenario), {from.pose, std::move(segments)}};
}

PathCheck judged(const Drive& drive, const PathClaims& claims = {}) {
  return check_path(drive.problem, drive.path, claims);
}

// ---- Laws ----

TEST(RigCheckLaw, CheckerAndJudgeAgreeWithBodiesAtManyPoses) {
  int free_count = 0;
  int close_count = 0;
  for_each_case(1, 3000, [&](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const State from{uniform_pose({-5, 5, -5, 5}, rng), uniform(-1.4, 1.4, rng)};
    const Segment segment = any_part(rng);
    if (largest_hitch_angle(vehicle, from.hitch_angle, segment) > 3) return;
    const Polygon obstacle = any_triangle(vehicle, from, segment, rng);
    SCOPED_TRACE(as_code(from.pose) + ", " + as_code(from.hitch_angle) + " " + as_code(segment) +
                 " " + as_code(obstacle));
    const Drive driven = drive(vehicle, from, {segment}, {obstacle});
    const double sampled = sampled_distance(vehicle, from, segment, obstacle);
    const Pose& start = driven.problem.task().start;
    const bool is_free =
        driven.problem.task().checker->is_free(Local(State{start, from.hitch_angle}), segment);
    const PathCheck check = judged(driven);
    free_count += is_free ? 1 : 0;
    close_count += sampled < 0.01 && sampled > 0 ? 1 : 0;
    if (is_free) {
      EXPECT_GT(sampled, 0);
      EXPECT_TRUE(check.valid) << check.reason;
    }
    // What samples miss between two of them is below a tenth of a metre.
    EXPECT_TRUE(is_free || sampled <= 0.1) << sampled;
    if (check.valid) {
      EXPECT_LE(*check.clearance, sampled + 2e-3);
      EXPECT_GE(*check.clearance, sampled - 0.1);
      EXPECT_TRUE(is_free || *check.clearance <= 2.1e-3) << *check.clearance;
    }
  });
  EXPECT_GT(free_count, cases(300));
  EXPECT_GT(close_count, cases(20));
}

TEST(RigCheckLaw, MarginsAreKeptByBothBodies) {
  for_each_case(2, 500, [&](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const State from{uniform_pose({-5, 5, -5, 5}, rng), uniform(-1.2, 1.2, rng)};
    const Segment segment = any_part(rng);
    if (largest_hitch_angle(vehicle, from.hitch_angle, segment) > 3) return;
    const Drive driven =
        drive(vehicle, from, {segment}, {any_triangle(vehicle, from, segment, rng)});
    const PathCheck check = judged(driven);
    if (!check.valid || *check.clearance < 0.01) return;
    const auto is_free_with = [&](double margin) {
      const Task task = task_of(driven.problem, {.margin = margin});
      return task.checker->is_free(Local(State{task.start, from.hitch_angle}), segment);
    };
    EXPECT_TRUE(is_free_with(*check.clearance - 3e-3));
    EXPECT_FALSE(is_free_with(*check.clearance + 1e-3));
    EXPECT_FALSE(judged(driven, {.clearance = {.margin = *check.clearance + 2e-3}}).valid);
  });
}

TEST(RigCheckLaw, TheJudgeFindsTheHitchAngleByItsOwnMeans) {
  for_each_case(3, 300, [&](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const State from{uniform_pose({-5, 5, -5, 5}, rng), uniform(-1, 1, rng)};
    const std::vector<Segment> segments = {any_part(rng), any_part(rng), any_part(rng)};
    State state = from;
    double largest = 0;
    for (const Segment& segment : segments) {
      largest = std::max(largest, largest_hitch_angle(vehicle, state.hitch_angle, segment));
      state = advance(vehicle, state, segment);
    }
    if (largest > 3) return;
    const PathCheck check = judged(drive(vehicle, from, segments, {}));
    EXPECT_TRUE(check.valid) << check.reason;
    EXPECT_NEAR(check.largest_hitch_angle, largest, 1e-4);
  });
}

// ---- What is wrong, by name ----

TEST(RigCheck, ATrailerThatCutsTheCornerIsNamed) {
  // The post is inside of the tractor's turn to the left, clear of it; the trailer cuts the corner.
  const std::vector<Polygon> post = {{{7.2, 2.2}, {7.5, 2.2}, {7.5, 2.5}, {7.2, 2.5}}};
  const std::vector<Segment> turn = {{0, 5}, {1 / 6.5, 10}};
  const Drive driven = drive(semitrailer(), {}, turn, post);
  const PathCheck check = judged(driven);
  EXPECT_FALSE(check.valid);
  EXPECT_EQ(check.reason, "the trailer's footprint hits obstacles[0]");
  ASSERT_TRUE(check.at);
  EXPECT_GT(check.at->s, 5);
  EXPECT_FALSE(driven.problem.task().checker->is_free(LocalState(), turn));
  EXPECT_TRUE(driven.problem.task().checker->tractor_is_free(LocalPose(), turn));
}

TEST(RigCheck, ATrailerInsideOfAWallIsNotFreeAlthoughNoBodyTouchesASide) {
  Vehicle vehicle{3.6, 1.4, 0.9, 2.55, 6.0};
  vehicle.hitch = -1.2;
  vehicle.trailer = Trailer{6.0, -1.5, 1.0, 2.55};  // a bare drawbar from -1.2 to -2.7
  const std::vector<Polygon> around = {{{-30, -9}, {-1.8, -9}, {-1.8, 9}, {-30, 9}}};
  const Drive standing = drive(vehicle, {}, {{0, 0.1}}, around);
  EXPECT_TRUE(standing.problem.task().checker->tractor_is_free(LocalPose()));
  EXPECT_FALSE(standing.problem.task().checker->is_free(LocalState()));
  EXPECT_FALSE(judged(standing).valid);
}

TEST(RigCheck, OverKerbsTheTrailerSwingsButItsWheelsDoNot) {
  // Behind the axle at x = -7.2 the trailer overhangs by 4.3 m.
  const std::vector<Polygon> behind = {{{-11, -3}, {-9, -3}, {-9, 3}, {-11, 3}}};
  const std::vector<Polygon> at_wheels = {{{-7.5, 1}, {-7, 1}, {-7, 2}, {-7.5, 2}}};
  EXPECT_TRUE(judged(drive(semitrailer(), {}, {{0, 1}}, {}, behind)).valid);
  const PathCheck check = judged(drive(semitrailer(), {}, {{0, 1}}, {}, at_wheels));
  EXPECT_EQ(check.reason, "the trailer's wheels hit kerbs[0]");
}

TEST(RigCheck, AJackknifeIsNamed) {
  // In reverse the angle grows; what ends within its limit is over it on the way.
  const Drive folded = drive(semitrailer(), {{0, 0, 0}, 0.9}, {{0, -4}, {0, 5}}, {});
  const PathCheck check = judged(folded);
  EXPECT_FALSE(check.valid);
  EXPECT_TRUE(check.reason.starts_with("the rig folds up (jackknife): the hitch angle is 1.2"))
      << check.reason;
  ASSERT_TRUE(check.at);
  EXPECT_LT(check.at->s, 4);
}

TEST(RigCheck, AHitchAngleThatIsOffAtTheGoalIsNamed) {
  Drive driven = drive(semitrailer(), {{0, 0, 0}, 0.3}, {{0, 4}}, {});
  EXPECT_TRUE(judged(driven).valid);
  const Problem& right = driven.problem;
  const EndHitchAngles straight{0.3, 0.0};
  driven.problem =
      make_problem(right.world(), right.vehicle(), right.start(), right.goal(), {}, straight);
  const PathCheck check = judged(driven);
  EXPECT_TRUE(check.reason.starts_with("the path ends with a hitch angle ")) << check.reason;
}

TEST(RigCheck, StatedHitchAnglesAreHeldToTheTruth) {
  const Drive driven = drive(semitrailer(), {{0, 0, 0}, 0.3}, {{0, 0.05}}, {});
  EXPECT_TRUE(judged(driven, {.start_hitch_angle = 0.3}).valid);
  EXPECT_FALSE(judged(driven, {.start_hitch_angle = 0.31}).valid);
  const double end = hitch_angle_after(semitrailer(), 0.3, {0, 0.05});
  const auto stated = [&](double angle) {
    return PathClaims{.poses = {{.s = 0, .pose = {0, 0, 0}, .hitch_angle = 0.3},
                                {.s = 0.05, .pose = {0.05, 0, 0}, .hitch_angle = angle}}};
  };
  EXPECT_TRUE(judged(driven, stated(end)).valid);
  EXPECT_FALSE(judged(driven, stated(end + 1e-4)).valid);
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The judge and segments whose curvature changes. tests/judge/judge_law_test.cpp has them, too,
// among obstacles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "judge/track.h"
#include "support/cases.h"
#include "support/clothoid_oracle.h"
#include "support/problems.h"
#include "vandplan/judge.h"

namespace vandplan {
namespace {

using std::numbers::pi;
const Vehicle nimble{.min_turning_radius = 4};  // its curvature: at most 0.25

PathCheck check_open(const Path& path, const PathClaims& claims = {},
                     const Bounds& bounds = wide_bounds) {
  const Problem problem = problem_of(path.start, end_pose(path), {}, bounds, nimble);
  return check_path(problem, path, claims);
}

std::vector<StatedPose> stated(const Path& path) {
  std::vector<StatedPose> poses;
  for (const auto& [s, pose, curvature, gear] : sampled(path, 0.1)) {
    poses.push_back({s, pose, curvature, gear});
  }
  return poses;
}

// ---- Where it is ----

void expect_there(const judge::Position& position, const SlowPose& slow) {
  EXPECT_LE(std::hypot(position.x - slow.x, position.y - slow.y), 1e-12);
  EXPECT_LE(std::abs(position.heading - slow.heading), 1e-12);
}

TEST(JudgedClothoidLaw, EndsWhereManySmallStepsEnd) {
  for_each_case(1, 10000, [&](Rng& rng) {
    const Segment segment = chance(0.5, rng) ? drivable_clothoid(rng) : any_clothoid(60, rng);
    const Pose start = uniform_pose({-20, 20, -20, 20}, rng);
    SCOPED_TRACE(as_code(segment) + " from " + as_code(start));
    const judge::Track track = judge::integrate({start, {segment}});
    expect_there(track.end, slow_advance(start, segment));
    EXPECT_NEAR(static_cast<double>(track.length), std::abs(segment.length), 1e-12);
    // And on the way.
    const auto index =
        static_cast<std::size_t>(uniform(0, static_cast<double>(track.stretches.size()), rng));
    const judge::Stretch& stretch = track.stretches[index];
    const judge::Real t = stretch.length * uniform01(rng);
    const auto driven = static_cast<double>(stretch.s + t);
    expect_there(judge::after(stretch, t), slow_advance(start, part_of(segment, 0, driven)));
    EXPECT_NEAR(
        static_cast<double>(judge::curvature_at(stretch, t)), curvature_at(segment, driven),
        1e-12 * (1 + std::abs(segment.curvature) + std::abs(segment.curvature_rate * driven)));
  });
}

TEST(JudgedClothoidLaw, PathsOfTheLibraryEndWhereTheySay) {
  for_each_case(2, 2000, [&](Rng& rng) {
    Path path{uniform_pose({-20, 20, -20, 20}, rng), {}};
    for (int i = 0; i < 4; ++i) path.segments.push_back(drivable_clothoid(rng));
    const judge::Track track = judge::integrate(path);
    const Pose end = end_pose(path);
    EXPECT_LE(std::hypot(end.x - track.end.x, end.y - track.end.y), 1e-12);
    const PathClaims claims{
        .length = length(path), .gear_changes = gear_changes(path), .poses = stated(path)};
    const PathCheck check = check_open(path, claims);
    EXPECT_TRUE(check.valid) << check.reason << ": " << as_code(path);
  });
}

TEST(JudgedClothoid, StatedCurvaturesAreThoseThere) {
  const Path path{{1, 2, 3}, {{0, 2, 0.1}, {0.2, -3, -0.05}}};
  PathClaims claims{.poses = stated(path)};
  EXPECT_TRUE(check_open(path, claims).valid);
  *claims.poses[7].curvature += 2e-5;
  EXPECT_EQ(check_open(path, claims).reason, "the stated poses[7] is not on the path");
}

TEST(JudgedClothoid, NumbersOutOfReasonAreNamed) {
  const Problem problem = problem_of({0, 0, 0}, {0, 0, 0}, {}, wide_bounds, nimble);
  const auto reason = [&](const Segment& segment) {
    return check_path(problem, {{0, 0, 0}, {{0, 1}, segment}}).reason;
  };
  EXPECT_EQ(reason({0, 1, std::numeric_limits<double>::quiet_NaN()}), "segments[1] is not finite");
  for (const Segment& segment : {Segment{0, 1, 1e300}, Segment{1e300, 1e300, -1e300},
                                 Segment{0.1, 1e9, 1e-12}, Segment{0, -1e6, 1e-3}}) {
    EXPECT_EQ(reason(segment), "segments[1] winds too often to be judged") << as_code(segment);
  }
  // Each is fine, all of them together are not: no file may ask for so much memory.
  const Segment long_one{0, 600, 1e-2};  // 7320 parts
  EXPECT_EQ(reason(long_one).substr(0, 9), "curvature");
  const std::vector<Segment> many(1000, long_one);
  EXPECT_EQ(check_path(problem, {{0, 0, 0}, many}).reason,
            "segments[136] winds too often to be judged");
  // It turns by 50 rad, in and out.
  EXPECT_EQ(check_open({{0, 0, 0}, {{0, 1}, {0.25, 200, -0.0025}}}).reason, "");
}

// ---- How tight it is ----

TEST(JudgedClothoid, TheTightestCurvatureIsAtOneOfTheEnds) {
  const double tight = 0.25 * (1 + 1e-6);
  EXPECT_TRUE(check_open({{0, 0, 0}, {{0, 2, 0.125}, {0.25, 2, -0.25}, {-0.25, -1, 0.5}}}).valid);
  const PathCheck at_end = check_open({{0, 0, 0}, {{0, 2, 0.125}, {0.25, 2, -(tight + 0.25) / 2}}});
  EXPECT_EQ(at_end.reason,
            "curvature -0.25000025 is tighter than the turning radius of 4 m allows");
  EXPECT_DOUBLE_EQ(at_end.at->s, 4);
  EXPECT_DOUBLE_EQ(at_end.at->curvature, -tight);
  const PathCheck at_start = check_open({{0, 0, 0}, {{tight, -2, -0.1}}});
  EXPECT_EQ(at_start.at->s, 0);
}

// ---- Where the axle may be ----

TEST(JudgedClothoidLaw, BoundsAreKeptToTheMicrometre) {
  int bulges = 0;
  for_each_case(3, 3000, [&](Rng& rng) {
    const Path path{uniform_pose({-20, 20, -20, 20}, rng),
                    {drivable_clothoid(rng), drivable_clothoid(rng)}};
    std::vector<Point> points;
    for (const PathPoint& p : sampled(path, 2e-3)) points.push_back({p.pose.x, p.pose.y});
    Bounds bounds = bounding_box(points);
    const double room = any_sign(1e-6, rng);  // what is between two samples bulges less
    double* const sides[] = {&bounds.x_min, &bounds.x_max, &bounds.y_min, &bounds.y_max};
    const auto side = static_cast<std::size_t>(uniform(0, 4, rng));
    for (std::size_t i = 0; i < 4; ++i) {
      *sides[i] += (i == side ? room : 1.0) * (i % 2 == 0 ? -1 : 1);
    }
    const PathCheck check = check_open(path, {}, bounds);
    EXPECT_EQ(check.valid, room > 0) << as_code(path) << " side " << side;
    if (!check.valid) {
      EXPECT_EQ(check.reason.substr(0, 13), "the rear axle");
      bulges += check.at->s > 0 && check.at->s < length(path);
    }
  });
  EXPECT_GT(bulges, cases(3000) / 10);
}

// ---- How closely it looks ----

// The truck turns on the spot, by a quarter turn in 15.7 mm of its axle. Half a millimetre to the
// left of where it stands is a wall, so that no other near miss matters. Its front corners, 6.03 m
// away, pass a pebble and dip 6 mm into it, for 50 micrometres of the axle's way.
TEST(JudgedTurnOnTheSpot, ACornerThatDipsIntoAPebbleIsSeen) {
  const Vehicle vehicle{.min_turning_radius = 0.01};
  const Path path{{0, 0, 0}, {{100, 0.01 * pi / 2}}};
  const Polygon wall = box(-1.6, 1.2755, -1.5, 1.28);
  const double near = 6.03 / std::sqrt(2.0);
  const Polygon pebble = box(near, near + 0.01, near + 0.02, near + 0.03);
  const auto check = [&](const std::vector<Polygon>& obstacles) {
    return check_path(problem_of({0, 0, 0}, end_pose(path), obstacles, wide_bounds, vehicle), path,
                      {});
  };
  EXPECT_TRUE(check({wall}).valid);
  EXPECT_EQ(check({wall, pebble}).reason, "the footprint hits obstacles[1]");
  // And found to be the first, before the front comes to a wall.
  const PathCheck first = check({box(-1, 5, 1, 5.1), pebble});
  EXPECT_EQ(first.reason, "the footprint hits obstacles[1]");
  EXPECT_NEAR(first.at->s, 0.01 * (pi / 4 - std::asin(1.275 / 6.03)), 1e-4);
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Segments whose curvature changes: where they lead, and what cutting, joining and turning them
// around must not change.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/cases.h"
#include "support/clothoid_oracle.h"
#include "vandplan/path.h"
#include "vandplan/search.h"

namespace vandplan {
namespace {

using search::end_of, search::prefix, search::suffix;

using std::numbers::pi;
constexpr Bounds around{-20, 20, -20, 20};

double distance(const Pose& a, const Pose& b) { return std::hypot(a.x - b.x, a.y - b.y); }
double turn_between(const Pose& a, const Pose& b) {
  return std::abs(std::remainder(a.heading - b.heading, 2 * pi));
}

void expect_near(const Pose& a, const Pose& b, double tolerance) {
  EXPECT_LE(distance(a, b), tolerance) << as_code(a) << " and " << as_code(b);
  EXPECT_LE(turn_between(a, b), tolerance) << as_code(a) << " and " << as_code(b);
}

void expect_as_slow(const Pose& pose, const Segment& segment, double tolerance) {
  SCOPED_TRACE(as_code(segment) + " from " + as_code(pose));
  const Pose end = advance(pose, segment);
  const SlowPose slow = slow_advance(pose, segment);
  EXPECT_LE(std::hypot(end.x - slow.x, end.y - slow.y), tolerance);
  EXPECT_LE(
      std::abs(std::remainder(end.heading - slow.heading, 2 * std::numbers::pi_v<long double>)),
      tolerance);
  EXPECT_GE(end.heading, -pi);
  EXPECT_LT(end.heading, pi);
}

// ---- Pencil and paper ----

// Over sqrt(2 * turn / rate) from straight a clothoid turns by `turn`; the coordinates are Fresnel
// integrals: C(1) = 0.7798934003768228, S(1) = 0.4382591473903548 (Abramowitz & Stegun, table 7.7).
TEST(Clothoid, TheFirstQuarterTurnOfTheUnitSpiralIsThatOfTheTables) {
  const Pose end = advance({0, 0, 0}, {0, 1, pi});
  EXPECT_NEAR(end.x, 0.7798934003768228, 1e-15);
  EXPECT_NEAR(end.y, 0.4382591473903548, 1e-15);
  EXPECT_EQ(end.heading, pi / 2);
}

TEST(Clothoid, InReverseTheWheelTurnsWithTheWayDriven) {
  const Pose end = advance({0, 0, 0}, {0, -1, pi});
  EXPECT_NEAR(end.x, -0.7798934003768228, 1e-15);
  EXPECT_NEAR(end.y, 0.4382591473903548, 1e-15);
  EXPECT_EQ(end.heading, -pi / 2);
}

TEST(Clothoid, ASpiralWithoutEndRunsIntoItsPole) {
  // Fresnel's integrals tend to 1/2; what is left of them is 1 / curvature.
  const Pose end = advance({0, 0, 0}, {0, 1e4, pi});
  EXPECT_NEAR(end.x, 0.5, 1.1 / (pi * 1e4));
  EXPECT_NEAR(end.y, 0.5, 1.1 / (pi * 1e4));
}

TEST(Clothoid, NumbersOutOfReasonEndInNoTime) {
  for (const double rate : {1e300, -1e300, 1e-300, 5e-324}) {
    for (const double curvature : {0.0, 1e300, -1e300, 1e20, 1e-300}) {
      for (const double length : {1e300, -1e300, 1e9, 1e-300}) {
        static_cast<void>(advance({0, 0, 0}, {curvature, length, rate}));
      }
    }
  }
  EXPECT_TRUE(std::isnan(advance({0, 0, 0}, {0, 1, std::nan("")}).x));
}

// ---- Laws ----

TEST(ClothoidLaw, EndsWhereManySmallStepsEnd) {
  for_each_case(1, 40000, [&](Rng& rng) {
    const Segment segment = chance(0.5, rng) ? drivable_clothoid(rng) : any_clothoid(60, rng);
    expect_as_slow(uniform_pose(around, rng), segment, 1e-12 * (1 + std::abs(segment.length)));
  });
}

TEST(ClothoidLaw, EndsThereAfterHundredsOfTurns) {
  for_each_case(2, 100, [&](Rng& rng) {
    const Segment segment = any_clothoid(1e4, rng);
    expect_as_slow(uniform_pose(around, rng), segment, 1e-9);
  });
}

TEST(ClothoidLaw, AVanishingRateGivesTheArc) {
  for_each_case(3, 10000, [&](Rng& rng) {
    Segment segment = any_clothoid(60, rng);
    segment.curvature_rate = any_sign(any_size(5e-324, 1e-20, rng), rng);
    const Pose pose = uniform_pose(around, rng);
    const Pose arc = advance(pose, {segment.curvature, segment.length});
    expect_near(advance(pose, segment), arc, 1e-12 * (1 + std::abs(segment.length)));
  });
}

TEST(ClothoidLaw, TheWayBackLeadsBack) {
  for_each_case(4, 10000, [&](Rng& rng) {
    Piece piece;
    for (piece.count = 0; piece.count < 3; ++piece.count) {
      piece.segments[piece.count] = drivable_clothoid(rng);
      piece.length += std::abs(piece.segments[piece.count].length);
    }
    piece.segments[1].curvature_rate *= chance(0.5, rng);
    const Pose start = uniform_pose(around, rng);
    const Piece back = reversed(piece);
    expect_near(end_of(end_of(start, piece), back), start, 1e-11);
    // And over the same ground.
    const double s = uniform(0, piece.length, rng);
    const Pose there = end_of(start, prefix(piece, s));
    const Pose again = end_of(end_of(start, piece), prefix(back, piece.length - s));
    expect_near(again, there, 1e-11);
  });
}

// The last metres, where the wheels get straight, come after a thousand radians.
TEST(Clothoid, ASpiralOfHundredsOfTurnsUnwinds) {
  const Pose centre = advance(Pose{}, {0.0, 200.0, 0.05});
  const Pose back = advance(centre, {10.0, -200.0, -0.05});
  EXPECT_NEAR(back.x, 0, 1e-9);
  EXPECT_NEAR(back.y, 0, 1e-9);
  EXPECT_NEAR(back.heading, 0, 1e-9);
}

TEST(ClothoidLaw, PrefixAndSuffixAreTheWhole) {
  for_each_case(5, 10000, [&](Rng& rng) {
    Piece piece;
    piece.segments[piece.count++] = any_clothoid(60, rng);
    piece.length = std::abs(piece.segments[0].length);
    const double s = piece.length * uniform01(rng);
    const Pose start = uniform_pose(around, rng);
    const Piece first = prefix(piece, s);
    const Piece last = suffix(piece, s);
    const double tolerance = 1e-11 * (1 + piece.length);
    expect_near(end_of(end_of(start, first), last), end_of(start, piece), tolerance);
    ASSERT_EQ(first.count, 1);
    ASSERT_EQ(last.count, 1);
    const std::vector<Segment> joined = merged(std::vector{first.segments[0], last.segments[0]});
    ASSERT_EQ(joined.size(), 1U) << as_code(piece.segments[0]) << " cut at " << as_code(s);
    EXPECT_EQ(joined[0].curvature, piece.segments[0].curvature);
    EXPECT_NEAR(joined[0].length, piece.segments[0].length, 1e-15 * piece.length);
  });
}

TEST(ClothoidLaw, SampledPointsLieOnThePathWithItsCurvature) {
  for_each_case(6, 300, [&](Rng& rng) {
    const Path path{uniform_pose(around, rng),
                    {drivable_clothoid(rng), {0.1, 1.3}, drivable_clothoid(rng)}};
    const std::vector<PathPoint> points = sampled(path, 0.1);
    double last = 0;
    for (const PathPoint& point : points) {
      EXPECT_LE(point.s - last, 0.1 + 1e-12);
      expect_near(point.pose, pose_at(path, point.s), 1e-12);
      last = point.s;
    }
    EXPECT_EQ(points.front().curvature, path.segments[0].curvature);
    const Segment& end = path.segments[2];
    EXPECT_EQ(points.back().curvature, end.curvature + end.curvature_rate * std::abs(end.length));
    EXPECT_EQ(points.back().pose, end_pose(path));
    // The turn between two points tells the curvature in their middle.
    const double first_length = std::abs(path.segments[0].length);
    for (std::size_t i = 1; points[i].s < first_length; ++i) {
      const PathPoint& a = points[i - 1];
      const PathPoint& b = points[i];
      const double turn = std::remainder(b.pose.heading - a.pose.heading, 2 * pi);
      const double middle = (a.curvature + b.curvature) / 2;
      EXPECT_NEAR(turn, direction_of(a.gear) * middle * (b.s - a.s), 1e-12);
    }
  });
}

// ---- Joining, and far away ----

TEST(Clothoid, MergedJoinsThoseThatGoOnOnly) {
  const Segment first{0.1, 2, 0.05};
  const Segment on{0.2, 3, 0.05};
  EXPECT_EQ(merged(std::vector{first, on}), (std::vector<Segment>{{0.1, 5, 0.05}}));
  for (const Segment& other : {Segment{0.2, 3, 0.06}, Segment{0.2, 3}, Segment{0.2, -3, 0.05},
                               Segment{0.1, 3, 0.05}, Segment{0.2 + 1e-9, 3, 0.05}}) {
    EXPECT_EQ(merged(std::vector{first, other}), (std::vector{first, other})) << as_code(other);
  }
}

TEST(Path, SamplesFarFromTheOriginAsWellAsBesideIt) {
  const std::vector<Segment> segments = {{0.1, 30.05}, {0.1, -12.5, -0.03}, {-0.2, 3}};
  const Path near{{0.25, -0.375, 0.5}, segments};
  const Path far{{1e9 + 0.25, -4e9 - 0.375, 0.5}, segments};
  const auto expect_moved = [&](const Pose& pose, const Pose& expected) {
    EXPECT_EQ(pose.x, 1e9 + expected.x);
    EXPECT_EQ(pose.y, -4e9 + expected.y);
    EXPECT_EQ(pose.heading, expected.heading);
  };
  expect_moved(end_pose(far), end_pose(near));
  expect_moved(pose_at(far, 33.3), pose_at(near, 33.3));
  const auto points = sampled(near, 0.1);
  const auto far_points = sampled(far, 0.1);
  ASSERT_EQ(far_points.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    expect_moved(far_points[i].pose, points[i].pose);
  }
}

TEST(Path, TellsItsLengthAndGearChanges) {
  const Path path{{}, {{0.1, 3}, {0.1, -1, 0.2}, {0, -2}}};
  EXPECT_EQ(length(path), 6);
  EXPECT_EQ(gear_changes(path), 1);
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/path.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vandplan {
namespace {

using std::numbers::pi;

TEST(Advance, QuarterTurnLeftEndsOneRadiusAheadAndLeft) {
  const Pose end = advance({0, 0, 0}, {1.0 / 7, 7 * pi / 2});
  EXPECT_NEAR(end.x, 7, 1e-12);
  EXPECT_NEAR(end.y, 7, 1e-12);
  EXPECT_NEAR(end.heading, pi / 2, 1e-12);
}

TEST(Advance, ReverseOnALeftArcTurnsRight) {
  const Pose end = advance({0, 0, 0}, {1.0 / 7, -7 * pi / 2});
  EXPECT_NEAR(end.x, -7, 1e-12);
  EXPECT_NEAR(end.y, 7, 1e-12);
  EXPECT_NEAR(end.heading, -pi / 2, 1e-12);
}

TEST(Path, GearChangesIgnoreSegmentsOfLengthZero) {
  const Segment segments[] = {{0, 2}, {0.1, 0}, {0, 3}, {0.1, -1}, {0, 0}, {0, 1}};
  EXPECT_EQ(gear_changes(segments), 2);
  EXPECT_DOUBLE_EQ(length(segments), 7);
}

TEST(Path, SampledPointsAreNoFurtherApartThanTheStep) {
  const Path path{{1, 2, 0.5}, {{0.1, 3.05}, {0, -1.01}}};
  const auto points = sampled(path, 0.1);
  EXPECT_EQ(points.front().pose, path.start);
  EXPECT_EQ(points.back().pose, end_pose(path));
  EXPECT_EQ(points.front().gear, Gear::forward);
  EXPECT_EQ(points.back().gear, Gear::reverse);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_LE(points[i].s - points[i - 1].s, 0.1 + 1e-12);
  }
}

TEST(Path, ASegmentHasTheGearOfItsLength) {
  EXPECT_EQ((Segment{0.1, 2}).gear(), Gear::forward);
  EXPECT_EQ((Segment{0.1, -2}).gear(), Gear::reverse);
  EXPECT_EQ(direction_of(Gear::forward), 1);
  EXPECT_EQ(direction_of(Gear::reverse), -1);
  EXPECT_EQ(name_of(Gear::forward), "forward");
  EXPECT_EQ(name_of(gear_of(-0.5)), "reverse");
}

TEST(Path, MergedJoinsEqualNeighboursOnly) {
  const Segment segments[] = {{0, 2}, {0, 1}, {0, -1}, {0.1, 0}, {0.1, -2}};
  const std::vector<Segment> expected = {{0, 3}, {0, -1}, {0.1, -2}};
  EXPECT_EQ(merged(segments), expected);
}

TEST(WrapAngle, PiBecomesMinusPi) { EXPECT_EQ(wrap_angle(pi), -pi); }

}  // namespace
}  // namespace vandplan

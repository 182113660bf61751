// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "support/radius.h"
#include "vandplan/steering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/cases.h"
#include "support/leads.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using std::numbers::pi;

TEST(Dubins, EqualPosesNeedNoSegments) {
  const Piece piece = dubins({1, 2, 3}, {1, 2, 3}, default_radius);
  EXPECT_EQ(piece.count, 0);
  EXPECT_EQ(piece.length, 0);
}

TEST(Dubins, HeadingsThatDifferByWholeTurnsAreEqual) {
  EXPECT_NEAR(dubins_length({1, 2, 0.3}, {1, 2, 0.3 + 4 * pi}, default_radius), 0, 1e-12);
}

TEST(Dubins, StraightAheadIsOneLine) {
  const Piece piece = dubins({0, 0, 0}, {10, 0, 0}, default_radius);
  ASSERT_EQ(piece.count, 1);
  EXPECT_EQ(piece.segments[0].curvature, 0);
  EXPECT_DOUBLE_EQ(piece.segments[0].length, 10);
}

TEST(Dubins, HalfTurnLeftIsOneArc) {
  const Piece piece = dubins({0, 0, 0}, {0, 14, pi}, default_radius);
  EXPECT_NEAR(piece.length, 7 * pi, 1e-9);
  EXPECT_TRUE(leads(piece, {0, 0, 0}, {0, 14, pi}));
}

TEST(Dubins, OneMetreBackNeedsAlmostTwoFullTurns) {
  // RLR or LRL: three arcs; the middle one turns more than pi.
  const Piece piece = dubins({0, 0, 0}, {-1, 0, 0}, default_radius);
  EXPECT_EQ(piece.count, 3);
  EXPECT_TRUE(leads(piece, {0, 0, 0}, {-1, 0, 0}));
}

TEST(Dubins, ShortArcsAreNotRoundedUpToFullTurns) {
  for_each_case(1, 40'000, [](Rng& rng) {
    const Pose from = uniform_pose({-50, 50, -50, 50}, rng);
    const double curvature = rng() % 2 == 0 ? 1 / default_radius : -1 / default_radius;
    const Segment arc{curvature, uniform(0, 40, rng)};
    const Pose to = advance(from, arc);
    EXPECT_NEAR(dubins_length(from, to, default_radius), arc.length, 1e-6)
        << as_code(from) << ", " << as_code(to);
  });
}

TEST(Dubins, IsTheShortestWordAndEveryWordEndsAtTheGoal) {
  for_each_case(2, 40'000, [](Rng& rng) {
    const Pose from = uniform_pose({-10, 10, -10, 10}, rng);
    const Pose to = uniform_pose({-10, 10, -10, 10}, rng);
    SCOPED_TRACE(as_code(from) + ", " + as_code(to));
    double least = INFINITY;
    for (const Piece& piece : dubins_words(from, to, default_radius)) {
      EXPECT_TRUE(leads(piece, from, to));
      least = std::min(least, piece.length);
    }
    EXPECT_EQ(dubins(from, to, default_radius).length, least);
    EXPECT_EQ(dubins_length(from, to, default_radius), least);
  });
}

}  // namespace
}  // namespace vandplan

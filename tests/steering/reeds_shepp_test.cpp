// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "support/radius.h"
#include "vandplan/steering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "support/cases.h"
#include "support/leads.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using std::numbers::pi;

TEST(ReedsShepp, EqualPosesNeedNoSegments) {
  const Piece piece = reeds_shepp({1, 2, 3}, {1, 2, 3}, default_radius);
  EXPECT_EQ(piece.count, 0);
  EXPECT_EQ(piece.length, 0);
}

TEST(ReedsShepp, HeadingsThatDifferByWholeTurnsAreEqual) {
  EXPECT_NEAR(reeds_shepp_length({1, 2, 0.3}, {1, 2, 0.3 + 4 * pi}, default_radius), 0, 1e-12);
}

TEST(ReedsShepp, StraightBackIsOneLineInReverse) {
  const Piece piece = reeds_shepp({0, 0, 0}, {-10, 0, 0}, default_radius);
  ASSERT_EQ(piece.count, 1);
  EXPECT_EQ(piece.segments[0].curvature, 0);
  EXPECT_DOUBLE_EQ(piece.segments[0].length, -10);
}

TEST(ReedsShepp, PureRotationIsAsLongAsItsArc) {
  for (const double turn : {1e-6, 0.1, 1.0, pi / 2, 3.0, pi, -pi, -2.0}) {
    const Piece piece = reeds_shepp({4, -3, 0.5}, {4, -3, 0.5 + turn}, default_radius);
    EXPECT_NEAR(piece.length, default_radius * std::abs(turn), 1e-9) << turn;
    EXPECT_TRUE(leads(piece, {4, -3, 0.5}, {4, -3, 0.5 + turn}));
  }
}

/// Turns and gears, such as "L+R-L+".
std::string word_of(const Piece& piece) {
  std::string word;
  for (const Segment& segment : piece.view()) {
    word += segment.curvature > 0 ? 'L' : segment.curvature < 0 ? 'R' : 'S';
    word += segment.length > 0 ? '+' : '-';
  }
  return word;
}

TEST(ReedsShepp, ThereAre48WordsAndNoneIsListedTwice) {
  std::set<std::string> all;
  for_each_case(1, 20'000, [&](Rng& rng) {
    std::set<std::string> here;
    for (const Piece& piece :
         reeds_shepp_words({}, uniform_pose({-50, 50, -50, 50}, rng), default_radius)) {
      EXPECT_TRUE(here.insert(word_of(piece)).second) << word_of(piece);
    }
    all.merge(here);
  });
  EXPECT_EQ(all.size(), 48U);
}

TEST(ReedsShepp, AShiftAcrossIsFourArcsAndCostsFarMoreThanItsWidth) {
  // At unit radius two arcs of angle a and back again shift by 4 (1 - cos a).
  const double a = std::acos(1 - 0.5 / 7 / 4);
  const Piece piece = reeds_shepp({0, 0, 0}, {0, 0.5, 0}, default_radius);
  EXPECT_EQ(piece.count, 4);
  EXPECT_LT(piece.length, 4 * a * default_radius + 1e-12);
  EXPECT_GT(piece.length, 5);  // half a metre sideways costs ten times as much
  EXPECT_TRUE(leads(piece, {0, 0, 0}, {0, 0.5, 0}));
}

TEST(ReedsShepp, BackIsTheSameWayReversed) {
  for_each_case(2, 40'000, [](Rng& rng) {
    const Pose from = uniform_pose({-10, 10, -10, 10}, rng);
    const Pose to = uniform_pose({-10, 10, -10, 10}, rng);
    const Piece there = reeds_shepp(from, to, default_radius);
    const Piece back = reversed(reeds_shepp(to, from, default_radius));
    SCOPED_TRACE(as_code(from) + ", " + as_code(to));
    EXPECT_EQ(there.length, back.length);
    ASSERT_EQ(there.count, back.count);
    for (std::size_t i = 0; i < there.count; ++i) EXPECT_EQ(there.segments[i], back.segments[i]);
  });
}

TEST(ReedsShepp, IsTheShortestWordAndEveryWordEndsAtTheGoal) {
  for_each_case(3, 8000, [](Rng& rng) {
    const Pose from = uniform_pose({-10, 10, -10, 10}, rng);
    const Pose to = uniform_pose({-10, 10, -10, 10}, rng);
    SCOPED_TRACE(as_code(from) + ", " + as_code(to));
    double least = INFINITY;
    for (const Piece& piece : reeds_shepp_words(from, to, default_radius)) {
      EXPECT_TRUE(leads(piece, from, to));
      least = std::min(least, piece.length);
    }
    const Piece piece = reeds_shepp(from, to, default_radius);
    EXPECT_NEAR(piece.length, least, 1e-12 * least);
    EXPECT_EQ(reeds_shepp_length(from, to, default_radius), piece.length);
    EXPECT_TRUE(leads(piece, from, to));
  });
}

}  // namespace
}  // namespace vandplan

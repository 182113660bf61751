// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/leads.h"
#include "support/pair_cases.h"
#include "support/radius.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

constexpr int dubins_pairs = 400'000;

// The length of a Dubins path jumps by a full circle where an arc vanishes. Laws that compare two
// computations of one path therefore keep away from borders between words.

DrawnPair dubins_pair(Rng& rng) { return any_pair(default_radius, rng); }

TEST(DubinsLaw, EndsAtTheGoalAndNeverReverses) {
  for_each_pair(1, dubins_pairs, dubins_pair, [](const DrawnPair& pair, Rng&) {
    const Piece piece = dubins(pair.from, pair.to, default_radius);
    EXPECT_TRUE(leads(piece, pair.from, pair.to));
    EXPECT_NEAR(length(piece.view()), piece.length, 1e-14 * piece.length) << as_code(pair);
    for (const Segment& segment : piece.view()) EXPECT_GT(segment.length, 0) << as_code(pair);
  });
}

TEST(DubinsLaw, IsTheLeastOfAllWordsAndEveryWordEndsAtTheGoal) {
  for_each_pair(2, dubins_pairs, near_or_far_pair, [](const DrawnPair& pair, Rng&) {
    double least = std::numeric_limits<double>::infinity();
    for (const Piece& piece : dubins_words(pair.from, pair.to, default_radius)) {
      EXPECT_TRUE(leads(piece, pair.from, pair.to));
      least = std::min(least, piece.length);
    }
    EXPECT_EQ(dubins_length(pair.from, pair.to, default_radius), least) << as_code(pair);
  });
}

TEST(DubinsLaw, MirroringChangesNothing) {
  for_each_pair(3, dubins_pairs, near_or_far_pair, [](const DrawnPair& pair, Rng&) {
    const auto mirrored = [](const Pose& p) { return Pose{p.x, -p.y, -p.heading}; };
    EXPECT_EQ(dubins_length(mirrored(pair.from), mirrored(pair.to), default_radius),
              dubins_length(pair.from, pair.to, default_radius))
        << as_code(pair);
  });
}

TEST(DubinsLaw, DrivenFromTheOtherEndWithTheHeadingsTurnedItIsAsLong) {
  for_each_pair(4, dubins_pairs, near_or_far_pair, [](const DrawnPair& pair, Rng&) {
    const auto turned = [](const Pose& p) { return Pose{p.x, p.y, p.heading + std::numbers::pi}; };
    EXPECT_NEAR(dubins_length(turned(pair.to), turned(pair.from), default_radius),
                dubins_length(pair.from, pair.to, default_radius), 1e-9)
        << as_code(pair);
  });
}

TEST(DubinsLaw, MotionChangesNothing) {
  for_each_pair(5, dubins_pairs, near_or_far_pair, [](const DrawnPair& pair, Rng& rng) {
    const Pose frame = uniform_pose({-100, 100, -100, 100}, rng);
    const double expected = dubins_length(pair.from, pair.to, default_radius);
    EXPECT_NEAR(dubins_length(compose(frame, pair.from), compose(frame, pair.to), default_radius),
                expected, 1e-9)
        << as_code(pair) << " moved by " << as_code(frame);
  });
}

TEST(DubinsLaw, LengthScalesWithTheRadius) {
  for_each_pair(6, dubins_pairs, near_or_far_pair, [](const DrawnPair& pair, Rng& rng) {
    const double scale = std::exp(uniform(-3, 3, rng));
    const auto scaled = [&](const Pose& p) { return Pose{scale * p.x, scale * p.y, p.heading}; };
    EXPECT_NEAR(dubins_length(scaled(pair.from), scaled(pair.to), scale * default_radius) / scale,
                dubins_length(pair.from, pair.to, default_radius), 1e-9)
        << as_code(pair) << " times " << as_code(scale);
  });
}

TEST(DubinsLaw, ADetourIsNoShorter) {
  for_each_pair(7, dubins_pairs, near_or_far_pair, [](const DrawnPair& pair, Rng& rng) {
    const Pose via =
        uniform_pose({pair.from.x - 20, pair.from.x + 20, pair.from.y - 20, pair.from.y + 20}, rng);
    EXPECT_LE(dubins_length(pair.from, pair.to, default_radius),
              dubins_length(pair.from, via, default_radius) +
                  dubins_length(via, pair.to, default_radius) + 1e-9)
        << as_code(pair) << " by " << as_code(via);
  });
}

TEST(DubinsLaw, IsNoShorterThanReedsSheppAndExceedsALineByABoundedLength) {
  for_each_pair(8, dubins_pairs, near_or_far_pair, [](const DrawnPair& pair, Rng&) {
    const double length = dubins_length(pair.from, pair.to, default_radius);
    const double line = std::hypot(pair.to.x - pair.from.x, pair.to.y - pair.from.y);
    EXPECT_GE(length, reeds_shepp_length(pair.from, pair.to, default_radius) * (1 - 1e-14))
        << as_code(pair);
    // Savla, Frazzoli & Bullo 2005.
    EXPECT_LE(length, line + 2.658 * std::numbers::pi * default_radius) << as_code(pair);
  });
}

}  // namespace
}  // namespace vandplan

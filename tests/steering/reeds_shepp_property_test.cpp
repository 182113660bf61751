// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "steering/mean_frame.h"
#include "steering/reeds_shepp_formulas.h"
#include "support/leads.h"
#include "support/pair_cases.h"
#include "support/radius.h"
#include "support/reeds_shepp_oracle.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

constexpr int reeds_shepp_pairs = 400'000;

DrawnPair reeds_shepp_pair(Rng& rng) { return any_pair(default_radius, rng); }

double least_word(const DrawnPair& pair) {
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& piece : reeds_shepp_words(pair.from, pair.to, default_radius)) {
    least = std::min(least, piece.length);
  }
  return least;
}

/// How much the length may change when rounding moves a pose by `shift`: near its start a path
/// of length L that moves sideways changes by up to 4 R/L metres per metre.
double tolerance(double length, double shift) {
  return shift * (2 + 8 * default_radius / std::max(length, std::sqrt(shift)));
}

TEST(ReedsSheppLaw, EndsAtTheGoal) {
  for_each_pair(1, reeds_shepp_pairs, reeds_shepp_pair, [](const DrawnPair& pair, Rng&) {
    const Piece piece = reeds_shepp(pair.from, pair.to, default_radius);
    EXPECT_TRUE(leads(piece, pair.from, pair.to));
    EXPECT_NEAR(length(piece.view()), piece.length, 1e-14 * piece.length + 1e-12) << as_code(pair);
    for (const Segment& segment : piece.view()) EXPECT_NE(segment.length, 0) << as_code(pair);
  });
}

TEST(ReedsSheppLaw, TheWayBackIsTheWayThereReversedBitForBit) {
  for_each_pair(2, reeds_shepp_pairs, reeds_shepp_pair, [](const DrawnPair& pair, Rng&) {
    const Piece there = reeds_shepp(pair.from, pair.to, default_radius);
    const Piece back = reversed(reeds_shepp(pair.to, pair.from, default_radius));
    EXPECT_EQ(there.length, back.length) << as_code(pair);
    EXPECT_TRUE(std::ranges::equal(there.view(), back.view())) << as_code(pair);
    EXPECT_EQ(reeds_shepp_length(pair.from, pair.to, default_radius), there.length)
        << as_code(pair);
  });
}

TEST(ReedsSheppLaw, MirroringChangesNothingBitForBit) {
  for_each_pair(3, reeds_shepp_pairs, reeds_shepp_pair, [](const DrawnPair& pair, Rng&) {
    const auto mirrored = [](const Pose& p) { return Pose{p.x, -p.y, -p.heading}; };
    EXPECT_EQ(reeds_shepp_length(mirrored(pair.from), mirrored(pair.to), default_radius),
              reeds_shepp_length(pair.from, pair.to, default_radius))
        << as_code(pair);
  });
}

TEST(ReedsSheppLaw, MotionChangesNothing) {
  for_each_pair(4, reeds_shepp_pairs, reeds_shepp_pair, [](const DrawnPair& pair, Rng& rng) {
    const Pose frame = uniform_pose({-100, 100, -100, 100}, rng);
    const double expected = reeds_shepp_length(pair.from, pair.to, default_radius);
    EXPECT_NEAR(
        reeds_shepp_length(compose(frame, pair.from), compose(frame, pair.to), default_radius),
        expected, tolerance(expected, 1e-12) + 1e-12 * expected)
        << as_code(pair) << " moved by " << as_code(frame);
  });
}

TEST(ReedsSheppLaw, LengthScalesWithTheRadius) {
  for_each_pair(5, reeds_shepp_pairs, reeds_shepp_pair, [](const DrawnPair& pair, Rng& rng) {
    const double scale = std::exp(uniform(-3, 3, rng));
    const auto scaled = [&](const Pose& p) { return Pose{scale * p.x, scale * p.y, p.heading}; };
    const double expected = reeds_shepp_length(pair.from, pair.to, default_radius);
    EXPECT_NEAR(
        reeds_shepp_length(scaled(pair.from), scaled(pair.to), scale * default_radius) / scale,
        expected, tolerance(expected, 1e-12) + 1e-12 * expected)
        << as_code(pair) << " times " << as_code(scale);
  });
}

TEST(ReedsSheppLaw, ADetourIsNoShorter) {
  for_each_pair(6, reeds_shepp_pairs, reeds_shepp_pair, [](const DrawnPair& pair, Rng& rng) {
    const Pose via =
        uniform01(rng) < 0.5
            ? uniform_pose({pair.from.x - 20, pair.from.x + 20, pair.from.y - 20, pair.from.y + 20},
                           rng)
            : border_pair(default_radius, rng).to;
    EXPECT_LE(reeds_shepp_length(pair.from, pair.to, default_radius),
              reeds_shepp_length(pair.from, via, default_radius) +
                  reeds_shepp_length(via, pair.to, default_radius) + 1e-9)
        << as_code(pair) << " by " << as_code(via);
  });
}

TEST(ReedsSheppLaw, IsNoShorterThanALineOrTheTurnOfTheHeading) {
  for_each_pair(7, reeds_shepp_pairs, reeds_shepp_pair, [](const DrawnPair& pair, Rng&) {
    const double length = reeds_shepp_length(pair.from, pair.to, default_radius);
    const double line = std::hypot(pair.to.x - pair.from.x, pair.to.y - pair.from.y);
    const double turn = std::remainder(pair.to.heading - pair.from.heading, 2 * std::numbers::pi);
    EXPECT_GE(length, line * (1 - 1e-15) - 1e-12) << as_code(pair);
    EXPECT_GE(length, default_radius * std::abs(turn) * (1 - 1e-15) - 1e-12) << as_code(pair);
  });
}

TEST(ReedsSheppLaw, IsTheLeastOfAllWords) {
  for_each_pair(8, reeds_shepp_pairs, reeds_shepp_pair, [](const DrawnPair& pair, Rng&) {
    const double least = least_word(pair);
    // The parts of a listed word are right to 10^-12 rad.
    EXPECT_NEAR(reeds_shepp_length(pair.from, pair.to, default_radius), least,
                1e-12 * least + 4e-12 * default_radius)
        << as_code(pair);
  });
}

TEST(ReedsSheppLaw, IsTheLeastOfAllWordsToTheLastBitsForTinyAndForRandomOffsets) {
  for_each_pair(9, reeds_shepp_pairs, reeds_shepp_pair, [](const DrawnPair&, Rng& rng) {
    const DrawnPair pair = uniform01(rng) < 0.5 ? tiny_pair(rng) : near_pair(20, rng);
    const double least = least_word(pair);
    EXPECT_NEAR(reeds_shepp_length(pair.from, pair.to, default_radius), least, 1e-14 * least)
        << as_code(pair);
  });
}

/// The ends of a word in the range in which no turn of the other way and no gear change pays, and
/// how long they may be there (docs/proofs/steering.md).
struct Range {
  double least, most, limit;
};

Range range_of(const steering::reeds_shepp_formulas::Solution& solution) {
  using steering::reeds_shepp_formulas::Formula;
  const auto& [formula, arcs] = solution;
  const auto [least, most] = std::minmax(arcs.first, arcs.last);
  const bool has_line = arcs.line != 0 || arcs.inner == 0;
  const double quarter = std::numbers::pi / 2;
  if (formula == Formula::l_r_l) return {least, most, std::numbers::pi};
  return {least, most, has_line ? quarter : std::min(arcs.inner, quarter)};
}

TEST(ReedsSheppLaw, TheEndsOfTheChosenWordAreInTheRangeThatMakesItShortest) {
  for_each_pair(12, reeds_shepp_pairs, reeds_shepp_pair, [](const DrawnPair&, Rng& rng) {
    const DrawnPair pair = uniform01(rng) < 0.5 ? tiny_pair(rng) : near_pair(20, rng);
    const steering::MeanFrame f = steering::mean_frame(pair.from, pair.to, default_radius);
    const Range range = range_of(steering::reeds_shepp_formulas::shortest(
        steering::Circles({std::abs(f.x), std::abs(f.y), std::abs(f.half_turn)})));
    EXPECT_GE(range.least, -1e-9) << as_code(pair);
    EXPECT_LE(range.most, range.limit + 1e-9) << as_code(pair);
  });
}

TEST(ReedsSheppLaw, EveryWordEndsAtTheGoal) {
  for_each_pair(10, reeds_shepp_pairs / 10, reeds_shepp_pair, [](const DrawnPair& pair, Rng&) {
    for (const Piece& piece : reeds_shepp_words(pair.from, pair.to, default_radius)) {
      EXPECT_TRUE(leads(piece, pair.from, pair.to));
    }
  });
}

TEST(ReedsSheppLaw, IsAsLongAsTheFormulasOfThePaperSay) {
  for_each_pair(11, reeds_shepp_pairs / 4, reeds_shepp_pair, [](const DrawnPair& pair, Rng&) {
    const auto expected =
        static_cast<double>(oracle::reeds_shepp_length(pair.from, pair.to, default_radius));
    // The paper's formulas lose half of the digits of tiny offsets.
    EXPECT_NEAR(reeds_shepp_length(pair.from, pair.to, default_radius), expected,
                tolerance(expected, 1e-14) + 1e-14 * expected)
        << as_code(pair);
  });
}

TEST(ReedsSheppLaw, IsExactWhereTheFirstLeftCircleIsTheLastRightOne) {
  for_each_pair(13, reeds_shepp_pairs / 10, reeds_shepp_pair, [](const DrawnPair&, Rng& rng) {
    const double half_turn = uniform(0, std::numbers::pi / 2, rng);
    const double offset = std::pow(10.0, uniform(-12.0, 0.0, rng));
    const double bearing = uniform(-std::numbers::pi, std::numbers::pi, rng);
    const double x = offset * std::cos(bearing);
    const double y = 2 * std::cos(half_turn) + offset * std::sin(bearing);
    const DrawnPair pair{{-x / 2, -y / 2, -half_turn}, {x / 2, y / 2, half_turn}};
    const auto expected = static_cast<double>(oracle::reeds_shepp_length(pair.from, pair.to, 1));
    EXPECT_NEAR(reeds_shepp_length(pair.from, pair.to, 1), expected, 1e-13) << as_code(pair);
  });
}

}  // namespace
}  // namespace vandplan

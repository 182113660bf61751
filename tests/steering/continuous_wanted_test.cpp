// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_wanted.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "steering/continuous_law.h"

namespace vandplan {
namespace {

constexpr double radius = law_radius;

/// What a metre in reverse, a change of gear and turning the wheels to full lock may cost.
struct Prices {
  double reverse, gear_change, full_lock;
};

Prices any_prices(Rng& rng) {
  const auto maybe = [&](double least, double most) {
    return chance(0.4, rng) ? 0 : any_size(least, most, rng);
  };
  return {any_size(1, 5, rng), maybe(0.1, 20), maybe(0.1, 10)};
}

double cost(const Piece& piece, const ContinuousCase& c, const Prices& prices) {
  const bool rolls = c.steering.continuity() == Continuity::throughout || !c.query.start_stands;
  double curvature =
      rolls || piece.count == 0 ? c.query.start_curvature : piece.segments[0].curvature;
  double sum = 0, last = 0;
  for (const Segment& s : piece.view()) {
    const double length = std::abs(s.length);
    const double change = std::abs(s.curvature - curvature) + std::abs(s.curvature_rate) * length;
    curvature = curvature_at(s, length);
    sum += length * (s.length < 0 ? prices.reverse : 1) + change * radius * prices.full_lock;
    sum += last * s.length < 0 ? prices.gear_change : 0;
    last = s.length;
  }
  return sum;
}

ContinuousCase drawn_case(Rng& rng) {
  const double ramp = any_size(1e-2, 0.5, rng);
  const Continuity kind = chance(0.3, rng) ? Continuity::throughout : Continuity::between_stops;
  ContinuousCase c{{radius, 1 / (ramp * radius * radius), kind}, near_or_far_pair(rng), {}};
  c.query.start_stands = chance(0.5, rng);
  c.query.goal_stands = chance(0.5, rng);
  if (chance(0.3, rng)) {
    c.query.start_curvature = any_curvature(radius, rng);
    c.query.goal_curvature = any_curvature(radius, rng);
  }
  return c;
}

std::vector<Piece> words_of(const ContinuousCase& c, int gear_changes, double longest) {
  std::vector<Piece> words;
  steering::find_continuous_words(c.steering, c.pair.from, c.pair.to, c.query,
                                  {gear_changes, longest}, words);
  return words;
}

TEST(ContinuousWanted, WordsAreDrivableAndShortEnough) {
  for_each_continuous_case(1, 100'000, [](const ContinuousCase& c, Rng& rng) {
    const double longest =
        c.steering.length(c.pair.from, c.pair.to, c.query) * any_size(0.9, 4, rng);
    for (const int changes : {0, 1, 2}) {
      for (const Piece& word : words_of(c, changes, longest)) {
        EXPECT_TRUE(is_drivable(word, c)) << as_code(c);
        EXPECT_LT(word.length, longest) << as_code(c);
      }
    }
  });
}

TEST(ContinuousWanted, CheapestIsThatOfAllCandidates) {
  int all = 0, equal = 0, near = 0;
  for_each_case(2, 2000, [&](Rng& rng) {
    const ContinuousCase c = drawn_case(rng);
    const Prices prices = any_prices(rng);
    const auto shortest = c.steering.steer(c.pair.from, c.pair.to, c.query);
    ASSERT_TRUE(shortest);
    double found = cost(*shortest, c, prices);
    for (const int changes : {0, 1, 2}) {
      for (const Piece& word : words_of(c, changes, found)) {
        found = std::min(found, cost(word, c, prices));
      }
    }
    double least = found;
    for (const Piece& piece : c.steering.candidates(c.pair.from, c.pair.to, c.query)) {
      least = std::min(least, cost(piece, c, prices));
    }
    ++all;
    equal += found <= least * (1 + 1e-9) ? 1 : 0;
    near += found <= least * 1.02 ? 1 : 0;
  });
  EXPECT_GE(equal, all * 0.99 - 1);
  EXPECT_GE(near, all * 0.995 - 1);
}

TEST(ContinuousWanted, WithoutGearChangeThereIsOneGear) {
  for_each_case(3, 2000, [](Rng& rng) {
    ContinuousCase c = drawn_case(rng);
    c.query.start_curvature = c.query.goal_curvature = 0;
    const auto length = c.steering.length(c.pair.from, c.pair.to, c.query);
    for (const Piece& word : words_of(c, 0, 3 * length + 10 * radius)) {
      EXPECT_EQ(gear_changes(word.view()), 0) << as_code(c);
    }
    for (const Piece& word : words_of(c, 1, 3 * length)) {
      EXPECT_LE(gear_changes(word.view()), 1) << as_code(c);
    }
  });
}

TEST(ContinuousWanted, StraightOnIsOneLine) {
  const ContinuousSteering steering(radius, 0.11, Continuity::throughout);
  const DrawnPair pair{{0, 0, 0}, {5, 0, 0}};
  const std::vector<Piece> words = words_of({steering, pair, {}}, 0, 6);
  ASSERT_EQ(words.size(), 1U);
  ASSERT_EQ(words[0].count, 1);
  EXPECT_NEAR(words[0].segments[0].length, 5, 1e-12);
}

TEST(ContinuousWanted, EqualWordsComeOnce) {
  const ContinuousSteering steering(radius, 0.11, Continuity::between_stops);
  // An arc alone is a word of several formulas.
  const Pose goal = advance({0, 0, 0}, {1 / radius, 5.0});
  const std::vector<Piece> words = words_of({steering, {{0, 0, 0}, goal}, {}}, 0, 5.001);
  EXPECT_LE(words.size(), 1U);
}

// Who knows how the path begins and ends gets those words of all that begin and end so.
TEST(ContinuousWanted, GearsAtTheEndsLeaveOutTheOthers) {
  for_each_continuous_case(5, 20'000, [](const ContinuousCase& c, Rng& rng) {
    if (c.query.start_curvature != 0 || c.query.goal_curvature != 0) return;
    const int changes = static_cast<int>(rng() % 3);
    const double longest = 2 * c.steering.length(c.pair.from, c.pair.to, c.query);
    const int first = rng() % 2 == 0 ? 1 : -1;
    const int last = rng() % 2 == 0 ? 1 : -1;
    std::vector<Piece> words;
    steering::find_continuous_words(c.steering, c.pair.from, c.pair.to, c.query,
                                    {changes, longest, first, last}, words);
    const std::vector<Piece> all = words_of(c, changes, longest);
    EXPECT_LE(words.size(), all.size());
    const auto fits = [&](const Piece& piece) {
      const int changed = gear_changes(piece.view());
      return piece.segments[0].length * first > 0 &&
             piece.segments[piece.count - 1U].length * last > 0 && changed == changes;
    };
    EXPECT_EQ(std::ranges::count_if(words, fits), std::ranges::count_if(all, fits));
  });
}

}  // namespace
}  // namespace vandplan

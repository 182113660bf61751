// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous/priced_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "steering/continuous_law.h"

namespace vandplan {
namespace {

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
    sum += length * (s.length < 0 ? prices.reverse : 1) + change * law_radius * prices.full_lock;
    sum += last * s.length < 0 ? prices.gear_change : 0;
    last = s.length;
  }
  return sum;
}

ContinuousCase drawn_case(Rng& rng) {
  const double ramp = any_size(1e-2, 0.5, rng);
  const Continuity kind = chance(0.3, rng) ? Continuity::throughout : Continuity::between_stops;
  ContinuousCase c{
      {law_radius, 1 / (ramp * law_radius * law_radius), kind}, near_or_far_pair(rng), {}};
  c.query.start_stands = chance(0.5, rng);
  c.query.goal_stands = chance(0.5, rng);
  if (chance(0.3, rng)) {
    c.query.start_curvature = any_curvature(law_radius, rng);
    c.query.goal_curvature = any_curvature(law_radius, rng);
  }
  return c;
}

std::vector<Piece> words_of(const ContinuousCase& c, int gear_changes, double longest,
                            int first_gear = 0, int last_gear = 0) {
  std::vector<Piece> words;
  const std::array ends{steering::continuous::PieceEnds{c.query, first_gear, last_gear}};
  steering::continuous::for_priced_pieces(c.steering, c.pair.from, c.pair.to, ends,
                                          {gear_changes, longest},
                                          [&](const Piece& word, std::size_t) {
                                            if (word.length < longest) words.push_back(word);
                                            return longest;
                                          });
  return words;
}

/// The least cost of a word with so many gear changes, as the search for it finds it.
double cheapest(const ContinuousCase& c, const Prices& prices, int gear_changes, double cutoff) {
  const std::array ends{steering::continuous::PieceEnds{c.query}};
  double least = cutoff;
  steering::continuous::for_priced_pieces(
      c.steering, c.pair.from, c.pair.to, ends,
      {gear_changes, cutoff, 1.0, prices.reverse, prices.gear_change},
      [&](const Piece& word, std::size_t) {
        return least = std::min(least, cost(word, c, prices));
      });
  return least;
}

TEST(ContinuousPriced, WordsAreDrivableAndShortEnough) {
  for_each_continuous_case(1, 40'000, [](const ContinuousCase& c, Rng& rng) {
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

TEST(ContinuousPriced, CheapestIsThatOfAllCandidates) {
  int all = 0, equal = 0, near = 0;
  for_each_case(2, 800, [&](Rng& rng) {
    const ContinuousCase c = drawn_case(rng);
    const Prices prices = any_prices(rng);
    const auto shortest = c.steering.steer(c.pair.from, c.pair.to, c.query);
    ASSERT_TRUE(shortest);
    double found = cost(*shortest, c, prices);
    for (const int changes : {0, 1, 2}) found = cheapest(c, prices, changes, found);
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

TEST(ContinuousPriced, WithoutGearChangeThereIsOneGear) {
  for_each_case(3, 800, [](Rng& rng) {
    ContinuousCase c = drawn_case(rng);
    c.query.start_curvature = c.query.goal_curvature = 0;
    const auto length = c.steering.length(c.pair.from, c.pair.to, c.query);
    for (const Piece& word : words_of(c, 0, 3 * length + 10 * law_radius)) {
      EXPECT_EQ(gear_changes(word.view()), 0) << as_code(c);
    }
    for (const Piece& word : words_of(c, 1, 3 * length)) {
      EXPECT_LE(gear_changes(word.view()), 1) << as_code(c);
    }
  });
}

TEST(ContinuousPriced, StraightOnIsOneLine) {
  const ContinuousSteering steering(law_radius, 0.11, Continuity::throughout);
  const DrawnPair pair{{0, 0, 0}, {5, 0, 0}};
  const std::vector<Piece> words = words_of({steering, pair, {}}, 0, 6);
  ASSERT_FALSE(words.empty());
  for (const Piece& word : words) {
    ASSERT_EQ(word.count, 1);
    EXPECT_NEAR(word.segments[0].length, 5, 1e-12);
  }
}

// Straight on, 5 m. What is driven before and after is part of the cost.
TEST(ContinuousPriced, WhatCostsTooMuchIsLeftOut) {
  const ContinuousSteering steering(law_radius, 0.11, Continuity::between_stops);
  const auto count = [&](double x, int before, int after, double cutoff) {
    const std::array ends{steering::continuous::PieceEnds{}};
    int words = 0;
    steering::continuous::for_priced_pieces(steering, {0, 0, 0}, {x, 0, 0}, ends,
                                            {0, cutoff, 1.0, 2.0, 3.0, before, after},
                                            [&](const Piece&, std::size_t) {
                                              ++words;
                                              return 0.0;
                                            });
    return words;
  };
  EXPECT_EQ(count(5, 1, 1, 5.1), 1);
  EXPECT_EQ(count(5, 1, 1, 4.9), 0);
  EXPECT_EQ(count(5, -1, 1, 7.9), 0);
  EXPECT_EQ(count(5, -1, 1, 8.1), 1);
  EXPECT_EQ(count(5, -1, -1, 10.9), 0);
  EXPECT_EQ(count(5, -1, -1, 11.1), 1);
  EXPECT_EQ(count(-5, 0, 0, 9.9), 0);
  EXPECT_EQ(count(-5, 0, 0, 10.1), 1);
}

// By the arcs of Reeds and Shepp the first of all words is the least one nearly always.
TEST(ContinuousPriced, TheLeastComeFirst) {
  int all = 0, first = 0;
  for_each_case(6, 800, [&](Rng& rng) {
    ContinuousCase c = drawn_case(rng);
    c.query.start_curvature = c.query.goal_curvature = 0;
    const std::vector<Piece> words =
        words_of(c, 1, 2 * c.steering.length(c.pair.from, c.pair.to, c.query));
    if (words.size() < 2) return;
    const auto is_less = [](const Piece& a, const Piece& b) { return a.length < b.length; };
    ++all;
    first += words.front().length <= std::ranges::min_element(words, is_less)->length * (1 + 1e-9)
                 ? 1
                 : 0;
  });
  EXPECT_GE(first, all * 0.8);
}

// Who knows how the path begins and ends gets those words of all that begin and end so.
TEST(ContinuousPriced, GearsAtTheEndsLeaveOutTheOthers) {
  for_each_continuous_case(5, 20'000, [](const ContinuousCase& c, Rng& rng) {
    if (c.query.start_curvature != 0 || c.query.goal_curvature != 0) return;
    const int changes = static_cast<int>(rng() % 3);
    const double longest = 2 * c.steering.length(c.pair.from, c.pair.to, c.query);
    const int first = rng() % 2 == 0 ? 1 : -1;
    const int last = rng() % 2 == 0 ? 1 : -1;
    const std::vector<Piece> words = words_of(c, changes, longest, first, last);
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

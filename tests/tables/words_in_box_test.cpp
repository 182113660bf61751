// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What the builder of the table of bounds says of a box of pairs holds for each of its pairs, and
// rounding stays below its margin.

#include "tables/words_in_box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "simd/bound_grid.h"
#include "support/cases.h"
#include "support/draws.h"
#include "tables/excess.h"

namespace vandplan::tables {
namespace {

using namespace words_in_box;

using std::numbers::pi;
constexpr std::array<bool, 4> all_circles{true, true, true, true};

/// The radial coordinate of a distance.
double radial_of(double distance) { return distance / (distance + simd::radial_reach); }

/// From one corner to the opposite one.
PairBox box_between(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const auto range = [&](std::size_t k) {
    return Interval{std::min(a[k], b[k]), std::max(a[k], b[k])};
  };
  return {range(0), range(1), range(2)};
}

/// Coordinates of a pair in which two turning circles of the same or of different sides coincide.
std::array<double, 3> coinciding(bool same_side, double turn) {
  const double half = turn * pi / 2;
  const double distance = 2 * (same_side ? std::sin(half) : std::cos(half));
  return {radial_of(distance), same_side ? 0.0 : 1.0, turn};
}

/// A box with such a pair in it or on its border, up to a third of all pairs wide.
PairBox box_where_circles_coincide(Rng& rng) {
  const std::array<double, 3> there = coinciding(chance(0.5, rng), uniform(0.05, 0.95, rng));
  std::array<double, 3> low = there;
  std::array<double, 3> high = there;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = std::max(0.0, there[k] - any_size(1e-6, 0.3, rng));
    high[k] = std::min(k == 0 ? 0.9 : 1.0, there[k] + any_size(1e-6, 0.3, rng));
  }
  return box_between(low, high);
}

double inside(Interval range, Rng& rng) {
  const double draw = uniform01(rng);
  if (draw < 0.2) return draw < 0.1 ? range.low : range.high;
  return uniform(range.low, range.high, rng);
}

/// The arc lies in the interval, whole turns and all.
bool holds(Interval range, Interval arc) {
  return range.low <= arc.high + 2 * margin && range.high >= arc.low - 2 * margin;
}

TEST(WordsInBox, ArcsAreAroundThoseOfEveryPairWhereCirclesCoincide) {
  static const std::vector<Word> words = list_words();
  Rng rng(1);
  int several = 0;  // boxes in which an arc has more than a turn to itself
  for (int i = 0; i < cases(20'000); ++i) {
    const PairBox box = box_where_circles_coincide(rng);
    const Polar whole = polar(box, all_circles);
    const PairBox pair{point(inside(box.radial, rng)), point(inside(box.side, rng)),
                       point(inside(box.turn, rng))};
    const Polar there = polar(pair, all_circles);
    for (const Word& word : words) {
      const auto one = pieces_of(there, word.left_word, view_of(there, word));
      if (!one || !one->can_be_shortest() || !there.circles[circles_of(word)].directed) continue;
      const auto all = pieces_of(whole, word.left_word, view_of(whole, word));
      ASSERT_TRUE(all && all->can_be_shortest()) << "case " << i;
      ASSERT_TRUE(holds(all->first, one->first)) << "case " << i << ", word " << word.left_word;
      ASSERT_TRUE(holds(all->last, one->last)) << "case " << i << ", word " << word.left_word;
      ASSERT_LE(all->least(), one->length().high + 3 * margin) << "case " << i;
      several += all->first.width() > 2 * pi + 1e-9 ? 1 : 0;
    }
  }
  EXPECT_GT(several, cases(1000));  // or the test says nothing
}

/// A box anywhere, up to a third of all pairs wide.
PairBox any_box(Rng& rng) {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double middle = uniform(0.0, k == 0 ? 0.9 : 1.0, rng);
    const double half = any_size(1e-4, 0.17, rng);
    low[k] = std::max(0.0, middle - half);
    high[k] = std::min(k == 0 ? 0.9 : 1.0, middle + half);
  }
  return box_between(low, high);
}

TEST(WordsInBox, SlopesLeadFromTheCentreToEveryPair) {
  Rng rng(4);
  int bounded = 0;
  for (int i = 0; i < cases(2000); ++i) {
    const PairBox box = any_box(rng);
    const Excess excess = excess_over(box, WordSet().set());
    bounded += excess.bounded ? 1 : 0;
    for (int k = 0; k < 20 && excess.bounded; ++k) {
      double low = excess.at_centre;
      double high = excess.at_centre;
      std::array<double, 3> pair{};
      const std::array<Interval, 3> ranges{box.radial, box.side, box.turn};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        pair[axis] = inside(ranges[axis], rng);
        const double away = pair[axis] - (ranges[axis].low + ranges[axis].high) / 2;
        const Interval slope = excess.slopes[axis];
        low += std::min(slope.low * away, slope.high * away);
        high += std::max(slope.low * away, slope.high * away);
      }
      const double truth = excess_at(pair[0], pair[1], pair[2]);
      ASSERT_GE(truth, low - 3 * margin) << "case " << i;
      ASSERT_LE(truth, high + 3 * margin) << "case " << i;
    }
  }
  EXPECT_GT(bounded, cases(1000));  // or the test says nothing
}

// Extended precision, by section 1 of docs/algorithms/steering.md: coordinates as the box has them.
struct Precise {
  long double distance, tangent, tilt;

  Precise(const Polar& pair, std::size_t which) {
    const auto half = static_cast<long double>(pair.turn.low) / 2;
    const long double s = 2 * std::sin(half);
    const long double c = 2 * std::cos(half);
    const long double x = which == 0 ? -s : which == 1 ? s : 0;
    const long double y = which == 2 ? -c : which == 3 ? c : 0;
    const auto r = static_cast<long double>(pair.distance.low);
    const auto b = static_cast<long double>(pair.bearing.low);
    distance = std::hypot(r * std::cos(b) + x, r * std::sin(b) + y);
    tangent = std::sqrt(std::max((distance - 2) * (distance + 2), 0.0L));
    tilt = std::atan2(2.0L, tangent);
  }
};

/// A pair for which those circles are so far apart, as exactly as coordinates say; none if no
/// distance of the poses does it.
std::optional<PairBox> pair_with_circles_apart(std::size_t which, double apart, Rng& rng) {
  const double side = chance(0.1, rng) ? 0.0 : uniform01(rng);
  const double turn = chance(0.1, rng) ? 1.0 : uniform01(rng);
  const auto at = [&](double radial) { return PairBox{point(radial), point(side), point(turn)}; };
  double low = 0.0;
  double high = 0.75;
  const auto excess = [&](double radial) {
    return polar(at(radial), all_circles).circles[which].distance.low - apart;
  };
  if (excess(low) > 0 || excess(high) < 0) return {};
  while (std::nextafter(low, 1.0) < high) {
    const double middle = (low + high) / 2;
    (excess(middle) < 0 ? low : high) = middle;
  }
  return at(chance(0.5, rng) ? low : high);
}

// Worst where the square root of a difference is taken that cancels: circles 2 radii apart.
TEST(WordsInBox, RoundingStaysBelowTheMargin) {
  Rng rng(2);
  double worst = 0.0;
  const auto note = [&worst](Interval found, long double truth) {
    worst = std::max(
        {worst, static_cast<double>(found.low - truth), static_cast<double>(truth - found.high)});
  };
  for (int i = 0; i < cases(20'000); ++i) {
    constexpr std::array<double, 5> special{2.0, 2.0, std::numbers::sqrt2 * 2, 4.0,
                                            4.47213595499958};
    const std::size_t which = rng() % 4;
    const auto pair = pair_with_circles_apart(which, special[rng() % special.size()], rng);
    if (!pair) continue;
    const Polar there = polar(*pair, all_circles);
    const CirclePair& c = there.circles[which];
    const Precise precise(there, which);
    note(c.distance, precise.distance);
    note(c.tangent, precise.tangent);
    note(c.tilt, precise.tilt);
  }
  RecordProperty("worst", as_code(worst));
  EXPECT_LT(worst, margin);
  EXPECT_GT(worst, margin / 10);  // the margin is no more than is needed
}

// Centres of circles coincide at distance 2 sin(turn / 2), bearing 0 and at distance
// 2 cos(turn / 2), bearing pi / 2 only. No corner of a box that the builder looks at is next to
// such a pair, but those with equal poses and with opposite ones: directions are as exact as
// angles.
TEST(WordsInBox, NoCornerIsNextToWhereCirclesCoincide) {
  constexpr int cuts = 4;  // of a side of a cell: two times into halves
  constexpr int radial_corners = simd::radial_cells * cuts;
  constexpr int turn_corners = simd::turn_cells * cuts;
  double nearest = 1.0;
  for (int i = 1; i < radial_corners; ++i) {
    const double distance = distance_at(static_cast<double>(i) / radial_corners);
    for (int k = 0; k <= turn_corners; ++k) {
      const double half = k * pi / 2 / turn_corners;
      nearest = std::min({nearest, std::abs(distance - 2 * std::sin(half)),
                          std::abs(distance - 2 * std::cos(half))});
    }
  }
  EXPECT_GT(nearest, 5e-5);
}

}  // namespace
}  // namespace vandplan::tables

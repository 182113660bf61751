// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "steering/continuous_law.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

double length_of(const ContinuousCase& c) {
  return c.steering.length(c.pair.from, c.pair.to, c.query);
}

ContinuousSteering with(const ContinuousSteering& s, Continuity continuity) {
  return {s.radius(), s.curvature_rate(), continuity};
}

/// How much a length may change when rounding moves a pose by `shift`: where poses nearly agree it
/// is as the cube root of the shift.
double tolerance(const ContinuousCase& c, double length, double shift) {
  const double rate = c.steering.curvature_rate();
  return shift * (10 + 8 * law_radius / std::max(length, std::sqrt(shift))) +
         8 * shift / rate / std::max(length * length, std::pow(shift / rate, 2.0 / 3));
}

/// The query with straight wheels where the vehicle stands.
ContinuousQuery straight_stands(const ContinuousCase& c) {
  ContinuousQuery query = c.query;
  if (query.start_stands) query.start_curvature = 0;
  if (query.goal_stands) query.goal_curvature = 0;
  return query;
}

TEST(ContinuousLaw, EveryPathIsDrivable) {
  for_each_continuous_case(1, 200'000, [](const ContinuousCase& c, Rng&) {
    const auto piece = c.steering.steer(c.pair.from, c.pair.to, c.query);
    ASSERT_TRUE(piece) << as_code(c);
    EXPECT_TRUE(is_drivable(*piece, c)) << as_code(c);
    EXPECT_EQ(piece->length, length_of(c)) << as_code(c);
  });
}

// Where a place of a path lies with straight wheels, the words to it and from it have parts that
// vanish: what rounding leaves of these is a micrometre, which no wheel can follow.
TEST(ContinuousLaw, PartsThatVanishAreLeftOut) {
  int words = 0, with_crumbs = 0;
  const auto look_at = [&](const Piece& piece) {
    ++words;
    with_crumbs += std::ranges::any_of(piece.view(), [](const Segment& s) {
      return 1e-9 < std::abs(s.length) && std::abs(s.length) < 1e-6;
    });
  };
  for_each_case(14, 8000, [&](Rng& rng) {
    const auto continuity = chance(0.5, rng) ? Continuity::throughout : Continuity::between_stops;
    const ContinuousSteering steering(law_radius, any_size(0.01, 0.5, rng), continuity);
    const Pose from{0, 0, 0};
    const Pose to = uniform_pose({-20, 20, -20, 20}, rng);
    Pose place = from;
    const Piece whole = steering.steer(from, to);
    for (const Segment& segment : whole.view()) {
      place = advance(place, segment);
      if (std::abs(curvature_at(segment, std::abs(segment.length))) > 1e-9) continue;
      look_at(steering.steer(from, place));
      look_at(steering.steer(place, to));
    }
  });
  EXPECT_GT(words, cases(8000));
  EXPECT_LE(with_crumbs, 1 + words / 1000);
}

TEST(ContinuousLaw, IsNoShorterThanReedsShepp) {
  for_each_continuous_case(2, 200'000, [](const ContinuousCase& c, Rng&) {
    const double least = reeds_shepp_length(c.pair.from, c.pair.to, law_radius);
    EXPECT_GE(length_of(c), least - tolerance(c, least, 1e-13) - 1e-12 * least) << as_code(c);
  });
}

TEST(ContinuousLaw, JumpsAtStopsMakeNothingLonger) {
  for_each_continuous_case(3, 200'000, [](const ContinuousCase& c, Rng&) {
    const double between =
        with(c.steering, Continuity::between_stops).length(c.pair.from, c.pair.to, c.query);
    const double throughout =
        with(c.steering, Continuity::throughout).length(c.pair.from, c.pair.to, straight_stands(c));
    // Where jumps save nearly all that there is to save, nothing else is looked at.
    const double near = 1.2 * reeds_shepp_length(c.pair.from, c.pair.to, law_radius);
    EXPECT_LE(between, std::max(near, throughout) * (1 + 1e-12)) << as_code(c);
  });
}

/// Rolling at an end is standing there with the wheels held, so it makes nothing shorter. The quick
/// search looks at other words then and may miss a shorter one.
TEST(ContinuousLaw, StandingAtAnEndMakesNothingLonger) {
  int longer = 0, all = 0;
  double lost = 0, sum = 0;
  for_each_continuous_case(11, 40'000, [&](const ContinuousCase& c, Rng&) {
    if (c.steering.curvature_rate() * law_radius * law_radius < 1) return;
    const ContinuousSteering steering = with(c.steering, Continuity::between_stops);
    const auto length = [&](bool start_stands, bool goal_stands) {
      ContinuousQuery query = c.query;
      query.start_stands = start_stands;
      query.goal_stands = goal_stands;
      return steering.length(c.pair.from, c.pair.to, query);
    };
    const double rolling = length(false, false), standing = length(true, true);
    for (const double one : {length(true, false), length(false, true)}) {
      all += 2;
      longer += (standing > one * (1 + 1e-6) ? 1 : 0) + (one > rolling * (1 + 1e-6) ? 1 : 0);
      lost += std::max(0.0, standing - one) + std::max(0.0, one - rolling);
      sum += one;
    }
  });
  EXPECT_LE(longer, all / 50);
  EXPECT_LE(lost, 1e-3 * sum);
}

/// Counts cases in which rounding led to another word: nearly equal words and Newton's method may
/// decide otherwise where poses are turned or scaled.
class Share {
 public:
  void count(double length, double expected, const std::string& what) {
    ++all_;
    if (std::abs(length - expected) <= 1e-6 * (law_radius + expected)) return;
    ++other_;
    last_ = what + ": " + as_code(length) + " instead of " + as_code(expected);
  }
  ~Share() { EXPECT_LE(other_, 2 + all_ / 1000) << "of " << all_ << ", last " << last_; }

 private:
  int all_ = 0, other_ = 0;
  std::string last_;
};

TEST(ContinuousLaw, TheWayBackIsAsLong) {
  Share share;
  for_each_continuous_case(4, 50'000, [&](const ContinuousCase& c, Rng&) {
    const ContinuousQuery back{c.query.goal_curvature, c.query.start_curvature, c.query.cutoff,
                               c.query.goal_stands, c.query.start_stands};
    const double there = length_of(c);
    const double again = c.steering.length(c.pair.to, c.pair.from, back);
    if (back.start_curvature == 0 && back.goal_curvature == 0) {
      EXPECT_EQ(there, again) << as_code(c);
    } else {
      share.count(again, there, as_code(c));
    }
  });
}

TEST(ContinuousLaw, MirroringChangesNothing) {
  Share share;
  for_each_continuous_case(5, 50'000, [&](const ContinuousCase& c, Rng&) {
    const auto mirrored = [](const Pose& p) { return Pose{p.x, -p.y, -p.heading}; };
    const ContinuousQuery query{-c.query.start_curvature, -c.query.goal_curvature, c.query.cutoff,
                                c.query.start_stands, c.query.goal_stands};
    share.count(c.steering.length(mirrored(c.pair.from), mirrored(c.pair.to), query), length_of(c),
                as_code(c));
  });
}

TEST(ContinuousLaw, LengthsScale) {
  Share share;
  for_each_continuous_case(6, 50'000, [&](const ContinuousCase& c, Rng& rng) {
    const double k = std::exp(uniform(-3, 3, rng));
    const ContinuousSteering steering(law_radius * k, c.steering.curvature_rate() / k / k,
                                      c.steering.continuity());
    const auto scaled = [&](const Pose& p) { return Pose{k * p.x, k * p.y, p.heading}; };
    const ContinuousQuery query{c.query.start_curvature / k, c.query.goal_curvature / k,
                                c.query.cutoff, c.query.start_stands, c.query.goal_stands};
    share.count(steering.length(scaled(c.pair.from), scaled(c.pair.to), query) / k, length_of(c),
                as_code(c));
  });
}

TEST(ContinuousLaw, PlacesFarFromTheOriginAreAsGood) {
  for_each_continuous_case(7, 20'000, [&](const ContinuousCase& c, Rng&) {
    const auto far = [&](const Pose& p) {  // whole metres, so that nothing is rounded
      return Pose{std::round(p.x - c.pair.from.x) + 1e6, std::round(p.y - c.pair.from.y) - 1e6,
                  p.heading};
    };
    const auto near = [&](const Pose& p) {
      return Pose{std::round(p.x - c.pair.from.x), std::round(p.y - c.pair.from.y), p.heading};
    };
    EXPECT_EQ(c.steering.length(far(c.pair.from), far(c.pair.to), c.query),
              c.steering.length(near(c.pair.from), near(c.pair.to), c.query))
        << as_code(c);
  });
}

TEST(ContinuousLaw, TendsToReedsSheppAsTheRateGrows) {
  for_each_pair(8, 20'000, near_or_far_pair, [](const DrawnPair& pair, Rng& rng) {
    const double ramp = any_size(1e-6, 1e-3, rng);
    const double rate = 1 / (ramp * law_radius * law_radius);
    const double least = reeds_shepp_length(pair.from, pair.to, law_radius);
    for (const Continuity kind : {Continuity::between_stops, Continuity::throughout}) {
      const double length = ContinuousSteering(law_radius, rate, kind).length(pair.from, pair.to);
      EXPECT_LE(length, least + 10 * ramp * law_radius)
          << as_code(pair) << " ramp " << as_code(ramp);
    }
  });
}

/// Nearly straight on there is no loop, however small the turns.
TEST(ContinuousLaw, NearlyStraightOnIsNearlyALine) {
  for_each_case(10, 8000, [](Rng& rng) {
    const double ramp = any_size(1e-3, 0.5, rng);
    const Continuity kind = chance(0.5, rng) ? Continuity::throughout : Continuity::between_stops;
    const ContinuousSteering steering(1, 1 / ramp, kind);
    const double x = ramp * any_size(4, 1000, rng);
    const auto small = [&] {
      return chance(0.2, rng) ? 0 : any_sign(any_size(1e-15, 1e-3, rng), rng);
    };
    const Pose goal{x, ramp * small(), ramp * small()};
    const double length = steering.length({0, 0, 0}, goal);
    EXPECT_LE(length, x + 0.3 * ramp) << as_code(goal) << " ramp " << as_code(ramp);
  });
}

/// How much is lost by the quick search, which looks at some of the words only?
class Loss {
 public:
  /// Of all lengths together, at most; and one of so many pairs may be longer than it has to be.
  explicit Loss(double most = 1e-4, int pairs = 100) : most_(most), pairs_(pairs) {}
  void count(const ContinuousCase& c) {
    const double length = length_of(c);
    double least = length;
    for (const Piece& piece : c.steering.candidates(c.pair.from, c.pair.to, c.query)) {
      EXPECT_TRUE(is_drivable(piece, c)) << as_code(c);
      least = std::min(least, piece.length);
    }
    ++all_;
    shorter_ += least < length * (1 - 1e-6) ? 1 : 0;
    lost_ += length - least;
    sum_ += least;
  }
  ~Loss() {
    EXPECT_LE(shorter_, 2 + all_ / pairs_);
    EXPECT_LE(lost_, most_ * sum_);
  }

 private:
  double most_;
  int pairs_;
  int shorter_ = 0, all_ = 0;
  double lost_ = 0, sum_ = 0;
};

TEST(ContinuousLaw, IsTheLeastOfAllWords) {
  Loss loss;
  for_each_case(9, 600, [&](Rng& rng) {
    const double ramp = any_size(1e-2, 0.5, rng);
    const Continuity kind = chance(0.5, rng) ? Continuity::throughout : Continuity::between_stops;
    const ContinuousSteering steering(law_radius, 1 / (ramp * law_radius * law_radius), kind);
    loss.count({steering, near_or_far_pair(rng), {}});
  });
}

TEST(ContinuousLaw, IsTheLeastOfAllWordsWithGivenCurvatures) {
  Loss loss;
  for_each_case(13, 500, [&](Rng& rng) {
    const double ramp = any_size(1e-2, 0.5, rng);
    const ContinuousSteering steering(law_radius, 1 / (ramp * law_radius * law_radius),
                                      Continuity::throughout);
    loss.count({steering,
                near_or_far_pair(rng),
                {any_curvature(law_radius, rng), any_curvature(law_radius, rng)}});
  });
}

TEST(ContinuousLaw, IsTheLeastOfAllWordsWhereAnEndRolls) {
  Loss loss;
  for_each_case(12, 600, [&](Rng& rng) {
    const double ramp = any_size(1e-2, 0.5, rng);
    const ContinuousSteering steering(law_radius, 1 / (ramp * law_radius * law_radius),
                                      Continuity::between_stops);
    ContinuousCase c{steering, near_or_far_pair(rng), {}};
    if (chance(0.3, rng)) {
      c.query.start_curvature = any_curvature(law_radius, rng);
      c.query.goal_curvature = any_curvature(law_radius, rng);
    }
    c.query.start_stands = chance(0.3, rng);
    c.query.goal_stands = !c.query.start_stands && chance(0.5, rng);
    loss.count(c);
  });
}

// Nearly where it is, or a little ahead or aside: what the word of Reeds and Shepp is tells little.
TEST(ContinuousLaw, IsTheLeastOfAllWordsBetweenNearPoses) {
  Loss loss(5e-3, 20);
  for_each_case(14, 500, [&](Rng& rng) {
    const double ramp = any_size(0.05, 0.5, rng);
    const ContinuousSteering steering(law_radius, 1 / (ramp * law_radius * law_radius),
                                      Continuity::throughout);
    const double way = uniform(-0.9, 0.9, rng) * ramp * law_radius;
    Pose goal = chance(0.5, rng) ? Pose{way, 0, 0} : Pose{1e-3 * way, 1e-3 * way, 1e-3 * way};
    if (chance(0.3, rng)) goal = {0, way / 10, 0};
    loss.count(
        {steering, {{}, goal}, {any_curvature(law_radius, rng), any_curvature(law_radius, rng)}});
  });
}

}  // namespace
}  // namespace vandplan

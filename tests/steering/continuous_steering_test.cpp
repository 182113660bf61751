// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "support/radius.h"
#include "vandplan/steering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "steering/continuous_law.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

constexpr double rate = 0.11;  // 1.3 m from straight to full lock

const ContinuousSteering between(default_radius, rate, Continuity::between_stops);
const ContinuousSteering throughout(default_radius, rate, Continuity::throughout);

TEST(ContinuousSteering, EqualPosesNeedNothing) {
  for (const ContinuousSteering& steering : {between, throughout}) {
    EXPECT_EQ(steering.steer({3, 4, 5}, {3, 4, 5}).count, 0);
    EXPECT_EQ(steering.length({3, 4, 5}, {3, 4, 5}), 0);
  }
}

TEST(ContinuousSteering, StraightOnIsALine) {
  for (const ContinuousSteering& steering : {between, throughout}) {
    for (const double way : {1e-6, 0.1, 3.0, 1e3}) {
      EXPECT_NEAR(steering.length({0, 0, 0}, {way, 0, 0}), way, 1e-9);
      EXPECT_NEAR(steering.length({0, 0, 0}, {-way, 0, 0}), way, 1e-9);
    }
  }
}

TEST(ContinuousSteering, AnArcIsAnArcWhereTheWheelsMayBeTurnedBefore) {
  const Pose goal = advance({0, 0, 0}, {1 / default_radius, 5.0});
  EXPECT_NEAR(between.length({0, 0, 0}, goal), 5, 1e-9);
  EXPECT_GT(throughout.length({0, 0, 0}, goal), 5.01);
  const ContinuousQuery bent{1 / default_radius, 1 / default_radius};
  EXPECT_NEAR(throughout.length({0, 0, 0}, goal, bent), 5, 1e-9);
}

TEST(ContinuousSteering, ALegTurnsItsWheelsWhereItStandsAndStraightensThemWhereItRolls) {
  const double ramp = 1 / default_radius / rate;
  const Pose bent = advance({0, 0, 0}, {1 / default_radius, 5.0});
  const Pose goal = advance(bent, {1 / default_radius, ramp, -rate});
  ContinuousQuery leg;
  leg.goal_stands = false;
  const Piece piece = *between.steer({0, 0, 0}, goal, leg);
  ASSERT_EQ(piece.count, 2);
  EXPECT_NEAR(piece.segments[0].curvature, 1 / default_radius, 1e-12);
  EXPECT_NEAR(piece.segments[0].length, 5, 1e-9);
  EXPECT_NEAR(piece.segments[1].length, ramp, 1e-9);

  ContinuousQuery back;
  back.start_stands = false;
  EXPECT_NEAR(between.length(goal, {0, 0, 0}, back), 5 + ramp, 1e-9);
  leg.goal_curvature = 1 / default_radius;
  EXPECT_NEAR(between.length({0, 0, 0}, bent, leg), 5, 1e-9);
}

TEST(ContinuousSteering, AStandingEndTakesNoAccountOfItsCurvature) {
  const ContinuousQuery bent{0.1, -0.1};
  EXPECT_EQ(between.length({0, 0, 0}, {3, 4, 1}, bent), between.length({0, 0, 0}, {3, 4, 1}));
}

TEST(ContinuousSteering, ATurnIsTwoClothoidsAndAnArc) {
  const double ramp = 1 / default_radius / rate;
  Pose goal = advance({0, 0, 0}, {0, ramp, rate});
  goal = advance(goal, {1 / default_radius, 3});
  goal = advance(goal, {1 / default_radius, ramp, -rate});
  const Piece piece = throughout.steer({0, 0, 0}, goal);
  ASSERT_EQ(piece.count, 3);
  EXPECT_NEAR(piece.length, 2 * ramp + 3, 1e-9);
  EXPECT_NEAR(piece.segments[0].curvature_rate, rate, 1e-12);
  EXPECT_NEAR(piece.segments[1].length, 3, 1e-9);
}

/// Forward and back in four turns of equal length that never reach full lock: each shifts the
/// vehicle by rate * (length / 2)^3, to the first order.
TEST(ContinuousSteering, AShortSidewaysMoveIsNoLoop) {
  for (const double aside : {1e-6, 1e-4, 1e-3, 1e-2}) {
    const double expected = 8 * std::cbrt(aside / (4 * rate));
    EXPECT_LE(throughout.length({0, 0, 0}, {0, aside, 0}), expected * (1 + 1e-6) + 1e-9) << aside;
    const double least = reeds_shepp_length({0, 0, 0}, {0, aside, 0}, default_radius);
    EXPECT_LE(between.length({0, 0, 0}, {0, aside, 0}), expected);
    EXPECT_GE(between.length({0, 0, 0}, {0, aside, 0}), least);
  }
}

TEST(ContinuousSteering, ACutoffKeepsWhatIsNoLonger) {
  const Pose goal{3, 4, 1};
  for (const ContinuousSteering& steering : {between, throughout}) {
    const double length = steering.length({0, 0, 0}, goal);
    ContinuousQuery query;
    query.cutoff = length;
    EXPECT_EQ(steering.length({0, 0, 0}, goal, query), length);
    EXPECT_TRUE(steering.steer({0, 0, 0}, goal, query));
    query.cutoff = length * (1 - 1e-9);
    EXPECT_EQ(steering.length({0, 0, 0}, goal, query), std::numeric_limits<double>::infinity());
    EXPECT_FALSE(steering.steer({0, 0, 0}, goal, query));
    query.cutoff = 3 * length;
    for (const Piece& piece : steering.candidates({0, 0, 0}, goal, query)) {
      EXPECT_LE(piece.length, query.cutoff);
    }
    EXPECT_GT(steering.candidates({0, 0, 0}, goal, query).size(), 2U);
  }
}

/// A word of Reeds and Shepp with a part of no length: there Newton's method takes no step,
/// although the word ends metres away.
TEST(ContinuousSteering, WhereNoStepHelpsThereIsNoWord) {
  ContinuousCase c{{default_radius, 0.0079401916730816747, Continuity::between_stops},
                   {{58.110609299647251, 36.082516789588055, -2.8445636142154589},
                    {53.465902022497112, 27.340280559103974, -1.2737672874205623}},
                   {}};
  c.query.goal_stands = false;
  EXPECT_TRUE(is_drivable(*c.steering.steer(c.pair.from, c.pair.to, c.query), c));
}

TEST(ContinuousSteering, SlowSteeringWindsByMoreThanATurn) {
  for (const double ramp : {3.5, 7.0, 30.0, 1000.0}) {
    for (const Continuity kind : {Continuity::between_stops, Continuity::throughout}) {
      const ContinuousSteering slow(default_radius, 1 / (ramp * default_radius * default_radius),
                                    kind);
      for (const double heading : {0.0, 0.5, 1.5, 3.0}) {
        const DrawnPair pair{{0, 0, 0}, {4, 3, heading}};
        const ContinuousCase c{slow, pair, {}};
        EXPECT_TRUE(is_drivable(slow.steer(pair.from, pair.to), c)) << as_code(c);
      }
    }
  }
}

TEST(ContinuousSteering, RefusesWhatMeansNothing) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    EXPECT_THROW(ContinuousSteering(bad, rate, Continuity::throughout), InputError);
    EXPECT_THROW(ContinuousSteering(default_radius, bad, Continuity::throughout), InputError);
  }
  EXPECT_THROW(ContinuousSteering(default_radius, 1e-9, Continuity::throughout), InputError);
  EXPECT_THROW((void)throughout.steer({nan, 0, 0}, {1, 0, 0}), InputError);
  EXPECT_THROW((void)throughout.length({0, 0, 0}, {1, 0, infinity}), InputError);
  for (const double bad : {1.01 / default_radius, -0.2, nan}) {
    EXPECT_THROW((void)throughout.length({}, {1, 0, 0}, {bad, 0}), InputError);
    EXPECT_THROW((void)throughout.length({}, {1, 0, 0}, {0, bad}), InputError);
  }
  EXPECT_THROW((void)throughout.length({}, {1, 0, 0}, {0, 0, nan}), InputError);
}

}  // namespace
}  // namespace vandplan

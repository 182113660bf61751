// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous/turn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/cases.h"
#include "support/draws.h"
#include "vandplan/path.h"

namespace vandplan::steering::continuous {
namespace {

/// A turn to the left as segments.
Pose driven(const SharpTurns& turns, double length, TurnEnds ends) {
  const bool rises = ends == TurnEnds::rolling || ends == TurnEnds::stands_after;
  const bool falls = ends == TurnEnds::rolling || ends == TurnEnds::stands_before;
  const double ramps = (rises ? 1 : 0) + (falls ? 1 : 0);
  const double ramp = ramps == 0 ? 0 : std::min(turns.ramp(), length / ramps);
  const double peak = ramps == 0 ? 1 : ramp * turns.sharpness();
  Pose pose;
  if (rises) pose = advance(pose, {0, ramp, turns.sharpness()});
  pose = advance(pose, {peak, length - ramps * ramp});
  if (falls) pose = advance(pose, {peak, ramp, -turns.sharpness()});
  return pose;
}

constexpr TurnEnds all_ends[] = {TurnEnds::rolling, TurnEnds::stands_before, TurnEnds::stands_after,
                                 TurnEnds::stands_at_both};

TEST(ContinuousTurn, LeadsWhereItsSegmentsLead) {
  for_each_case(1, 5000, [](Rng& rng) {
    const SharpTurns turns(1 / any_size(0.01, 8, rng));
    const double length = any_size(1e-4, 4, rng);
    for (const TurnEnds ends : all_ends) {
      const Turned t = turns.turn(length, ends);
      const Pose end = driven(turns, length, ends);
      const double rounding = 1e-13 * (1 + turns.ramp());
      EXPECT_NEAR(t.x, end.x, rounding);
      EXPECT_NEAR(t.y, end.y, rounding);
      EXPECT_NEAR(t.sin, std::sin(end.heading), rounding);
      EXPECT_NEAR(t.cos, std::cos(end.heading), rounding);
      EXPECT_NEAR(std::remainder(t.angle - end.heading, 2 * std::numbers::pi), 0, rounding);
    }
  });
}

TEST(ContinuousTurn, SlopesAreThoseOfTheWay) {
  for_each_case(2, 5000, [](Rng& rng) {
    const SharpTurns turns(1 / any_size(0.1, 8, rng));
    const double length = any_size(1e-2, 4, rng);
    constexpr double step = 1e-5;
    for (const TurnEnds ends : all_ends) {
      const Turned t = turns.turn(length, ends);
      const Turned less = turns.turn(length - step, ends), more = turns.turn(length + step, ends);
      // At full lock the second derivative jumps.
      constexpr double near = 1e-3;
      EXPECT_NEAR(t.slope_x, (more.x - less.x) / (2 * step), near);
      EXPECT_NEAR(t.slope_y, (more.y - less.y) / (2 * step), near);
      EXPECT_NEAR(t.angle_slope, (more.angle - less.angle) / (2 * step), near);
    }
  });
}

}  // namespace
}  // namespace vandplan::steering::continuous

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Does a slow search that knows nothing of circles find a shorter path of the same words?

#include "support/continuous_oracle.h"

#include <gtest/gtest.h>

#include "support/draws.h"
#include "support/pair_cases.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

/// Compares lengths for random goals. The quick search misses a word now and then (at most as often
/// as the laws allow); the oracle has no words of parts of negative length.
void expect_as_short(Continuity continuity, std::uint64_t seed) {
  int all = 0, longer = 0, equal = 0;
  for_each_case(seed, 40, [&](Rng& rng) {
    const double ramp = any_size(0.05, 0.6, rng);
    const double reach = chance(0.5, rng) ? 2 : 8;
    const Pose goal = uniform_pose({-reach, reach, -reach, reach}, rng);
    const double slow = ContinuousOracle(ramp, continuity).length(goal);
    const double quick = ContinuousSteering(1, 1 / ramp, continuity).length({}, goal);
    EXPECT_LE(quick, slow * (1 + 2e-3)) << as_code(goal) << " ramp " << as_code(ramp);
    ++all;
    longer += quick > slow * (1 + 1e-7) ? 1 : 0;
    equal += std::abs(quick - slow) <= 1e-7 * quick ? 1 : 0;
  });
  EXPECT_LE(longer, all / 50);
  EXPECT_GE(equal, all * 9 / 10);
}

TEST(ContinuousOracle, FindsNothingShorterThroughout) {
  expect_as_short(Continuity::throughout, 1);
}

TEST(ContinuousOracle, FindsNothingShorterBetweenStops) {
  expect_as_short(Continuity::between_stops, 2);
}

}  // namespace
}  // namespace vandplan

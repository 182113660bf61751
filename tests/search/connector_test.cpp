// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What steering under prices may leave out, and what it must find.
#include <gtest/gtest.h>

#include <array>

#include "../support/cases.h"
#include "../support/problems.h"
#include "vandplan/dubins.h"
#include "vandplan/random.h"
#include "vandplan/reeds_shepp.h"
#include "vandplan/search.h"

namespace vandplan {
namespace {

using search::Connector;
using search::CostRule;
using search::Gears;
using search::GearSign;

constexpr Bounds region{-30, 30, -30, 30};

CostRule random_rule(Rng& rng) { return {1.0, uniform(1, 4, rng), uniform(0, 20, rng), 0}; }

GearSign random_gear(Rng& rng) { return static_cast<GearSign>(rng() % 3) - 1; }

TEST(Connector, NoWordCostsLessThanTheLeastCost) {
  for_each_case(1, 2000, [](Rng& rng) {
    const Pose from = uniform_pose(region, rng);
    const Pose to = uniform_pose(region, rng);
    const Problem problem = problem_of(from, {0, 0, 0}, {});
    Connector connector(problem.task(), random_rule(rng));
    const Gears gears{random_gear(rng), random_gear(rng)};
    const double least = connector.least_cost(from, to, gears);
    for (const Piece& word : reeds_shepp_words(from, to, connector.radius())) {
      EXPECT_GE(connector.cost(word, gears), least - 1e-9);
    }
    const Piece forward = dubins(from, to, connector.radius());
    const Piece reverse = reversed(dubins(to, from, connector.radius()));
    for (const Piece& word : {forward, reverse}) {
      EXPECT_GE(connector.cost(word, gears), least - 1e-9);
    }
    EXPECT_GE(least, reeds_shepp_length(from, to, connector.radius()) - 1e-9);
  });
}

TEST(Connector, TheLeastCostIsReachedWhereOneGearDoes) {
  const Problem problem = problem_of({0, 0, 0}, {20, 5, 0.2}, {});
  Connector connector(problem.task(), {1.0, 1.5, 100.0, 0});
  const Pose from{0, 0, 0}, to{20, 5, 0.2};
  EXPECT_NEAR(connector.least_cost(from, to, {1, 1}), dubins_length(from, to, 7.0), 1e-9);
  EXPECT_NEAR(connector.least_cost(to, from), 1.5 * dubins_length(from, to, 7.0), 1e-9);
  EXPECT_NEAR(connector.least_cost(from, to, {-1, 1}), 100 + dubins_length(from, to, 7.0), 1e-9);
}

TEST(Connector, ACutoffHidesNoWordThatCostsLess) {
  for_each_case(2, 2000, [](Rng& rng) {
    const Pose from = uniform_pose(region, rng);
    const Pose to = uniform_pose(region, rng);
    const Problem problem = problem_of(from, {0, 0, 0}, {});
    Connector connector(problem.task(), random_rule(rng));
    const Gears gears{random_gear(rng), random_gear(rng)};
    const double cost = connector.cost(*connector.steer(from, to, gears), gears);
    const double cutoff = cost * uniform(0.5, 2.0, rng);
    const double below = connector.cost(*connector.steer(from, to, gears, cutoff), gears);
    if (cost < cutoff) {
      EXPECT_NEAR(below, cost, 1e-5);  // among words that cost alike the one of fewer segments
    } else {
      EXPECT_GE(below, cutoff);
    }
  });
}

}  // namespace
}  // namespace vandplan

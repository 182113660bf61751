// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What steering under prices may leave out, and what it must find.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../support/cases.h"
#include "../support/draws.h"
#include "../support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/random.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using namespace search;

constexpr Bounds region{-30, 30, -30, 30};

CostRule random_rule(Rng& rng) { return {1.0, uniform(1, 4, rng), uniform(0, 20, rng), 0}; }

GearSign random_gear(Rng& rng) { return static_cast<GearSign>(rng() % 3) - 1; }

TEST(Connector, NoWordCostsLessThanTheLeastCost) {
  for_each_case(1, 2000, [](Rng& rng) {
    const Pose from = uniform_pose(region, rng);
    const Pose to = uniform_pose(region, rng);
    const Problem problem = problem_of(from, {0, 0, 0}, {});
    Connector connector(problem.task(), random_rule(rng));
    const DrivenBeside beside{random_gear(rng), random_gear(rng)};
    const double least = connector.least_cost(Local(from), Local(to), beside);
    for (const Piece& word : reeds_shepp_words(from, to, connector.radius())) {
      EXPECT_GE(connector.cost(word, beside), least - 1e-9);
    }
    const Piece forward = dubins(from, to, connector.radius());
    const Piece reverse = reversed(dubins(to, from, connector.radius()));
    for (const Piece& word : {forward, reverse}) {
      EXPECT_GE(connector.cost(word, beside), least - 1e-9);
    }
    EXPECT_GE(least, reeds_shepp_length(from, to, connector.radius()) - 1e-9);
  });
}

TEST(Connector, TheLeastCostIsReachedWhereOneGearDoes) {
  const Problem problem = problem_of({0, 0, 0}, {20, 5, 0.2}, {});
  Connector connector(problem.task(), {1.0, 1.5, 100.0, 0});
  const Pose from{0, 0, 0}, to{20, 5, 0.2};
  EXPECT_NEAR(connector.least_cost(Local(from), Local(to), {1, 1}), dubins_length(from, to, 7.0),
              1e-9);
  EXPECT_NEAR(connector.least_cost(Local(to), Local(from)), 1.5 * dubins_length(from, to, 7.0),
              1e-9);
  EXPECT_NEAR(connector.least_cost(Local(from), Local(to), {-1, 1}),
              100 + dubins_length(from, to, 7.0), 1e-9);
}

TEST(Connector, ACutoffHidesNoWordThatCostsLess) {
  for_each_case(2, 2000, [](Rng& rng) {
    const Pose from = uniform_pose(region, rng);
    const Pose to = uniform_pose(region, rng);
    const Problem problem = problem_of(from, {0, 0, 0}, {});
    Connector connector(problem.task(), random_rule(rng));
    const DrivenBeside beside{random_gear(rng), random_gear(rng)};
    const double cost = connector.cost(*connector.steer(Local(from), Local(to), beside), beside);
    const double cutoff = cost * uniform(0.5, 2.0, rng);
    const double below =
        connector.cost(*connector.steer(Local(from), Local(to), beside, cutoff), beside);
    if (cost < cutoff) {
      EXPECT_NEAR(below, cost, 1e-5);  // among words that cost alike the one of fewer segments
    } else {
      EXPECT_GE(below, cutoff);
    }
  });
}

/// A task in which the curvature is continuous, on open ground.
Task continuous_task(Steering steering) {
  Task task = problem_of({-90, 3, 1}, {90, -3, -2}, {}).task();
  task.steering = steering;
  return task;
}

/// Whether a piece may follow (or precede, at its end) what is driven beside it.
bool fits(const Driven& beside, const Driven& end, Steering steering) {
  const bool stands = beside.gear != 0 && end.gear == -beside.gear;
  if (stands && steering == Steering::continuous_between_stops) return true;
  const double wanted = std::isnan(beside.curvature) ? 0.0 : beside.curvature;
  return std::abs(end.curvature - wanted) < 1e-12;
}

TEST(Connector, AContinuousPieceGoesOnFromWhatIsDrivenAroundIt) {
  int found = 0;
  for (const Steering steering : {Steering::continuous_between_stops, Steering::continuous}) {
    const Task task = continuous_task(steering);
    for_each_case(7, 2000, [&](Rng& rng) {
      const CostRule rule = rng() % 2 == 0 ? CostRule{} : CostRule{1.0, 2.0, 5.0, 0};
      Connector connector(task, rule);
      const Pose from = uniform_pose({-10, 10, -10, 10}, rng);
      const Pose to = uniform_pose({-10, 10, -10, 10}, rng);
      const auto any_driven = [&]() -> Driven {
        const double curvatures[] = {0.0, 1 / connector.radius(), Driven::any};
        const GearSign gear = random_gear(rng);
        return {gear, gear == 0 ? Driven::any : curvatures[rng() % 3]};
      };
      const DrivenBeside beside{any_driven(), any_driven()};
      const std::optional<Piece> piece = connector.steer(Local(from), Local(to), beside);
      if (!piece) return;
      ++found;
      EXPECT_TRUE(fits(beside.before, first_driven(*piece), steering));
      EXPECT_TRUE(fits(beside.after, last_driven(*piece), steering));
      const Pose end = end_of(from, *piece);
      EXPECT_NEAR(std::hypot(end.x - to.x, end.y - to.y), 0.0, 1e-6);
    });
  }
  EXPECT_GE(found, cases(2000));
}

// Where an arc leads to a place from which another one is to be driven in the same gear, a stroke
// of no length in the other gear would let the wheels be turned; who cuts the piece leaves it out.
TEST(Connector, WheelsAreTurnedAtNoStrokeOfAHairsBreadth) {
  const Task task = continuous_task(Steering::continuous_between_stops);
  Connector connector(task);
  for_each_case(5, 5000, [&](Rng& rng) {
    const double sharpest = (chance(0.5, rng) ? 1 : -1) / connector.radius();
    const GearSign gear = chance(0.5, rng) ? 1 : -1;
    const Pose from = uniform_pose({-20, 20, -20, 20}, rng);
    const Pose to = advance(from, {sharpest, gear * uniform(0.1, 12, rng)});
    const auto piece = connector.steer(Local(from), Local(to), {{-gear, 0.0}, {gear, -sharpest}});
    if (!piece) return;
    for (const Segment& segment : piece->view()) EXPECT_GT(std::abs(segment.length), 1e-12);
  });
}

TEST(Connector, WheelsThatTurnTooSlowlyForTheGivenCurvatureAreNamed) {
  Task task = continuous_task(Steering::continuous);
  task.vehicle.limits.max_curvature_rate = 1e-4;
  task.curvatures.start = 0.9 / continuous_radius(task.vehicle);
  EXPECT_NO_THROW(Connector{task});
  task.curvatures.start = 1 / task.vehicle.min_turning_radius;
  EXPECT_THROW(Connector{task}, InputError);
  task.steering = Steering::continuous_between_stops;
  EXPECT_NO_THROW(Connector{task});
}

TEST(Connector, ItStandsAtTheEndsOfTheTaskBetweenStops) {
  const Task task = continuous_task(Steering::continuous_between_stops);
  Connector connector(task);
  const std::optional<Piece> piece = connector.steer(task.start, task.goal);
  ASSERT_TRUE(piece);
  EXPECT_NE(first_driven(*piece).curvature, 0.0);
  EXPECT_NE(last_driven(*piece).curvature, 0.0);
}

TEST(Connector, AContinuousPieceIsCutWhereTheWheelsAreStraight) {
  const Task task = continuous_task(Steering::continuous_between_stops);
  Connector connector(task);
  for_each_case(8, 500, [&](Rng& rng) {
    const Pose to = uniform_pose({-20, 20, -20, 20}, rng);
    const std::optional<Piece> piece = connector.steer({}, Local(to));
    ASSERT_TRUE(piece);
    const double s = nearest_cut(*piece, uniform(0, piece->length, rng), connector.radius());
    const Piece head = prefix(*piece, s);
    const Piece tail = suffix(*piece, s);
    EXPECT_NEAR(head.length + tail.length, piece->length, 1e-9);
    if (head.count == 0 || tail.count == 0) return;
    const Driven before = last_driven(head);
    const Driven after = first_driven(tail);
    EXPECT_TRUE(before.gear != after.gear || std::abs(before.curvature) < 1e-12);
  });
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does turning the wheels cost, in the eyes of the planner and of the judge?
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "search/route.h"
#include "support/cases.h"
#include "support/problems.h"
#include "support/radius.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"
#include "vandplan/search.h"

namespace vandplan {
namespace {

using search::CostRule;
using search::Driven;

constexpr CostRule steering{.curvature_change_cost = 10};

double cost_of(const CostRule& rule, std::span<const Segment> segments) {
  Driven driven = rule.initial_gear;
  return drive_cost(rule, segments, driven);
}

/// Arcs, lines and clothoids in either gear.
std::vector<Segment> random_segments(Rng& rng) {
  std::vector<Segment> segments(1 + rng() % 6);
  for (Segment& segment : segments) {
    segment = {uniform(-0.1, 0.1, rng), uniform(-9, 9, rng)};
    if (rng() % 3 == 0) segment.curvature_rate = uniform(-0.004, 0.004, rng);
  }
  return segments;
}

TEST(CurvatureCost, IsTheTotalVariationBetweenTheFirstSegmentAndTheLast) {
  const double k = 1 / default_radius;
  EXPECT_DOUBLE_EQ(cost_of(steering, std::vector<Segment>{{k, 5}}), 5);
  EXPECT_DOUBLE_EQ(cost_of(steering, std::vector<Segment>{{k, 5}, {0, 3}}), 8 + 10 * k);
  EXPECT_DOUBLE_EQ(cost_of(steering, std::vector<Segment>{{k, 5}, {-k, 3}}), 8 + 20 * k);
  // Wheels that turn at a standstill turn, too; those that stay do not.
  EXPECT_DOUBLE_EQ(cost_of(steering, std::vector<Segment>{{k, 5}, {-k, -3}}), 8 + 20 * k);
  EXPECT_DOUBLE_EQ(cost_of(steering, std::vector<Segment>{{k, 5}, {k, -3}}), 8);
  EXPECT_NEAR(cost_of(steering, std::vector<Segment>{{0, 10, k / 10}, {k, -3}}), 13 + 10 * k,
              1e-12);
}

TEST(CurvatureCost, IsOfPartsWhatItIsOfTheWhole) {
  for_each_case(1, 300, [](Rng& rng) {
    const std::vector<Segment> all = random_segments(rng);
    const CostRule rule{.reverse_weight = 2, .gear_change_cost = 3, .curvature_change_cost = 10};
    const auto at = static_cast<std::ptrdiff_t>(rng() % (all.size() + 1));
    const std::vector<Segment> first(all.begin(), all.begin() + at);
    const std::vector<Segment> second(all.begin() + at, all.end());
    Driven driven;
    double sum = drive_cost(rule, first, driven);
    sum += drive_cost(rule, second, driven);
    EXPECT_NEAR(sum, cost_of(rule, all), 1e-9);
  });
}

TEST(CurvatureCost, IsWorkedOutAgainByTheJudge) {
  for_each_case(2, 300, [](Rng& rng) {
    const Path path{{}, random_segments(rng)};
    const Problem problem = problem_of_path({.bounds = wide_bounds}, path);
    const CostRule rule{.reverse_weight = 2, .gear_change_cost = 3, .curvature_change_cost = 10};
    StatedCost stated{.cost = cost_of(rule, path.segments),
                      .rule = {.reverse_weight = 2,
                               .gear_change_cost = 3,
                               .curvature_change_cost = 10,
                               .clearance_weight = 0}};
    const PathCheck check = check_path(problem, path, {.cost = stated});
    EXPECT_TRUE(check.valid) << check.reason;
    EXPECT_NEAR(10 * check.curvature_change, cost_of(steering, path.segments) - check.length, 1e-9);
    stated.cost += 1e-3;
    EXPECT_FALSE(check_path(problem, path, {.cost = stated}).valid);
  });
}

// Steering knows how the wheels stand before and after a piece.
TEST(CurvatureCost, MakesAPieceGoOnAsItsNeighboursDo) {
  for_each_case(3, 200, [](Rng& rng) {
    const Problem problem = problem_of({}, {90, 0, 0}, {});
    search::Connector connector(problem.task(), {.curvature_change_cost = 50});
    const Pose to = uniform_pose({-20, 20, -20, 20}, rng);
    const Driven left{1, 1 / default_radius};
    const Driven right{1, -1 / default_radius};
    const Piece after_left = *connector.steer({}, Local(to), {left, 0});
    const Piece after_right = *connector.steer({}, Local(to), {right, 0});
    EXPECT_LE(connector.cost(after_left, {left, 0}), connector.cost(after_right, {left, 0}));
    EXPECT_LE(connector.cost(after_right, {right, 0}), connector.cost(after_left, {right, 0}));
  });
}

// Around boxes: what is planned with a price turns the wheels less, and its cost is what it says.
TEST(CurvatureCost, MakesPathsWithFewerTurnsOfTheWheel) {
  double turned = 0.0;
  double turned_less = 0.0;
  for_each_case(4, 12, [&](Rng& rng) {
    const std::vector<Polygon> boxes = {box(10, -4, 14, 6), box(24, -9, 28, 2)};
    const Problem problem =
        problem_of({0, 0, 0}, {uniform(38, 45, rng), uniform(-3, 3, rng), 0}, boxes);
    PlanOptions options{.budget = {.max_iterations = 4000}, .cost = shortest_style};
    const PlanResult free = plan(problem, options);
    options.cost.curvature_change_cost = 50;
    const PlanResult priced = plan(problem, options);
    ASSERT_EQ(free.status, PlanStatus::solved);
    ASSERT_EQ(priced.status, PlanStatus::solved) << priced.reason;
    turned += free.check->curvature_change;
    turned_less += priced.check->curvature_change;
    EXPECT_NEAR(priced.cost, priced.check->length + 50 * priced.check->curvature_change, 1e-6);
    EXPECT_LE(priced.lower_bound, priced.cost);
  });
  EXPECT_LT(turned_less, 0.9 * turned);
}

// A route's cost is that of its path: joints between pieces are charged as those inside.
TEST(CurvatureCost, OfARouteIsThatOfItsPath) {
  for_each_case(5, 100, [](Rng& rng) {
    const CostRule rule{.reverse_weight = 2, .gear_change_cost = 3, .curvature_change_cost = 10};
    const Problem problem = problem_of({}, {90, 0, 0}, {});
    search::Connector connector(problem.task(), rule);
    search::Route route{{}, {}, 0.0};
    for (int i = 0; i < 4; ++i) {
      const LocalPose via(uniform_pose({-20, 20, -20, 20}, rng));
      const std::size_t n = route.legs.size();
      const search::DrivenBeside beside = driven_around({rule.initial_gear, 0}, route, n, n);
      route.legs.push_back({*connector.steer(route.begin_of(n), via, beside), via});
    }
    EXPECT_NEAR(search::cost_of(rule, route), cost_of(rule, path_of(route).segments), 1e-9);
    const CostRule backwards{
        .forward_weight = 2, .gear_change_cost = 3, .curvature_change_cost = 10};
    EXPECT_NEAR(search::cost_of(backwards, reversed(route)), search::cost_of(rule, route), 1e-9);
  });
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Kinds of route, and those that only wheels that turn at once lead to.
#include "planners/anytime/kinds.h"

#include <gtest/gtest.h>

#include <vector>

#include "planners/anytime/strokes.h"
#include "support/problems.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

using anytime::Kinds;
using search::CostRule, search::Route;

constexpr CostRule priced{.reverse_weight = 2, .gear_change_cost = 5, .curvature_change_cost = 5};

/// Round a wall, into a gap.
Problem problem_with_walls() {
  return problem_of({0, 0, 0}, {30, 14, 1.5707963267948966},
                    {box(14, -20, 16, 6), box(24, 12, 27.5, 20), box(32.5, 12, 36, 20)});
}

/// What the default planner finds for wheels that turn at once.
Route relaxed_route(const Problem& problem, std::int64_t iterations) {
  PlanOptions options;
  options.steering = Steering::reeds_shepp;
  options.budget.max_iterations = iterations;
  const PlanResult result = plan(problem, planner_named("anytime"), options);
  Route route = anytime::legs_along(result.path.value(), problem.task().goal);
  const Task task = task_of(problem, {}, Steering::reeds_shepp);
  price(search::Connector(task, priced), route);
  return route;
}

TEST(Kinds, ARouteIsNewOnceUnlessItIsMuchCheaper) {
  const Problem open = problem_of({0, 0, 0}, {30, 0, 0}, {});
  Route route = relaxed_route(open, 100);
  Kinds kinds;
  EXPECT_TRUE(kinds.is_new(route, 6));
  EXPECT_FALSE(kinds.is_new(route, 6));
  route.cost *= 0.99;
  EXPECT_FALSE(kinds.is_new(route, 6));
  route.cost *= 0.98;
  EXPECT_TRUE(kinds.is_new(route, 6));
  EXPECT_TRUE(kinds.is_new(relaxed_route(problem_with_walls(), 2000), 6));
}

/// A bus, and walls with a gap each that it has to get through one after the other.
Problem problem_with_gates() {
  const Vehicle bus{.wheelbase = 6,
                    .front_overhang = 2.7,
                    .rear_overhang = 3.3,
                    .width = 2.55,
                    .min_turning_radius = 8.5};
  std::vector<Polygon> walls = {box(-50, 40, 50, 41), box(-50, -41, 50, -40)};
  double x = -30;
  for (const double gate : {-2.0, 9.6, 15.6, -10.6}) {
    walls.push_back(box(x, -40, x + 1, gate));
    walls.push_back(box(x, gate + 4.6, x + 1, 40));
    x += 20;
  }
  return problem_of({-45, 2.4, 3.14159265}, {40, 6.6, 1.57079633}, walls, {-65, 65, -56, 56}, bus);
}

// Searches for wheels that may not turn at once find a way that costs nearly twice as much.
TEST(Anytime, FollowsTheWaysThroughGatesOfWheelsThatTurnAtOnce) {
  const Problem problem = problem_with_gates();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto cost_with = [&](Steering steering) {
      PlanOptions options{.cost = driver_style, .steering = steering};
      options.budget = {.max_iterations = 4000, .seed = seed};
      return plan(problem, options).cost;
    };
    EXPECT_LT(cost_with(Steering::continuous), 1.1 * cost_with(Steering::reeds_shepp)) << seed;
  }
}

}  // namespace
}  // namespace vandplan

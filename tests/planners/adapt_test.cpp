// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Routes of wheels that turn at once, and the routes that the wheels can follow along them.
#include "planners/anytime/adapt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "planners/anytime/seeker.h"
#include "planners/anytime/strokes.h"
#include "support/continuity.h"
#include "support/problems.h"
#include "vandplan/path_check.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

using anytime::Adapter, anytime::Kinds;
using search::Budget, search::CostRule, search::Route;

constexpr std::array continuous_kinds = {Steering::continuous_between_stops, Steering::continuous};
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

/// The route that the adapter finds in so many trials.
std::optional<Route> adapted(Adapter& adapter, int trials) {
  for (int i = 0; i < trials && adapter.has_work(); ++i) {
    if (adapter.step()) return adapter.route();
  }
  return std::nullopt;
}

TEST(Adapter, FindsARouteThatTheWheelsCanFollow) {
  const Problem problem = problem_with_walls();
  const Route relaxed = relaxed_route(problem, 2000);
  for (const Steering steering : continuous_kinds) {
    const Task task = task_of(problem, {}, steering);
    Adapter adapter(task, priced, 1);
    EXPECT_FALSE(adapter.has_work());
    adapter.offer(relaxed);
    EXPECT_TRUE(adapter.has_work());
    const std::optional<Route> route = adapted(adapter, 100);
    ASSERT_TRUE(route) << name_of(steering);
    EXPECT_FALSE(adapter.has_work());
    adapter.offer(relaxed);  // again
    EXPECT_FALSE(adapter.has_work());
    const Path path = path_of(*route);
    EXPECT_EQ(path.start, task.start);
    EXPECT_EQ(route->legs.back().end, task.goal);
    EXPECT_TRUE(task.checker->is_free(task.start, path.segments));
    expect_continuous(path, problem, steering);
    EXPECT_LT(route->cost, 2 * relaxed.cost);
    EXPECT_NEAR(route->cost, cost_of(priced, *route), 1e-9);
    EXPECT_GT(adapter.solves(), 0);
    EXPECT_GT(adapter.checks(), 0);
  }
}

// Through a wall no trial leads, and the next route gets its turn.
TEST(Adapter, GivesUpWhatIsBlocked) {
  const Problem open = problem_of({0, 0, 0}, {30, 0, 0}, {});
  const Problem walled =
      problem_of({0, 0, 0}, {30, 0, 0}, {box(14, -150, 15, 150)}, {-40, 40, -151, 151});
  const Task task = task_of(walled, {}, Steering::continuous);
  Adapter adapter(task, priced, 1);
  adapter.offer(relaxed_route(open, 100));
  int trials = 0;
  for (; adapter.has_work(); ++trials) {
    ASSERT_FALSE(adapter.step());
    ASSERT_LT(trials, 1000);
  }
  EXPECT_GT(trials, 10);
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

TEST(Adapter, IsTheSourceOfAWorker) {
  const Problem problem = problem_with_walls();
  for (const Steering steering : continuous_kinds) {
    const Task task = task_of(problem, {}, steering);
    anytime::Seeker worker(task, priced, anytime::Scope::all, 1,
                           [&] { return std::make_unique<Adapter>(task, priced, 1); });
    const Budget budget{BudgetOptions{}};
    EXPECT_FALSE(worker.work(100, {}, budget).route);
    worker.offer(relaxed_route(problem, 2000));
    const anytime::Found found = worker.work(400, {}, budget);
    ASSERT_TRUE(found.route) << name_of(steering);
    ASSERT_FALSE(found.improvements.empty());
    EXPECT_EQ(found.improvements.back().cost, found.route->cost);
    EXPECT_GT(worker.counts().solves, 0);
    EXPECT_GT(worker.counts().checks, 0);
  }
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
TEST(Anytime, AdaptsTheWaysThroughGatesOfWheelsThatTurnAtOnce) {
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

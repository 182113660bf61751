// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Whole sites: what is near is found among very many, a strip is looked at instead of all of it,
// and a long route is shortened window by window.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "../support/cases.h"
#include "../support/continuity.h"
#include "../support/grids.h"
#include "../support/problems.h"
#include "planners/anytime/lattice.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/sources.h"
#include "search/grid_distance.h"
#include "search/polygon_squares.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using anytime::Lattice;
using anytime::Shortener;
using search::Connector;
using search::CostRule;
using search::GridDistance;
using search::PolygonSquares;
using search::Route;

bool overlap(const Bounds& a, const Bounds& b) {
  return a.x_min <= b.x_max && b.x_min <= a.x_max && a.y_min <= b.y_max && b.y_min <= a.y_max;
}

Bounds random_bounds(double reach, Rng& rng) {
  const double x = uniform(-500, 500, rng);
  const double y = uniform(-200, 200, rng);
  return {x, x + uniform(0, reach, rng), y, y + uniform(0, reach, rng)};
}

Polygon box_around(const Bounds& b) { return box(b.x_min, b.y_min, b.x_max, b.y_max); }

// One in forty reaches over much of the plane.
TEST(PolygonSquares, VisitsAllThatAreNear) {
  for_each_case(1, 200, [](Rng& rng) {
    std::vector<Polygon> polygons;
    const auto count = 1 + rng() % 200;
    for (std::size_t i = 0; i < count; ++i) {
      polygons.push_back(box_around(random_bounds(rng() % 40 == 0 ? 800 : 20, rng)));
    }
    const PolygonSquares squares(polygons);
    for (int i = 0; i < 20; ++i) {
      const Bounds query = random_bounds(100, rng);
      std::set<const Polygon*> visited;
      squares.visit_near(query, [&](const Polygon& polygon) { visited.insert(&polygon); });
      for (const Polygon& polygon : polygons) {
        EXPECT_TRUE(!overlap(bounding_box(polygon), query) || visited.contains(&polygon));
      }
    }
  });
}

TEST(PolygonSquares, OfNoPolygonsVisitsNone) {
  const PolygonSquares squares({});
  squares.visit_near({-1, 1, -1, 1}, [](const Polygon&) { FAIL(); });
}

// One building on `area`, none where start and goal are; they lie in opposite corners.
Problem site(double side, std::uint64_t seed, double area = 900) {
  Rng rng(seed);
  std::vector<Polygon> buildings;
  for (double left = side * side / area; left > 0; --left) {
    const double x = uniform(0, side, rng), y = uniform(0, side, rng);
    const double apart = std::min(std::hypot(x, y), std::hypot(x - side, y - side));
    const double width = uniform(3, 12, rng), height = uniform(3, 12, rng);
    if (apart > 30) buildings.push_back(box(x, y, x + width, y + height));
  }
  return problem_in({.bounds = {-60, side + 60, -60, side + 60}, .obstacles = buildings}, {0, 0, 0},
                    {side, side, 1.5});
}

Bounds all_of(const Problem& problem) { return sampling_region(problem.task(), Region::scene); }

/// A guide for a whole site.
GridDistance guide_in(const Problem& problem, const Bounds& box, double greediness,
                      double price = 0.0) {
  const double side = problem.vehicle().width;
  return GridDistance(
      problem.task(), box, problem.task().goal, problem.task().start,
      {.side = side, .price = {price, 2 * side}, .greediness = greediness, .detour = 1.0});
}

TEST(GridDistance, OfASiteIsAsFarAsOneThatGoesOn) {
  for_each_case(2, 20, [](Rng& rng) {
    const Problem problem = site(200, rng());
    const Pose& start = problem.task().start;
    const Pose& goal = problem.task().goal;
    GridDistance grid(problem.task(), all_of(problem), goal, start,
                      {.side = problem.vehicle().width, .detour = 1.5});
    GridDistance exact = guide_in(problem, all_of(problem), 1.0);
    GridDistance greedy = guide_in(problem, all_of(problem), 1.25);
    while (grid.step()) {
    }
    while (exact.step()) {
    }
    while (greedy.step()) {
    }
    ASSERT_EQ(grid.is_connected(), exact.is_connected());
    ASSERT_EQ(grid.is_connected(), greedy.is_connected());
    if (!grid.is_connected()) return;
    const double least = grid.at(start.x, start.y);
    EXPECT_NEAR(exact.at(start.x, start.y), least, 1e-9);
    EXPECT_GE(greedy.at(start.x, start.y), least - 1e-9);
    EXPECT_LE(greedy.at(start.x, start.y), 1.25 * least + 1e-9);
    EXPECT_NEAR(exact.at(-500, 0), std::hypot(-500 - goal.x, goal.y), 1e-9);  // outside: Euclid
  });
}

TEST(GridDistance, GoesAroundTheCellsOfAMapAndAroundKerbs) {
  OccupancyGrid map = grid_of(std::vector<std::string>(60, "..#.."), 0.5, {19, -15, 0});
  map.unknown_is_free = true;
  const Polygon wall = box(20, -15, 20.5, 15);
  const Bounds bounds{-30, 70, -40, 40};
  const Surroundings grounds[] = {{.bounds = bounds, .map = map},
                                  {.bounds = bounds, .kerbs = {wall}},
                                  {.bounds = bounds, .obstacles = {wall}}};
  for (const Surroundings& ground : grounds) {
    const Problem problem = problem_in(ground, {0, 0, 0}, {40, 0, 0});
    GridDistance guide = guide_in(problem, bounds, 1.0);
    while (guide.step()) {
    }
    EXPECT_TRUE(guide.is_connected());
    EXPECT_NEAR(guide.at(0, 0), 2 * std::hypot(20, 15), 6.0);
  }
}

TEST(GridDistance, SaysWhereNoWayIs) {
  const Problem problem = problem_of({0, 0, 0}, {40, 0, 0}, {box(20, -300, 21, 300)});
  GridDistance guide = guide_in(problem, {-30, 70, -40, 40}, 1.25);
  while (guide.step()) {
  }
  EXPECT_FALSE(guide.is_connected());
  EXPECT_NEAR(guide.at(0, 0), 40.0, 1e-9);
}

TEST(GridDistance, SeesASiteWhereOneGridWouldBeTooCoarse) {
  const Problem problem = site(600, 1);
  EXPECT_TRUE(search::is_site(problem.task(), {0, 600, 0, 600}));
  EXPECT_FALSE(search::is_site(problem.task(), {0, 400, 0, 400}));
}

// Leads where there is room to turn.
std::vector<Point> way_of(const Problem& problem) {
  GridDistance guide = guide_in(problem, all_of(problem), 1.25, 3.0);
  while (guide.step()) {
  }
  return guide.way();
}

double length_of(const std::vector<Point>& way) {
  double sum = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    sum += std::hypot(way[i].x - way[i - 1].x, way[i].y - way[i - 1].y);
  }
  return sum;
}

TEST(GridDistance, ItsWayIsAsLongAsItSays) {
  for_each_case(6, 10, [](Rng& rng) {
    const Problem problem = site(600, rng());
    const double side = problem.vehicle().width;
    GridDistance guide = guide_in(problem, all_of(problem), 1.0);
    while (guide.step()) {
    }
    const std::vector<Point> way = guide.way();
    EXPECT_EQ(way.front().x, problem.task().start.x);
    EXPECT_EQ(way.back().y, problem.task().goal.y);
    for (std::size_t i = 1; i < way.size(); ++i) {
      EXPECT_LT(std::hypot(way[i].x - way[i - 1].x, way[i].y - way[i - 1].y), 2.2 * side);
    }
    // Diagonals count 7 fifths of a cell, and both ends lie somewhere in theirs.
    const double said = guide.at(problem.task().start.x, problem.task().start.y);
    EXPECT_NEAR(length_of(way), said, 0.011 * said + 2 * side);
  });
}

/// How much the wheels turn along a route [1/m].
double total_turning(const Route& route) {
  const CostRule turning{.curvature_change_cost = 1.0};
  const Path path = path_of(route);
  return search::drive_cost(turning, path.segments) - route.length();
}

// Bends are pulled straight and turned gently where there is room.
TEST(Strung, DrivesAlongAWayForward) {
  const CostRule prices{1.0, 2.0, 5.0, 0};
  constexpr std::array steerings = {Steering::reeds_shepp, Steering::continuous_between_stops,
                                    Steering::continuous};
  int complete = 0;
  double length = 0.0, turning = 0.0;  // sums of [ways] and [1/m per m]
  for_each_case(7, 12, [&](Rng& rng) {
    const Problem problem = site(1000, rng(), 450);
    Task task = problem.task();
    task.steering = steerings[rng() % steerings.size()];
    const std::vector<Point> way = way_of(problem);
    Connector connector(task, prices);
    const auto strung = anytime::strung(task, way, connector);
    bool is_complete = false;
    while (strung->has_work()) is_complete = strung->step();
    if (!is_complete) return;
    ++complete;
    const PathCheck check =
        check_path(problem, path_of(strung->route()), {.steering = task.steering});
    EXPECT_TRUE(check.valid) << check.reason;
    length += check.length / length_of(way);
    turning += total_turning(strung->route()) / check.length;
    EXPECT_LT(check.reverse_length, 0.03 * check.length);
  });
  EXPECT_GT(complete, is_sanitized ? 0 : 9);
  EXPECT_LT(length, 0.952 * complete);
  EXPECT_LT(turning, 0.0056 * complete);
}

// A gate that is too narrow: the way of a point leads through it, and nobody drives there.
TEST(Strung, GivesUpWhereNobodyGetsThrough) {
  const Problem problem =
      problem_of({0, 0, 0}, {100, 0, 0}, {box(48, 1.2, 52, 80), box(48, -80, 52, -1.2)});
  Connector connector(problem.task());
  const auto strung =
      anytime::strung(problem.task(), {{0, 0}, {25, 0}, {50, 0}, {75, 0}, {100, 0}}, connector);
  for (int steps = 0; strung->has_work(); ++steps) {
    ASSERT_LT(steps, 10000);
    EXPECT_FALSE(strung->step());
  }
}

// A raw route of more legs than windows have, as a lattice finds it.
std::optional<Route> long_route(const Problem& problem, Connector& connector) {
  GridDistance guide = guide_in(problem, all_of(problem), 1.25);
  while (guide.step()) {
  }
  Lattice lattice(problem.task().start, problem.task().goal, {}, {12, 0.5, 2.0}, guide, connector);
  for (int i = 0; i < 20000; ++i) {
    if (lattice.step()) return lattice.route();
  }
  return std::nullopt;
}

TEST(Shortener, WindowsShortenALongRouteAndKeepItWhole) {
  constexpr CostRule rules[] = {{}, {1.0, 2.0, 3.0, 0}};
  for_each_case(3, 6, [&](Rng& rng) {
    const Problem problem = site(1000, rng());
    const CostRule& rule = rules[rng() % 2];
    Connector connector(problem.task(), rule);
    const std::optional<Route> raw = long_route(problem, connector);
    ASSERT_TRUE(raw);
    ASSERT_GT(raw->legs.size(), 40U);
    Shortener shortener(connector, *raw, rng());
    EXPECT_GT(shortener.trials_for_one(), 2.0);
    double cost = shortener.cost();
    EXPECT_NEAR(cost, raw->cost, 1e-6);
    for (int i = 0; i < 20000; ++i) {
      const bool is_cheaper = shortener.step();
      EXPECT_EQ(is_cheaper, shortener.cost() < cost);
      cost = shortener.cost();
    }
    const Route route = shortener.route();
    EXPECT_NEAR(route.cost, cost, 1e-6);
    EXPECT_LT(route.cost, 0.97 * raw->cost);
    EXPECT_LT(route.legs.size(), raw->legs.size());
    const PathCheck check = check_path(problem, path_of(route), {});
    EXPECT_TRUE(check.valid) << check.reason;
    EXPECT_NEAR(check.length + rule.gear_change_cost * check.gear_changes +
                    (rule.reverse_weight - 1) * check.reverse_length,
                cost, 1e-5);
  });
}

// A route that turns long after the end of the wall: what is put in its place is shorter from then
// on, and the detours lead off that.
TEST(Detours, OfALongRoutePutShorterStretchesInTheirPlace) {
  const Problem problem = problem_of({0, 0, 0}, {0, 20, 3}, {box(-60, 9, 30, 11)});
  for (const CostRule& rule : {CostRule{}, CostRule{1.0, 2.0, 3.0, 0}}) {
    Connector connector(problem.task(), rule);
    Route route{problem.task().start, {}, 0.0};
    for (const auto& via : {LocalPose({80, 0, 0}), LocalPose({80, 20, 3}), problem.task().goal}) {
      const LocalPose from = route.legs.empty() ? route.start : route.legs.back().end;
      route.legs.push_back({*connector.steer(from, via), via});
    }
    route.cost = cost_of(rule, route);
    const auto detours = anytime::detours(problem.task(), rule, 1);
    detours->set_route(route);
    double best = route.cost;
    for (int i = 0; i < 20000; ++i) {
      if (!detours->step()) continue;
      EXPECT_LT(detours->route().cost, best);
      EXPECT_NEAR(cost_of(rule, detours->route()), detours->route().cost, 1e-9);
      EXPECT_TRUE(check_path(problem, path_of(detours->route()), {}).valid);
      best = detours->route().cost;
    }
    EXPECT_LT(best, 0.6 * route.cost);
  }
}

// Where a route changes gear the wheels are bent: what ends there in the same gear may not.
TEST(Detours, OfALongRouteAreFollowedByWhatIsDrivenThere) {
  int found = 0;
  for_each_case(5, 60, [&](Rng& rng) {
    Task task = problem_of({0, 0, 0}, {1, 0, 0}, {}).task();
    task.steering = Steering::continuous_between_stops;
    const CostRule rule{1.0, 1.5, 1.0, 0};
    Connector connector(task, rule);
    Route route{task.start, {}, 0.0};
    for (int i = 0; i < 4; ++i) {
      const LocalPose from = route.legs.empty() ? route.start : route.legs.back().end;
      const search::Driven before =
          route.legs.empty() ? search::Driven{} : search::last_driven(route.legs.back().piece);
      const LocalPose via(uniform_pose({-12, 12, -12, 12}, rng));
      const auto piece = connector.steer(from, via, {before, 0});
      if (piece) route.legs.push_back({*piece, via});
    }
    task.goal = route.legs.back().end;
    route.cost = cost_of(rule, route);
    ASSERT_LT(largest_jump(path_of(route), task.steering, {}), 1e-9);
    const auto detours = anytime::detours(task, rule, rng());
    detours->set_route(route);
    for (int i = 0; i < 3000; ++i) {
      if (!detours->step()) continue;
      ++found;
      EXPECT_LT(largest_jump(path_of(detours->route()), task.steering, {}), 1e-9);
    }
  });
  EXPECT_GT(found, is_sanitized ? 0 : 10);
}

// 1.4 km from corner to corner; a grid over all of it had cells of 5 m, and found nothing for long.
TEST(Anytime, CrossesAWholeSiteInFewIterations) {
  const Problem problem = site(1000, 5);
  for (const char* style : {"shortest", "driver"}) {
    PlanOptions options;
    if (style == std::string_view("shortest")) options.cost = shortest_style;
    options.budget.time_limit.reset();
    options.budget.max_iterations = is_sanitized ? 6000 : 40000;
    const PlanResult result = plan(problem, options);
    ASSERT_TRUE(result.path) << style;
    EXPECT_LT(result.anytime.front().iteration, 1000) << style;
    EXPECT_LT(result.check->length, (is_sanitized ? 1.4 : 1.1) * 1000 * std::sqrt(2));
    EXPECT_LT(result.anytime.front().cost, 1.03 * result.cost) << style;
    options.budget.threads = 2;
    EXPECT_EQ(plan(problem, options).cost, result.cost) << style;
  }
}

}  // namespace
}  // namespace vandplan

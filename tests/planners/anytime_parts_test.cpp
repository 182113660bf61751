// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// The parts of the default planner, each by itself: every route is one that the judge accepts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "../support/cases.h"
#include "../support/problems.h"
#include "planners/anytime/lattice.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/sources.h"
#include "planners/anytime/workers.h"
#include "search/grid_distance.h"
#include "vandplan/judge.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using anytime::Lattice;
using anytime::Shortener;
using search::Budget;
using search::Connector;
using search::CostRule;
using search::GridDistance;
using search::Route;

// A truck among five boxes; start and goal are free.
Problem random_problem(Rng& rng) {
  while (true) {
    std::vector<Polygon> boxes;
    for (int i = 0; i < 5; ++i) {
      const double x = uniform(-25, 20, rng);
      const double y = uniform(-25, 20, rng);
      boxes.push_back(box(x, y, x + uniform(1, 8, rng), y + uniform(1, 8, rng)));
    }
    const Bounds region{-30, 30, -30, 30};
    Problem problem = problem_of(uniform_pose(region, rng), uniform_pose(region, rng), boxes);
    const CollisionChecker& checker = *problem.task().checker;
    if (checker.is_free(problem.task().start) && checker.is_free(problem.task().goal))
      return problem;
  }
}

void expect_valid(const Problem& problem, const CostRule& rule, const Route& route) {
  const PathCheck check = check_path(problem, path_of(route), {});
  EXPECT_TRUE(check.valid) << check.reason << " " << as_code(problem.task().start) << " "
                           << as_code(problem.task().goal) << " " << as_code(obstacles_of(problem));
  EXPECT_NEAR(cost_of(rule, route), route.cost, 1e-9);
  EXPECT_NEAR(rule.forward_weight * (check.length - check.reverse_length) +
                  rule.reverse_weight * check.reverse_length +
                  rule.gear_change_cost * check.gear_changes,
              route.cost, 1e-6);
}

using std::numbers::pi;
constexpr CostRule rules[] = {{}, {1.0, 2.0, 3.0, 0}};

/// A complete guide to the goal.
GridDistance guide_of(const Problem& problem) {
  GridDistance guide(problem.task(), {-50, 50, -50, 50}, problem.task().goal, problem.task().start,
                     {.side = 1.0 * problem.vehicle().width});
  while (guide.step()) {
  }
  return guide;
}

TEST(Lattice, EveryRouteIsValidAndCheaperThanTheOneBefore) {
  for_each_case(2, 100, [](Rng& rng) {
    const Problem problem = random_problem(rng);
    const CostRule& rule = rules[rng() % 2];
    Connector connector(problem.task(), rule);
    GridDistance guide = guide_of(problem);
    Lattice lattice(problem.task().start, problem.task().goal, {}, {12, 0.5, 2.0}, guide,
                    connector);
    double cost = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 400 && !lattice.is_exhausted(); ++i) {
      if (!lattice.step()) continue;
      expect_valid(problem, rule, lattice.route());
      // The search adds up node by node, the route segment by segment: equal but for rounding.
      EXPECT_LT(lattice.route().cost, cost + 1e-9);
      cost = lattice.route().cost;
    }
  });
}

TEST(Rotation, EveryRouteIsValidAndOfInterest) {
  for_each_case(5, 40, [](Rng& rng) {
    const Problem problem = random_problem(rng);
    const CostRule rule{1.0, 2.0, 3.0, 0};
    GridDistance guide(problem.task(), {-50, 50, -50, 50}, problem.task().goal,
                       problem.task().start, {.side = 1.0 * problem.vehicle().width});
    while (guide.step()) {
    }
    Connector connector(problem.task(), rule);
    const auto rotation = anytime::rotation(problem.task().start, problem.task().goal, {},
                                            anytime::coarse_to_fine, 256, guide, connector);
    double cutoff = 150.0;
    for (int i = 0; i < 3000 && rotation->has_work(); ++i) {
      rotation->set_cutoff(cutoff);
      if (!rotation->step()) continue;
      Route route = rotation->route();
      route.cost = cost_of(rule, route);
      expect_valid(problem, rule, route);
      EXPECT_LT(route.cost, cutoff + 1e-9);
      cutoff = std::min(cutoff, route.cost);
    }
  });
}

// Where a cutoff leaves nothing every search ends, and so does the rotation.
TEST(Rotation, EndsWhenNothingCheaperIsLeft) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, {box(14, -20, 16, 20)});
  GridDistance guide(problem.task(), {-20, 50, -40, 40}, problem.task().goal, problem.task().start,
                     {.side = 0.5 * problem.vehicle().width});
  while (guide.step()) {
  }
  Connector connector(problem.task(), {1.0, 2.0, 5.0, 0});
  const auto rotation = anytime::rotation(problem.task().start, problem.task().goal, {},
                                          anytime::coarse_to_fine, 256, guide, connector);
  rotation->set_cutoff(9.0);
  for (int i = 0; i < 50000 && rotation->has_work(); ++i) EXPECT_FALSE(rotation->step());
  EXPECT_FALSE(rotation->has_work());
}

// Of a turn between straight wheels, which only its ends cut. Its length and the place of the last
// cut differ by rounding.
Piece turn_that_rounds(double radius) {
  const double rate = 0.5 / (radius * radius);
  Piece turn;
  turn.count = 3;
  turn.segments.data()[0] = {0.0, radius, rate};
  turn.segments.data()[1] = {0.5 / radius, radius, 0.0};
  turn.segments.data()[2] = {0.5 / radius, radius, -rate};
  turn.length = std::nextafter(3 * radius, 4 * radius);
  return turn;
}

TEST(Detours, CutsThatOnlyRoundingTellsApartHaveNothingBetweenThem) {
  Task task = problem_of({0, 0, 0}, {1, 0, 0}, {}).task();
  task.steering = Steering::continuous;
  const Piece turn = turn_that_rounds(task.vehicle.min_turning_radius);
  Route route{task.start, {}, 0.0};
  task.goal = task.start;
  for (int i = 0; i < 3; ++i) {
    task.goal = search::end_of(task.goal, turn);
    route.legs.push_back({turn, task.goal});
  }
  const CostRule rule;
  route.cost = cost_of(rule, route);
  int found = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto detours = anytime::detours(task, rule, seed);
    detours->set_route(route);
    for (int i = 0; i < 1000; ++i) {
      if (!detours->step()) continue;
      ++found;
      const Pose end = end_pose(path_of(detours->route()));
      EXPECT_NEAR(end.x, task.goal.x, 1e-9);
      EXPECT_NEAR(end.y, task.goal.y, 1e-9);
    }
  }
  EXPECT_GT(found, 0);
}

/// The routes of so many looks around, while ways that cost little more than `cutoff` count.
std::vector<Route> survey(const Problem& problem, const CostRule& rule, double cutoff,
                          int steps = 4000) {
  const auto survey = anytime::survey(problem.task(), rule);
  survey->set_cutoff(cutoff);
  std::vector<Route> routes;
  for (int i = 0; i < steps; ++i) {
    if (survey->step()) routes.push_back(survey->route());
  }
  return routes;
}

TEST(Survey, EveryRouteIsValid) {
  int found = 0;
  for_each_case(11, 20, [&](Rng& rng) {
    const Problem problem = random_problem(rng);
    const CostRule& rule = rules[1];
    const std::vector<Route> routes = survey(problem, rule, 300.0);
    for (const Route& route : routes) {
      expect_valid(problem, rule, route);
      Pose pose = route.start;
      for (const search::Leg& leg : route.legs) {
        pose = search::end_of(pose, leg.piece);
        EXPECT_NEAR(std::hypot(pose.x - leg.end.x, pose.y - leg.end.y), 0.0, 1e-9);
        pose = leg.end;
      }
      EXPECT_EQ(pose, problem.task().goal);
    }
    found += routes.empty() ? 0 : 1;
  });
  EXPECT_GT(found, 0.8 * cases(20));
}

TEST(Survey, FindsTheWaysOnBothSidesOfAnObstacle) {
  const Problem problem = problem_of({-30, 0, 0}, {30, 0, 0}, {box(-5, -12, 5, 12)});
  bool left = false, right = false;
  for (const Route& route : survey(problem, rules[1], 100.0)) {
    const Path path = path_of(route);
    for (double s = 0.0; s < length(path); s += 0.5) {
      const Pose pose = pose_at(path, s);
      if (std::abs(pose.x) > 5) continue;
      (pose.y > 0 ? left : right) = true;
    }
  }
  EXPECT_TRUE(left);
  EXPECT_TRUE(right);
}

TEST(Survey, FindsThatTurningAroundPays) {
  const Problem problem = problem_of({0, 0, pi}, {100, 0, pi}, {box(40, 20, 60, 30)});
  double cheapest = 200.0;  // in reverse all the way
  for (const Route& route : survey(problem, rules[1], 200.0)) {
    cheapest = std::min(cheapest, route.cost);
  }
  EXPECT_LT(cheapest, 165.0);
}

TEST(Survey, LooksForNothingThatCostsMuchMore) {
  const Problem problem = problem_of({-30, 0, 0}, {30, 0, 0}, {box(-5, -12, 5, 12)});
  EXPECT_TRUE(survey(problem, rules[1], 45.0).empty());
  for (const Route& route : survey(problem, rules[1], 70.0)) EXPECT_LT(route.cost, 1.5 * 70.0);
}

// A route that wins for a while may be of a kind that gets cheaper than all others yet.
TEST(Seeker, KeepsWhatHasWonForAWhile) {
  const Problem problem = problem_of({0, 0, pi}, {100, 0, pi}, {box(40, 20, 60, 30)});
  const auto worker = anytime::seeker(problem.task(), rules[1], 1,
                                      [&] { return anytime::survey(problem.task(), rules[1]); });
  const Budget budget{BudgetOptions{}};
  Route reverse{problem.task().start, {}, 0.0};
  search::drive_on(reverse.legs, {0.0, -100.0}, problem.task().goal);
  price(Connector(problem.task(), rules[1]), reverse);
  const anytime::Found found = worker->work(20'000, {&reverse}, budget);
  ASSERT_GE(found.improvements.size(), 2U);
  for (std::size_t i = 0; i + 1 < found.improvements.size(); ++i) {
    EXPECT_TRUE(std::ranges::any_of(found.given_up, [&](const Route& route) {
      return route.cost == found.improvements[i].cost;
    }));
  }
}

// Kerbs are left to the exact checks.
TEST(Survey, KeepsTheWheelsOffKerbs) {
  const Problem problem =
      problem_in({.bounds = wide_bounds, .kerbs = {box(-1, -40, 1, 40)}}, {-30, 0, 0}, {30, 0, 0});
  const std::vector<Route> routes = survey(problem, rules[1], 150.0);
  EXPECT_FALSE(routes.empty());
  for (const Route& route : routes) expect_valid(problem, rules[1], route);
}

// A scene that is large for a nimble vehicle: cells get larger and not too many.
TEST(Survey, ALargeSceneTakesNoMoreMemory) {
  Vehicle nimble;
  nimble.min_turning_radius = 0.5;
  const Problem problem =
      problem_of({-90, 0, 0}, {90, 0, 0}, {box(-5, -92, 5, 92)}, wide_bounds, nimble);
  for (const Route& route : survey(problem, rules[1], 500.0)) {
    expect_valid(problem, rules[1], route);
  }
}

TEST(Shortener, TheCostFallsAndTheRouteStaysValid) {
  for_each_case(3, 60, [](Rng& rng) {
    const Problem problem = random_problem(rng);
    const CostRule& rule = rules[rng() % 2];
    Connector connector(problem.task(), rule);
    GridDistance guide = guide_of(problem);
    Lattice lattice(problem.task().start, problem.task().goal, {}, {12, 0.5, 2.0}, guide,
                    connector);
    int tries = 0;
    while (!lattice.step() && ++tries < 400 && !lattice.is_exhausted()) {
    }
    if (lattice.route().legs.empty()) return;
    Shortener shortener(connector, lattice.route(), rng());
    double cost = shortener.route().cost;
    for (int i = 0; i < 500; ++i) {
      const bool cheaper = shortener.step();
      EXPECT_EQ(cheaper, shortener.route().cost < cost);
      cost = shortener.route().cost;
    }
    expect_valid(problem, rule, shortener.route());
  });
}

// With nothing in the way the shortest word is all that remains.
TEST(Shortener, OnOpenGroundItFindsTheShortestPath) {
  for_each_case(4, 20, [](Rng& rng) {
    Problem problem = random_problem(rng);
    problem = problem_of(problem.task().start, problem.task().goal, {});
    Connector connector(problem.task());
    const LocalPose via(uniform_pose({-30, 30, -30, 30}, rng));
    Route route{problem.task().start, {}, 0.0};
    route.legs.push_back({*connector.steer(problem.task().start, via), via});
    route.legs.push_back({*connector.steer(via, problem.task().goal), problem.task().goal});
    route.cost = cost_of({}, route);
    Shortener shortener(connector, route, rng());
    for (int i = 0; i < 200; ++i) shortener.step();
    EXPECT_NEAR(shortener.route().cost,
                connector.least_cost(problem.task().start, problem.task().goal), 1e-6);
  });
}

TEST(GridDistance, GoesAroundAWallAndIsNearTheTruth) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, {box(14, -20, 16, 20)});
  GridDistance guide(problem.task(), {-20, 50, -40, 40}, problem.task().goal, problem.task().start,
                     {.side = 0.5 * problem.vehicle().width});
  while (guide.step()) {
  }
  EXPECT_NEAR(guide.at(0, 0), 2 * std::hypot(14, 20) + 2, 0.12 * 50);
  EXPECT_NEAR(guide.at(25, 0), 5.0, 2.0);
  EXPECT_NEAR(guide.at(500, 0), 470.0, 1e-9);  // outside: Euclid
}

/// The same polygon with nine more corners on each side.
Polygon with_more_corners(const Polygon& polygon) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    for (int k = 0; k < 10; ++k) {
      result.push_back({a.x + (b.x - a.x) * k / 10, a.y + (b.y - a.y) * k / 10});
    }
  }
  return result;
}

// Long sides in any direction, and short ones: a side is near to few of the cells of its box.
TEST(GridDistance, MindsNotInHowManySidesAnOutlineIsGiven) {
  for_each_case(9, 200, [](Rng& rng) {
    std::vector<Polygon> few, many;
    for (int i = 0; i < 4; ++i) {
      const auto corner = [&] { return Point{uniform(-25, 25, rng), uniform(-25, 25, rng)}; };
      few.push_back({corner(), corner(), corner()});
      many.push_back(with_more_corners(few.back()));
    }
    const Pose start = uniform_pose({-30, 30, -30, 30}, rng);
    const Pose goal = uniform_pose({-30, 30, -30, 30}, rng);
    const double weight = rng() % 2 == 0 ? 0.0 : 2.0;
    const auto guide_among = [&](const std::vector<Polygon>& obstacles) {
      const Problem problem = problem_of(start, goal, obstacles);
      GridDistance guide(problem.task(), {-40, 40, -40, 40}, goal, start,
                         {.side = 0.25 * problem.vehicle().width, .price = {weight, 1.0}});
      while (guide.step()) {
      }
      return guide;
    };
    const GridDistance one = guide_among(few);
    const GridDistance other = guide_among(many);
    EXPECT_EQ(one.is_connected(), other.is_connected());
    for (int i = 0; i < 100; ++i) {
      const Pose place = uniform_pose({-40, 40, -40, 40}, rng);
      ASSERT_NEAR(one.at(place.x, place.y), other.at(place.x, place.y), weight == 0.0 ? 0.0 : 0.3)
          << as_code(few);
    }
  });
}

// Between two walls as far apart as the vehicle is wide, or around them in the open.
TEST(GridDistance, WithAPriceItKeepsAwayFromWalls) {
  const Problem problem =
      problem_of({0, 0, 0}, {30, 0, 0}, {box(5, -3, 25, -1.35), box(5, 1.35, 25, 3)});
  const auto guide_with = [&](double weight, const Pose& root) {
    GridDistance guide(problem.task(), {-20, 50, -40, 40}, problem.task().goal, root,
                       {.side = 0.5 * problem.vehicle().width, .price = {weight, 1.0}});
    while (guide.step()) {
    }
    return guide;
  };
  const GridDistance by_length = guide_with(0.0, problem.task().start);
  EXPECT_NEAR(by_length.at(0, 0), 30.0, 1.0);
  const GridDistance by_price = guide_with(2.0, problem.task().start);
  EXPECT_GT(by_price.at(0, 0), 32.0);
  EXPECT_LT(by_price.at(0, 0), 40.0);
  const GridDistance out_of_it = guide_with(2.0, {15, 0, 0});
  EXPECT_GT(out_of_it.at(15, 0), 1.1 * 15.0);
  EXPECT_LT(out_of_it.at(15, 0), 3.0 * 15.0);
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Are the interpolated costs of Field D* near to those of the cheapest ways, and can a vehicle
// drive along its routes?

#include <gtest/gtest.h>

#include <cmath>

#include "lab/cost_field.h"
#include "support/cases.h"
#include "support/numbers.h"
#include "support/problems.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

constexpr Bounds square{0, 40, 0, 40};

using search::CostCells, search::CostField;

double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

Point uniform_point(const Bounds& bounds, Rng& rng) {
  const Pose pose = uniform_pose(bounds, rng);
  return {pose.x, pose.y};
}

CostField settled(const CostCells& cells, const Point& target, const Point& root) {
  CostField field(cells, target, root);
  while (field.step()) {
  }
  return field;
}

double cost_between(const CostCells& cells, const Point& a, const Point& b) {
  return settled(cells, b, a).at(a);
}

double length_through(const std::vector<Point>& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
  return sum;
}

/// What interpolation adds to a straight way: lines instead of arcs about its end, less and less
/// far from it.
double slack(double length, double side) {
  return side * (0.3 + 0.3 * std::log(1 + length / side));
}

TEST(CostField, IsNearTheDistanceOnOpenGroundAndNeverBelowIt) {
  for_each_case(1, 100, [](Rng& rng) {
    const CostCells cells{square, uniform(0.3, 3.0, rng), [](const Point&) { return 1.0; }};
    const Point target = uniform_point(square, rng);
    const Point root = uniform_point(square, rng);
    const double cost = cost_between(cells, root, target);
    EXPECT_GE(cost, distance(root, target) * (1 - 1e-9));
    EXPECT_LE(cost, distance(root, target) + slack(distance(root, target), cells.side));
  });
}

// A wall of closed cells from y = 0 to y = 20 at 19 < x < 21: ways go around (19, 20) and (21, 20).
TEST(CostField, IsNearTheWayAroundAWall) {
  for_each_case(2, 100, [](Rng& rng) {
    const double side = 1.0 / static_cast<double>(1 + rng() % 3);
    const CostCells cells{square, side, [](const Point& p) {
                            return p.x > 19 && p.x < 21 && p.y < 20 ? infinity : 1.0;
                          }};
    const Point target = uniform_point({0, 18, 0, 19}, rng);
    const Point root = uniform_point({22, 40, 0, 19}, rng);
    const double exact = distance(root, {21, 20}) + 2 + distance({19, 20}, target);
    const double cost = cost_between(cells, root, target);
    EXPECT_GE(cost, exact * (1 - 1e-9));
    const double around = slack(distance(root, {21, 20}), side) + slack(2, side) +
                          slack(distance({19, 20}, target), side);
    EXPECT_LE(cost, exact + around);
  });
}

// Where x > 20 a metre costs three times as much: the way is refracted.
TEST(CostField, IsNearTheCheapestWayOverTwoGrounds) {
  for_each_case(3, 50, [](Rng& rng) {
    const CostCells cells{square, 0.5, [](const Point& p) { return p.x > 20 ? 3.0 : 1.0; }};
    const Point target = uniform_point({2, 18, 0, 40}, rng);
    const Point root = uniform_point({22, 38, 0, 40}, rng);
    double exact = infinity;
    for (double y = 0; y <= 40; y += 0.01) {
      exact = std::min(exact, distance(target, {20, y}) + 3 * distance({20, y}, root));
    }
    const double cost = cost_between(cells, root, target);
    EXPECT_GE(cost, exact * (1 - 1e-5));
    EXPECT_LE(cost, exact * 1.03);
  });
}

// From (0, 20) to (10, 30): along the cheap side of the dear cell, then across it.
TEST(CostField, AWayMayGoAlongASideFirst) {
  const CostCells cells{square, 10.0, [](const Point& p) { return p.y > 20 ? 5.0 : 1.0; }};
  double exact = infinity;
  for (double x = 0; x <= 10; x += 1e-3) exact = std::min(exact, x + 5 * std::hypot(10 - x, 10));
  EXPECT_NEAR(settled(cells, {10, 30}, {0, 21}).at({0, 20}), exact, 1e-5);
}

TEST(CostField, ItsRouteCostsWhatItSays) {
  int found = 0;
  for_each_case(4, 60, [&found](Rng& rng) {
    std::vector<Bounds> rocks(12);
    for (Bounds& rock : rocks) {
      const Point corner = uniform_point(square, rng);
      rock = {corner.x, corner.x + uniform(1, 9, rng), corner.y, corner.y + uniform(1, 9, rng)};
    }
    const CostCells cells{square, 0.5, [&](const Point& p) {
                            double cost = 1.0;
                            for (const Bounds& rock : rocks) {
                              if (contains(rock, p)) return infinity;
                              if (std::abs(p.x - rock.x_min) < 2) cost = 2.5;
                            }
                            return cost;
                          }};
    const Point target = uniform_point(square, rng);
    const Point root = uniform_point(square, rng);
    if (cells.cost(target) == infinity || cells.cost(root) == infinity) return;
    const CostField field = settled(cells, target, root);
    const std::vector<Point> route = field.route();
    ASSERT_EQ(route.empty(), field.at(root) == infinity);
    if (route.empty()) return;
    ++found;
    EXPECT_EQ(route.front(), root);
    EXPECT_EQ(route.back(), target);
    EXPECT_LE(length_through(route), field.at(root) * 1.02 + 1e-6);
    EXPECT_GE(length_through(route), distance(root, target) * (1 - 1e-9));
    for (std::size_t i = 1; i < route.size(); ++i) {  // through cells that are open
      const Point middle{(route[i - 1].x + route[i].x) / 2, (route[i - 1].y + route[i].y) / 2};
      const auto is_open = [&](double dx, double dy) {
        const double x = (std::floor((middle.x + dx) / 0.5) + 0.5) * 0.5;
        const double y = (std::floor((middle.y + dy) / 0.5) + 0.5) * 0.5;
        return contains(square, {x, y}) && cells.cost({x, y}) < infinity;
      };
      EXPECT_TRUE(is_open(1e-6, 1e-6) || is_open(-1e-6, 1e-6) || is_open(1e-6, -1e-6) ||
                  is_open(-1e-6, -1e-6));
    }
  });
  EXPECT_GT(found, cases(60) / 4);
}

TEST(CostField, KnowsThatThereIsNoWay) {
  const CostCells cells{square, 1.0,
                        [](const Point& p) { return p.x > 19 && p.x < 21 ? infinity : 1.0; }};
  const CostField field = settled(cells, {5, 5}, {35, 35});
  EXPECT_EQ(field.at({35, 35}), infinity);
  EXPECT_TRUE(field.route().empty());
}

// ---- the planner ----

PlanResult planned(const Problem& problem, std::int64_t iterations, double margin = 0.0) {
  PlanOptions options;
  options.budget.max_iterations = iterations;
  options.clearance.margin = margin;
  return plan(problem, planner_named("field-d-star"), options);
}

TEST(FieldDStar, DrivesAroundWallsThatAreFarFromEachOther) {
  const Problem problem = problem_of(
      {-30, 0, 0}, {30, 0, 0}, {box(-12, -40, -10, 20), box(10, -20, 12, 40)}, {-60, 60, -60, 60});
  const PlanResult few = planned(problem, 600);
  ASSERT_EQ(few.status, PlanStatus::solved) << few.reason;
  const PlanResult many = planned(problem, 3000);
  EXPECT_LE(many.cost, few.cost);
  EXPECT_LT(many.cost, 120);
}

TEST(FieldDStar, KeepsAMargin) {
  const std::vector<Polygon> gate = {box(-1, -40, 1, -2.2), box(-1, 2.2, 1, 40)};
  const Problem problem = problem_of({-20, 5, 0}, {20, -5, 0}, gate, {-40, 40, -40, 40});
  EXPECT_EQ(planned(problem, 4000, 0.5).status, PlanStatus::solved);
  EXPECT_NE(planned(problem, 1000, 1.0).status, PlanStatus::solved);  // 0.925 m on either side
}

TEST(FieldDStar, SaysThatTheFinestCellsHaveNoRoute) {
  const Problem problem =
      problem_of({-20, 0, 0}, {20, 0, 0}, {box(-1, -40, 1, 40)}, {-40, 40, -40, 40});
  PlanOptions options;
  options.budget.max_iterations = 1'000'000;
  options.planner.set("max_cells", std::int64_t{20'000});
  const PlanResult result = plan(problem, planner_named("field-d-star"), options);
  EXPECT_EQ(result.status, PlanStatus::node_limit);
  EXPECT_EQ(result.reason, "the finest cells have no route");
}

TEST(FieldDStar, TurnsRoundWhereItStands) {
  const Problem problem =
      problem_of({0, 0, 0}, {0, 0, 3.0}, {box(-30, 6.5, 30, 12), box(-30, -12, 30, -6.5)});
  const PlanResult result = planned(problem, 5000);
  EXPECT_EQ(result.status, PlanStatus::solved);
  EXPECT_EQ(result.iterations, 5000);  // the piece from pose to pose does not fit in
}

TEST(FieldDStar, AFreePieceIsProvenToBeTheShortestPath) {
  const PlanResult result = planned(problem_of({0, 0, 0}, {20, 10, 1}, {}), 100);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(result.lower_bound, result.cost);
}

}  // namespace
}  // namespace vandplan

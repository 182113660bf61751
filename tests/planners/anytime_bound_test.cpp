// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Is the bound that comes with a path true? Held against paths that are known to be (nearly) the
// best ones: a bound that is 2 % too high is above the cost of some of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "search/geodesic.h"
#include "search/open_ground.h"
#include "support/cases.h"
#include "support/draws.h"
#include "support/problems.h"
#include "support/radius.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

double bound_of(const Problem& problem, const search::CostRule& rule) {
  return cost_lower_bound(search::open_ground(problem.task(), rule), rule, 0.0);
}

PlanResult run(const Problem& problem, const CostOptions& cost = shortest_style) {
  PlanOptions options{.cost = shortest_style};
  options.budget.max_iterations = 20000;
  options.cost = cost;
  PlanResult result = plan(problem, options);
  EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
  return result;
}

/// Proven to be within `gap` of the best, and solved: the judge takes no bound above the cost.
void expect_tight(const PlanResult& result, double gap) {
  EXPECT_LE(result.lower_bound, result.cost);
  EXPECT_GT(result.lower_bound, (1 - gap) * result.cost);
}

TEST(AnytimeBound, IsTheShortestLengthOnOpenGround) {
  for (const Pose& goal : {Pose{20, 30, 2}, {0, 3, 0}, {-9, 1, 3}, {0.5, 0, 1}}) {
    const PlanResult result = run(problem_of({0, 0, 0}, goal, {}));
    EXPECT_NEAR(result.lower_bound.value_or(0.0), reeds_shepp_length({}, goal, 7.0), 1e-9);
    expect_tight(result, 1e-9);
  }
}

// A long way with a thin wall across: around its end, hardly longer than the way of the axle.
TEST(AnytimeBound, IsCloseBelowALongDetour) {
  const Problem problem =
      problem_of({0, 0, 0}, {180, 0, 0}, {box(89, -20, 91, 1)}, {-20, 200, -40, 40});
  expect_tight(run(problem), 0.01);
}

// A rear overhang below half the width: with its rear to a wall the axle is nearer than any side.
TEST(AnytimeBound, LetsTheAxleAsNearAsAShortRearOverhangDoes) {
  const Vehicle van{.wheelbase = 2,
                    .front_overhang = 0.5,
                    .rear_overhang = 0.05,
                    .width = 4,
                    .min_turning_radius = 2.5};
  const Problem problem =
      problem_of({0.06, 6, 0}, {0.06, -6, 0}, {box(-9, -1.9, 0, 1.9)}, {-20, 20, -20, 20}, van);
  search::Geodesic geodesic(problem.task(), 1e3);
  while (geodesic.step()) {
  }
  EXPECT_NEAR(geodesic.bound(), 12, 1e-9);  // straight past the wall
}

// The rear axle is at the end of the body: the disc that is led around the wall goes before it.
TEST(AnytimeBound, SeesObstaclesWithoutARearOverhang) {
  Vehicle truck;
  truck.rear_overhang = 0.0;
  const Problem problem =
      problem_of({0, 0, 0}, {60, 0, 0}, {box(29, -40, 31, 20)}, {-200, 200, -200, 200}, truck);
  const PlanResult result = run(problem);
  expect_tight(result, 0.1);
  EXPECT_GT(result.lower_bound, 1.1 * 60);
}

// Whichever disc is led around the obstacles: no path that a planner finds is shorter.
TEST(AnytimeBound, IsBelowEveryPathOfVehiclesWithAnyOverhang) {
  for_each_case(41, 150, [](Rng& rng) {
    Vehicle vehicle;
    vehicle.rear_overhang = chance(0.3, rng) ? 0 : uniform(0, 2, rng);
    vehicle.width = uniform(1, 4, rng);
    std::vector<Polygon> boxes;
    for (int i = 0; i < 4; ++i) {
      const double x = uniform(8, 30, rng);
      const double y = uniform(-20, 10, rng);
      boxes.push_back(box(x, y, x + uniform(0.1, 6, rng), y + uniform(1, 25, rng)));
    }
    const Problem problem =
        problem_of({0, 0, uniform(-3, 3, rng)}, {45, uniform(-15, 15, rng), uniform(-3, 3, rng)},
                   boxes, {-60, 100, -60, 60}, vehicle);
    PlanOptions options{.cost = shortest_style};
    options.budget.max_iterations = 3000;
    const PlanResult result = plan(problem, options);
    ASSERT_NE(result.status, PlanStatus::rejected) << result.reason;
    if (!result.path) return;
    search::Geodesic geodesic(problem.task(), result.cost * 1.5);
    while (geodesic.step()) {
    }
    ASSERT_LE(geodesic.bound(), result.cost * (1 + 1e-9)) << as_code(boxes);
  });
}

// Forward is free of charge, reverse is not: open ground knows the price of both ways.
TEST(AnytimeBound, IsTheCostOfTheOnlyWayWithPrices) {
  const PlanResult ahead =
      run(problem_of({0, 0, 0}, {40, 0, 0}, {}), {.reverse_weight = 2, .gear_change_cost = 5});
  EXPECT_NEAR(ahead.lower_bound.value_or(0.0), 40, 1e-4);  // heading aside, the line may be shorter
  const PlanResult behind = run(problem_of({0, 0, 0}, {-10, 0, 0}, {}), {.reverse_weight = 1.5});
  expect_tight(behind, 0.4);
}

// ---- Poses that are a little off ----

using search::CostRule;

constexpr CostRule bound_rules[] = {{1, 2, 20, 0},  {1, 2, 5, 0}, {1, 1, 0.1, 0},
                                    {1, 1.5, 0, 0}, {1, 3, 5, 1}, {2, 1, 5, -1}};

/// As far away as the judge allows, or nearer.
Pose beside(const Pose& pose, Rng& rng) {
  const double angle = uniform(-4, 4, rng);
  const double by = rng() % 2 == 0 ? 1e-6 : uniform(0, 1e-6, rng);
  const double turn = rng() % 2 == 0 ? 1e-6 : uniform(0, 1e-6, rng);
  return {pose.x + by * std::cos(angle), pose.y + by * std::sin(angle),
          pose.heading + (rng() % 2 == 0 ? turn : -turn)};
}

/// Forward or in reverse, or both: a few arcs and lines, many of them quarter turns or tiny.
Piece random_drive(Rng& rng) {
  Piece piece;
  const auto count = 1 + rng() % 3;
  const double gear = rng() % 2 == 0 ? 1 : -1;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double curvature = (static_cast<double>(rng() % 3) - 1) / default_radius;
    double size = uniform(0, 5 * default_radius, rng);
    if (rng() % 4 == 0) size = default_radius * 1.5707963267948966;
    if (rng() % 4 == 0) size = std::exp2(uniform(-30, 0, rng));
    const double turned = rng() % 8 == 0 ? -gear : gear;
    piece.segments[piece.count++] = {curvature, turned * size};
    piece.length += size;
  }
  return piece;
}

// Whatever is driven from near the start to near the goal costs no less.
TEST(AnytimeBound, HoldsForEveryPathThatTheJudgeAccepts) {
  for_each_case(1, 1000, [](Rng& rng) {
    for (int i = 0; i < 100; ++i) {
      const Pose from = uniform_pose({-100, 100, -100, 100}, rng);
      const Piece drive = random_drive(rng);
      const Problem problem =
          problem_of(beside(from, rng), beside(search::end_of(from, drive), rng), {});
      const CostRule& rule = bound_rules[rng() % std::size(bound_rules)];
      search::Driven driven = rule.initial_gear;
      const double cost = drive_cost(rule, drive.view(), driven);
      EXPECT_LE(bound_of(problem, rule), cost)
          << as_code(drive.view()) << " from " << as_code(problem.start());
    }
  });
}

// What the tolerance takes from it is next to nothing where the length does not jump.
TEST(AnytimeBound, IsCloseBelowTheLeastOfForwardReverseAndOneChange) {
  for_each_case(2, 100, [](Rng& rng) {
    for (int i = 0; i < 100; ++i) {
      const Pose from = uniform_pose({-50, 50, -50, 50}, rng);
      const Pose to = uniform_pose({-50, 50, -50, 50}, rng);
      const Problem problem = problem_of(from, to, {});
      const CostRule& rule = bound_rules[rng() % 4];
      const double bound = bound_of(problem, rule);
      const double leeway = search::open_ground(problem.task(), rule).leeway;
      const double forward = dubins_length(from, to, default_radius);
      const double reverse = rule.reverse_weight * dubins_length(to, from, default_radius);
      const double one_change =
          reeds_shepp_length(from, to, default_radius) + rule.gear_change_cost;
      EXPECT_NEAR(bound, std::min({forward, reverse, one_change}), 0.02)
          << as_code(from) << " to " << as_code(to);
      EXPECT_LT(leeway, 0.02);
    }
  });
}

// Where an arc vanishes the Dubins length jumps up; the bound does not.
TEST(AnytimeBound, DoesNotJumpWhereAnArcVanishes) {
  for (const double off : {-1e-7, 0.0, 1e-7}) {
    for (const Pose& goal : {Pose{7 + off, 7, 1.570796}, Pose{7, 7 + off, 1.570797}}) {
      const Problem problem = problem_of({}, goal, {});
      EXPECT_NEAR(bound_of(problem, bound_rules[0]), 10.9956, 1e-3);
    }
  }
  const Pose lane = end_pose({{}, {{1 / default_radius, 5}, {-1 / default_radius, 5}}});
  for (const double off : {-1e-7, 0.0, 1e-7}) {
    const Problem problem = problem_of({}, {lane.x + off, lane.y, lane.heading}, {});
    EXPECT_NEAR(bound_of(problem, bound_rules[0]), 10, 0.02);
  }
}

// The way around holds for each kind of path, and a change of gear comes on top of it.
TEST(AnytimeBound, PutsOpenGroundAndTheWayAroundTogether) {
  const search::OpenGround ground{.forward = 50, .reverse = 22, .shortest = 10};
  search::CostRule rule{.reverse_weight = 2, .gear_change_cost = 5};
  EXPECT_DOUBLE_EQ(cost_lower_bound(ground, rule, 0), 15);
  EXPECT_DOUBLE_EQ(cost_lower_bound(ground, rule, 20), 25);
  EXPECT_DOUBLE_EQ(cost_lower_bound(ground, rule, 48), 50);
  EXPECT_DOUBLE_EQ(cost_lower_bound(ground, rule, 60), 60);
  rule.initial_gear = 1;
  rule.gear_change_cost = 100;
  EXPECT_DOUBLE_EQ(cost_lower_bound(ground, rule, 20), 50);
  rule.initial_gear = -1;
  EXPECT_DOUBLE_EQ(cost_lower_bound(ground, rule, 24), 48);
  EXPECT_DOUBLE_EQ(cost_lower_bound(ground, {}, 20), 20);
}

// A planner that claims too much is told so; its claim is not made to fit.
TEST(AnytimeBound, AboveTheCostIsAFaultThatIsReported) {
  Planner boaster{.name = "boaster", .summary = "proves too much"};
  boaster.function = [](const Task&, const PlanOptions&) {
    PlannerAnswer answer{.status = PlanStatus::solved};
    answer.segments = {{0, 40}};
    answer.lower_bound = 40.001;
    return answer;
  };
  const PlanResult result = plan(problem_of({0, 0, 0}, {40, 0, 0}, {}), boaster);
  EXPECT_EQ(result.status, PlanStatus::rejected);
  EXPECT_NE(result.reason.find("bound"), std::string::npos) << result.reason;
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <numbers>

#include "../support/problems.h"
#include "planners/anytime/shares.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using std::numbers::pi;

PlanResult run(const Problem& problem, const PlanOptions& options) {
  PlanResult result = plan(problem, planner_named("anytime"), options);
  EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
  return result;
}

PlanOptions iterations(std::int64_t count) {
  PlanOptions options{.cost = shortest_style};
  options.budget.max_iterations = count;
  return options;
}

// To turn around in a road 12 m wide takes several gear changes.
Problem narrow_road() {
  return problem_of({0, -2, 0}, {0, 2, pi}, {box(-60, 6, 60, 8), box(-60, -8, 60, -6)});
}

TEST(Anytime, IsTheDefault) { EXPECT_EQ(default_planner().name, "anytime"); }

TEST(Anytime, OnOpenGroundTheShortestPathIsProvenAtOnce) {
  const Problem problem = problem_of({0, 0, 0}, {20, 30, 2}, {});
  const PlanResult result = run(problem, iterations(1000));
  const double shortest = reeds_shepp_length(problem.start(), problem.goal(), 7.0);
  EXPECT_NEAR(result.cost, shortest, 1e-9);
  EXPECT_NEAR(result.lower_bound.value_or(0.0), shortest, 1e-9);
  EXPECT_EQ(result.iterations, 0);
}

TEST(Anytime, TheBoundSeesTheObstacles) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, {box(14, -20, 16, 20)});
  const PlanResult result = run(problem, iterations(20000));
  ASSERT_TRUE(result.path);
  EXPECT_GT(result.lower_bound, 50.0);  // 2 * hypot(14, 20) = 48.8 for a point
  EXPECT_LE(result.lower_bound, result.cost);
}

TEST(Anytime, AnyNumberOfThreadsGivesTheSameAnswer) {
  PlanOptions options = iterations(6000);
  const PlanResult one = run(narrow_road(), options);
  for (const int threads : {2, 3, 16}) {
    options.budget.threads = threads;
    const PlanResult many = run(narrow_road(), options);
    EXPECT_EQ(many.path, one.path) << threads;
    EXPECT_EQ(many.iterations, one.iterations) << threads;
    EXPECT_EQ(many.lower_bound, one.lower_bound) << threads;
    ASSERT_EQ(many.anytime.size(), one.anytime.size()) << threads;
    for (std::size_t i = 0; i < one.anytime.size(); ++i) {
      EXPECT_EQ(many.anytime[i].iteration, one.anytime[i].iteration) << threads;
      EXPECT_EQ(many.anytime[i].cost, one.anytime[i].cost) << threads;
    }
  }
}

// However short the first rounds are: the least share is an iteration in some of them only.
TEST(Anytime, WorkersGetTheirSharesWithBending) {
  std::int64_t of_one = 0, of_many = 0;
  for (std::int64_t round = 0; round < 300; ++round) {
    const std::int64_t many = anytime::growing_share(96, round);
    EXPECT_GE(many, round == 0 ? 24 : anytime::growing_share(96, round - 1));
    of_one += anytime::growing_share(1, round);
    of_many += many;
    EXPECT_LE(96 * of_one, of_many);
    EXPECT_LT(of_many, 96 * (of_one + 1));
  }
}

// Every path that only turns left is as long as the shortest: three gear changes do, seldom four.
TEST(Anytime, OfTheShortestPathsItTakesOneWithFewGearChanges) {
  PlanOptions options = iterations(6000);
  for (options.budget.seed = 1; options.budget.seed <= 10; ++options.budget.seed) {
    const PlanResult result = run(narrow_road(), options);
    EXPECT_NEAR(result.cost, 7 * pi, 1e-6) << options.budget.seed;
    EXPECT_LE(gear_changes(result.path->segments), 4) << options.budget.seed;
  }
}

TEST(Anytime, EndsAsSoonAsItIsProvenToBeNearTheOptimum) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, {box(14, -20, 16, 20)});
  PlanOptions options = iterations(20000);
  const PlanResult whole = run(problem, options);
  EXPECT_EQ(whole.iterations, 20000);
  options.budget.target_gap = 0.2;
  const PlanResult near = run(problem, options);
  ASSERT_TRUE(near.path);
  EXPECT_LE(near.cost, 1.2 * near.lower_bound.value());
  EXPECT_LT(near.iterations, 3000);
  options.budget.threads = 3;
  const PlanResult shared = run(problem, options);
  EXPECT_EQ(shared.path, near.path);
  EXPECT_EQ(shared.iterations, near.iterations);
  options.budget.target_gap = 0.0;  // is not proven here
  EXPECT_EQ(run(problem, options).iterations, 20000);
}

// Around a corner shortening the first route is enough: no other way is looked for.
TEST(Anytime, ProvesAnEasyGapWithFewTrials) {
  const Problem problem = problem_of({0, 0, 0}, {30, 30, pi / 2}, {box(-5, 12, 15, 60)});
  PlanOptions options = iterations(20000);
  options.budget.target_gap = 0.05;
  for (options.budget.seed = 1; options.budget.seed <= 10; ++options.budget.seed) {
    const PlanResult result = run(problem, options);
    EXPECT_LE(result.cost, 1.05 * result.lower_bound.value());
    EXPECT_LT(result.iterations, 130) << options.budget.seed;
  }
}

// Parallel to a kerb, 0.3 m from the lorries before and behind.
TEST(Anytime, LeavesAVeryTightSlotAndGetsIntoIt) {
  const std::vector<Polygon> street = {box(-12, -1.5, -1.9, 1.5), box(6.2, -1.5, 16, 1.5),
                                       box(-12, -3, 16, -2)};
  const Pose slot{0, 0, 0};
  const Pose lane{2, 8, 0};
  const PlanResult out = run(problem_of(slot, lane, street), iterations(20000));
  ASSERT_TRUE(out.path);
  EXPECT_GE(gear_changes(out.path->segments), 20);
  EXPECT_TRUE(run(problem_of(lane, slot, street), iterations(20000)).path);
}

TEST(Anytime, ReversingCostsItsWeight) {
  const Problem behind = problem_of({0, 0, 0}, {-10, 0, 0}, {});
  PlanOptions options = iterations(3000);
  options.cost.reverse_weight = 1.5;
  EXPECT_NEAR(run(behind, options).cost, 15.0, 1e-9);
}

// Turning around forward takes more than 40 m, so a weight of 100 makes it worth while.
TEST(Anytime, AHighWeightMakesItDriveForward) {
  const Problem behind = problem_of({0, 0, 0}, {-10, 0, 0}, {});
  PlanOptions options = iterations(20000);
  options.cost.reverse_weight = 100.0;
  const PlanResult result = run(behind, options);
  const PathCheck check = check_path(behind, *result.path, {});
  EXPECT_LT(check.reverse_length, 0.05);
  EXPECT_LE(result.lower_bound, result.cost);
}

TEST(Anytime, TheGearBeforeTheStartIsCharged) {
  const Problem ahead = problem_of({0, 0, 0}, {10, 0, 0}, {});
  PlanOptions options = iterations(100);
  options.cost.gear_change_cost = 3.0;
  EXPECT_NEAR(run(ahead, options).cost, 10.0, 1e-9);
  options.cost.initial_gear = InitialGear::forward;
  EXPECT_NEAR(run(ahead, options).cost, 10.0, 1e-9);
  options.cost.initial_gear = InitialGear::reverse;
  EXPECT_NEAR(run(ahead, options).cost, 13.0, 1e-9);
}

TEST(Anytime, DearGearChangesBecomeFew) {
  PlanOptions options = iterations(20000);
  const PlanResult cheap = run(narrow_road(), options);
  options.cost.gear_change_cost = 20.0;
  const PlanResult dear = run(narrow_road(), options);
  const double cheap_length = length(cheap.path->segments);
  const int cheap_changes = gear_changes(cheap.path->segments);
  const double dear_length = length(dear.path->segments);
  const int dear_changes = gear_changes(dear.path->segments);
  EXPECT_NEAR(cheap.cost, cheap_length, 1e-9);
  EXPECT_NEAR(dear.cost, dear_length + 20.0 * dear_changes, 1e-9);
  EXPECT_LE(dear.cost, cheap_length + 20.0 * cheap_changes);
  EXPECT_LE(dear_changes, cheap_changes);
}

// A small truck faces away from two gates in long walls. To drive forward it has to go around both;
// one stroke back turns it.
Problem gates() {
  const Vehicle small{4.4, 1.1, 1.6, 2.5, 7.0};
  return problem_of(
      {-18, 0, pi}, {45, 0, 0},
      {box(0, -30, 1, -2.2), box(0, 2.2, 1, 30), box(20, -30, 21, 4), box(20, 8.4, 21, 30)},
      wide_bounds, small);
}

TEST(Anytime, WithPricesItLooksForAnotherKindOfPath) {
  PlanOptions options = iterations(5000);
  options.cost = by_length_and(2, 5);
  for (options.budget.seed = 1; options.budget.seed <= 5; ++options.budget.seed) {
    const PlanResult result = run(gates(), options);
    EXPECT_LT(result.cost, 90.0) << options.budget.seed;  // 108 without a change
    EXPECT_EQ(gear_changes(result.path->segments), 1) << options.budget.seed;
  }
}

TEST(Anytime, APriceDoesNotMakeTheSearchWorse) {
  PlanOptions options = iterations(5000);
  for (options.budget.seed = 1; options.budget.seed <= 5; ++options.budget.seed) {
    options.cost = shortest_style;
    const PlanResult shortest = run(gates(), options);
    options.cost = by_length_and(1, 1);
    const PlanResult priced = run(gates(), options);
    const double price = shortest.cost + gear_changes(shortest.path->segments);
    EXPECT_LE(priced.cost, 1.02 * price) << options.budget.seed;
  }
}

TEST(Anytime, WithPricesAnyNumberOfThreadsGivesTheSameAnswer) {
  PlanOptions options = iterations(6000);
  options.cost = by_length_and(2, 5);
  const PlanResult one = run(gates(), options);
  for (const int threads : {2, 6, 16}) {
    options.budget.threads = threads;
    const PlanResult many = run(gates(), options);
    EXPECT_EQ(many.path, one.path) << threads;
    EXPECT_EQ(many.iterations, one.iterations) << threads;
    EXPECT_EQ(many.lower_bound, one.lower_bound) << threads;
  }
}

// A yard where most of twelve searches find but one kind of way, 30 % dearer than the best.
TEST(Anytime, ASurveyFindsTheKindOfWayThatSearchesMiss) {
  const Vehicle truck{.wheelbase = 4,
                      .front_overhang = 1,
                      .rear_overhang = 1,
                      .width = 2.2,
                      .min_turning_radius = 6};
  const Problem problem =
      problem_of({-10.93, 15.6, 2.686}, {11.81, -27.01, -0.523},
                 {box(11.74, -10.56, 17.23, -5.68), box(-38.97, -1.97, -30.87, 4.66),
                  box(-30.08, -17.35, 6.41, -16.35), box(-13.14, -24.93, -12.14, 8.12),
                  box(-17.82, -18.12, 11.95, -17.12), box(12.96, -13.59, 38.6, -12.59),
                  box(-10.69, 1.49, 21.98, 2.49), box(-23.81, -30.39, -19.31, -25.53),
                  box(-18.97, -25.62, -17.97, 10), box(-45, -45, 45, -44), box(-45, -44, -44, 44),
                  box(44, -44, 45, 44)},
                 {-45, 45, -45, 45}, truck);
  PlanOptions options{.cost = driver_style};
  options.steering = Steering::continuous_between_stops;
  options.budget.max_iterations = 15'000;
  const PlanResult result = run(problem, options);
  ASSERT_TRUE(result.path);
  EXPECT_LT(result.cost, 112);
}

// ---- small vehicles ----

/// Everything smaller by the same factor.
Problem shrunk(Scenario scenario, double factor) {
  Vehicle& v = scenario.vehicle;
  for (double* const length :
       {&v.wheelbase, &v.front_overhang, &v.rear_overhang, &v.width, &v.min_turning_radius}) {
    *length *= factor;
  }
  v.limits.max_curvature_rate = max_curvature_rate({}) / (factor * factor);
  const auto shrink = [&](double& x, double& y) { x *= factor, y *= factor; };
  shrink(scenario.start.x, scenario.start.y);
  shrink(scenario.goal.x, scenario.goal.y);
  shrink(scenario.bounds.x_min, scenario.bounds.x_max);
  shrink(scenario.bounds.y_min, scenario.bounds.y_max);
  for (Polygon& polygon : scenario.obstacles) {
    for (Point& corner : polygon) shrink(corner.x, corner.y);
  }
  return make_problem(scenario);
}

TEST(Anytime, ASmallRobotInASmallYardDrivesLikeATruckInALargeOne) {
  const Scenario yard{.bounds = {-50, 50, -50, 50},
                      .start = {0, 0, 0},
                      .goal = {0, 12, 0},
                      .obstacles = {box(-20, 5, 15, 7)}};
  PlanOptions options;
  options.budget.max_iterations = 5000;
  const PlanResult large = run(shrunk(yard, 1.0), options);
  const PlanResult small = run(shrunk(yard, 0.125), options);
  ASSERT_TRUE(large.path && small.path);
  EXPECT_NEAR(8 * small.cost, large.cost, 0.01 * large.cost);
  EXPECT_EQ(small.check->gear_changes, large.check->gear_changes);
}

Vehicle robot(double min_turning_radius) {
  return {.wheelbase = 0.6,
          .front_overhang = 0.15,
          .rear_overhang = 0.15,
          .width = 0.62,
          .min_turning_radius = min_turning_radius};
}

TEST(Anytime, ASmallRobotDrivesNoLoopToGetAside) {
  PlanOptions options;
  options.budget.max_iterations = 2000;
  const PlanResult result =
      run(problem_of({0, 0, 0}, {0, 0.1, 0}, {}, {-10, 10, -10, 10}, robot(1.0)), options);
  ASSERT_TRUE(result.path);
  EXPECT_LT(length(result.path->segments), 2.0);  // it was 6.4
}

// Walls are nearer than a truck's metre everywhere in this aisle.
TEST(Anytime, ASmallRobotKeepsAwayFromCornersInANarrowAisle) {
  PlanOptions options;
  options.budget.max_iterations = 10'000;
  const Problem aisle = problem_of({4.55, 1, 1.5707963267948966}, {8, 5.55, 0},
                                   {box(0, 0, 4, 5), box(5.1, 0, 10, 5), box(0, 6.1, 10, 10)},
                                   {0, 10, 0, 10}, robot(0.6));
  const PlanResult result = run(aisle, options);
  ASSERT_TRUE(result.path);
  EXPECT_GT(*result.check->clearance, 0.05);  // it was 4 mm
}

}  // namespace
}  // namespace vandplan

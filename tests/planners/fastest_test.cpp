// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Where the cost is the time: what is planned, what is proven, and what the judge says of it.
#include <gtest/gtest.h>

#include <numbers>

#include "../support/cases.h"
#include "../support/draws.h"
#include "../support/drive_oracle.h"
#include "../support/problems.h"
#include "planners/drive_time.h"
#include "vandplan/input_error.h"
#include "vandplan/motion.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using std::numbers::pi;

PlanOptions by(CostMeasure measure, std::int64_t iterations) {
  PlanOptions options;
  options.cost.measure = measure;
  options.budget.max_iterations = iterations;
  return options;
}

PlanResult fastest(const Problem& problem, std::int64_t iterations = 2000) {
  return plan(problem, by(CostMeasure::time, iterations));
}

Problem narrow_road() {
  return problem_of({0, -2, 0}, {0, 2, pi}, {box(-60, 6, 60, 8), box(-60, -8, 60, -6)});
}

Path random_drive(Rng& rng, double sharpest, double tightest) {
  Path path;
  double curvature = 0;
  while (path.segments.size() < 12) {
    const double gear = chance(0.2, rng) ? -1 : 1;
    const double length = uniform(0.05, 8, rng);
    const double next = uniform(-tightest, tightest, rng);
    const bool jumps = chance(0.3, rng);
    const double needed = std::max(length, std::abs(next - curvature) / sharpest);
    path.segments.push_back(jumps ? Segment{next, gear * length}
                                  : Segment{curvature, gear * needed, (next - curvature) / needed});
    curvature = next;
  }
  return path;
}

TEST(Fastest, CostsWhatItsDriveTakes) {
  const Problem problem = narrow_road();
  const PlanResult result = fastest(problem);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_EQ(result.cost, speed_profile(*result.path, problem.vehicle()).duration);
  EXPECT_EQ(result.anytime.back().cost, result.cost);
  EXPECT_GT(result.lower_bound, 0.0);
  EXPECT_LE(result.lower_bound, result.cost);
}

TEST(Fastest, TakesLessTimeThanADriver) {
  const Problem problem = narrow_road();
  const PlanResult driver = plan(problem, by(CostMeasure::prices, 16000));
  ASSERT_TRUE(driver.path);
  const double usual = speed_profile(*driver.path, problem.vehicle()).duration;
  EXPECT_LT(fastest(problem, 16000).cost, 0.9 * usual);
}

TEST(Fastest, TraceFallsFromFirstToLast) {
  const PlanResult result = fastest(narrow_road());
  ASSERT_GT(result.anytime.size(), 2U);
  for (std::size_t i = 1; i < result.anytime.size(); ++i) {
    EXPECT_LT(result.anytime[i].cost, result.anytime[i - 1].cost);
    EXPECT_GE(result.anytime[i].iteration, result.anytime[i - 1].iteration);
  }
}

TEST(Fastest, StraightOnIsProven) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, {});
  const PlanResult result = fastest(problem);
  // 2.5 m/s, gained and lost at 1 m/s^2: 6.25 m and 5 s, and the rest at full speed.
  EXPECT_NEAR(result.cost, 5 + (30 - 6.25) / 2.5, 1e-9);
  EXPECT_NEAR(result.lower_bound.value_or(0.0), result.cost, 0.02 * result.cost);
}

TEST(Fastest, EndsWhenItIsGoodEnough) {
  PlanOptions options = by(CostMeasure::time, 100000);
  options.budget.target_gap = 100.0;
  EXPECT_LT(plan(narrow_road(), options).iterations, 5000);
}

TEST(Fastest, IsTheSameWithAnyNumberOfThreads) {
  PlanOptions options = by(CostMeasure::time, 2000);
  const PlanResult one = plan(narrow_road(), options);
  options.budget.threads = 5;
  EXPECT_EQ(plan(narrow_road(), options).path, one.path);
}

TEST(Fastest, KeepsEverySteering) {
  for (const Steering steering : {Steering::reeds_shepp, Steering::continuous}) {
    PlanOptions options = by(CostMeasure::time, 1000);
    options.steering = steering;
    const PlanResult result = plan(narrow_road(), options);
    EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
  }
}

TEST(Fastest, KnowsNoPrices) {
  PlanOptions options = by(CostMeasure::time, 10);
  options.cost.gear_change_cost = 3;
  try {
    (void)plan(narrow_road(), options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "gear_change_cost");
  }
}

TEST(Fastest, IsForThoseWhoHonourIt) {
  const PlanOptions options = by(CostMeasure::time, 10);
  EXPECT_THROW((void)plan(narrow_road(), planner_named("rrt-connect"), options), InputError);
}

TEST(Fastest, NoDriveBeatsTheLeastTime) {
  Rng rng(1);
  for (int i = 0; i < cases(2000); ++i) {
    Vehicle vehicle;
    vehicle.limits.max_speed = {any_size(0.3, 30, rng), any_size(0.3, 30, rng)};
    vehicle.limits.max_acceleration = any_size(0.1, 10, rng);
    if (chance(0.5, rng)) vehicle.limits.max_braking = any_size(0.1, 10, rng);
    const Path path{{}, {{0, any_size(1e-3, 1e3, rng) * (chance(0.5, rng) ? 1 : -1)}}};
    const double time = speed_profile(path, vehicle).duration;
    const AllowedGears own =
        path.segments[0].length > 0 ? AllowedGears::forward : AllowedGears::reverse;
    const search::CostRule in_both, in_one = search::restricted({}, own);
    const double least = planning::drive_time_lower_bound(vehicle, in_both, length(path));
    const double least_in_one = planning::drive_time_lower_bound(vehicle, in_one, length(path));
    EXPECT_LE(least, least_in_one);
    EXPECT_LE(least_in_one, time * (1 + 1e-12));
    vehicle.limits.max_speed = {10, 10};
    EXPECT_NEAR(planning::drive_time_lower_bound(vehicle, in_both, length(path)),
                speed_profile(path, vehicle).duration, 1e-9 * time + 1e-9 * length(path));
  }
}

// The judge works times out by himself: what is true he believes, what is 2 in 1000 off he does
// not.
TEST(Fastest, JudgeKnowsTheTime) {
  Rng rng(2);
  for (int i = 0; i < cases(100); ++i) {
    Vehicle vehicle{.min_turning_radius = 5};
    vehicle.limits.max_steering_rate = any_size(0.1, 2, rng);
    vehicle.limits.max_lateral_acceleration = any_size(0.2, 3, rng);
    const Path path = random_drive(rng, 0.2, 0.2);
    const Problem problem =
        make_problem(world_of({.bounds = wide_bounds}), vehicle, path.start, end_pose(path));
    CostOptions rule = shortest_style;
    rule.measure = CostMeasure::time;
    const double time = speed_profile(path, vehicle).duration;
    const auto said = [&](double cost) {
      return check_path(problem, path, {.cost = StatedCost{.cost = cost, .rule = rule}});
    };
    EXPECT_TRUE(said(time).valid) << said(time).reason;
    EXPECT_FALSE(said(1.002 * time).valid);
    EXPECT_FALSE(said(0.998 * time).valid);
    EXPECT_NEAR(time, dense_duration(path, vehicle), 2e-4 * time);
  }
}

TEST(Fastest, JudgeKnowsTheLeastTimeWithALimitOfJerk) {
  Vehicle vehicle;
  vehicle.limits.max_jerk = 1.0;
  const Problem problem = problem_of({0, 0, 0}, {20, 0, 0}, {}, wide_bounds, vehicle);
  const Path path{{}, {{0, 20}}};
  CostOptions rule = shortest_style;
  rule.measure = CostMeasure::time;
  const auto said = [&](double cost) {
    return check_path(problem, path, {.cost = StatedCost{.cost = cost, .rule = rule}}).valid;
  };
  EXPECT_TRUE(said(speed_profile(path, vehicle).duration));
  vehicle.limits.max_jerk.reset();
  EXPECT_FALSE(said(0.99 * speed_profile(path, vehicle).duration));
  EXPECT_EQ(fastest(problem).status, PlanStatus::solved);
}

}  // namespace
}  // namespace vandplan

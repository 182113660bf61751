// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What may be driven in one gear alone is planned in that gear, by whoever honours it, whatever
// else is asked for; and what is proven of it is true.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "planners/pricing.h"
#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using std::numbers::pi;

enum class Bodies { truck, rig };
enum class Minimised { length, driver, time };

PlanOptions limited(AllowedGears gears, std::int64_t iterations = is_sanitized ? 100 : 1000) {
  PlanOptions options;
  options.budget.max_iterations = iterations;
  options.cost.gears = gears;
  return options;
}

/// Whether all metres are driven in that gear.
bool is_in(AllowedGears gears, const std::vector<Segment>& segments) {
  return std::ranges::all_of(segments, [&](const Segment& s) {
    return gears == AllowedGears::forward ? s.length >= 0.0 : s.length <= 0.0;
  });
}

/// Points the other way: what was driven forward is driven in reverse.
Pose turned(const Pose& pose) { return {pose.x, pose.y, wrap_angle(pose.heading + pi)}; }

/// Around a wall in one gear, past a car that crosses behind it if there are movers.
Problem around_a_wall(Bodies who, AllowedGears gears, bool has_movers) {
  Scenario scenario{.name = "wall",
                    .vehicle = who == Bodies::rig ? semitrailer() : Vehicle{},
                    .bounds = {-60, 110, -60, 60},
                    .start = {0, 0, 0},
                    .goal = {50, 4, 0},
                    .obstacles = {box(24, -6, 26, 3)}};
  if (gears == AllowedGears::reverse) {
    scenario.start = turned(scenario.start);
    scenario.goal = turned(scenario.goal);
  }
  if (has_movers) {
    scenario.moving = {{.outline = box(-2, -1, 2, 1),
                        .trajectory = {{0, {40, 30, -pi / 2}}, {12, {40, -30, -pi / 2}}},
                        .after = Afterwards::leaves}};
  }
  return make_problem(scenario);
}

using GearsCombination = std::tuple<Bodies, AllowedGears, Steering, Minimised, bool, double>;

std::string name_of_gears(const testing::TestParamInfo<GearsCombination>& info) {
  const auto& [who, gears, steering, cost, has_movers, margin] = info.param;
  constexpr const char* steerings[] = {"Arcs", "BetweenStops", "Continuous"};
  constexpr const char* costs[] = {"Length", "Driver", "Time"};
  std::string name = who == Bodies::rig ? "Rig" : "Truck";
  name += gears == AllowedGears::forward ? "Forward" : "Reverse";
  name += steerings[static_cast<int>(steering)];
  name += costs[static_cast<int>(cost)];
  if (has_movers) name += "Movers";
  if (margin > 0) name += "Margin";
  return name;
}

class InOneGear : public testing::TestWithParam<GearsCombination> {};

TEST_P(InOneGear, EverythingIsPlanned) {
  const auto& [who, gears, steering, cost, has_movers, margin] = GetParam();
  const Problem problem = around_a_wall(who, gears, has_movers);
  PlanOptions options = limited(gears);
  const bool backs_up = who == Bodies::rig && gears == AllowedGears::reverse;
  if (backs_up && !is_sanitized) options.budget.max_iterations = 15'000;
  if (cost == Minimised::length) options.style = Style::shortest;
  if (cost == Minimised::time) options.cost.measure = CostMeasure::time;
  options.steering = steering;
  options.clearance.margin = margin;
  const PlanResult result = plan(problem, options);
  ASSERT_NE(result.status, PlanStatus::rejected) << result.reason;
  if (is_sanitized && !result.path) return;  // in so few iterations
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(is_in(gears, result.path->segments)) << as_code(*result.path);
  PathClaims claims{.clearance = options.clearance, .steering = steering, .gears = gears};
  claims.cost = StatedCost{.cost = result.cost, .rule = result.rule};
  const PathCheck check = check_path(problem, *result.path, claims);
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_LE(result.lower_bound, result.cost);
  EXPECT_EQ(result.rule.gears, gears);
}

INSTANTIATE_TEST_SUITE_P(
    OfTheDefaultPlanner, InOneGear,
    testing::Combine(testing::Values(Bodies::truck, Bodies::rig),
                     testing::Values(AllowedGears::forward, AllowedGears::reverse),
                     testing::Values(Steering::reeds_shepp, Steering::continuous_between_stops,
                                     Steering::continuous),
                     testing::Values(Minimised::length, Minimised::driver, Minimised::time),
                     testing::Bool(), testing::Values(0.0, 0.3)),
    name_of_gears);

class HonoursGears : public testing::TestWithParam<AllowedGears> {};

TEST_P(HonoursGears, EveryPlannerThatSaysSo) {
  const AllowedGears gears = GetParam();
  const Problem problem = around_a_wall(Bodies::truck, gears, false);
  for (const Planner& planner : planners()) {
    PlanOptions options = limited(gears, is_sanitized ? 50 : 1000);
    if (!planner.can(Capability::gears)) {
      EXPECT_THROW((void)plan(problem, planner, options), InputError) << planner.name;
      continue;
    }
    if (honours(planner, "region")) options.planner.set("region", "scene");
    const PlanResult result = plan(problem, planner, options);
    EXPECT_NE(result.status, PlanStatus::rejected) << planner.name << ": " << result.reason;
    EXPECT_TRUE(result.path || is_sanitized) << planner.name << ": " << result.reason;
    if (result.path) {
      EXPECT_TRUE(is_in(gears, result.path->segments)) << planner.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OneByOne, HonoursGears,
                         testing::Values(AllowedGears::forward, AllowedGears::reverse),
                         [](const auto& one) { return std::string(name_of(one.param)); });

// On open ground the path of Dubins is the answer, and known to be the best one.
TEST(OneGear, OnOpenGroundItsShortestPathIsThatOfDubins) {
  for_each_case(1, 100, [](Rng& rng) {
    const Vehicle vehicle;
    const double radius = vehicle.min_turning_radius;
    const Bounds field{-3 * radius, 3 * radius, -3 * radius, 3 * radius};
    const Pose start = uniform_pose(field, rng);
    const Pose goal = uniform_pose(field, rng);
    const Problem problem = problem_of(start, goal, {});
    for (const AllowedGears gears : {AllowedGears::forward, AllowedGears::reverse}) {
      PlanOptions options = limited(gears, 100);
      options.style = Style::shortest;
      const PlanResult result = plan(problem, options);
      ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
      const bool is_forward = gears == AllowedGears::forward;
      const double least = is_forward ? dubins_length(start, goal, radius)
                                      : dubins_length(turned(start), turned(goal), radius);
      EXPECT_NEAR(result.cost, least, 1e-4 * radius) << as_code(start) << " " << as_code(goal);
      EXPECT_GE(result.lower_bound, least - 1e-3 * radius);
    }
  });
}

// Whoever may not reverse out of a dead end has no way, and whoever backs in needs one.
TEST(OneGear, ASlotIsLeftInTheGearThatLeadsOut) {
  const std::vector<Polygon> slot = {box(-8, -3, 10, -2), box(-8, 2, 10, 3), box(9, -3, 10, 3)};
  const Problem problem = problem_of({0, 0, 0}, {-30, 0, 0}, slot);
  EXPECT_EQ(plan(problem, limited(AllowedGears::reverse)).status, PlanStatus::solved);
  EXPECT_NE(plan(problem, limited(AllowedGears::forward)).status, PlanStatus::solved);
}

// A place beside the start: in both gears a short shunt, in one of them a loop. What is proven
// knows that, among obstacles, too.
TEST(OneGear, TheBoundKnowsThatALoopIsNeeded) {
  const std::vector<Polygon> pillar = {box(-1, 9, 1, 11)};
  const Problem problem = problem_of({0, 0, 0}, {0, 4, 0}, pillar);
  const double radius = problem.vehicle().min_turning_radius;
  PlanOptions options = limited(AllowedGears::forward, 20000);
  options.style = Style::shortest;
  const PlanResult result = plan(problem, options);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_GT(result.cost, dubins_length(problem.start(), problem.goal(), radius) - 1e-6);
  EXPECT_GT(result.lower_bound, 3 * reeds_shepp_length(problem.start(), problem.goal(), radius));
}

// Straight back the shortest word is driven in reverse: who may not has none up to that length.
TEST(OneGear, SteeringAnswersInTheGearOrNotAtAll) {
  const Problem problem = problem_of({0, 0, 0}, {-5, 0, 0}, {});
  const Task& task = problem.task();
  search::Connector connector(task, search::restricted({}, AllowedGears::forward));
  EXPECT_FALSE(connector.steer(task.start, task.goal, {}, 6.0));
  const std::optional<Piece> loop = connector.steer(task.start, task.goal);
  ASSERT_TRUE(loop);
  EXPECT_TRUE(search::may_drive(connector.rule(), loop->view()));
}

TEST(OneGear, TheTimeInAnotherGearIsInfinite) {
  const Problem problem = problem_of({0, 0, 0}, {-5, 0, 0}, {});
  const std::vector<Segment> back = {{0, -5}};
  CostOptions cost{.measure = CostMeasure::time};
  EXPECT_GT(planning::Pricing(problem.task(), cost).cost(back, 0.0), 1.0);
  EXPECT_LT(planning::Pricing(problem.task(), cost).cost(back, 0.0), 100.0);
  cost.gears = AllowedGears::forward;
  EXPECT_TRUE(std::isinf(planning::Pricing(problem.task(), cost).cost(back, 0.0)));
}

// ---- bounds hold for all that the judge accepts: ends may be off by a micrometre ----

// The goal is where the vehicle stands, but for the tolerance: no metre needs to be driven, and so
// no gear to be changed.
TEST(OneGear, WhoStandsAtTheGoalChangesNoGear) {
  for (const Pose& goal : {Pose{0, 0, 5e-7}, Pose{5e-7, 0, 0}, Pose{0, 7e-7, 0}}) {
    const Problem problem = problem_of({0, 0, 0}, goal, {});
    for (const Steering steering : {Steering::reeds_shepp, Steering::continuous}) {
      PlanOptions options = limited(AllowedGears::forward, 100);
      options.cost.initial_gear = InitialGear::reverse;
      options.steering = steering;
      const PlanResult result = plan(problem, options);
      EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
      EXPECT_TRUE(check_path(problem, {{0, 0, 0}, {}}, {.gears = AllowedGears::forward}).valid);
      EXPECT_FALSE(result.lower_bound) << as_code(goal);
    }
  }
}

TEST(OneGear, PlannersOfTheLaboratoryClaimNoMoreThanTheToleranceLeaves) {
  const Problem problem = problem_of({0, 0, 0}, {0, 7e-7, 0}, {});
  for (const Planner& planner : planners()) {
    if (!planner.can(Capability::gears)) continue;
    const PlanResult result = plan(problem, planner, limited(AllowedGears::forward, 300));
    EXPECT_NE(result.status, PlanStatus::rejected) << planner.name << ": " << result.reason;
    EXPECT_FALSE(result.lower_bound) << planner.name;
  }
}

// Along the circle on which it just keeps its hitch angle a trailer's path jumps by a circle where
// the angle at the end is off by the judge's tolerance.
TEST(OneGear, ATrailersBoundKnowsThatItsAngleMayBeOff) {
  Vehicle rig{3.6, 1.4, 0.9, 2.55, 5};
  rig.max_hitch_angle = 1.2;
  rig.trailer = Trailer{9, -0.5, 1, 2.5};
  const Path path{{0, 0, 0}, {{0.10355989441460514, 1}}};
  const Problem problem =
      make_problem(world_of({.bounds = wide_bounds}), rig, path.start,
                   {0.9982135162847174, 0.05173368692252423, 0.10356087441460514}, {},
                   {1.1999999, 1.1999989199999999});
  ASSERT_TRUE(check_path(problem, path, {.gears = AllowedGears::forward}).valid);
  for (const bool in_one_gear : {true, false}) {
    PlanOptions options = limited(AllowedGears::forward, 300);
    options.style = Style::shortest;
    if (!in_one_gear) {
      options = limited(AllowedGears::both, 300);
      options.cost = by_length_and(100, 1000);
    }
    const PlanResult result = plan(problem, options);
    EXPECT_LE(result.lower_bound, 1.0);
  }
}

/// Back and forth, and so no path for somebody who may not change gear.
Path shunting_path() { return {{0, 0, 0}, {{0.1, 6}, {-0.1, -6}, {0.1, 6}, {-0.1, -6}, {0, 40}}}; }

TEST(OneGear, AKnownPathInAnotherGearIsNotTheAnswer) {
  const Path known = shunting_path();
  const Problem problem = problem_of(known.start, end_pose(known), {box(30, -30, 31, -8)});
  const PlanResult result = plan(problem, warm_started(known), limited(AllowedGears::forward));
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(is_in(AllowedGears::forward, result.path->segments));
}

TEST(OneGear, ASmoothedPathIsInThatGearOrNone) {
  const Path given = shunting_path();
  const Problem problem = problem_of(given.start, end_pose(given), {});
  for (const SmoothMethod method : {SmoothMethod::clothoids, SmoothMethod::optimised}) {
    const Smoothed smoothed = smooth(problem, given, method, limited(AllowedGears::forward, 500));
    EXPECT_NE(smoothed.given_fault, "");
    EXPECT_NE(smoothed.result.status, PlanStatus::rejected) << smoothed.result.reason;
    if (!smoothed.result.path) continue;
    EXPECT_TRUE(is_in(AllowedGears::forward, smoothed.result.path->segments));
  }
}

// The answer is the same with any number of threads.
TEST(OneGear, ThreadsShareTheWorkAndNothingElse) {
  const Problem problem = around_a_wall(Bodies::truck, AllowedGears::forward, false);
  PlanOptions options = limited(AllowedGears::forward);
  const PlanResult one = plan(problem, options);
  options.budget.threads = 3;
  EXPECT_EQ(plan(problem, options).path, one.path);
}

// ---- prices of both gears ----

// A vehicle that drives forks first: what costs twice as much is driven as little as may be.
TEST(ForwardWeight, PutsThePathIntoReverse) {
  const Problem problem = problem_of({0, 0, 0}, {0, 30, 0}, {});
  const auto reverse_length = [&](double forward, double reverse) {
    PlanOptions options = limited(AllowedGears::both);
    options.cost.forward_weight = forward;
    options.cost.reverse_weight = reverse;
    const PlanResult result = plan(problem, options);
    EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
    return result.check->reverse_length / result.check->length;
  };
  EXPECT_LT(reverse_length(1, 4), 0.2);
  EXPECT_GT(reverse_length(4, 1), 0.8);
}

TEST(ForwardWeight, ThePathBackIsTheSameInTheOtherGear) {
  const Vehicle vehicle;
  const Problem there = problem_of({0, 0, 0}, {20, 9, 1}, {});
  const Problem back = problem_of({20, 9, 1}, {0, 0, 0}, {});
  PlanOptions options = limited(AllowedGears::both);
  options.steering = Steering::reeds_shepp;
  options.cost = {.forward_weight = 3.0,
                  .reverse_weight = 1.0,
                  .gear_change_cost = 5.0,
                  .curvature_change_cost = 2.0};
  const double cost = plan(there, options).cost;
  std::swap(options.cost.forward_weight, options.cost.reverse_weight);
  EXPECT_NEAR(plan(back, options).cost, cost, 1e-3 * cost);
}

}  // namespace
}  // namespace vandplan

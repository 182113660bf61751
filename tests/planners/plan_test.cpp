// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What does `plan` owe its caller, and what does it make of planners that it does not know?

#include "vandplan/planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using std::numbers::pi;

PlanOptions plan_iterations(std::int64_t count) {
  PlanOptions options;
  options.budget.max_iterations = count;
  return options;
}

// ---- one frame ----

Scenario yard() {
  Scenario scenario;
  scenario.bounds = {-50, 50, -40, 40};
  scenario.start = {1.25, -0.5, 0.25};
  scenario.goal = {30.5, 4.75, -1};
  scenario.obstacles = {box(14, -8, 16, 8)};
  return scenario;
}

constexpr double far_x = 4.5e9;   // [m]
constexpr double far_y = -1.5e9;  // [m]

Scenario far_yard() { return moved_by(yard(), far_x, far_y); }

// Doubles are a micrometre apart there.
void expect_moved(const Pose& there, const Pose& here, double tolerance = 1e-6) {
  EXPECT_NEAR(there.x - far_x, here.x, tolerance);
  EXPECT_NEAR(there.y - far_y, here.y, tolerance);
  EXPECT_EQ(there.heading, here.heading);
}

class OneFrame : public testing::TestWithParam<const char*> {};

TEST_P(OneFrame, APlanFarAwayIsTheSamePlanMoved) {
  const Planner planner = planner_named(GetParam());
  PlanOptions options = plan_iterations(800);
  if (honours(planner, "keep_tree")) options.planner.set("keep_tree", true);
  const Problem here = make_problem(yard());
  const Problem there = make_problem(far_yard());
  const PlanResult near = plan(here, planner, options);
  const PlanResult far = plan(there, planner, options);
  ASSERT_TRUE(near.path && far.path);
  EXPECT_EQ(near.path->start, yard().start);
  EXPECT_EQ(far.path->start, far_yard().start);
  EXPECT_EQ(far.path->segments, near.path->segments);
  EXPECT_EQ(far.cost, near.cost);
  EXPECT_EQ(far.lower_bound, near.lower_bound);
  expect_moved(end_pose(*far.path), end_pose(*near.path), 1e-5);  // summed up over there

  const std::vector<PathPoint> points = sampled(*near.path, 0.5);
  const std::vector<PathPoint> far_points = sampled(*far.path, 0.5);
  ASSERT_EQ(far_points.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    expect_moved(far_points[i].pose, points[i].pose, 1e-5);
  }

  ASSERT_TRUE(near.check && far.check);
  EXPECT_TRUE(far.check->valid);
  EXPECT_EQ(far.check->length, near.check->length);
  EXPECT_EQ(far.check->reverse_length, near.check->reverse_length);
  EXPECT_EQ(far.check->clearance, near.check->clearance);
  EXPECT_TRUE(check_path(there, *far.path).valid);
  EXPECT_FALSE(check_path(here, *far.path).valid);

  ASSERT_EQ(far.tree.has_value(), near.tree.has_value());
  if (!near.tree) return;
  EXPECT_EQ(near.tree->poses.front(), yard().start);
  EXPECT_EQ(far.tree->poses.front(), far_yard().start);
  EXPECT_EQ(far.tree->parents, near.tree->parents);
  for (std::size_t i = 0; i < near.tree->poses.size(); ++i) {
    expect_moved(far.tree->poses[i], near.tree->poses[i]);
  }
}

INSTANTIATE_TEST_SUITE_P(Planners, OneFrame, testing::Values("anytime", "rrt-opt-bound-goal"),
                         [](const auto& planner) { return std::to_string(planner.index); });

TEST(OneFrame, TheJudgeSaysWhereInTheScenariosFrame) {
  const Problem problem = make_problem(far_yard());
  const PathCheck check = check_path(problem, {far_yard().start, {{0, 30}}});
  EXPECT_EQ(check.reason, "the footprint hits obstacles[0]");
  ASSERT_TRUE(check.at);
  EXPECT_NEAR(check.at->pose.x - far_x, 1.25 + check.at->s * std::cos(0.25), 1e-5);
  EXPECT_NEAR(check.at->pose.y - far_y, -0.5 + check.at->s * std::sin(0.25), 1e-5);
}

TEST(OneFrame, StatedPosesAreInTheScenariosFrame) {
  const Problem problem = make_problem(far_yard());
  const PlanResult result = plan(problem, plan_iterations(800));
  ASSERT_TRUE(result.path);
  PathClaims claims;
  for (const PathPoint& point : sampled(*result.path, 0.1)) {
    claims.poses.push_back({point.s, point.pose});
  }
  EXPECT_EQ(check_path(problem, *result.path, claims).reason, "");
  claims.poses[5].pose.x += 1e-3;
  EXPECT_EQ(check_path(problem, *result.path, claims).reason,
            "the stated poses[5] is not on the path");
}

// Wheels that turn only while the vehicle rolls need a path from a pose back to it.
TEST(Plan, DrivesWhereStartAndGoalDifferInTheirWheelsAlone) {
  Scenario scenario;
  scenario.bounds = {-50, 50, -50, 50};
  scenario.curvatures = {0.05, -0.05};
  PlanOptions options = plan_iterations(3000);
  options.steering = Steering::continuous;
  const PlanResult result = plan(make_problem(scenario), options);
  ASSERT_TRUE(result.path) << result.reason;
  EXPECT_GT(length(*result.path), 0.0);
}

TEST(Plan, AScenarioIsPlannedLikeItsProblem) {
  const PlanResult result = plan(yard(), plan_iterations(800));
  ASSERT_TRUE(result.path);
  EXPECT_EQ(result.path, plan(make_problem(yard()), plan_iterations(800)).path);
}

// ---- margins ----

/// The default truck beside a kerb, parallel to it, with a yard to its left; the goal is ahead.
Problem beside_a_kerb(double gap) {
  return problem_in({.bounds = wide_bounds,
                     .obstacles = {box(10, -2, 12, 1)},
                     .kerbs = {box(-30, -3, 60, -1.275 - gap)}},
                    {0, 0, 0}, {30, 5, 0});
}

PlanOptions with_margin(double margin, double ramp = 0.0) {
  PlanOptions options = plan_iterations(3000);
  options.cost = shortest_style;
  options.clearance = {.margin = margin, .margin_ramp = ramp};
  return options;
}

TEST(Margin, IsKept) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, {box(12, -2, 14, 1)});
  const PlanResult touching = plan(problem, with_margin(0));
  const PlanResult result = plan(problem, with_margin(0.4));
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LT(*touching.check->clearance, 0.1);
  EXPECT_GE(*result.check->clearance, 0.4 - 1e-6);
  EXPECT_LE(*result.check->clearance, 0.42);
  EXPECT_GT(result.cost, touching.cost);
}

TEST(Margin, AStartOrGoalThatIsNearerIsNamed) {
  const PlanResult result = plan(beside_a_kerb(0.1), with_margin(0.3));
  EXPECT_EQ(result.status, PlanStatus::start_in_collision);
  EXPECT_EQ(result.reason,
            "the wheels are only 0.100 m from kerbs[0], the margin is 0.3 m; with margin_ramp a "
            "start or goal may be nearer");
  const Problem goal = problem_of({0, 0, 0}, {30, 0, 0}, {box(36.1, -2, 40, 2)});
  const PlanResult at_goal = plan(goal, with_margin(0.3));
  EXPECT_EQ(at_goal.status, PlanStatus::goal_in_collision);
  EXPECT_EQ(at_goal.reason,
            "the footprint is only 0.200 m from obstacles[0], the margin is 0.3 m; with "
            "margin_ramp a start or goal may be nearer");
}

TEST(Refusal, NamesWhatIsInTheWayByItsNumber) {
  const auto hit_with = [](Scenario scenario) {
    scenario.goal = {30, 0, 0};
    return plan(make_problem(scenario), with_margin(0.3)).hit;
  };
  const Scenario open{.bounds = {-50, 50, -50, 50}};
  Scenario scenario = open;
  scenario.obstacles = {box(-40, -40, -39, -39), box(30, -1, 31, 1)};
  EXPECT_EQ(hit_with(scenario), (Hit{HitKind::obstacle, 1}));
  scenario.obstacles = {box(36.1, -2, 40, 2)};  // nearer than the margin
  EXPECT_EQ(hit_with(scenario), (Hit{HitKind::obstacle, 0}));
  scenario.obstacles.clear();
  scenario.kerbs = {box(-40, -40, -39, -39), box(-1, -1, 1, 1)};
  EXPECT_EQ(hit_with(scenario), (Hit{HitKind::kerb, 1}));
  scenario = open;
  scenario.bounds.x_max = 20;
  EXPECT_EQ(hit_with(scenario), (Hit{HitKind::bounds}));
  scenario = open;
  scenario.map = OccupancyGrid{.origin = {-50, -50, 0}, .columns = 100, .rows = 100};
  std::vector<Cell> cells(10000, Cell::free);
  cells[100 * 50 + 81] = Cell::occupied;
  scenario.map->cells = cells;
  EXPECT_EQ(hit_with(scenario), (Hit{HitKind::map, 0, Point{31.5, 0.5}}));
  EXPECT_EQ(hit_with(open), std::nullopt);
}

TEST(Refusal, OfAPathNamesWhatItHits) {
  const Path path{{}, {{0, 30}}};
  const Problem problem =
      problem_of({0, 0, 0}, {30, 0, 0}, {box(9, 9, 10, 10), box(20, -1, 21, 1)});
  EXPECT_EQ(check_path(problem, path).hit, (Hit{HitKind::obstacle, 1}));
  EXPECT_EQ(check_path(problem, {{}, {{0, 20}}}).hit, (Hit{HitKind::obstacle, 1}));
  EXPECT_EQ(check_path(problem, {{}, {{0, 5}}}).hit, std::nullopt);  // it ends elsewhere
}

// What is exactly as far away as it has to be is valid, and still no path can be planned there.
TEST(Margin, AStartOrGoalThatJustKeepsItIsToldApart) {
  const Problem wall = problem_of({0, 0, 0}, {30, 0, 0}, {box(28, 1.8, 40, 2)});
  const PlanResult at_goal = plan(wall, with_margin(1.8 - Vehicle{}.width / 2));
  EXPECT_EQ(at_goal.status, PlanStatus::goal_in_collision);
  EXPECT_TRUE(at_goal.reason.starts_with("the pose keeps the margin of 0.5")) << at_goal.reason;
  const PlanResult at_start = plan(beside_a_kerb(1e-4), with_margin(0));
  EXPECT_EQ(at_start.status, PlanStatus::start_in_collision);
  EXPECT_EQ(at_start.reason,
            "the pose keeps the margin of 0 m, but planning asks for up to 1 mm more");
}

TEST(Margin, ARampLeadsAwayFromAKerb) {
  const Problem problem = beside_a_kerb(0.1);
  const PlanResult result = plan(problem, with_margin(0.3, 15));
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_NEAR(*result.check->clearance, 0.1, 1.1e-3);
  // Not for ever: the same path with a shorter ramp.
  const ClearanceOptions shorter{.margin = 0.3, .margin_ramp = 1};
  EXPECT_FALSE(check_path(problem, *result.path, {.clearance = shorter}).valid);
}

TEST(Margin, IsPartOfEveryPlannersTask) {
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, {box(12, -2, 14, 1)});
  for (const Planner& planner : planners()) {
    const PlanResult result = plan(problem, planner, with_margin(0.4));
    EXPECT_NE(result.status, PlanStatus::rejected) << planner.name << ": " << result.reason;
    EXPECT_TRUE(!result.check || *result.check->clearance >= 0.4 - 1e-6) << planner.name;
  }
}

// ---- planners of others ----

Problem straight_ahead(std::vector<Polygon> obstacles = {}, const Bounds& bounds = wide_bounds) {
  return problem_of({0, 0, 0}, {20, 0, 0}, std::move(obstacles), bounds);
}

/// A planner that always gives the same answer.
Planner answering(PlannerAnswer answer) {
  return {.name = "mine",
          .summary = "knows the answer",
          .function = [answer](const Task&, const PlanOptions&) { return answer; }};
}

Planner driving(std::vector<Segment> segments, std::optional<double> lower_bound = {}) {
  return answering(
      {.status = PlanStatus::solved, .segments = std::move(segments), .lower_bound = lower_bound});
}

/// Drives straight ahead in as many segments as its option says, and counts its runs.
Planner straight_planner(const std::shared_ptr<int>& runs) {
  return {.name = "straight",
          .summary = "for goals straight ahead",
          .options = {{.name = "parts",
                       .summary = "segments of the path",
                       .default_value = std::int64_t{2},
                       .least = 1,
                       .most = 9}},
          .function = [runs](const Task& task, const PlanOptions& options) {
            ++*runs;
            const std::int64_t parts = options.planner.integer("parts");
            const double length =
                std::hypot(task.goal.x - task.start.x, task.goal.y - task.start.y);
            PlannerAnswer answer{.status = PlanStatus::solved};
            answer.segments.emplace(static_cast<std::size_t>(parts),
                                    Segment{0, length / static_cast<double>(parts)});
            answer.counters = {{"parts", parts}};
            return answer;
          }};
}

TEST(OwnPlanner, MayHoldStateAndHaveOptionsOfItsOwn) {
  const auto runs = std::make_shared<int>(0);
  const Planner planner = straight_planner(runs);
  PlanResult result = plan(straight_ahead(), planner);
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_EQ(result.path->segments.size(), 2U);
  EXPECT_EQ(result.cost, 20.0);
  EXPECT_EQ(counter(result, "parts"), 2);
  EXPECT_EQ(counter(result, "nodes"), 0);

  PlanOptions options;
  set_option(options, planner, "parts", "5");
  result = plan(straight_ahead(), planner, options);
  EXPECT_EQ(result.path->segments.size(), 5U);
  EXPECT_EQ(*runs, 2);
}

TEST(OwnPlanner, ItsOptionsAreCheckedLikeOurs) {
  const Planner planner = straight_planner(std::make_shared<int>(0));
  PlanOptions options;
  EXPECT_THROW(set_option(options, planner, "parts", "10"), InputError);
  EXPECT_THROW(set_option(options, planner, "part", "3"), InputError);
  EXPECT_THROW(set_option(options, planner, "max_nodes", "3"), InputError);
  options.planner.set("parts", std::int64_t{10});
  EXPECT_THROW((void)plan(straight_ahead(), planner, options), InputError);
  options = {};
  options.planner.set("parts", 2.5);
  EXPECT_THROW((void)plan(straight_ahead(), planner, options), InputError);
  options = {};
  options.cost.reverse_weight = 3;  // its properties do not say that it honours prices
  EXPECT_THROW((void)plan(straight_ahead(), planner, options), InputError);
}

TEST(OwnPlanner, PricesAreChargedByPlanWhereItHonoursThem) {
  Planner planner = driving({{0, -1}, {0, 21}});
  planner.properties.capabilities.add(Capability::prices);
  PlanOptions options;
  options.cost = by_length_and(3, 5);
  options.cost.initial_gear = InitialGear::forward;
  const PlanResult result = plan(straight_ahead(), planner, options);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_NEAR(result.cost, 21 + 3 + 2 * 5, 1e-12);
  EXPECT_NEAR(result.check->reverse_length, 1, 1e-12);
}

TEST(OwnPlanner, IsToldHowTheVehicleSteers) {
  std::optional<Steering> in_task;
  std::optional<Steering> in_options;
  Planner planner{.name = "asks",
                  .summary = "",
                  .properties = {.capabilities = {Capability::steering}},
                  .function = [&](const Task& task, const PlanOptions& options) {
                    in_task = task.steering;
                    in_options = options.steering;
                    return PlannerAnswer{.status = PlanStatus::time_limit};
                  }};
  PlanOptions options = plan_iterations(3);
  options.steering = Steering::continuous;
  (void)plan(straight_ahead(), planner, options);
  EXPECT_EQ(in_task, Steering::continuous);
  EXPECT_EQ(in_options, Steering::continuous);
  planner.properties.capabilities.remove(Capability::steering);
  EXPECT_THROW((void)plan(straight_ahead(), planner, options), InputError);
}

// Where start and goal are one pose, the wheels are to be turned all the same.
TEST(OwnPlanner, IsAskedWhereOnlyTheWheelsAreToTurn) {
  const auto runs = std::make_shared<int>(0);
  Planner planner = straight_planner(runs);
  planner.properties.capabilities.add(Capability::steering);
  const Problem here = problem_of({1, 2, 3}, {1, 2, 3}, {});
  const Problem turned =
      make_problem(here.world(), here.vehicle(), here.start(), here.goal(), {0.0, 0.1});
  const auto runs_for = [&](const Problem& problem, Steering steering) {
    *runs = 0;
    PlanOptions options = plan_iterations(3);
    options.steering = steering;
    (void)plan(problem, planner, options);
    return *runs;
  };
  EXPECT_EQ(runs_for(turned, Steering::continuous), 1);
  EXPECT_EQ(runs_for(turned, Steering::continuous_between_stops), 0);
  EXPECT_EQ(runs_for(here, Steering::continuous), 0);
}

TEST(PlanResult, SlowWheelsAreALikelyReason) {
  const Vehicle slow{.wheelbase = 1,
                     .front_overhang = 0.3,
                     .rear_overhang = 0.3,
                     .width = 1.3,
                     .min_turning_radius = 1,
                     .limits = {.max_curvature_rate = 0.03}};
  PlanOptions options;
  options.budget.max_iterations = 0;
  options.steering = Steering::continuous;
  const auto reason_in = [&](const Bounds& bounds) {
    const std::vector<Polygon> walls = {box(-1, -1, 8, 0), box(-1, 7, 8, 8), box(-1, 0, 0, 7),
                                        box(7, 0, 8, 7)};
    return plan(problem_of({2.75, 4, 1.57}, {4.25, 4, -1.57}, walls, bounds, slow), options).reason;
  };
  EXPECT_EQ(reason_in({0, 7, 0, 7}),
            "likely because of max_curvature_rate: the wheels turn from lock to lock on 67 m, and "
            "the bounds are 7 m long");
  EXPECT_EQ(reason_in({-40, 47, -40, 47}), "");
  options.steering = Steering::continuous_between_stops;
  EXPECT_EQ(reason_in({0, 7, 0, 7}), "");
}

TEST(OwnPlanner, IsNotAskedWhatNeedsNoSearch) {
  const auto runs = std::make_shared<int>(0);
  const Planner planner = straight_planner(runs);
  PlanResult result = plan(straight_ahead({box(-1, -1, 1, 1)}), planner);
  EXPECT_EQ(result.status, PlanStatus::start_in_collision);
  EXPECT_EQ(result.reason, "the footprint hits obstacles[0]");
  result = plan(straight_ahead({box(50, 0, 51, 1), box(20, -1, 21, 1)}), planner);
  EXPECT_EQ(result.status, PlanStatus::goal_in_collision);
  EXPECT_EQ(result.reason, "the footprint hits obstacles[1]");
  result = plan(straight_ahead({}, {-5, 19, -5, 5}), planner);
  EXPECT_EQ(result.status, PlanStatus::goal_in_collision);
  EXPECT_EQ(result.reason, "the rear axle is 1 m outside the bounds");
  result = plan(problem_of({1, 2, 3}, {1, 2, 3}, {}), planner);
  EXPECT_EQ(result.status, PlanStatus::solved);
  EXPECT_TRUE(result.path->segments.empty());
  EXPECT_EQ(*runs, 0);
}

TEST(OwnPlanner, MayProveThatThereIsNoPath) {
  const PlanResult result =
      plan(straight_ahead(), answering({.status = PlanStatus::no_path, .iterations = 3}));
  EXPECT_EQ(result.status, PlanStatus::no_path);
  EXPECT_FALSE(result.path);
  EXPECT_FALSE(result.check);
  EXPECT_EQ(result.reason, "");
  EXPECT_EQ(result.iterations, 3);
  EXPECT_EQ(name_of(PlanStatus::no_path), "no_path");
}

TEST(OwnPlanner, WhatItThrowsComesOut) {
  const Planner planner{.name = "broken",
                        .summary = "",
                        .function = [](const Task&, const PlanOptions&) -> PlannerAnswer {
                          throw std::runtime_error("broken");
                        }};
  EXPECT_THROW((void)plan(straight_ahead(), planner), std::runtime_error);
}

TEST(OwnPlanner, ARunWithoutALimitIsToldTheDefaultTime) {
  std::optional<double> told;
  const Planner planner{
      .name = "asks", .summary = "", .function = [&](const Task&, const PlanOptions& options) {
        told = options.budget.time_limit;
        return PlannerAnswer{.status = PlanStatus::time_limit};
      }};
  (void)plan(straight_ahead(), planner, PlanOptions{});
  EXPECT_EQ(told, default_time_limit);
  (void)plan(straight_ahead(), planner, plan_iterations(3));
  EXPECT_EQ(told, std::nullopt);
}

// ---- paths that the judge rejects ----

void expect_rejected(const PlanResult& result, const std::string& reason) {
  EXPECT_EQ(result.status, PlanStatus::rejected);
  EXPECT_EQ(result.reason, reason);
  EXPECT_FALSE(result.path);
  EXPECT_EQ(result.cost, 0.0);
  EXPECT_FALSE(result.lower_bound);
  EXPECT_TRUE(result.anytime.empty());
  ASSERT_TRUE(result.check);
  EXPECT_FALSE(result.check->valid);
  EXPECT_EQ(result.check->reason, reason);
}

TEST(RejectedPath, TurnsTooTight) {
  const double radius = 6.9;
  const Problem problem = problem_of({0, 0, 0}, {radius, radius, pi / 2}, {});
  const PlanResult result = plan(problem, driving({{1 / radius, radius * pi / 2}}));
  expect_rejected(result,
                  "curvature 0.1449275362 is tighter than the turning radius of 7 m allows");
}

TEST(RejectedPath, JumpsInCurvatureWhereTheVehicleRolls) {
  Planner planner = driving({{0, 3}, {1.0 / 7, 7 * pi / 2}});
  const Problem problem = problem_of({0, 0, 0}, {10, 7, pi / 2}, {});
  EXPECT_EQ(plan(problem, planner).status, PlanStatus::solved);
  planner.properties.capabilities.add(Capability::steering);
  PlanOptions options;
  options.steering = Steering::continuous_between_stops;
  const PlanResult result = plan(problem, planner, options);
  expect_rejected(result, "the curvature jumps from 0 to 0.1428571 1/m where the vehicle rolls");
  EXPECT_EQ(result.check->at->s, 3);
}

TEST(RejectedPath, LeadsThroughAWall) {
  const PlanResult result = plan(straight_ahead({box(12, -3, 12.1, 3)}), driving({{0, 20}}));
  expect_rejected(result, "the footprint hits obstacles[0]");
  ASSERT_TRUE(result.check->at);
  EXPECT_NEAR(result.check->at->s, 12 - 5.9, 1e-3);
}

TEST(RejectedPath, LeavesTheBounds) {
  const PlanResult result = plan(straight_ahead({}, {-1, 21, -5, 5}), driving({{0, 22}, {0, -2}}));
  expect_rejected(result, "the rear axle is 1 m outside the bounds");
}

TEST(RejectedPath, EndsBesideTheGoal) {
  expect_rejected(plan(straight_ahead(), driving({{0, 19.5}})),
                  "the path ends 0.5 m and 0 rad away");
}

TEST(RejectedPath, HasANumberThatIsNone) {
  expect_rejected(plan(straight_ahead(), driving({{0, 10}, {std::nan(""), 10}})),
                  "segments[1] is not finite");
}

TEST(RejectedPath, CostsLessThanTheStatedLowerBound) {
  expect_rejected(plan(straight_ahead(), driving({{0, 20}}, 20.5)),
                  "the stated bound is 20.5 m, the path costs 20 m");
}

TEST(RejectedPath, ABoundAboveTheCostByRoundingIsNone) {
  const PlanResult result = plan(straight_ahead(), driving({{0, 20}}, 20 * (1 + 1e-12)));
  EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_EQ(result.lower_bound, 20.0);
  EXPECT_EQ(plan(straight_ahead(), driving({{0, 20}}, 19)).lower_bound, 19.0);
}

TEST(Plan, ABoundThatIsNotAboveZeroIsNone) {
  for (const double bound : {0.0, -1.0}) {
    const PlanResult result = plan(straight_ahead(), driving({{0, 20}}, bound));
    EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_FALSE(result.lower_bound) << bound;
  }
  EXPECT_FALSE(plan(straight_ahead(), driving({{0, 20}})).lower_bound);
}

TEST(RejectedPath, IsNotThere) {
  const PlanResult result = plan(straight_ahead(), answering({.status = PlanStatus::solved}));
  EXPECT_EQ(result.status, PlanStatus::rejected);
  EXPECT_EQ(result.reason, "the planner says solved, and gives no path");
  EXPECT_FALSE(result.path);
  const PlanResult contrary =
      plan(straight_ahead(),
           answering({.status = PlanStatus::no_path, .segments = std::vector<Segment>{{0, 20}}}));
  EXPECT_EQ(contrary.status, PlanStatus::rejected);
  EXPECT_EQ(contrary.reason, "the planner gives a path, and says no_path");
  EXPECT_FALSE(contrary.path);
  EXPECT_EQ(name_of(PlanStatus::rejected), "rejected");
}

// ---- finding planners ----

TEST(Planners, HaveNamesOfTheirOwn) {
  for (const Planner& planner : planners()) {
    const auto is_it = [&](const Planner& other) { return other.name == planner.name; };
    EXPECT_EQ(std::ranges::count_if(planners(), is_it), 1) << planner.name;
    EXPECT_EQ(planner_named(planner.name).name, planner.name);
  }
  EXPECT_FALSE(find_planner("anytim"));
  EXPECT_THROW((void)planner_named("anytim"), InputError);
  EXPECT_THROW((void)planner_named("anytime:euclid"), InputError);  // it takes no estimate
}

TEST(Planners, PropertiesSayWhatNamesWouldMean) {
  const PlannerProperties& printed = planner_named("rrt-bsc-hlut-2").properties;
  EXPECT_EQ(printed.family, "rrt");
  EXPECT_EQ(printed.strategy, "bsc");
  EXPECT_EQ(printed.estimate, "hlut-2");
  EXPECT_FALSE(printed.tries_goal);
  EXPECT_EQ(printed.groups, std::vector<std::string>{"thesis"});
  const PlannerProperties& tried = planner_named("rrt-opt-rs-goal").properties;
  EXPECT_EQ(tried.strategy, "opt");
  EXPECT_EQ(tried.estimate, "reeds-shepp");
  EXPECT_TRUE(tried.tries_goal);
  EXPECT_TRUE(tried.groups.empty());
}

}  // namespace
}  // namespace vandplan

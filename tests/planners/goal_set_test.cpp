// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// A path to a set of goals ends at one of them, costs no more than paths to the others, and what is
// proven of it is true.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stop_token>
#include <string>
#include <tuple>
#include <vector>

#include "planners/free_parts.h"
#include "planners/goal_poses.h"
#include "problem/goal_set.h"
#include "support/cases.h"
#include "support/combined.h"
#include "support/draws.h"
#include "support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/replanner.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using std::numbers::pi;

constexpr double endless_cost = std::numeric_limits<double>::infinity();

PlanOptions with_iterations(std::int64_t iterations, std::uint64_t seed = 1) {
  PlanOptions options;
  options.budget.max_iterations = iterations;
  options.budget.seed = seed;
  return options;
}

PlanOptions by_length(std::int64_t iterations) {
  PlanOptions options = with_iterations(iterations);
  options.cost = shortest_style;
  return options;
}

Scenario yard(std::vector<GoalRegion> set, std::vector<Polygon> obstacles = {}) {
  return {.name = "set",
          .bounds = {-60, 100, -60, 60},
          .goal_set = std::move(set),
          .obstacles = std::move(obstacles)};
}

GoalRegion region(Interval x, Interval y, HeadingRange heading) {
  return {.x = x, .y = y, .heading = heading};
}

/// Docks side by side that are backed into from a lane, the first ones behind a wall.
Scenario docks(int count) {
  std::vector<GoalRegion> set;
  std::vector<Polygon> obstacles = {box(-60, 20, 100, 21), box(10, 8, 14, 20)};
  for (int i = 0; i < count; ++i) {
    const double x = 12 + 4.0 * i;
    set.push_back(region_of_pose({x, 17, -pi / 2}));
    obstacles.push_back(box(x + 1.9, 14, x + 2.1, 20));
  }
  return yard(set, obstacles);
}

/// Whether the path ends at the goal that the result says, in that region of the set.
void expect_at_goal(const Problem& problem, const PlanResult& result) {
  ASSERT_TRUE(result.path) << name_of(result.status) << ": " << result.reason;
  ASSERT_TRUE(result.goal);
  ASSERT_LT(result.goal->index, problem.goal_set().size());
  const Pose off = relative(result.goal->pose, end_pose(*result.path));
  EXPECT_LT(std::hypot(off.x, off.y), 1.1e-6);
  EXPECT_LT(std::abs(off.heading), 1.1e-6);
  const PathCheck check = check_path(problem, *result.path, {.goal = result.goal});
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_EQ(check.goal, result.goal);
}

TEST(GoalSet, TakesTheDockThatIsCheapest) {
  const Scenario scenario = docks(6);
  const PlanResult result = plan(make_problem(scenario), with_iterations(8000));
  expect_at_goal(make_problem(scenario), result);
  double least = endless_cost;
  for (const GoalRegion& dock : scenario.goal_set) {
    Scenario alone = scenario;
    alone.goal_set = {dock};
    const PlanResult single = plan(make_problem(alone), with_iterations(3000));
    if (single.path) least = std::min(least, single.cost);
  }
  EXPECT_LT(result.cost, 1.02 * least);
}

TEST(GoalSet, ProvesNothingThatAnyOfItsGoalsDisproves) {
  const Scenario scenario = docks(6);
  const double bound = plan(make_problem(scenario), with_iterations(40)).lower_bound.value();
  for (const GoalRegion& dock : scenario.goal_set) {
    Scenario alone = scenario;
    alone.goal_set = {dock};
    const PlanResult single = plan(make_problem(alone), with_iterations(2000));
    if (!single.path) continue;
    EXPECT_LE(bound, single.cost);
  }
}

TEST(GoalSet, ASearchThatOnlyPausedProvesNothing) {
  Scenario scenario = yard({region_of_pose({20, 5, 0})}, {box(12, -9, 13, 9)});
  for (const std::int64_t iterations : {1, 5, 20, 60}) {
    PlanOptions options = with_iterations(iterations);
    options.budget.target_gap = 0.2;
    options.steering = iterations == 20 ? Steering::continuous : Steering::reeds_shepp;
    EXPECT_NE(plan(make_problem(scenario), options).status, PlanStatus::no_path) << iterations;
  }
  scenario.moving = {{.outline = box(-1, -1, 1, 1), .trajectory = {{0, {-40, 0, 0}}}}};
  EXPECT_NE(plan(make_problem(scenario), with_iterations(3)).status, PlanStatus::no_path);
  scenario.goal = {20, 5, 0};
  scenario.goal_set.clear();
  EXPECT_NE(plan(make_problem(scenario), with_iterations(3)).status, PlanStatus::no_path);
}

TEST(GoalSet, ManyRegionsKeepToTheTime) {
  std::vector<GoalRegion> many;
  for (int i = 0; i < 2000; ++i) {
    many.push_back(region({10 + 0.02 * i, 11 + 0.02 * i}, {0, 5}, any_heading));
  }
  const PlanResult result = plan(make_problem(yard(many)), with_iterations(50));
  EXPECT_EQ(result.status, PlanStatus::solved);
  EXPECT_LE(result.lower_bound, result.cost);
}

// That nothing was looked at does not mean that nothing is free.
TEST(GoalSet, ARunThatIsStoppedAtOnceSaysSo) {
  std::stop_source stop;
  stop.request_stop();
  PlanOptions options;
  options.budget.stop = stop.get_token();
  const GoalRegion blocked = region({8, 9}, {-1, 1}, any_heading);
  const GoalRegion dock = region_of_pose({20, 4, 0});
  for (const std::vector<GoalRegion>& set :
       {std::vector{blocked}, {dock, region_of_pose({20, 8, 0})}, {blocked, dock}}) {
    Scenario scenario = yard(set, {box(0, 10, 60, 11), box(4, -5, 12, -2)});
    EXPECT_EQ(plan(make_problem(scenario), options).status, PlanStatus::stopped);
    scenario.via = {{{blocked}, false}};
    EXPECT_EQ(plan(make_problem(scenario), options).status, PlanStatus::stopped);
  }
}

TEST(GoalSet, TakesTheFreeDockWhereOthersAreTaken) {
  Scenario scenario = docks(4);
  for (const int taken : {0, 1, 3}) {
    const double x = 12 + 4.0 * taken;
    scenario.obstacles.push_back(box(x - 1, 15, x + 1, 16));
  }
  const PlanResult result = plan(make_problem(scenario), with_iterations(3000));
  expect_at_goal(make_problem(scenario), result);
  EXPECT_EQ(result.goal->index, 2U);
}

TEST(GoalSet, SaysThatNoGoalIsFree) {
  Scenario scenario = docks(3);
  scenario.obstacles.push_back(box(0, 16, 40, 17));
  const PlanResult result = plan(make_problem(scenario), with_iterations(3000));
  EXPECT_EQ(result.status, PlanStatus::goal_in_collision);
  EXPECT_EQ(result.reason, "none of the 3 poses of the goal that were looked at is free");
  scenario.goal_set = {scenario.goal_set[1]};  // of one pose the judge says more
  EXPECT_NE(plan(make_problem(scenario), with_iterations(10)).reason.find("obstacles["),
            std::string::npos);
}

/// An area with a slot along x that is wider than the vehicle by `room` [m].
Scenario slot(double room) {
  GoalRegion area{.area = {{20, -10}, {40, -10}, {40, 10}, {20, 10}}, .heading = any_heading};
  const double side = 1.275 + room / 2;  // beside y = 0.3
  return yard({area}, {box(12, -25, 50, 0.3 - side), box(12, 0.3 + side, 50, 25)});
}

/// A wall with a gate of 6 m before the places of a goal.
Scenario gate(GoalRegion goal, std::vector<Zone> zones) {
  Scenario scenario = yard({std::move(goal)}, {box(20, -90, 21, -3), box(20, 3, 21, 90)});
  for (Zone& zone : zones) zone.area = box(19, -3, 22, 3);
  scenario.zones = std::move(zones);
  return scenario;
}

TEST(GoalSet, ProvesThatNoPlaceIsReachedWhateverTheHeading) {
  constexpr std::int64_t until_proof = 40'000, in_vain = is_sanitized ? 2000 : 40'000;
  const auto status = [](const GoalRegion& goal, std::vector<Zone> zones, std::int64_t most) {
    return plan(make_problem(gate(goal, std::move(zones))), with_iterations(most)).status;
  };
  const GoalRegion area{.area = {{38, -2}, {42, -2}, {42, 2}}, .heading = any_heading};
  for (const GoalRegion& goal : {region({40, 40}, {0, 0}, any_heading), area}) {
    EXPECT_EQ(status(goal, {{.direction = HeadingRange{2.6, 3.7}}}, until_proof),
              PlanStatus::no_path);
    EXPECT_EQ(status(goal, {{.closed = true}}, until_proof), PlanStatus::no_path);
    EXPECT_NE(status(goal, {}, in_vain), PlanStatus::no_path);
  }
  // One end of the interval is before the gate.
  const GoalRegion line = region({15, 40}, {0, 0}, {0, 0});
  EXPECT_NE(status(line, {{.closed = true}}, in_vain), PlanStatus::no_path);
}

// Without a via no pose of the set is proven to have no path.
TEST(GoalSet, SaysThatNoSearchHasWorkLeft) {
  Scenario scenario = yard({region({40, 42}, {0, 0}, any_heading)});
  scenario.via = {{{region_of_pose({20, 0, 0})}, false}};
  scenario.obstacles = {box(19, -1, 21, 1)};
  const PlanResult result = plan(make_problem(scenario), with_iterations(40'000));
  EXPECT_EQ(result.status, PlanStatus::node_limit);
  EXPECT_EQ(result.reason,
            "no search for a goal goes on; the first: the pose of via[0] is not free");
}

TEST(GoalSet, FindsANarrowSlotInAnArea) {
  const Problem problem = make_problem(slot(0.1));
  const PlanResult result = plan(problem, with_iterations(is_sanitized ? 200 : 3000));
  EXPECT_NE(result.status, PlanStatus::goal_in_collision) << result.reason;
  if (!is_sanitized) expect_at_goal(problem, result);
}

/// A slot that is 10 cm wider than the vehicle and closed at one end. It is turned about the
/// origin, which is in the middle of its mouth.
Scenario turned_slot(double turn) {
  const auto turned = [turn](Polygon polygon) {
    for (Point& p : polygon) {
      p = {p.x * std::cos(turn) - p.y * std::sin(turn),
           p.x * std::sin(turn) + p.y * std::cos(turn)};
    }
    return polygon;
  };
  Scenario scenario = yard(
      {{.area = turned(box(0, -1.325, 11, 1.325)), .heading = any_heading}},
      {turned(box(0, -4, 11, -1.325)), turned(box(0, 1.325, 11, 4)), turned(box(11, -4, 12, 4))});
  scenario.start = {4.5, -32, -2.3};
  return scenario;
}

// Turned, the slot holds none of the poses that are spread over the area, otherwise few.
TEST(GoalSet, InASlotThePathEndsInTheMouthAndTheCheaperWayRound) {
  for (const double turn : {0.0, 0.7}) {
    Scenario scenario = turned_slot(turn);
    const Problem set = make_problem(scenario);
    const PlanResult result = plan(set, with_iterations(is_sanitized ? 200 : 40'000));
    if (is_sanitized) continue;
    expect_at_goal(set, result);
    double least = endless_cost;
    for (const double heading : {turn, turn + pi}) {
      scenario.goal_set = {region_of_pose({1e-3 * std::cos(turn), 1e-3 * std::sin(turn), heading})};
      const PlanResult single = plan(make_problem(scenario), with_iterations(8000));
      if (single.path) least = std::min(least, single.cost);
    }
    EXPECT_LT(result.cost, 1.03 * least) << turn;
  }
}

TEST(GoalSet, PlacesBesideAGoalAreAheadBehindAndOnBothSides) {
  const GoalRegion area{.area = box(20, -5, 30, 5), .heading = {0.7, 0.9}};
  const Problem problem = make_problem(yard({area}));
  const planning::GoalPoint middle{.at = {0.5, 0.5, 0.0, 0.5}};
  const Pose from = planning::state_of(problem.task(), middle).pose;
  std::vector<Pose> moves;
  for (const planning::GoalPoint& point : planning::beside(problem.task(), middle, 0.1)) {
    moves.push_back(relative(from, planning::state_of(problem.task(), point).pose));
  }
  const std::vector<Point> places = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  ASSERT_EQ(moves.size(), places.size() + 1);  // the heading moves to one side
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(moves[i].x, places[i].x, 1e-9);
    EXPECT_NEAR(moves[i].y, places[i].y, 1e-9);
  }
  EXPECT_NEAR(moves.back().heading, 0.02, 1e-9);
}

TEST(GoalSet, ProvesThatNothingOfAnAreaIsFree) {
  const PlanResult result = plan(make_problem(slot(-0.1)), with_iterations(10));
  EXPECT_EQ(result.status, PlanStatus::goal_in_collision);
  EXPECT_EQ(result.reason, "no pose of the goal is free");
  // A slot as wide as the vehicle is neither free nor surely taken.
  const PlanResult unproven = plan(make_problem(slot(0.0)), with_iterations(10));
  EXPECT_EQ(unproven.status, PlanStatus::node_limit);
  EXPECT_TRUE(unproven.reason.ends_with("is free; others may be")) << unproven.reason;
}

TEST(GoalSet, OfAnOutlineInASlotIsFoundOrProvenToBeTaken) {
  const auto status = [](double room) {
    Scenario scenario = slot(room);
    scenario.vehicle.outline = {{-1.6, -1.275}, {5.9, -1.275}, {5.9, 1.275}, {-1.6, 1.275}};
    return plan(make_problem(scenario), with_iterations(is_sanitized ? 200 : 3000)).status;
  };
  EXPECT_NE(status(0.1), PlanStatus::goal_in_collision);
  EXPECT_EQ(status(-1.0), PlanStatus::goal_in_collision);
}

TEST(GoalSet, NothingIsFreeWhereThatIsProven) {
  int proofs = 0, found = 0;
  for_each_case(31, is_sanitized ? 5 : 40, [&](Rng& rng) {
    const double x = uniform(20, 30, rng), y = uniform(-5, 5, rng), heading = uniform(-pi, pi, rng);
    GoalRegion goal = region({x, x + uniform(0, 2, rng)}, {y, y + uniform(0, 2, rng)},
                             {heading, heading + uniform(0, 1, rng)});
    Scenario scenario = yard({goal});
    if (rng() % 3 == 0) {
      scenario.vehicle = semitrailer();
      scenario.goal_set[0].is_of_trailer = rng() % 2 == 0;
      scenario.goal_set[0].hitch_angle = {-0.2, uniform(-0.2, 0.5, rng)};
    }
    for (int i = 0; i < 4; ++i) {
      const double left = x + uniform(-8, 8, rng), low = y + uniform(-8, 8, rng);
      scenario.obstacles.push_back(
          box(left, low, left + uniform(0.2, 4, rng), low + uniform(0.2, 4, rng)));
    }
    scenario.zones = {{.area = box(x, y - 9, x + 9, y + uniform(0, 3, rng)), .closed = true}};
    const Problem problem = make_problem(scenario);
    const Task& task = problem.task();
    const auto is_free = [&](const planning::GoalPoint& point) {
      return task.checker->is_free(planning::state_of(task, point));
    };
    const auto [points, is_proof] = planning::free_points(task, 0, search::Budget({}), is_free);
    if (!points.empty()) ++found;
    if (!is_proof) return;
    ++proofs;
    for (std::size_t i = 0; i < 1000; ++i) {
      ASSERT_FALSE(is_free(planning::point_of_sequence(task, 0, i)));
    }
  });
  EXPECT_GE(proofs, is_sanitized ? 0 : 3);
  EXPECT_GE(found, is_sanitized ? 0 : 3);
}

TEST(GoalSet, ProvesThatAllGoalsAreWalledIn) {
  Scenario scenario = docks(3);
  scenario.obstacles.push_back(box(-60, 10, 100, 10.5));
  const PlanResult result = plan(make_problem(scenario), with_iterations(100'000));
  EXPECT_EQ(result.status, PlanStatus::no_path) << name_of(result.status);
  EXPECT_NE(result.reason.find("so for all 2 goals that are free"), std::string::npos)
      << result.reason;
  scenario.goal_set.push_back(region_of_pose({30, 0, 0}));
  EXPECT_EQ(plan(make_problem(scenario), with_iterations(1000)).goal->index, 3U);
}

TEST(GoalSet, EndsWhereAnIntervalIsNearest) {
  const PlanResult ahead =
      plan(make_problem(yard({region({20, 30}, {-2, 2}, {-0.2, 0.2})})), by_length(4000));
  EXPECT_NEAR(ahead.cost, 20.0, 0.02);
  EXPECT_EQ(ahead.goal->index, 0U);
  const PlanResult behind =
      plan(make_problem(yard({region({-30, -20}, {0, 0}, {0, 0})})), by_length(4000));
  EXPECT_NEAR(behind.cost, 20.0, 0.02);
  EXPECT_LE(behind.lower_bound, behind.cost);
  EXPECT_GT(behind.lower_bound, 19.5);
}

TEST(GoalSet, EndsAtTheEdgeOfAnArea) {
  const Polygon area = {{20, -5}, {40, -5}, {40, 5}, {20, 5}, {30, 0}};
  const GoalRegion region{.area = area, .heading = any_heading};
  const PlanResult result = plan(make_problem(yard({region})), by_length(8000));
  expect_at_goal(make_problem(yard({region})), result);
  // The nearest corners are at (20, +-5): no path is shorter than the line.
  EXPECT_GE(result.cost, std::hypot(20, 5));
  EXPECT_LT(result.cost, 1.03 * std::hypot(20, 5));
  EXPECT_LE(result.lower_bound, result.cost);
}

TEST(GoalSet, PointsEitherWay) {
  GoalRegion both = region_of_pose({-20, 0, pi});
  both.either_way = true;
  const PlanResult result = plan(make_problem(yard({both})), by_length(2000));
  EXPECT_NEAR(result.cost, 20.0, 1e-9);  // in reverse, as it stands
  EXPECT_NEAR(std::abs(result.goal->pose.heading), 0.0, 1e-9);
}

TEST(GoalSet, DrivesNowhereIfTheStartIsAGoal) {
  const PlanResult result =
      plan(make_problem(yard({region_of_pose({30, 0, 0}), region_of_pose({0, 0, 0})})));
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_TRUE(result.path->segments.empty());
  EXPECT_EQ(result.cost, 0.0);
  EXPECT_EQ(result.goal->index, 1U);
}

TEST(GoalSet, TurnsTheWheelsWhereTheStartIsTheGoal) {
  GoalRegion here = region_of_pose({0, 0, 0});
  here.curvature = 0.1;
  PlanOptions options = with_iterations(is_sanitized ? 200 : 2000);
  options.steering = Steering::continuous;
  const PlanResult result = plan(make_problem(yard({here})), options);
  EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_FALSE(result.path->segments.empty());
}

TEST(GoalSet, CostsNoMoreThanAnyOfItsHeadings) {
  const std::vector<Polygon> walls = {box(15, -5, 18, 22), box(25, 10, 30, 30)};
  GoalRegion any = region_of_pose({35, 20, 0});
  any.heading = any_heading;
  const Problem problem = make_problem(yard({any}, walls));
  const PlanResult result = plan(problem, with_iterations(is_sanitized ? 2000 : 20'000));
  expect_at_goal(problem, result);
  for (int i = 0; i < 12 && !is_sanitized; ++i) {
    const GoalRegion one = region_of_pose({35, 20, i * pi / 6});
    const PlanResult single = plan(make_problem(yard({one}, walls)), with_iterations(5000));
    if (!single.path) continue;
    EXPECT_LT(result.cost, 1.005 * single.cost) << i;
  }
}

TEST(GoalSet, AnswersAlikeOnAnyNumberOfThreads) {
  GoalRegion any = region_of_pose({35, 20, 0});
  any.heading = any_heading;
  const Problem problem =
      make_problem(yard({any, region_of_pose({30, -20, 1})}, docks(3).obstacles));
  PlanOptions options = with_iterations(is_sanitized ? 500 : 4000);
  const PlanResult one = plan(problem, options);
  options.budget.threads = 3;
  const PlanResult three = plan(problem, options);
  EXPECT_EQ(one.path, three.path);
  EXPECT_EQ(one.goal, three.goal);
  EXPECT_EQ(one.cost, three.cost);
  EXPECT_EQ(one.lower_bound, three.lower_bound);
  EXPECT_EQ(one.iterations, three.iterations);
}

TEST(GoalSet, KeepsToItsIterations) {
  for (const std::int64_t iterations : {0, 1, 7, 100, 1000}) {
    const PlanResult result = plan(make_problem(docks(5)), with_iterations(iterations));
    EXPECT_LE(result.iterations, iterations);
  }
}

TEST(GoalSet, EndsAsSoonAsTheGapIsProven) {
  const Scenario scenario = yard({region({20, 30}, {-2, 2}, {0, 0}), region_of_pose({40, 0, 0})});
  PlanOptions options = by_length(50'000);
  options.budget.target_gap = 0.05;
  const PlanResult result = plan(make_problem(scenario), options);
  EXPECT_LT(result.iterations, 50'000);
  EXPECT_LE(result.cost, 1.05 * result.lower_bound.value() + 1e-6);
}

TEST(GoalSet, TraceFallsToTheCostOfTheAnswer) {
  const PlanResult result = plan(make_problem(docks(6)), with_iterations(3000));
  ASSERT_FALSE(result.anytime.empty());
  for (std::size_t i = 1; i < result.anytime.size(); ++i) {
    EXPECT_LE(result.anytime[i].cost, result.anytime[i - 1].cost);
    EXPECT_GE(result.anytime[i].iteration, result.anytime[i - 1].iteration);
    EXPECT_GE(result.anytime[i].time, result.anytime[i - 1].time);
  }
  EXPECT_NEAR(result.anytime.back().cost, result.cost, 1e-6);
}

TEST(GoalSet, IsTakenByEveryPlanner) {
  GoalRegion any = region_of_pose({20, 6, 0});
  any.heading = any_heading;
  const Problem problem = make_problem(yard({region_of_pose({45, 20, 1}), any}));
  for (const Planner& planner : planners()) {
    PlanOptions options = with_iterations(is_sanitized ? 300 : 6000);
    if (honours(planner, "region")) options.planner.set("region", "scene");
    const PlanResult result = plan(problem, planner, options);
    EXPECT_NE(result.status, PlanStatus::rejected) << planner.name << ": " << result.reason;
    EXPECT_LE(result.iterations, options.budget.max_iterations) << planner.name;
    if (is_sanitized) continue;
    EXPECT_EQ(result.status, PlanStatus::solved) << planner.name << ": " << result.reason;
    EXPECT_EQ(result.goal.has_value(), result.path.has_value()) << planner.name;
  }
}

// ---- Everything together ----

enum class Hauls { alone, rig };
using SetCombination = std::tuple<Hauls, Steering, CostMeasure, bool, double>;

class OfASet : public testing::TestWithParam<SetCombination> {};

std::string name_of_set(const testing::TestParamInfo<SetCombination>& info) {
  const auto& [who, steering, measure, has_movers, margin] = info.param;
  constexpr const char* steerings[] = {"Arcs", "BetweenStops", "Continuous"};
  std::string name = who == Hauls::rig ? "Rig" : "Truck";
  name += steerings[static_cast<int>(steering)];
  if (measure == CostMeasure::time) name += "Time";
  if (has_movers) name += "Movers";
  if (margin > 0) name += "Margin";
  return name;
}

TEST_P(OfASet, EverythingIsPlanned) {
  const auto& [who, steering, measure, has_movers, margin] = GetParam();
  GoalRegion bay = region({30, 34}, {4, 5}, {-0.2, 0.2});
  if (who == Hauls::rig) bay.hitch_angle = {-0.2, 0.2};
  Scenario scenario = yard({region_of_pose({60, 20, 0}), bay}, {box(14, -6, 16, 3)});
  if (who == Hauls::rig) scenario.vehicle = semitrailer();
  if (has_movers) scenario.moving = {car_across(24)};
  const PlanOptions options = combined(steering, measure, margin, 2500, 100);
  const Problem problem = make_problem(scenario);
  const PlanResult result = plan(problem, options);
  if (!is_planned(result)) return;
  EXPECT_EQ(result.goal->index, 1U);
  EXPECT_EQ(result.speeds.has_value(), has_movers);
  PathClaims claims{.clearance = options.clearance, .steering = steering, .goal = result.goal};
  claims.cost = StatedCost{.cost = result.cost, .rule = result.rule};
  const PathCheck check = check_path(problem, *result.path, claims);
  EXPECT_TRUE(check.valid) << check.reason;
}

INSTANTIATE_TEST_SUITE_P(OfTheDefaultPlanner, OfASet,
                         testing::Combine(testing::Values(Hauls::alone, Hauls::rig),
                                          testing::Values(Steering::reeds_shepp,
                                                          Steering::continuous_between_stops,
                                                          Steering::continuous),
                                          testing::Values(CostMeasure::prices, CostMeasure::time),
                                          testing::Bool(), testing::Values(0.0, 0.3)),
                         name_of_set);

TEST_P(OfASet, EndsStraight) {
  const auto& [who, steering, measure, has_movers, margin] = GetParam();
  GoalRegion dock = region_of_pose({34, 16, pi / 2});
  dock.straight = 6;
  dock.either_way = true;
  Scenario scenario = yard({dock}, {box(14, -6, 16, 3)});
  if (who == Hauls::rig) scenario.vehicle = semitrailer();
  if (has_movers) scenario.moving = {car_across(24)};
  const PlanOptions options = combined(steering, measure, margin, 2500, 100);
  const Problem problem = make_problem(scenario);
  const PlanResult result = plan(problem, options);
  if (!is_planned(result)) return;
  EXPECT_EQ(result.path->segments.back().curvature, 0.0);
  EXPECT_GE(std::abs(result.path->segments.back().length), 6.0);
}

TEST(GoalSet, EndsStraightInTheGearThatIsAllowed) {
  GoalRegion dock = region_of_pose({10, 10, pi / 2});
  dock.straight = 6;
  const Problem problem = make_problem(yard({dock}));
  for (const AllowedGears gears : {AllowedGears::forward, AllowedGears::reverse}) {
    PlanOptions options = with_iterations(2000);
    options.cost.gears = gears;
    const PlanResult result = plan(problem, options);
    expect_at_goal(problem, result);
    EXPECT_EQ(result.path->segments.back().length > 0.0, gears == AllowedGears::forward);
  }
}

// A long line would carry an error of the way before it to the goal.
TEST(GoalSet, EndsStraightAtTheGoalAfterALongLine) {
  PlanOptions options = with_iterations(100);
  options.cost = {.forward_weight = 1.0, .reverse_weight = 1.2, .gear_change_cost = 0.2};
  options.steering = Steering::reeds_shepp;
  for (int i = 0; i < 40; ++i) {
    GoalRegion dock = region_of_pose({30 + 0.37 * i, 10, 1e-6 * i});
    dock.straight = 25;
    const PlanResult result = plan(make_problem(yard({dock})), options);
    EXPECT_EQ(result.status, PlanStatus::solved) << i << ": " << result.reason;
  }
}

// Forward on a line the trailer straightens, so before it the rig would be folded up.
TEST(GoalSet, EndsStraightWhereARigIsNotFoldedUp) {
  GoalRegion dock = region_of_pose({20, 4, 0});
  dock.straight = 6;
  dock.hitch_angle = {1.0, 1.0};
  Scenario scenario = yard({dock});
  scenario.vehicle = semitrailer();
  PlanOptions options = with_iterations(is_sanitized ? 200 : 3000);
  options.cost.gears = AllowedGears::forward;
  EXPECT_EQ(plan(make_problem(scenario), options).status, PlanStatus::no_path);
  options.cost.gears = AllowedGears::both;
  const PlanResult result = plan(make_problem(scenario), options);
  ASSERT_TRUE(!result.path || result.path->segments.back().length < 0.0);
}

// In reverse an error of the hitch angle grows by a factor of e in each length of the trailer. A
// drive from where the line begins has none.
TEST(GoalSet, NoTrailerIsBackedFartherThanRoundingAllows) {
  Scenario scenario = yard({});
  scenario.vehicle = semitrailer();
  scenario.bounds = {-300, 300, -300, 300};
  const auto backed = [&](double start, double length) {
    scenario.start = {start, 0, 0};
    GoalRegion dock = region_of_pose({0, 0, 0});
    dock.straight = length;
    dock.hitch_angle = {0.0, 0.0};
    scenario.goal_set = {dock};
    PlanOptions options = with_iterations(is_sanitized ? 200 : 2000);
    options.cost.gears = AllowedGears::reverse;
    return plan(make_problem(scenario), options);
  };
  const double most = std::log(1e4) * semitrailer().trailer->wheelbase;
  EXPECT_EQ(backed(most + 20, most - 0.1).status, PlanStatus::solved);
  const PlanResult result = backed(most + 20, most + 0.1);
  EXPECT_EQ(result.status, PlanStatus::goal_in_collision);  // nothing is proven
  EXPECT_TRUE(result.reason.ends_with("it is too long to back a trailer")) << result.reason;
  EXPECT_EQ(backed(140, 140).status, PlanStatus::solved);
}

TEST(GoalSet, EndsStraightByEveryPlanner) {
  GoalRegion dock = region_of_pose({30, 10, 0});
  dock.straight = 6;
  const Problem problem = make_problem(yard({dock}));
  for (const Planner& planner : planners()) {
    PlanOptions options = with_iterations(is_sanitized ? 300 : 6000);
    if (honours(planner, "region")) options.planner.set("region", "scene");
    const PlanResult result = plan(problem, planner, options);
    EXPECT_NE(result.status, PlanStatus::rejected) << planner.name << ": " << result.reason;
  }
}

TEST(GoalSet, SaysThatNothingComesStraightToTheGoal) {
  GoalRegion dock = region_of_pose({30, 0, 0});
  dock.straight = 20;
  // Posts 15 m ahead and behind.
  const PlanResult result = plan(
      make_problem(yard({dock}, {box(10, -1, 11, 1), box(50, -1, 51, 1)})), with_iterations(500));
  EXPECT_EQ(result.status, PlanStatus::no_path);
  EXPECT_EQ(result.reason,
            "before none of the 2 poses of the goal that were looked at there is a free straight "
            "last stretch");
}

TEST(GoalSet, SaysThatNothingComesStraightToAnArea) {
  GoalRegion bay = region({28, 30}, {-1, 1}, {-0.1, 0.1});
  bay.straight = 20;
  const PlanResult result = plan(
      make_problem(yard({bay}, {box(10, -9, 11, 9), box(50, -9, 51, 9)})), with_iterations(500));
  EXPECT_EQ(result.status, PlanStatus::node_limit);  // nothing is proven
  EXPECT_TRUE(result.reason.ends_with("there is a free straight last stretch")) << result.reason;
  EXPECT_EQ(result.iterations, 0);
}

TEST(GoalSet, DrivesTheLastStretchAgainIfTheStartIsTheGoal) {
  GoalRegion dock = region_of_pose({0, 0, 0});
  dock.straight = 5;
  const PlanResult result = plan(make_problem(yard({dock})), by_length(500));
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_NEAR(length(*result.path), 10.0, 1e-6);
  dock = region_of_pose({5, 0, 0});
  dock.straight = 5;
  const PlanResult line = plan(make_problem(yard({dock})), by_length(500));
  ASSERT_EQ(line.status, PlanStatus::solved) << line.reason;
  EXPECT_NEAR(length(*line.path), 5.0, 1e-9);
}

TEST(GoalSet, GivesTheMarginWayAtTheGoalThatIsTaken) {
  Scenario scenario = yard({region_of_pose({20, 0, 0}), region_of_pose({30, 0, 0})},
                           {box(26, -1, 27, 1), box(36, -1, 37, 1)});  // 0.1 m ahead
  PlanOptions options = with_iterations(2000);
  options.clearance = {.margin = 0.3, .margin_ramp = 6.0};
  const PlanResult result = plan(make_problem(scenario), options);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_EQ(result.goal->index, 0U);
  options.clearance.margin_ramp = 0.0;
  EXPECT_EQ(plan(make_problem(scenario), options).status, PlanStatus::goal_in_collision);
}

TEST(GoalSet, OfATrailerIsWhereItsAxleIs) {
  GoalRegion bay = region({10, 12}, {0, 0}, {0, 0});
  bay.is_of_trailer = true;
  bay.hitch_angle = {-0.3, 0.3};
  Scenario scenario = yard({bay});
  scenario.vehicle = semitrailer();
  const Problem problem = make_problem(scenario);
  const PlanResult result = plan(problem, by_length(is_sanitized ? 300 : 4000));
  if (is_sanitized && !result.path) return;
  expect_at_goal(problem, result);
  State end{result.path->start, 0.0};
  for (const Segment& segment : result.path->segments) {
    end = advance(problem.vehicle(), end, segment);
  }
  const Pose axle = trailer_pose(problem.vehicle(), end);
  EXPECT_GT(axle.x, 10 - 1e-5);
  EXPECT_LT(axle.x, 12 + 1e-5);
  EXPECT_NEAR(axle.y, 0.0, 1e-5);
  EXPECT_NEAR(axle.heading, 0.0, 1e-5);
}

TEST(GoalSet, IsSmoothedToTheGoalThatWasReached) {
  const Problem problem = make_problem(docks(4));
  PlanOptions options = with_iterations(1500);
  options.steering = Steering::reeds_shepp;
  const PlanResult planned = plan(problem, options);
  ASSERT_TRUE(planned.path);
  const Smoothed smoothed =
      smooth(problem, *planned.path, SmoothMethod::optimised, with_iterations(500));
  ASSERT_TRUE(smoothed.result.path) << smoothed.result.reason;
  const Smoothed given =
      smooth(problem, *planned.path, SmoothMethod::clothoids, with_iterations(0));
  EXPECT_EQ(given.result.goal.has_value(), given.result.path.has_value());
  EXPECT_EQ(smoothed.result.goal->index, planned.goal->index);
  expect_at_goal(problem, smoothed.result);
}

TEST(GoalSet, IsDrivenToWhilePlanningAnew) {
  Scenario scenario = docks(4);
  ReplanOptions options;
  options.plan.budget.max_iterations = is_sanitized ? 300 : 3000;
  Replanner replanner(scenario, options);
  const ReplanAnswer first = replanner.tick(0.0);
  if (is_sanitized && !first.reaches_goal) return;
  ASSERT_TRUE(first.reaches_goal) << first.reason;
  const Problem problem = make_problem(scenario);
  const std::optional<ReachedGoal> goal = check_path(problem, first.drive->path).goal;
  ASSERT_TRUE(goal);
  // Somebody parks there: it drives to another one.
  const Pose taken = goal->pose;
  replanner.patch({.added = {{1, box(taken.x - 1, taken.y - 2, taken.x + 1, taken.y - 1)}}});
  std::optional<ReachedGoal> other;
  for (int i = 1; i < 12 && !other; ++i) {
    const ReplanAnswer& answer = replanner.tick(0.1 * i);
    if (!answer.reaches_goal) continue;
    const Pose end = end_pose(answer.drive->path);
    for (std::size_t k = 0; k < scenario.goal_set.size(); ++k) {
      const GoalRegion& dock = scenario.goal_set[k];
      if (std::hypot(end.x - dock.x.least, end.y - dock.y.least) < 1e-5) {
        other = ReachedGoal{k, end};
      }
    }
  }
  if (is_sanitized) return;
  ASSERT_TRUE(other);
  EXPECT_NE(other->index, goal->index);
}

// ---- What is proven ----

TEST(GoalSet, NoPathToARegionIsShorterThanItsBound) {
  for_each_case(4711, 300, [](Rng& rng) {
    GoalRegion any;
    const auto interval = [&](double reach, double width) {
      const double least = uniform(-reach, reach, rng);
      return Interval{least, least + (chance(0.4, rng) ? 0.0 : uniform(0, width, rng))};
    };
    any.x = interval(30, 10);
    any.y = interval(30, 10);
    const auto [from, to] = interval(pi, 2 * pi);
    any.heading = chance(0.2, rng) ? any_heading : HeadingRange{from, to};
    any.either_way = chance(0.3, rng);
    const Problem problem = make_problem(yard({any}));
    const Task& task = problem.task();
    const double bound = planning::length_lower_bound_to(task, 0, 2000, search::Budget({}));
    double least = endless_cost;
    for (std::size_t i = 0; i < 500; ++i) {
      const planning::GoalPoint point = planning::point_of_sequence(task, 0, i);
      const Pose pose = planning::state_of(task, point).pose;
      least = std::min(least,
                       reeds_shepp_length(task.start, pose, problem.vehicle().min_turning_radius));
    }
    EXPECT_LE(bound, least);
    EXPECT_GE(bound, 0.5 * least - 3.0);
  });
}

TEST(GoalSet, PointsOfARegionAreInIt) {
  for_each_case(815, 200, [](Rng& rng) {
    const Polygon area = {{0, 0}, {10, 0}, {10, 8}, {5, 2}, {0, 8}};
    GoalRegion any =
        region({1, 3}, {-2, uniform(-2, 2, rng)}, {uniform(-7, 7, rng), uniform(-7, 7, rng)});
    if (width(any.heading) > 2 * pi) return;
    if (chance(0.5, rng)) any.area = area;
    any.either_way = chance(0.5, rng);
    const Problem problem = make_problem(yard({any}));
    planning::GoalPoint point = planning::point_of_sequence(
        problem.task(), 0, static_cast<std::size_t>(uniform(0, 4000, rng)));
    if (chance(0.5, rng)) {
      const auto others = planning::beside(problem.task(), point, uniform(0, 0.5, rng));
      if (!others.empty()) point = others[rng() % others.size()];
    }
    const Pose pose = planning::state_of(problem.task(), point).pose;
    const PathCheck check = check_path(problem, {{}, {}});
    EXPECT_FALSE(check.goal.has_value() && check.valid && any.area.empty());
    // The judge agrees: a path of no length that stands there ends at the goal.
    Scenario there = yard({any});
    there.start = pose;
    there.goal_set = {any};
    const PathCheck stands = check_path(make_problem(there), {pose, {}});
    EXPECT_TRUE(stands.valid) << stands.reason << as_code(pose.x) << " " << as_code(pose.y);
  });
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Costs from everywhere on a site to its goals, and the ways that they stand for.
#include "vandplan/site_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stop_token>
#include <string>
#include <vector>

#include "sites/data.h"
#include "sites/way.h"
#include "support/cases.h"
#include "support/problems.h"
#include "support/sites.h"
#include "support/zoned.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using sites::SiteData, sites::SiteState;
using std::numbers::pi;
using namespace sites;

/// A yard of boxes with a goal, free start and goal.
Scenario yard(Rng& rng) {
  while (true) {
    Scenario scenario{.bounds = area,
                      .start = uniform_pose({-30, 30, -30, 30}, rng),
                      .goal = uniform_pose({-30, 30, -30, 30}, rng)};
    for (int i = 0; i < 6; ++i) {
      const double x = uniform(-35, 30, rng);
      const double y = uniform(-35, 30, rng);
      scenario.obstacles.push_back(box(x, y, x + uniform(1, 8, rng), y + uniform(1, 8, rng)));
    }
    const Problem problem = make_problem(scenario);
    const CollisionChecker& checker = *problem.task().checker;
    if (checker.is_free(problem.task().start) && checker.is_free(problem.task().goal)) {
      return scenario;
    }
  }
}

Problem from(const Problem& problem, const Pose& start, const Pose& goal) {
  return with_poses(problem, start, goal);
}

// ---- ways ----

TEST(SiteTable, WaysAreAcceptedByTheJudgeAtTheirCost) {
  int ways = 0;
  for_each_case(1, 12, [&](Rng& rng) {
    const Problem problem = make_problem(yard(rng));
    for (const PlanOptions& options : {drivers_options(), length_options()}) {
      const SiteTable table = table_to(problem, options);
      for (int i = 0; i < 10; ++i) {
        const Problem other = from(problem, uniform_pose({-30, 30, -30, 30}, rng), problem.goal());
        if (!other.task().checker->is_free(other.task().start)) continue;
        const auto way = site_way(table, other, options);
        if (!way) continue;
        ++ways;
        EXPECT_EQ(way->path.start, other.start());
        const PathCheck check = check_path(other, way->path);
        EXPECT_TRUE(check.valid) << check.reason;
      }
    }
  });
  EXPECT_GT(ways, 12.5 * cases(12));
}

TEST(SiteTable, WaysOnOpenGroundCostLittleMoreThanTheShortest) {
  // Specks in two corners make the table as large as the area.
  const std::vector<Polygon> specks = {box(39, 39, 40, 40), box(-40, -40, -39, -39)};
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, specks, area);
  const PlanOptions options = length_options();
  const SiteTable table = table_to(problem, options);
  double sum = 0.0;
  double least = 0.0;
  for_each_case(2, 100, [&](Rng& rng) {
    const Problem other = from(problem, uniform_pose({-30, 30, -30, 30}, rng), {0, 0, 0});
    const auto way = site_way(table, other, options);
    ASSERT_TRUE(way);
    const double shortest = reeds_shepp_length(other.start(), {0, 0, 0}, 7.0);
    EXPECT_GE(way->cost, shortest - 1e-6);
    EXPECT_NEAR(way->cost, length(way->path), 1e-9);
    sum += way->cost;
    least += shortest;
  });
  EXPECT_LT(sum, 1.1 * least);
}

TEST(SiteTable, CostsAreThoseOfTheWays) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {box(-5, 5, 30, 6)}, area);
  const PlanOptions options = drivers_options();
  const SiteTable table = table_to(problem, options);
  double sum = 0.0;
  int ways = 0;
  for_each_case(3, 200, [&](Rng& rng) {
    const Problem other = from(problem, uniform_pose({-24, 30, -19, 25}, rng), {0, 0, 0});
    const auto way = site_way(table, other, options);
    const double cost = table.cost(other.start(), 0);
    if (!way || std::isinf(cost)) return;
    sum += std::abs(cost / way->cost - 1);
    ++ways;
  });
  EXPECT_GT(ways, 0.75 * cases(200));
  EXPECT_LT(sum / ways, 0.25);
}

TEST(SiteTable, EveryStepLeadsNearerToTheGoal) {
  const Problem problem = problem_of({20, 0, 0}, {3, 2, 1}, {box(-5, 12, 30, 14)}, area);
  const SiteTable table = table_to(problem, drivers_options());
  const SiteData& data = table.data();
  int states = 0;
  int goals = 0;
  for (SiteState state; state.row < data.grid.rows; ++state.row) {
    for (state.column = 0; state.column < data.grid.columns; ++state.column) {
      for (state.heading = 0; state.heading < data.grid.headings; ++state.heading) {
        for (const int gear : {1, -1}) {
          state.gear = gear;
          const auto entry = data.find(data.layers[0], state);
          if (!entry) continue;
          ++states;
          if (entry->is_goal) {
            ++goals;
            EXPECT_EQ(entry->cost, 0.0);
            continue;
          }
          const auto next = data.find(data.layers[0], data.after(state, *entry));
          ASSERT_TRUE(next);
          const double step = std::abs(sites::site_step(data.grid, state.gear, entry->arc).length);
          EXPECT_GE(entry->cost - next->cost, step - 4 * table.rounding(0));
        }
      }
    }
  }
  EXPECT_GT(states, 20'000);
  EXPECT_EQ(goals, 1);
}

// The bounds are 40 cells wide. The grid has one more column and row, where only the bounds begin.
TEST(SiteTable, NoStateLiesBeyondTheBounds) {
  const Problem problem =
      problem_of({-20, 0, 0}, {15, 15, 0.3}, {box(-35, -35, -34, -34), box(34, 34, 35, 35)},
                 {-35, 35, -35, 35});
  const SiteTable table = table_to(problem, length_options());
  const SiteData& data = table.data();
  ASSERT_EQ(data.grid.columns, 41);
  const auto count_at = [&](std::int32_t column, std::int32_t row) {
    int count = 0;
    SiteState state{.column = column, .row = row};
    for (; state.heading < data.grid.headings; ++state.heading) {
      for (const int gear : {1, -1}) {
        state.gear = gear;
        count += data.find(data.layers[0], state) ? 1 : 0;
      }
    }
    return count;
  };
  int before = 0, beyond = 0;
  for (std::int32_t i = 0; i < 41; ++i) {
    before += count_at(39, i) + count_at(i, 39);
    beyond += count_at(40, i) + count_at(i, 40);
  }
  EXPECT_GT(before, 1000);
  EXPECT_EQ(beyond, 0);
}

TEST(SiteTable, ReachesItsFreeStarts) {
  const Problem problem = problem_of({20, 20, 0}, {-20, -20, 0}, {}, {-60, 60, -60, 60});
  SiteTableOptions options = coarse;
  const auto reach = [&](const std::vector<Pose>& starts) {
    options.starts = starts;
    return table_to(problem, drivers_options(), options).bounds().x_max;
  };
  const double without = reach({});
  EXPECT_NEAR(without, 0.0, 2.0);
  EXPECT_NEAR(reach({{20, 20, 0}, {-30, 0, 1}}), 40.0, 2.0);
  EXPECT_EQ(reach({{61, 0, 0}}), without);  // outside of the bounds
  EXPECT_FALSE(std::isinf(table_to(problem, drivers_options(), {.starts = {problem.start()}})
                              .cost(problem.start(), 0)));
  EXPECT_EQ(refusal([&] { (void)reach({{20, 20, 0}, {NAN, 0, 0}}); }).substr(0, 10), "starts[1]:");
}

TEST(SiteTable, KnowsNoWayThroughAWall) {
  const std::vector<Polygon> wall = {box(-40, 5, 40, 6)};
  const Problem problem = problem_of({20, 20, 0}, {0, 0, 0}, wall, area);
  const SiteTable table = table_to(problem, drivers_options());
  EXPECT_TRUE(std::isinf(table.cost({20, 20, 0}, 0)));
  EXPECT_TRUE(std::isinf(table.cost({1000, 0, 0}, 0)));
  EXPECT_FALSE(std::isinf(table.cost({20, -15, 0}, 0)));
  EXPECT_FALSE(site_way(table, problem, drivers_options()));
}

TEST(SiteTable, KeepsToOneGear) {
  PlanOptions options = drivers_options();
  options.cost.gears = AllowedGears::forward;
  const Problem problem = problem_of({-20, 10, 0}, {0, 0, 0}, {box(-12, -3, -8, 3)}, area);
  const auto way = site_way(table_to(problem, options), problem, options);
  ASSERT_TRUE(way);
  for (const Segment& segment : way->path.segments) EXPECT_GT(segment.length, 0.0);
}

TEST(SiteTable, KeepsTheMargin) {
  PlanOptions options = drivers_options();
  options.clearance.margin = 0.5;
  const std::vector<Polygon> gate = {box(-1, 1.6, 1, 40), box(-1, -40, 1, -1.6)};
  const Problem problem = problem_of({-20, 0, 0}, {20, 0, 0}, gate, area);
  const SiteTableOptions fine;
  EXPECT_TRUE(site_way(table_to(problem, drivers_options(), fine), problem, drivers_options()));
  EXPECT_FALSE(site_way(table_to(problem, options, fine), problem, options));
}

TEST(SiteTable, WaysKeepToTheRulesOfZones) {
  // Two lanes through a wall; one leads to the east, the other one to the west.
  Scenario scenario =
      with_zones({-20, 0, 0}, {30, 0, 0},
                 {{.area = box(0, -9, 8, 0), .direction = HeadingRange{pi - 0.6, pi + 0.6}},
                  {.area = box(0, 0, 8, 9), .direction = HeadingRange{-0.6, 0.6}},
                  {.area = box(12, -40, 16, -5), .closed = true}});
  scenario.obstacles = {box(0, 9, 8, 40), box(0, -40, 8, -9)};
  const Problem problem = make_problem(scenario);
  const SiteTable table = table_to(problem, drivers_options());
  int ways = 0;
  for_each_case(6, 40, [&](Rng& rng) {
    const Problem other = from(problem, uniform_pose({-35, 30, -30, 30}, rng), problem.goal());
    const auto way = site_way(table, other, drivers_options());
    if (!way) return;
    ++ways;
    const PathCheck check = check_path(other, way->path);
    EXPECT_TRUE(check.valid) << check.reason;
  });
  EXPECT_GT(ways, 0.375 * cases(40));
}

TEST(SiteTable, WaysLeadAroundDearGround) {
  const Zone dear{.area = box(-5, -8, 5, 8), .cost = 5.0};
  Scenario scenario = with_zones({-20, 0, 0}, {20, 0, 0}, {dear});
  scenario.obstacles = {box(-30, -30, -29, -29)};  // makes the table reach the start
  const Problem problem = make_problem(scenario);
  scenario.zones.clear();
  const Problem cheap = make_problem(scenario);
  const auto way = site_way(table_to(problem, drivers_options()), problem, drivers_options());
  ASSERT_TRUE(way);
  EXPECT_GT(way->path.segments.size(), 1U);
  EXPECT_NEAR(way->cost, cost_of(problem, way->path, drivers_options().cost), 0.05);
  EXPECT_LT(way->cost, 60);  // 80 straight on
  const auto straight = site_way(table_to(cheap, drivers_options()), cheap, drivers_options());
  ASSERT_TRUE(straight);
  EXPECT_LT(straight->cost, 42);
}

TEST(SiteTable, StepsFarFromDearGroundNeedNotAskForItsPrice) {
  // A price so small that no cost shows it makes all steps ask.
  const Zone everywhere{.area = box(-40, -40, 80, 40), .cost = 1 + 1e-15};
  const OccupancyGrid cells{.origin = {12, -10, 0.3},
                            .columns = 4,
                            .rows = 6,
                            .cells = std::vector<Cell>(24, Cell::occupied)};
  for (const bool body : {false, true}) {
    const Zone dear{.area = box(-5, -8, 5, 8), .cost = 5.0, .body = body};
    Scenario scenario = with_zones({-20, 0, 0}, {20, 0, 0}, {dear});
    scenario.obstacles = {box(-30, -30, -29, -29)};
    scenario.masks = {cost_mask(cells, 3.0)};
    const SiteTable near = table_to(make_problem(scenario), drivers_options());
    scenario.zones.push_back(everywhere);
    const SiteTable all = table_to(make_problem(scenario), drivers_options());
    constexpr std::size_t head = 96;  // it names the world
    EXPECT_EQ(site_table_to_bytes(near).substr(head), site_table_to_bytes(all).substr(head));
  }
}

TEST(SiteTable, WhatItsStepsTouchIsNoWay) {
  // The table was made for a world without the wall: only its steps tell.
  const Pose start{-30, 0, 0};
  const Pose goal{30, 0, 0};
  const Problem open = problem_of(start, goal, {box(-40, 39, 40, 40)}, area);
  const Problem walled = problem_of(start, goal, {box(20, -40, 21, 40)}, area);
  const SiteTable table = table_to(open, length_options());
  const auto finds = [&](const Problem& problem) {
    sites::Ways ways(table.data(), table.data().layers[0], problem.task(), {});
    return ways.find(problem.task().start).has_value();
  };
  EXPECT_TRUE(finds(open));
  EXPECT_FALSE(finds(walled));
}

// ---- many starts ----

TEST(SiteMatrix, HoldsTheCostsOfAllPairs) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {box(9, 9, 12, 12)}, area);
  const std::vector<Pose> goals = {{0, 0, 0}, {10, -5, 2}};
  const SiteTable table = make_site_table(problem, goals, drivers_options(), coarse).value();
  const std::vector<Pose> starts = {{18, 15, 0}, {10, 10, 0}, {-9, 3, 2}};
  const std::vector<SiteCost> costs = site_matrix(table, problem, starts, drivers_options(), 2);
  ASSERT_EQ(costs.size(), 6U);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const Problem pair = from(problem, starts[i / 2], goals[i % 2]);
    const auto way = site_way(table, pair, drivers_options());
    EXPECT_GT(costs[i].lower_bound, 0.0);
    if (i / 2 == 1) {  // not free
      EXPECT_TRUE(std::isinf(costs[i].cost));
      continue;
    }
    ASSERT_TRUE(way);
    EXPECT_EQ(costs[i].cost, way->cost);
    EXPECT_LE(costs[i].lower_bound, costs[i].cost);
  }
  EXPECT_EQ(refusal([&] {
              const std::vector<Pose> far = {{18, 15, 0}, {1e300, 0, 0}};
              (void)site_matrix(table, problem, far, drivers_options());
            }).substr(0, 10),
            "starts[1]:");
}

TEST(SiteMatrix, LowerBoundsHoldForPlans) {
  for_each_case(5, 4, [&](Rng& rng) {
    const Problem problem = make_problem(yard(rng));
    PlanOptions options{.steering = Steering::reeds_shepp};
    options.budget.max_iterations = 2000;
    const PlanOptions all = complete(default_planner(), options);
    const std::vector<Pose> starts = {problem.start()};
    const std::vector<SiteCost> costs = site_matrix(table_to(problem, all), problem, starts, all);
    const PlanResult result = plan(problem, options);
    if (!result.path) return;
    EXPECT_LE(costs[0].lower_bound, result.cost);
  });
}

/// Expects that no plan from beside the goal, or from 5 m behind it, costs less than its bound.
void expect_bounds_beside_the_goal(const Problem& problem, PlanOptions options) {
  const Pose& goal = problem.goal();
  const double cos = 5 * std::cos(goal.heading);
  const double sin = 5 * std::sin(goal.heading);
  std::vector<Pose> starts = {goal};
  for (const double size : {0.0, 1e-12, 1e-10, 1e-9, 1e-7, 1e-6, 1e-4}) {
    for (const double off : {size, -size}) {
      const auto& [x, y, heading] = goal;
      starts.insert(starts.end(), {{x + off, y, heading}, {x, y + off, heading}});
      starts.insert(starts.end(), {{x, y, heading + off}, {x - cos, y - sin, heading + off}});
    }
  }
  const std::vector<SiteCost> costs =
      site_matrix(table_to(problem, options), problem, starts, options);
  options.budget.max_iterations = 20;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    EXPECT_LE(costs[i].lower_bound, costs[i].cost) << i;
    const PlanResult planned = plan(from(problem, starts[i], goal), options);
    ASSERT_TRUE(planned.path) << i;
    EXPECT_LE(costs[i].lower_bound, planned.cost) << i;
  }
}

// A path may end beside its goal, by as much as the judge allows, and an empty one changes no gear.
TEST(SiteMatrix, LowerBoundsHoldForPlansThatEndBesideTheGoal) {
  PlanOptions one_gear = drivers_options();
  one_gear.cost.gears = AllowedGears::forward;
  one_gear.cost.initial_gear = InitialGear::reverse;
  PlanOptions equal_gears = drivers_options();
  equal_gears.cost.gear_change_cost = 0.0;
  const Problem problem = problem_of({20, 0, 0}, {3, 4, 1}, {box(9, 9, 12, 12)}, area);
  for (const PlanOptions& options : {drivers_options(), length_options(), one_gear, equal_gears}) {
    expect_bounds_beside_the_goal(problem, options);
  }
  const Zone dear{.area = box(20, -10, 21, -9), .cost = 2.0};
  for (const double heading : {1.0, -2.4636, -2.4517, 1.3247}) {
    const Pose goal{26.25, 7.921, heading};
    expect_bounds_beside_the_goal(make_problem(with_zones({-20, 0, 0}, goal, {dear})),
                                  length_options());
  }
}

TEST(SiteMatrix, DoesNotDependOnOtherStarts) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {box(9, 9, 12, 12)}, area);
  const SiteTable table = table_to(problem, drivers_options());
  Rng rng(7);
  std::vector<Pose> starts;
  for (int i = 0; i < cases(300); ++i) starts.push_back(uniform_pose({-30, 30, -30, 30}, rng));
  const std::vector<SiteCost> all = site_matrix(table, problem, starts, drivers_options(), 2);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const auto alone = site_matrix(table, problem, {&starts[i], 1}, drivers_options());
    EXPECT_EQ(all[i].cost, alone[0].cost);
  }
}

TEST(SiteMatrix, KeepsTheMarginsOfEachStart) {
  // Behind the second start stands what only a ramp allows so near.
  PlanOptions options = drivers_options();
  options.clearance = {.margin = 0.5, .margin_ramp = 6.0};
  const double end = -20 - footprint(Vehicle{}).rear - 0.25;
  const Problem problem = problem_of({-20, 0, 0}, {20, 0, 0}, {box(end - 1, -1, end, 1)}, area);
  const SiteTable table = table_to(problem, options);
  const std::vector<Pose> starts = {{-20, -15, 0}, {-20, 0, 0}};
  const std::vector<SiteCost> costs = site_matrix(table, problem, starts, options);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const auto way = site_way(table, from(problem, starts[i], problem.goal()), options);
    ASSERT_TRUE(way);
    EXPECT_EQ(costs[i].cost, way->cost);
  }
}

TEST(SiteMatrix, LowerBoundsHoldForWays) {
  for_each_case(8, 10, [&](Rng& rng) {
    const Problem problem = make_problem(yard(rng));
    for (const PlanOptions& options : {drivers_options(), length_options()}) {
      std::vector<Pose> starts;
      for (int i = 0; i < 500; ++i) starts.push_back(uniform_pose({-30, 30, -30, 30}, rng));
      for (const SiteCost& cost :
           site_matrix(table_to(problem, options), problem, starts, options)) {
        EXPECT_LE(cost.lower_bound, cost.cost);
      }
    }
  });
}

// ---- who makes it ----

TEST(SiteTable, ThreadsChangeNothing) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {box(9, 9, 12, 12)}, area);
  const std::vector<Pose> goals = {{0, 0, 0}, {10, -5, 2}, {-20, 3, 1}};
  SiteTableOptions options = coarse;
  std::size_t done = 0;
  options.progress = [&done](std::size_t goals_done) { EXPECT_EQ(goals_done, ++done); };
  const SiteTable one = make_site_table(problem, goals, drivers_options(), options).value();
  EXPECT_EQ(done, goals.size());
  options.threads = 3;
  options.progress = {};
  const SiteTable three = make_site_table(problem, goals, drivers_options(), options).value();
  EXPECT_EQ(site_table_to_bytes(one), site_table_to_bytes(three));
  EXPECT_EQ(one.goals(), goals);
  for (std::size_t i = 0; i < goals.size(); ++i) {
    EXPECT_EQ(one.cost(goals[i], i), 0.0);
    EXPECT_GT(one.cost(goals[i], (i + 1) % goals.size()), 5.0);
    const auto way = site_way(one, from(problem, {20, 0, 0}, goals[i]), drivers_options());
    ASSERT_TRUE(way);
    EXPECT_EQ(way->goal, i);
  }
}

TEST(SiteTable, OfSomeGoalsIsThatMadeForThem) {
  const Problem problem =
      problem_of({20, 0, 0}, {0, 0, 0}, {box(-39, -39, 39, -38), box(-39, 38, 39, 39)}, area);
  const auto made = [&](const std::vector<Pose>& goals) {
    return make_site_table(problem, goals, drivers_options(), coarse).value();
  };
  const SiteTable all = made({{0, 0, 0}, {10, -5, 2}, {-20, 3, 1}});
  const std::vector<Pose> some = {{-20, 3, 1}, {0, 0, 0}};
  const SiteTable chosen = all.with_goals(some);
  EXPECT_EQ(chosen.goals(), some);
  EXPECT_EQ(chosen.cost({10, 10, 0}, 0), all.cost({10, 10, 0}, 2));
  EXPECT_EQ(site_table_to_bytes(chosen), site_table_to_bytes(made(some)));
}

TEST(SiteMatrix, HasNoCostToAGoalThatIsNotFree) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {box(9, 9, 12, 12)}, area);
  SiteTableOptions options = coarse;
  options.allows_blocked_goals = true;
  const std::vector<Pose> goals = {{10, 10, 0}, {0, 0, 0}};
  const SiteTable table = make_site_table(problem, goals, drivers_options(), options).value();
  const std::vector<Pose> starts = {{18, 15, 0}};
  const std::vector<SiteCost> costs = site_matrix(table, problem, starts, drivers_options());
  EXPECT_EQ(costs[0].outcome, SiteOutcome::goal_in_collision);
  EXPECT_TRUE(std::isinf(costs[0].cost));
  EXPECT_GT(costs[0].lower_bound, 0.0);
  EXPECT_EQ(costs[1].outcome, SiteOutcome::way);
}

TEST(SiteTable, IsNotMadeWhenStopped) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {}, area);
  std::stop_source stop;
  SiteTableOptions options = coarse;
  options.stop = stop.get_token();
  options.progress = [&stop](std::size_t) { stop.request_stop(); };
  const std::vector<Pose> goals = {{0, 0, 0}, {10, -5, 2}};
  EXPECT_FALSE(make_site_table(problem, goals, drivers_options(), options));
}

// ---- planning ----

TEST(SiteTable, GivesThePlannerItsFirstPath) {
  int planned = 0;
  for_each_case(4, 6, [&](Rng& rng) {
    const Problem problem = make_problem(yard(rng));
    PlanOptions options{.steering = Steering::reeds_shepp};
    options.budget.max_iterations = 300;
    const PlanOptions all = complete(default_planner(), options);
    const SiteTable table = table_to(problem, all);
    const auto way = site_way(table, problem, all);
    if (!way) return;
    const PlanResult result = plan(problem, using_site(table, options));
    ASSERT_EQ(result.status, PlanStatus::solved);
    EXPECT_LE(result.cost, way->cost + 1e-3);
    ASSERT_FALSE(result.anytime.empty());
    EXPECT_EQ(result.anytime.front().iteration, 0);
    ++planned;
  });
  EXPECT_GE(planned, cases(6) * 2 / 3);
}

// The wheels cannot turn at once as a way says, so the vehicle leaves it a little.
TEST(SiteTable, GivesThePlannerAWayToFollow) {
  Scenario walls{.bounds = {0, 40, 0, 40},
                 .start = {4, 4, 1.57},
                 .goal = {36, 36, 1.57},
                 .obstacles = {box(9, 0, 10, 28), box(19, 12, 20, 40), box(29, 0, 30, 28)}};
  Vehicle& van = walls.vehicle;
  van.wheelbase = 3.4;
  van.front_overhang = 0.9;
  van.rear_overhang = 1.5;
  van.width = 2.1;
  van.min_turning_radius = 5.42;
  van.limits.max_steering_rate = 0.4;
  const Problem problem = make_problem(walls);
  PlanOptions options;
  options.budget.max_iterations = 200;
  const PlanOptions all = complete(default_planner(), options, problem.vehicle());
  const std::pair<Pose, Pose> pairs[] = {{{1.635, 38.713, -0.6487}, {37.221, 2.328, -0.7335}},
                                         {{1.635, 38.713, -0.6487}, {33.832, 15.888, 2.1859}}};
  for (const auto& [start, goal] : pairs) {
    const Problem there = from(problem, start, goal);
    const SiteTable table = *make_site_table(there, std::span(&goal, 1), all);
    const auto way = site_way(table, there, all);
    ASSERT_TRUE(way);
    const PlanResult result = plan(there, using_site(table, options));
    ASSERT_EQ(result.status, PlanStatus::solved);
    EXPECT_LT(result.cost, way->cost);
  }
}

TEST(SiteTable, OfARigIsThatOfItsTractor) {
  const std::vector<Polygon> walls = {box(-21, -40, -20, 20), box(-1, -20, 0, 40)};
  const Problem rig =
      problem_of({-31, -20, pi / 2}, {31, -10, -pi / 2}, walls, area, semitrailer());
  Vehicle tractor = rig.vehicle();
  tractor.trailer.reset();
  const PlanOptions prices = complete(default_planner(), {}, tractor);
  const SiteTable table = table_to(rig, prices);
  const Problem alone = make_problem(rig.world(), tractor, rig.start(), rig.goal());
  EXPECT_EQ(site_table_to_bytes(table), site_table_to_bytes(table_to(alone, prices)));
  EXPECT_TRUE(site_way(table, alone, prices));
  PlanOptions options;
  options.budget.max_iterations = 5000;
  EXPECT_TRUE(plan(rig, using_site(table, options)).path);
}

TEST(SiteTable, BeginsTheSearchesForTheGoalsOfASet) {
  const std::vector<Polygon> wall = {box(-38, 9, 30, 10)};
  const Problem problem = problem_of({-20, 20, 0}, {0, 0, 0}, wall, area);
  const std::vector<Pose> docks = {{0, 0, 0}, {-20, -10, 1}};
  const SiteTable table = make_site_table(problem, docks, drivers_options(), coarse).value();
  PlanOptions options;
  options.budget.max_iterations = 40;  // too few without a table
  const Problem any = with_goal_set(problem, {region_of_pose(docks[0]), region_of_pose(docks[1])});
  EXPECT_TRUE(plan(any, using_site(table, options)).path);
  EXPECT_FALSE(plan(any, options).path);
}

}  // namespace
}  // namespace vandplan

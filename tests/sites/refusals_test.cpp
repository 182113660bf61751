// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What a table of a site was made for, and what it is refused for.
#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "support/problems.h"
#include "support/sites.h"
#include "support/zoned.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan {
namespace {

using namespace sites;

TEST(SiteRefusal, HoldsForAnyStartAndSteering) {
  Scenario scenario{.bounds = area, .start = {-20.3, 10.7, 1}, .goal = {5.1, 3.3, 2}};
  scenario.obstacles = {{{0.1, 0.2}, {1.7, 0.3}, {0.9, 2.2}}};
  const SiteTable table = table_to(make_problem(scenario), drivers_options());
  scenario.start = {21.9, -12.4, 0};
  PlanOptions options = drivers_options();
  options.steering = Steering::continuous;
  const Problem other = make_problem(scenario);
  EXPECT_NE(other.world()->origin(), make_problem({.bounds = area}).world()->origin());
  EXPECT_TRUE(site_way(table, other, options));
}

TEST(SiteRefusal, IsRefusedForAnotherWorldVehicleOrPrices) {
  const std::vector<Polygon> wall = {box(-5, 5, 30, 6)};
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, wall, area);
  const SiteTable table = table_to(problem, drivers_options());
  const auto told = [&](const Problem& other, const PlanOptions& options) {
    return refusal([&] { (void)site_way(table, other, options); });
  };
  EXPECT_EQ(told(problem, drivers_options()), "no refusal");
  const std::vector<Polygon> longer = {box(-5, 5, 31, 6)};
  EXPECT_EQ(told(problem_of({20, 0, 0}, {0, 0, 0}, longer, area), drivers_options()),
            "site: the table was made for another world: bounds, obstacles, maps or zones differ");
  const Vehicle wide{.width = 2.6};
  EXPECT_EQ(told(problem_of({20, 0, 0}, {0, 0, 0}, wall, area, wide), drivers_options()),
            "site: the table was made for another vehicle: its body or radius differs");
  PlanOptions other = drivers_options();
  other.cost.reverse_weight = 3;
  EXPECT_EQ(told(problem, other),
            "site: the table was made for other options: prices (style), gears or margin differ");
  other = drivers_options();
  other.clearance.margin = 0.1;
  EXPECT_EQ(told(problem, other),
            "site: the table was made for other options: prices (style), gears or margin differ");
  EXPECT_EQ(told(problem_of({20, 0, 0}, {0, 1, 0}, wall, area), drivers_options()),
            "site: the table has no such goal, expected one of its 1");
  EXPECT_EQ(refusal([&] { table.expect_made_for(problem, other); }),
            "site: the table was made for other options: prices (style), gears or margin differ");
}

TEST(SiteRefusal, IsRefusedWithOtherZones) {
  const Zone dear{.area = box(-5, -8, 5, 8), .cost = 5.0};
  const auto problem_with = [](const Zone& zone) {
    return make_problem(with_zones({-20, 0, 0}, {20, 0, 0}, {zone}));
  };
  const SiteTable table = table_to(problem_with(dear), drivers_options());
  const auto told = [&](const Zone& zone) {
    return refusal([&] { table.expect_made_for(problem_with(zone), drivers_options()); })
        .substr(0, 41);
  };
  EXPECT_EQ(told(dear), "no refusal");
  Zone other = dear;
  other.max_speed = 2.0;  // changes no price of a path
  EXPECT_EQ(told(other), "no refusal");
  const std::string refused = "site: the table was made for another world";
  for (const auto& change : std::vector<std::function<void(Zone&)>>{
           [](Zone& zone) { zone.cost = 4.0; }, [](Zone& zone) { zone.closed = true; },
           [](Zone& zone) { zone.gears = AllowedGears::forward; },
           [](Zone& zone) {
             zone.direction = HeadingRange{0.0, 1.0};
           },
           [](Zone& zone) { zone.body = true; }, [](Zone& zone) { zone.area[0].x -= 0.01; }}) {
    other = dear;
    change(other);
    EXPECT_EQ(told(other), refused.substr(0, 41));
  }
}

TEST(SiteRefusal, IsRefusedForMovingObstaclesAndTrailers) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {box(9, 9, 12, 12)}, area);
  const SiteTable table = table_to(problem, drivers_options());
  const MovingObstacle crossing{.outline = box(-1, -1, 1, 1),
                                .trajectory = {{0.0, {0, 30, 0}}, {9.0, {0, -30, 0}}}};
  const Problem busy = with_moving(problem, std::vector{crossing});
  EXPECT_EQ(refusal([&] { (void)plan(busy, using_site(table)); }),
            "site: expected no moving obstacles: a table knows none");
  EXPECT_EQ(refusal([&] {
              (void)site_matrix(table, busy, std::vector<Pose>{{20, 0, 0}}, drivers_options());
            }),
            "site: expected no moving obstacles: a table knows none");
  EXPECT_EQ(refusal([&] { (void)table_to(busy, drivers_options()); }),
            "moving: expected none: a table knows no moving obstacles");
  const Problem rig = problem_of({20, 0, 0}, {0, 0, 0}, {box(9, 9, 12, 12)}, area, semitrailer());
  const SiteTable of_tractor = table_to(rig, drivers_options());
  const std::string no_trailer =
      "site: expected no trailer, as ways of a table are of the tractor alone: plan instead";
  EXPECT_EQ(refusal([&] { (void)site_way(of_tractor, rig, drivers_options()); }), no_trailer);
  EXPECT_EQ(refusal([&] {
              (void)site_matrix(of_tractor, rig, std::vector<Pose>{{20, 0, 0}}, drivers_options());
            }),
            no_trailer);
  const Problem any = with_goal_set(problem, {region_of_pose({0, 0, 0})});
  EXPECT_EQ(refusal([&] { (void)site_way(table, any, drivers_options()); }),
            "site: expected one goal, no set of goals or vias");
}

TEST(SiteRefusal, IsRefusedWithOptionsOutOfRange) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {box(9, 9, 12, 12)}, area);
  const auto told = [&](const std::vector<Pose>& goals, const SiteTableOptions& table,
                        const PlanOptions& options) {
    return refusal([&] { (void)make_site_table(problem, goals, options, table); });
  };
  const std::vector<Pose> goals = {{0, 0, 0}};
  EXPECT_EQ(told({}, coarse, drivers_options()), "goals: expected at least one");
  EXPECT_EQ(told(goals, {.headings = 7}, drivers_options()), "headings: expected 8 to 256");
  EXPECT_EQ(told(goals, {.cell = 2}, drivers_options()), "cell: expected 0.01 to 1 turning radii");
  EXPECT_EQ(told(goals, {.threads = 0}, drivers_options()), "threads: expected 1 to 256");
  EXPECT_EQ(
      told({{0, 0, 0}, {10, 10, 0}}, coarse, drivers_options()),
      "goals[1]: is not free (of obstacles, or by zones), expected a pose where the vehicle can "
      "stand");
  PlanOptions by_time = drivers_options();
  by_time.cost = {.measure = CostMeasure::time};
  EXPECT_EQ(told(goals, coarse, by_time), "cost: expected prices: a table knows no times");
  const Problem wide = problem_of({}, {0, 0, 0}, {box(1e5, 0, 1e5 + 1, 1), box(0, 1e5, 1, 1e5 + 1)},
                                  {-1e6, 1e6, -1e6, 1e6});
  EXPECT_EQ(refusal([&] { (void)make_site_table(wide, goals, drivers_options(), coarse); }),
            "cell: expected larger cells: the site has too many");
}

TEST(SiteRefusal, NamesAGoalThatTheTableLacks) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {}, area);
  const SiteTable table = table_to(problem, drivers_options());
  EXPECT_EQ(refusal([&] { table.expect_goal({1e-9, 0, 2 * std::numbers::pi}); }), "no refusal");
  EXPECT_EQ(refusal([&] {
              table.expect_goal({0, 0, 0.01});
            }),
            "site: the table has no such goal, expected one of its 1");
  const std::vector<Pose> other = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(refusal([&] { (void)table.with_goals(other); }),
            "goals[1]: the table has no such goal, expected one of its 1");
  EXPECT_EQ(refusal([&] {
              table.expect_goal({0, 1, 0}, "pairs.csv:3");
            }),
            "pairs.csv:3: the table has no such goal, expected one of its 1");
}

TEST(SiteRefusal, TakesThePosesOfASetOfGoals) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {box(9, 9, 12, 12)}, area);
  const auto goals_of = [&](const std::vector<GoalRegion>& set) {
    return site_goals(with_goal_set(problem, set), drivers_options());
  };
  EXPECT_EQ(site_goals(problem, drivers_options()).poses, (std::vector<Pose>{{0, 0, 0}}));
  GoalRegion either = region_of_pose({-10, 5, 1});
  either.either_way = true;
  const SiteGoals goals =
      goals_of({region_of_pose({0, 5, 2}), region_of_pose({10, 10, 0}), either});
  ASSERT_EQ(goals.poses.size(), 3U);
  EXPECT_EQ(goals.left_out, 1U);
  EXPECT_EQ(goals.poses[0], (Pose{0, 5, 2}));
  EXPECT_EQ(goals.poses[1], (Pose{-10, 5, 1}));
  EXPECT_NEAR(goals.poses[2].heading, 1 - std::numbers::pi, 1e-12);
  const Problem set = with_goal_set(problem, {region_of_pose({0, 5, 2}), either});
  const SiteTable table =
      make_site_table(set, site_goals(set, drivers_options()).poses, drivers_options(), coarse)
          .value();
  PlanOptions options = using_site(table);
  options.budget.max_iterations = 50;
  EXPECT_TRUE(plan(set, options).path);
  either.x.most = -9;
  EXPECT_EQ(
      refusal([&] { (void)goals_of({either}); }),
      "goals: the goal of the scenario holds infinitely many poses, expected a list of poses");
  EXPECT_EQ(refusal([&] {
              (void)goals_of({region_of_pose({10, 10, 0})});
            }),
            "goals: no pose of the scenario's goal is free, expected a list of poses");
}

TEST(SiteRefusal, KnowsWhichOptionsMeanNothing) {
  for (const CommonOption& option : style_and_common_options()) {
    const bool is_of_plans = option.part == OptionPart::budget;
    EXPECT_EQ(fault_of_site_option(option.name).empty(), !is_of_plans) << option.name;
  }
  EXPECT_NE(fault_of_site_option("site"), "");
}

TEST(SiteRefusal, StopsAPlanForAnotherWorld) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {}, area);
  const SiteTable table = table_to(problem, drivers_options());
  const Problem other = problem_of({20, 0, 0}, {0, 0, 0}, {box(9, 9, 12, 12)}, area);
  EXPECT_EQ(refusal([&] { (void)plan(other, using_site(table)); }),
            "site: the table was made for another world: bounds, obstacles, maps or zones differ");
}

}  // namespace
}  // namespace vandplan

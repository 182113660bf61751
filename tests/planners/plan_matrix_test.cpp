// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Costs of plans from many starts to many goals.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "support/problems.h"
#include "support/sites.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan {
namespace {

using namespace sites;

const std::vector<Pose> docks = {{0, 0, 0}, {15, -10, 2}};
const std::vector<Pose> starts = {{-20, 5, 1}, {7, 14, 0}, {25, 10, -2}};
const std::vector<Polygon> walls = {box(5, 12, 9, 16), box(-12, 4, -10, 14)};

Problem problem_for(const Vehicle& vehicle) {
  return problem_of({20, 0, 0}, docks[0], walls, area, vehicle);
}

PlanOptions options_for(const Problem& problem, std::int64_t iterations) {
  PlanOptions options;
  options.budget.max_iterations = iterations;
  options = complete(default_planner(), options, problem.vehicle());
  options.site =
      std::make_shared<const SiteTable>(make_site_table(problem, docks, options, coarse).value());
  return options;
}

TEST(PlanMatrix, CostsNoMoreThanTheWaysOfTheTable) {
  const Problem problem = problem_for({});
  for (const std::int64_t iterations : {1, 60}) {
    const PlanOptions options = options_for(problem, iterations);
    const std::vector<SiteCost> ways = site_matrix(*options.site, problem, starts, options);
    const std::vector<SiteCost> plans = plan_matrix(problem, starts, options);
    ASSERT_EQ(plans.size(), ways.size());
    for (std::size_t i = 0; i < plans.size(); ++i) {
      const bool is_in_wall = i / docks.size() == 1;
      EXPECT_EQ(std::isinf(plans[i].cost), is_in_wall) << i;
      if (is_in_wall) continue;
      EXPECT_LE(plans[i].cost, ways[i].cost) << i;
      EXPECT_LE(plans[i].lower_bound, plans[i].cost) << i;
      EXPECT_GT(plans[i].lower_bound, 5) << i;
    }
  }
}

// A lane so narrow that one iteration does not smooth the way.
TEST(PlanMatrix, KeepsTheWayWhereThereIsNoPlan) {
  const std::vector<Polygon> cage = {box(-11, -30, -9, 30), box(9, -30, 11, 30), box(-9, -1, 9, 1)};
  const std::vector<Pose> pocket = {{0, -16, 1.570796}};
  const Problem problem = problem_of({20, 0, 0}, pocket[0], cage, area);
  PlanOptions options;
  options.budget.max_iterations = 1;
  options = complete(default_planner(), options, problem.vehicle());
  options.site =
      std::make_shared<const SiteTable>(make_site_table(problem, pocket, options).value());
  const std::vector<Pose> from = {
      {-1.2, 10, 2.9}, {2.8, 6.4, 2.4}, {-2.1, -21.8, 0.1}, {1.7, -17.3, 2.4}};
  const std::vector<SiteCost> ways = site_matrix(*options.site, problem, from, options);
  const std::vector<SiteCost> kept = plan_matrix(problem, from, options, 2);
  int without_plan = 0;
  int dearer = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    ASSERT_EQ(ways[i].outcome, SiteOutcome::way) << i;
    EXPECT_LE(kept[i].cost, ways[i].cost) << i;
    EXPECT_LE(kept[i].lower_bound, kept[i].cost) << i;
    const PlanResult planned = plan(with_poses(problem, from[i], pocket[0]), options);
    const bool is_plan = planned.path && planned.cost <= ways[i].cost;
    EXPECT_EQ(kept[i].outcome, is_plan ? SiteOutcome::plan : SiteOutcome::way) << i;
    without_plan += planned.path ? 0 : 1;
    dearer += planned.path && planned.cost > ways[i].cost ? 1 : 0;
  }
  EXPECT_GT(without_plan, 0);
  EXPECT_GT(dearer, 0);
  options.steering = Steering::continuous;
  for (const SiteCost& cost : plan_matrix(problem, from, options)) {
    EXPECT_NE(cost.outcome, SiteOutcome::way);
  }
}

TEST(PlanMatrix, SaysWhyThereIsNoCost) {
  std::vector<Polygon> obstacles = walls;
  for (const Polygon& side : {box(-38, 18, -18, 19), box(-38, 37, -18, 38), box(-38, 18, -37, 38),
                              box(-19, 18, -18, 38)}) {
    obstacles.push_back(side);  // a cage without a gate
  }
  const Problem problem = problem_of({20, 0, 0}, docks[0], obstacles, area);
  const std::vector<Pose> from = {starts[0], {7, 14, 0}, {38, -38, 0}, {-28, 28, 0}};
  const PlanOptions options = options_for(problem, 2000);
  const auto expect = [&](const std::vector<SiteCost>& costs, std::vector<SiteOutcome> outcomes) {
    for (std::size_t i = 0; i < costs.size(); ++i) {
      const SiteOutcome outcome = outcomes[i / docks.size()];
      EXPECT_EQ(costs[i].outcome, outcome) << name_of(costs[i].outcome);
      EXPECT_EQ(std::isinf(costs[i].cost), outcome > SiteOutcome::plan) << i;
      const bool is_proven =
          outcome == SiteOutcome::start_in_collision || outcome == SiteOutcome::no_path;
      EXPECT_EQ(std::isinf(costs[i].lower_bound), is_proven) << i;
    }
  };
  expect(site_matrix(*options.site, problem, from, options),
         {SiteOutcome::way, SiteOutcome::start_in_collision, SiteOutcome::outside,
          SiteOutcome::no_path});
  expect(plan_matrix(problem, from, options), {SiteOutcome::plan, SiteOutcome::start_in_collision,
                                               SiteOutcome::plan, SiteOutcome::no_path});
  EXPECT_EQ(name_of(SiteOutcome::no_plan), "no_plan");
  EXPECT_EQ(name_of(SiteOutcome::way), "way");
}

TEST(PlanMatrix, DoesNotClaimAProofWhereAGateIsWideEnough) {
  std::vector<Polygon> obstacles = walls;
  for (const Polygon& side : {box(-38, 18, -18, 19), box(-38, 37, -18, 38), box(-38, 18, -37, 38),
                              box(-19, 18, -18, 26.6), box(-19, 29.4, -18, 38)}) {
    obstacles.push_back(side);
  }
  const Problem problem = problem_of({20, 0, 0}, docks[0], obstacles, area);
  const std::vector<Pose> from = {{-32, 28, 1.6}};
  for (const SiteCost& cost :
       site_matrix(*options_for(problem, 1).site, problem, from, options_for(problem, 1))) {
    EXPECT_LT(cost.outcome, SiteOutcome::no_path);
    EXPECT_TRUE(std::isfinite(cost.lower_bound));
  }
  const Problem towed = problem_of({20, 0, 0}, docks[0], obstacles, area, semitrailer());
  const std::vector<Pose> of_rig = {{-25, 31, 0.8}};
  const SiteCost briefly = plan_matrix(towed, of_rig, options_for(towed, 1))[0];
  EXPECT_EQ(briefly.outcome, SiteOutcome::no_plan);
  EXPECT_TRUE(std::isfinite(briefly.lower_bound));
}

// Goals in a cage and in a street that only leads out, among others, with a start in a pen.
TEST(PlanMatrix, ProvesWhichPairsWallsAndOneWayStreetsPart) {
  Surroundings ground{.bounds = area};
  ground.obstacles = {box(-38, 18, -18, 19), box(-38, 37, -18, 38), box(-38, 18, -37, 38),
                      box(-19, 18, -18, 38), box(18, 18, 19, 38),   box(18, 37, 38, 38),
                      box(37, 18, 38, 38)};
  ground.zones.push_back({.area = box(18, 14, 38, 20), .direction = HeadingRange{-1.9, -1.2}});
  const Problem problem = problem_in(ground, {20, 0, 0}, docks[0]);
  const std::vector<Pose> goals = {docks[0], {-28, 28, 0}, {28, 28, 0}, {-26, 30, 1}};
  const std::vector<Pose> from = {{-20, 5, 1}, {-30, 28, 0}, {28, 30, -1.5708}};
  const PlanOptions options = drivers_options();
  SiteTableOptions as = coarse;
  as.starts = from;
  const SiteTable table = make_site_table(problem, goals, options, as).value();
  const std::vector<SiteCost> costs = site_matrix(table, problem, from, options);
  const std::vector<std::vector<bool>> parted = {
      {false, true, true, true}, {true, false, true, false}, {false, true, false, true}};
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const bool is_parted = parted[i / goals.size()][i % goals.size()];
    EXPECT_EQ(costs[i].outcome == SiteOutcome::no_path, is_parted) << i;
    EXPECT_EQ(std::isinf(costs[i].lower_bound), is_parted) << i;
  }
  const std::vector<SiteCost> by_two = site_matrix(table, problem, from, options, 2);
  for (std::size_t i = 0; i < costs.size(); ++i) EXPECT_EQ(costs[i].outcome, by_two[i].outcome);
}

TEST(CheapestGoals, AreProvenByTheBoundsOfTheOthers) {
  const auto way = [](double cost, double bound) {
    return SiteCost{.cost = cost, .lower_bound = bound, .outcome = SiteOutcome::way};
  };
  const double never = std::numeric_limits<double>::infinity();
  const std::vector<SiteCost> costs = {
      way(9, 5), way(7, 6),         way(30, 7),        way(9, 5),  way(7, 4),  way(7, 6),
      way(9, 8), way(never, never), way(never, never), SiteCost{}, SiteCost{}, way(never, never)};
  const auto cheapest = cheapest_goals(costs, 3);
  ASSERT_EQ(cheapest.size(), 4U);
  EXPECT_EQ(cheapest[0]->goal, 1U);
  EXPECT_FALSE(cheapest[0]->is_proven);  // the first goal may cost 5
  EXPECT_EQ(cheapest[0]->cost, 7);
  EXPECT_EQ(cheapest[0]->lower_bound, 5);
  EXPECT_EQ(cheapest[1]->goal, 1U);
  EXPECT_EQ(cheapest[1]->lower_bound, 4);
  EXPECT_EQ(cheapest[2]->goal, 0U);
  EXPECT_TRUE(cheapest[2]->is_proven);
  EXPECT_EQ(cheapest[2]->lower_bound, 8);
  EXPECT_FALSE(cheapest[3]);
  EXPECT_TRUE(cheapest_goals(std::vector{way(9, 5), way(11, 9)}, 2)[0]->is_proven);
  EXPECT_TRUE(cheapest_goals({}, 3).empty());
}

TEST(PlanMatrix, SaysThatAGoalIsNotFree) {
  const Problem problem = problem_for({});
  const PlanOptions options = drivers_options();
  ChangingSiteTable changing(problem, docks, options, coarse);
  std::vector<Polygon> parked = walls;
  parked.push_back(box(14, -11, 16, -9));
  const Problem changed = problem_of({20, 0, 0}, docks[0], parked, area);
  changing.repair(changed);
  const std::vector<SiteCost> costs = site_matrix(changing.table(), changed, starts, options);
  EXPECT_EQ(costs[0].outcome, SiteOutcome::way);
  EXPECT_EQ(costs[1].outcome, SiteOutcome::goal_in_collision);
  EXPECT_TRUE(std::isinf(costs[1].lower_bound));
}

TEST(PlanMatrix, HasWhatTheRigDrives) {
  const Problem problem = problem_for(semitrailer());
  const PlanOptions options = options_for(problem, 40);
  const std::vector<SiteCost> costs = plan_matrix(problem, starts, options);
  const std::vector<SiteCost> by_two = plan_matrix(problem, starts, options, 2);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const PlanResult result =
        plan(with_poses(problem, starts[i / docks.size()], docks[i % docks.size()]), options);
    EXPECT_EQ(std::isinf(costs[i].cost), !result.path) << i;
    if (result.path) {
      EXPECT_EQ(costs[i].cost, result.cost) << i;
    }
    EXPECT_EQ(costs[i].cost, by_two[i].cost) << i;
    EXPECT_LE(costs[i].lower_bound, costs[i].cost) << i;
  }
  EXPECT_FALSE(std::isinf(costs.front().cost));
}

TEST(PlanMatrix, RefusesAStartOutOfRangeAndNoTable) {
  const Problem problem = problem_for({});
  PlanOptions options = options_for(problem, 5);
  const std::vector<Pose> wrong = {starts[0], {NAN, 0, 0}};
  EXPECT_EQ(refusal([&] { (void)plan_matrix(problem, wrong, options); }).substr(0, 10),
            "starts[1]:");
  options.site.reset();
  EXPECT_EQ(refusal([&] { (void)plan_matrix(problem, starts, options); }),
            "site: expected a table of the site");
}

}  // namespace
}  // namespace vandplan

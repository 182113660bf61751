// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Costs of plans from many starts to many goals.
#include <gtest/gtest.h>

#include <cmath>
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
  const PlanOptions options = options_for(problem, 60);
  const std::vector<SiteCost> ways = site_matrix(*options.site, problem, starts, options);
  const std::vector<SiteCost> plans = plan_matrix(problem, starts, options);
  ASSERT_EQ(plans.size(), ways.size());
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const bool is_in_wall = i / docks.size() == 1;
    EXPECT_EQ(std::isinf(plans[i].cost), is_in_wall) << i;
    if (is_in_wall) continue;
    EXPECT_LE(plans[i].cost, ways[i].cost * 1.001) << i;
    EXPECT_LE(plans[i].lower_bound, plans[i].cost) << i;
    EXPECT_GT(plans[i].lower_bound, 5) << i;
  }
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

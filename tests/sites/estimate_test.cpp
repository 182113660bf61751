// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What a table of a site tells searches, and which of them take it.
#include "sites/estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/problems.h"
#include "support/sites.h"
#include "vandplan/graphs.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using namespace sites;

Problem around_a_wall() { return problem_of({20, 0, 0}, {0, 0, 0}, {box(9, -12, 11, 12)}, area); }

Problem docks_behind_a_wall() { return problem_of({-30, 30, 0}, {0, 0, 0}, {}, area); }

SiteTable to_docks(const Problem& problem) {
  const std::vector<Pose> docks = {{0, 0, 0}, {-20, -10, 1}};
  return make_site_table(problem, docks, length_options(), coarse).value();
}

TEST(SiteEstimate, IsTheCostOfTheTableToTheGoalOfTheTask) {
  const Problem problem = docks_behind_a_wall();
  const SiteTable table = to_docks(problem);
  for (std::size_t goal = 0; goal < 2; ++goal) {
    const Problem to = with_poses(problem, problem.start(), table.goals()[goal]);
    const CostsToGoal costs(table, to.task());
    for (const Pose& pose : {Pose{10, 5, 1}, Pose{-25, 20, 3}}) {
      EXPECT_EQ(costs.from(to_local(*to.world(), pose)), table.cost(pose, goal));
    }
  }
}

TEST(SiteEstimate, WhereTheTableKnowsNoWayIsAsFarAsTheFarthestState) {
  const Problem problem = around_a_wall();
  const SiteTable table = table_to(problem, length_options());
  const Pose in_the_wall{10, 0, 0}, outside{1000, 0, 0};
  ASSERT_FALSE(std::isfinite(table.cost(in_the_wall, 0)));
  const CostsToGoal costs(table, problem.task());
  const double farthest = costs.from(to_local(*problem.world(), outside));
  EXPECT_TRUE(std::isfinite(farthest));
  EXPECT_EQ(costs.from(to_local(*problem.world(), in_the_wall)), farthest);
  EXPECT_GT(farthest, table.cost({-15, -25, 2}, 0));
}

/// Lengths from nodes to a sample on open ground of length 1, raised by a table.
std::vector<float> raised(const SiteTable& table, const Problem& problem, bool is_one_way,
                          const std::vector<Pose>& nodes, const Pose& sample) {
  CostDifferences differences(table, problem.task(), is_one_way, nodes.size());
  for (const Pose& node : nodes) differences.add(to_local(*problem.world(), node));
  std::vector<float> lengths(nodes.size(), 1.0F);
  differences.raise(to_local(*problem.world(), sample), lengths);
  return lengths;
}

TEST(SiteEstimate, RaisesLengthsToTheCostIfTheSampleIsTheGoal) {
  const Problem problem = around_a_wall();
  const SiteTable table = table_to(problem, length_options());
  const std::vector<Pose> nodes = {{20, 0, 0}, {-10, 5, 1}};
  const std::vector<float> lengths = raised(table, problem, false, nodes, problem.goal());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_FLOAT_EQ(lengths[i], static_cast<float>(table.cost(nodes[i], 0)));
  }
}

// A node behind a wall is near to the sample, but far from it on the way that the table knows.
TEST(SiteEstimate, RaisesLengthsToTheLargestDifferenceOfCosts) {
  const Problem problem = docks_behind_a_wall();
  const SiteTable table = to_docks(problem);
  const Pose sample{5, 5, 2};
  const std::vector<Pose> nodes = {{20, 0, 0}, {-30, -20, 1}, {10, 0, 0}};
  const std::vector<float> lengths = raised(table, problem, false, nodes, sample);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    double least = 1.0;
    for (std::size_t goal = 0; goal < 2; ++goal) {
      least = std::max(least, std::abs(table.cost(nodes[i], goal) - table.cost(sample, goal)));
    }
    EXPECT_NEAR(lengths[i], least, 1e-4);
  }
}

TEST(SiteEstimate, InOneGearCountsOnlyWhatAWaySaves) {
  const Problem problem = around_a_wall();
  const SiteTable table = table_to(problem, length_options());
  const Pose near{-5, 0, 0}, far{25, 0, 0};
  const double saved = table.cost(far, 0) - table.cost(near, 0);
  ASSERT_GT(saved, 10.0);
  EXPECT_NEAR(raised(table, problem, true, {far}, near)[0], saved, 1e-4);
  EXPECT_EQ(raised(table, problem, true, {near}, far)[0], 1.0F);
  EXPECT_NEAR(raised(table, problem, false, {near}, far)[0], saved, 1e-4);
}

TEST(SiteEstimate, LeavesLengthsAsTheyAreWhereTheTableKnowsNoWay) {
  const Problem problem = around_a_wall();
  const SiteTable table = table_to(problem, length_options());
  const Pose in_the_wall{10, 0, 0}, free{20, 0, 0};
  EXPECT_EQ(raised(table, problem, false, {in_the_wall}, free)[0], 1.0F);
  EXPECT_EQ(raised(table, problem, false, {free}, in_the_wall)[0], 1.0F);
}

TEST(SiteEstimate, TakesCostsOfAFunctionInPlaceOfThoseOfCells) {
  const Problem problem = docks_behind_a_wall();
  const SiteTable table = to_docks(problem);
  const SiteTable other = with_costs(table, [](const Pose& pose, std::size_t goal) {
    return pose.x + 10.0 * static_cast<double>(goal);
  });
  EXPECT_EQ(other.cost({3, 1, 2}, 1), 13.0);
  EXPECT_EQ(other.goals(), table.goals());
  EXPECT_NE(table.cost({3, 1, 2}, 1), 13.0);
  EXPECT_EQ(CostsToGoal(other, problem.task()).from(to_local(*problem.world(), {3, 1, 2})), 3.0);
}

// ---- searches ----

/// All searches with the estimate, each as one would name it.
std::vector<Planner> searches_by_site() {
  std::vector<Planner> found;
  for (const Planner& planner : planners()) {
    if (auto guided = find_planner(planner.name + ":site")) found.push_back(*std::move(guided));
  }
  for (const char* const name :
       {"rrt-bsc-site", "rrt-opt-site", "rrt-bsc-site-goal", "rrt-opt-site-goal"}) {
    found.push_back(planner_named(name));
  }
  return found;
}

PlanOptions limited(const Planner& planner, PlanOptions options) {
  options.style = Style::shortest;
  options.budget.max_iterations = 1500;
  if (honours(planner, "region")) options.planner.set("region", "scene");
  return options;
}

TEST(SiteEstimate, GuidesEverySearchThatTakesAnEstimate) {
  const Problem problem = around_a_wall();
  const SiteTable table = table_to(problem, length_options());
  const double on_open_ground = reeds_shepp_length(problem.start(), problem.goal(), 7.0);
  const std::vector<Planner> searches = searches_by_site();
  EXPECT_GE(searches.size(), 12U);
  for (const Planner& planner : searches) {
    EXPECT_EQ(planner.properties.estimate, "site");
    EXPECT_TRUE(planner.can(Capability::site)) << planner.name;
    const PlanOptions options = limited(planner, using_site(table));
    const PlanResult result = plan(problem, planner, options);
    EXPECT_EQ(result.status, PlanStatus::solved) << planner.name << ": " << result.reason;
    // The estimate is no lower bound: no more is proven than open ground tells.
    EXPECT_LE(result.lower_bound.value_or(0.0), on_open_ground) << planner.name;
    const PlanResult same = plan(problem, planner, options);
    ASSERT_TRUE(result.path && same.path) << planner.name;
    EXPECT_EQ(result.path->segments, same.path->segments) << planner.name;
  }
}

// The way leads around the wall, which an estimate of open ground does not know.
TEST(SiteEstimate, LeadsHybridAStarAroundAWall) {
  const Problem problem = around_a_wall();
  const SiteTable table = table_to(problem, length_options());
  const auto expansions = [&](const char* name, const PlanOptions& given) {
    const Planner planner = planner_named(name);
    PlanOptions options = limited(planner, given);
    options.budget.max_iterations = 100'000;
    const PlanResult result = plan(problem, planner, options);
    EXPECT_EQ(result.status, PlanStatus::solved) << name;
    return counter(result, "expansions");
  };
  EXPECT_LT(3 * expansions("hybrid-a-star:site", using_site(table)),
            expansions("hybrid-a-star:reeds-shepp", {}));
}

TEST(SiteEstimate, HoldsForPricesInSearchesThatTakeThem) {
  const Problem problem = around_a_wall();
  const SiteTable table = table_to(problem, drivers_options());
  const Planner planner = planner_named("hybrid-a-star:site");
  PlanOptions options = using_site(table, {.style = Style::driver});
  options.budget.max_iterations = 20'000;
  EXPECT_EQ(plan(problem, planner, options).status, PlanStatus::solved);
}

TEST(SiteEstimate, IsTheLargerOneWithAnother) {
  const Problem problem = around_a_wall();
  const Planner planner = planner_named("hybrid-a-star:max-site-any-angle");
  const SiteTable table = table_to(problem, length_options());
  EXPECT_EQ(plan(problem, planner, limited(planner, using_site(table))).status, PlanStatus::solved);
}

// ---- refusals ----

TEST(SiteEstimate, WithoutATableOneLineSaysHowToGiveOne) {
  const Problem problem = around_a_wall();
  for (const Planner& planner : searches_by_site()) {
    EXPECT_EQ(refusal([&] { (void)plan(problem, planner); }),
              "site: the estimate needs a table of the site, expected --site FILE.vst, site=TABLE "
              "in Python, PlanOptions::site in C++")
        << planner.name;
  }
  EXPECT_EQ(refusal([&] { (void)search::make_goal_estimate("site", problem.task()); }),
            "estimate: site is for planners with a table of the site, PlanOptions::site");
}

TEST(SiteEstimate, IsRefusedWhereNobodyUsesTheTable) {
  const Problem problem = around_a_wall();
  const PlanOptions options = using_site(table_to(problem, length_options()));
  EXPECT_EQ(refusal([&] { (void)plan(problem, planner_named("hybrid-a-star"), options); }),
            "site: is for estimate=site or max_with=site");
  EXPECT_EQ(
      refusal([&] { (void)plan(problem, planner_named("rrt-bsc-rs"), options); }).substr(0, 33),
      "site: is no option of rrt-bsc-rs,");
  PlanOptions any;
  EXPECT_EQ(refusal([&] { set_option(any, default_planner(), "site", "yard.vst"); }),
            "site: is a table and no text, expected --site FILE.vst");
}

TEST(SiteEstimate, IsRefusedForAnotherWorldGoalOrPrices) {
  const Problem problem = around_a_wall();
  const SiteTable table = table_to(problem, length_options());
  const Problem other_world = problem_of({20, 0, 0}, {0, 0, 0}, {box(9, -12, 11, 13)}, area);
  const Problem other_goal = with_poses(problem, problem.start(), {0, 3, 0});
  const SiteTable by_prices = table_to(problem, drivers_options());
  for (const Planner& planner : searches_by_site()) {
    const auto told = [&](const Problem& asked, const SiteTable& given) {
      return refusal([&] { (void)plan(asked, planner, limited(planner, using_site(given))); });
    };
    EXPECT_EQ(told(other_world, table).substr(0, 42), "site: the table was made for another world")
        << planner.name;
    EXPECT_EQ(told(other_goal, table), "site: the table has no such goal, expected one of its 1")
        << planner.name;
    EXPECT_EQ(told(problem, by_prices),
              "site: the table was made for other options: prices (style), gears or margin differ")
        << planner.name;
  }
}

TEST(SiteEstimate, TreesWithItAreNotAmongThePlanners) {
  for (const Planner& planner : planners()) {
    EXPECT_FALSE(asks_for_estimate(planner, {}, search::site_estimate)) << planner.name;
  }
  EXPECT_FALSE(find_planner("rrt-opt-sites"));
}

}  // namespace
}  // namespace vandplan

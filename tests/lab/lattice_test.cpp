// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What lattice-a-star, lattice-ara-star and ltba-star promise beside what all planners do.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/graphs.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

// A bay that is entered in reverse, beside a wall.
Problem bay() {
  return problem_of({0, 0, 0}, {14, -11, 1.6},
                    {box(-10, 6, 40, 7), box(2, -16, 11.6, -5), box(16.4, -16, 26, -5)});
}

Problem around_the_short_wall() { return problem_of({0, 0, 0}, {30, 0, 0}, {box(14, -8, 16, 8)}); }

PlanResult run(const Problem& problem, const std::string& planner,
               const std::vector<Setting>& settings = {}, std::int64_t iterations = 100'000) {
  const Planner chosen = planner_named(planner);
  PlanOptions options;
  options.cost = shortest_style;
  options.budget.max_iterations = iterations;
  set_honoured(options, chosen, settings);
  return plan(problem, chosen, options);
}

double factor_of(const PlanResult& result) {
  return static_cast<double>(counter(result, "lattice_factor_per_mille")) / 1000;
}

TEST(LatticeAStar, FindsTheSameLengthWithEveryEstimateThatIsAdmissible) {
  const std::vector<Setting> pure = {{"shots", "false"}};
  const double best = run(bay(), "lattice-a-star", pure).cost;
  EXPECT_GT(best, 20.0);
  for (const char* estimate : {"euclid", "reeds-shepp", "max-euclid-lattice-table"}) {
    const PlanResult result = run(bay(), std::string("lattice-a-star:") + estimate, pure);
    EXPECT_NEAR(result.cost, best, 1e-4 * best) << estimate;
  }
}

TEST(LatticeAStar, LooksAtFewerVerticesWithTheTable) {
  const std::vector<Setting> pure = {{"shots", "false"}};
  const auto expansions = [&](const char* planner) {
    return counter(run(bay(), planner, pure), "expansions");
  };
  EXPECT_LT(2 * expansions("lattice-a-star"), expansions("lattice-a-star:euclid"));
  EXPECT_LT(expansions("lattice-a-star"), expansions("lattice-a-star:reeds-shepp"));
}

TEST(LatticeAStar, IsAtMostSoManyTimesAsLongAsItsWeightSays) {
  const double best = run(bay(), "lattice-a-star").cost;
  for (const double weight : {1.2, 2.0, 5.0}) {
    const PlanResult result =
        run(bay(), "lattice-a-star", {{"weight", std::to_string(weight)}, {"shots", "false"}});
    ASSERT_EQ(result.status, PlanStatus::solved);
    EXPECT_LE(result.cost, weight * best * (1 + 1e-9));
    EXPECT_LE(factor_of(result), weight + 0.001);
  }
}

TEST(LatticeAStar, SaysWhatItHasProvenAndNotMore) {
  EXPECT_EQ(factor_of(run(bay(), "lattice-a-star")), 1.0);
  EXPECT_EQ(factor_of(run(bay(), "lattice-a-star:hlut-4")), 0.0);  // it over-estimates
  EXPECT_EQ(factor_of(run(around_the_short_wall(), "lattice-a-star", {}, 300)),
            0.0);  // not at its end
}

TEST(LatticeAStar, ARoomThatTheLatticeCannotLeaveProvesNothing) {
  const Problem problem =
      problem_of({0, 0, 0}, {24, 0, 0}, {box(12, -14, 13, 14)}, {-12, 32, -12, 12});
  const PlanResult result = run(problem, "lattice-a-star", {}, 2'000'000);
  EXPECT_EQ(result.status, PlanStatus::node_limit);
  EXPECT_EQ(result.reason, "no way over the lattice is free");
  const PlanResult few = run(problem, "lattice-a-star", {{"max_nodes", "1500"}}, 2'000'000);
  EXPECT_EQ(few.status, PlanStatus::node_limit);
  EXPECT_EQ(few.reason, "the search has found as many vertices as it may");
  EXPECT_LE(counter(few, "nodes"), 1600);
}

TEST(LatticeAStar, KeepsItsTreeInTheOrderOfExpansion) {
  const PlanResult result = run(bay(), "lattice-a-star", {{"keep_tree", "true"}});
  ASSERT_TRUE(result.tree);
  EXPECT_GE(static_cast<std::int64_t>(result.tree->poses.size()), counter(result, "expansions"));
  EXPECT_EQ(result.tree->parents[0], -1);
  for (std::size_t i = 1; i < result.tree->parents.size(); ++i) {
    EXPECT_GE(result.tree->parents[i], 0);
    EXPECT_LT(result.tree->parents[i], static_cast<std::int32_t>(i));
  }
}

TEST(LatticeAraStar, EndsAtTheShortestWayAndIsNeverWorseOnTheWay) {
  const PlanResult best = run(bay(), "lattice-a-star");
  const PlanResult result = run(bay(), "lattice-ara-star");
  EXPECT_LE(result.cost, best.cost * (1 + 1e-4));
  EXPECT_EQ(factor_of(result), 1.0);
  EXPECT_LT(result.anytime.front().iteration, result.anytime.back().iteration);
}

TEST(Primitives, OfAUserAreUsedAndThoseThatTurnTooSharplyRefused) {
  PlanOptions options;
  options.cost = shortest_style;
  options.budget.max_iterations = 20'000;
  const Planner planner = planner_named("lattice-a-star");
  options.primitives = search::make_primitives(9.0, {.largest_coordinate = 1});
  const PlanResult result = plan(around_the_short_wall(), planner, options);
  EXPECT_EQ(result.status, PlanStatus::solved);
  options.primitives = search::make_primitives(6.9);
  EXPECT_THROW((void)plan(around_the_short_wall(), planner, options), InputError);
  EXPECT_THROW((void)complete(planner_named("rrt-bsc-euc"), options), InputError);
}

TEST(LtbaStar, WithoutHasteItIsTheWayOfAStar) {
  const PlanResult best = run(around_the_short_wall(), "lattice-a-star");
  const PlanResult result =
      run(around_the_short_wall(), "ltba-star", {{"cycle_expansions", "1000000"}});
  EXPECT_EQ(result.path, best.path);
  EXPECT_EQ(counter(result, "cycles"), 0);
}

TEST(LtbaStar, CommitsWhileItSearches) {
  const PlanResult result = run(around_the_short_wall(), "ltba-star", {{"cycle_expansions", "2"}});
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_GT(counter(result, "cycles"), 10);
  EXPECT_GT(counter(result, "committed_mm"), 0);
  EXPECT_EQ(counter(result, "cycles_without_plan"), 0);
}

// Starts all around, with more or less haste: at every tick it can stop, and it gets there.
TEST(LtbaStar, CanAlwaysStopAndStillArrives) {
  for_each_case(3, 40, [](Rng& rng) {
    const Problem base = around_the_short_wall();
    const Pose start =
        compose(base.start(), {uniform(-4, 4, rng), uniform(-1, 1, rng), uniform(-0.4, 0.4, rng)});
    const Problem problem = make_problem(base.world(), base.vehicle(), start, base.goal());
    const auto haste = std::to_string(1 + static_cast<int>(uniform(0.0, 60.0, rng)));
    const PlanResult best = run(problem, "lattice-a-star");
    const PlanResult result =
        run(problem, "ltba-star", {{"cycle_expansions", haste}, {"cycle_time", "0.05"}});
    ASSERT_EQ(result.status, best.status) << result.reason;
    EXPECT_EQ(counter(result, "cycles_without_plan"), 0);
    EXPECT_LE(result.cost, best.cost + 90.0);
  });
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does Hybrid A* promise beyond what every planner does?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "../support/cases.h"
#include "../support/problems.h"
#include "lab/voronoi_field.h"
#include "vandplan/graphs.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"
#include "vandplan/tables.h"

namespace vandplan {
namespace {

const Planner& hybrid() {
  static const Planner planner = planner_named("hybrid-a-star");
  return planner;
}

PlanOptions by_length(std::vector<Setting> settings = {}, std::int64_t iterations = 20'000) {
  PlanOptions options{.cost = shortest_style};
  options.budget.max_iterations = iterations;
  for (const auto& [name, value] : settings) set_option(options, hybrid(), name, value);
  return options;
}

Problem around_the_wall_in_bounds() {
  return problem_of({0, 0, 0}, {30, 0, 0}, {box(14, -8, 16, 8)}, {-40, 70, -40, 40});
}

Problem walled_in_within_bounds() {
  return problem_of(
      {0, 0, 0}, {60, 0, 0},
      {box(40, -20, 80, -18), box(40, 18, 80, 20), box(40, -20, 42, 20), box(78, -20, 80, 20)},
      {-15, 90, -30, 30});
}

TEST(HybridAStar, EndsAtOnceWhereNothingIsInTheWay) {
  const PlanResult result = plan(problem_of({0, 0, 0}, {30, 10, 2}, {}), hybrid(), by_length());
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_NEAR(result.lower_bound.value_or(0.0), result.cost, 1e-6);
}

TEST(HybridAStar, CostsNoMoreThanTheWeightTimesWhatAFinerSearchFinds) {
  const auto cost = [](const char* weight) {
    const PlanResult result = plan(around_the_wall_in_bounds(), hybrid(),
                                   by_length({{"weight", weight}, {"shorten", "false"}}));
    EXPECT_EQ(result.status, PlanStatus::solved);
    EXPECT_LE(result.lower_bound, result.cost);
    return result.cost;
  };
  const double least = cost("1");
  EXPECT_GT(least, 34.9);  // the way of a disc as wide as the vehicle
  EXPECT_LT(least, 37.0);
  EXPECT_LE(cost("1.5"), 1.5 * least);
  EXPECT_LE(cost("3"), 3 * least);
}

TEST(HybridAStar, ImprovesOnlyWhenItIsTold) {
  const auto run = [](const char* improve) {
    return plan(around_the_wall_in_bounds(), hybrid(),
                by_length({{"improve", improve}, {"weight", "2"}, {"shorten", "false"}}, 100'000));
  };
  const PlanResult first = run("false");
  const PlanResult best = run("true");
  ASSERT_TRUE(first.path && best.path);
  EXPECT_LT(best.cost, first.cost);
  EXPECT_GT(best.iterations, first.iterations);
}

TEST(HybridAStar, ShortensItsPath) {
  const PlanResult rough =
      plan(around_the_wall_in_bounds(), hybrid(), by_length({{"shorten", "false"}}));
  const PlanResult result = plan(around_the_wall_in_bounds(), hybrid(), by_length());
  ASSERT_TRUE(rough.path && result.path);
  EXPECT_LT(result.cost, rough.cost);
  EXPECT_EQ(counter(result, "expansions"), counter(rough, "expansions"));
}

TEST(HybridAStar, KeepsTheTreeInOrderOfExpansion) {
  const PlanResult result =
      plan(around_the_wall_in_bounds(), hybrid(), by_length({{"keep_tree", "true"}}));
  ASSERT_TRUE(result.tree);
  const auto& [poses, parents] = *result.tree;
  EXPECT_EQ(static_cast<std::int64_t>(poses.size()), counter(result, "expansions"));
  ASSERT_EQ(poses.size(), parents.size());
  EXPECT_EQ(parents.front(), -1);
  for (std::size_t i = 1; i < parents.size(); ++i) {
    ASSERT_GE(parents[i], 0);
    ASSERT_LT(parents[i], static_cast<std::int32_t>(i));
  }
}

TEST(HybridAStar, ProvesThatThereIsNoWay) {
  const PlanResult result = plan(walled_in_within_bounds(), hybrid(), by_length());
  EXPECT_EQ(result.status, PlanStatus::no_path);
  EXPECT_FALSE(result.reason.empty());
}

// An estimate that knows no obstacles proves nothing: all cells are searched.
TEST(HybridAStar, DoesNotTakeAnExhaustedLatticeForAProof) {
  const PlanResult result = plan(
      walled_in_within_bounds(), hybrid(),
      by_length({{"estimate", "euclid"}, {"max_with", "none"}, {"cell", "4"}, {"headings", "12"}},
                1'000'000));
  EXPECT_EQ(result.status, PlanStatus::node_limit);
  EXPECT_NE(result.reason.find("every cell"), std::string::npos);
}

TEST(HybridAStar, EndsWhenItsTreeIsFull) {
  const PlanResult result = plan(around_the_wall_in_bounds(), hybrid(),
                                 by_length({{"max_nodes", "20"}, {"shot_spacing", "0.01"}}));
  EXPECT_EQ(result.status, PlanStatus::node_limit);
  EXPECT_EQ(result.reason, "the search tree is full");
  EXPECT_LT(counter(result, "nodes"), 20 + 6);
}

// Forward costs less than half: what is near enough to reverse to is driven around to.
TEST(HybridAStar, MindsPrices) {
  const Problem problem = problem_of({0, 0, 0}, {-25, 0, 0}, {}, {-60, 60, -60, 60});
  EXPECT_NEAR(plan(problem, hybrid(), by_length()).cost, 25.0, 1e-9);
  PlanOptions options = by_length();
  options.cost = by_length_and(10.0, 0.0);
  const PlanResult result = plan(problem, hybrid(), options);
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_LT(result.cost, 120.0);
  PlanOptions driver = by_length();
  driver.cost = driver_style;
  const PlanResult around = plan(around_the_wall_in_bounds(), hybrid(), driver);
  ASSERT_EQ(around.status, PlanStatus::solved);
  EXPECT_EQ(around.check->gear_changes, 0);
  EXPECT_GT(around.cost, length(*around.path));  // of turning the wheels
}

// ---- On request ----

// Two walls, 10 m apart.
TEST(VoronoiField, KnowsThingsAndTheMiddleBetweenThem) {
  const Problem problem = problem_of(
      {0, 0, 0}, {20, 0, 0}, {box(-40, 5, 60, 6), box(-40, -6, 60, -5)}, {-40, 60, -20, 20});
  search::VoronoiField field(problem.task(), 0.25);
  while (field.step()) {
  }
  for (const double y : {-4.0, -2.0, 0.0, 1.0, 3.0}) {
    EXPECT_NEAR(field.at({10, y}).obstacle, 5 - std::abs(y), 0.6) << y;
    EXPECT_NEAR(field.at({10, y}).middle, std::abs(y), 0.6) << y;
  }
  const search::VoronoiField::Range range{2, 8};
  EXPECT_NEAR(field.potential({10, 4.9}, range), 1.0, 0.3);
  EXPECT_LT(field.potential({10, 0}, range), 0.05);
  EXPECT_GT(field.potential({10, 3}, range), field.potential({10, 2}, range));
  EXPECT_EQ(field.potential({10, 3}, {2, 1}), 0.0);  // out of reach
  const Segment ahead{0.0, 10.0};
  EXPECT_NEAR(field.along({5, 3, 0}, {&ahead, 1}, range), 10 * field.potential({10, 3}, range),
              1e-9);
}

// The start and the goal are near the same wall of an alley.
TEST(HybridAStar, KeepsToTheMiddleOnRequest) {
  const Problem problem = problem_of(
      {0, 3, 0}, {60, 3, 0}, {box(-40, 7, 100, 8), box(-40, -7, 100, -6)}, {-40, 100, -20, 20});
  const auto mean_aside = [&](const char* weight) {
    const PlanResult result =
        plan(problem, hybrid(), by_length({{"voronoi_weight", weight}}, 20000));
    EXPECT_EQ(result.status, PlanStatus::solved);
    EXPECT_NEAR(result.cost, length(*result.path), 1e-9);  // the field is no part of the cost
    double sum = 0.0;
    const std::vector<PathPoint> points = sampled(*result.path, 0.5);
    for (const PathPoint& point : points) sum += std::abs(point.pose.y - 0.5);
    return sum / static_cast<double>(points.size());
  };
  EXPECT_NEAR(mean_aside("0"), 2.5, 1e-9);
  EXPECT_LT(mean_aside("10"), 1.2);
}

// A gap of 4 m above the wall, and none below it.
TEST(HybridAStar, StepsShorterWhereThereIsLittleRoom) {
  const Problem problem = problem_of(
      {0, 0, 0}, {30, 0, 0}, {box(14, -40, 16, 8), box(-40, 12, 70, 13)}, {-40, 70, -40, 40});
  const auto shortest_step = [&](const char* is_variable) {
    const PlanResult result =
        plan(problem, hybrid(),
             by_length({{"variable_step", is_variable}, {"keep_tree", "true"}}, 3000));
    double least = 1e9;
    const auto& [poses, parents] = *result.tree;
    for (std::size_t i = 1; i < poses.size(); ++i) {
      const Pose& from = poses[static_cast<std::size_t>(parents[i])];
      least = std::min(least, std::hypot(poses[i].x - from.x, poses[i].y - from.y));
    }
    return least;
  };
  EXPECT_LT(shortest_step("true"), 0.3 * shortest_step("false"));
}

// ---- Estimates by name ----

TEST(HybridAStar, TakesEveryEstimate) {
  for (const std::string_view name : search::goal_estimate_names()) {
    if (name == search::user_table || name == search::site_estimate) continue;
    const Planner planner = planner_named("hybrid-a-star:" + std::string(name));
    EXPECT_EQ(planner.properties.estimate, name);
    const PlanResult result = plan(around_the_wall_in_bounds(), planner, by_length());
    ASSERT_EQ(result.status, PlanStatus::solved) << name;
    const bool is_proven =
        name == "euclid" || name == "bound" || name == "reeds-shepp" || name == "any-angle";
    EXPECT_EQ(result.lower_bound > 0.0, is_proven) << name;
  }
  EXPECT_EQ(planner_named("hybrid-a-star:max-hlut-4-any-angle").properties.estimate,
            "max-hlut-4-any-angle");
  EXPECT_THROW((void)planner_named("hybrid-a-star:max-hlut-4"), InputError);
}

TEST(HybridAStar, LooksUpAUsersTable) {
  const Planner planner = planner_named("hybrid-a-star:max-table-any-angle");
  PlanOptions options = by_length();
  EXPECT_TRUE(asks_for_estimate(planner, options, search::user_table));
  EXPECT_THROW((void)complete(planner, options), InputError);
  options.table = std::make_shared<const HeuristicTable>(thesis_table(4));
  const PlanResult result = plan(around_the_wall_in_bounds(), planner, options);
  const PlanResult same = plan(around_the_wall_in_bounds(),
                               planner_named("hybrid-a-star:max-hlut-4-any-angle"), by_length());
  ASSERT_TRUE(result.path && same.path);
  EXPECT_EQ(result.path->segments, same.path->segments);
}

TEST(HybridAStar, RefusesATableThatNobodyAsks) {
  PlanOptions options = by_length();
  options.table = std::make_shared<const HeuristicTable>(thesis_table(1));
  try {
    (void)complete(hybrid(), options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "table");
  }
  EXPECT_FALSE(honours(planner_named("rrt-bsc-euc"), "table"));
  EXPECT_THROW((void)complete(planner_named("rrt-bsc-euc"), options), InputError);
}

// ---- Laws ----

// The judge has seen every path, and every bound.
TEST(HybridAStarLaw, IsNeverRejected) {
  int solved = 0;
  for_each_case(11, 150, [&](Rng& rng) {
    std::vector<Polygon> obstacles;
    for (int i = static_cast<int>(uniform(0, 10, rng)); i > 0; --i) {
      const double x = uniform(-36, 36, rng);
      const double y = uniform(-36, 36, rng);
      obstacles.push_back(box(x, y, x + uniform(0.2, 20, rng), y + uniform(0.2, 4, rng)));
    }
    const Bounds bounds{-40, 40, -40, 40};
    const Problem problem =
        problem_of(uniform_pose(bounds, rng), uniform_pose(bounds, rng), obstacles, bounds);
    PlanOptions options = by_length({}, 2000);
    options.budget.seed = rng();
    if (uniform01(rng) < 0.3) options.cost = driver_style;
    if (uniform01(rng) < 0.3) options.clearance.margin = 0.3;
    const PlanResult result = plan(problem, hybrid(), options);
    EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
    solved += result.path ? 1 : 0;
  });
  EXPECT_GE(solved, cases(50));
}

}  // namespace
}  // namespace vandplan

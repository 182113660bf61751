// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Tidying: fewer and longer segments, the same end, free, at next to no cost.
#include "planners/anytime/finish.h"
#include "planners/anytime/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using search::Connector;
using search::CostRule;

constexpr double k = 1.0 / 7;
constexpr CostRule dear_gears{.reverse_weight = 2, .gear_change_cost = 5};

double cost_of(const CostRule& rule, std::span<const Segment> segments) {
  return drive_cost(rule, segments);
}

std::vector<Segment> tidied(const Problem& problem, const Path& path,
                            Steering steering = Steering::reeds_shepp) {
  const Task task = task_of(problem, {}, steering);
  Connector connector(task, dear_gears);
  return anytime::tidied(connector, Local(path.start), path.segments);
}

std::vector<Segment> with_strokes(const Problem& problem, const Path& path, double least) {
  Connector connector(problem.task(), dear_gears);
  const search::Route legs = anytime::legs_along(path, problem.task().goal);
  return path_of(anytime::with_strokes(connector, {}, legs, least)).segments;
}

double shortest(const std::vector<Segment>& segments) {
  double least = 1e9;
  for (const Segment& segment : segments) least = std::min(least, std::abs(segment.length));
  return least;
}

/// Lengths between gear changes, the first and the last stroke among them.
std::vector<double> strokes(std::span<const Segment> segments) {
  std::vector<double> result;
  double gear = 0;
  for (const Segment& segment : segments) {
    if (segment.length * gear <= 0) result.push_back(0);
    result.back() += std::abs(segment.length);
    gear = segment.length;
  }
  return result;
}

void expect_no_crumbs(const std::vector<Segment>& crumbly, Steering steering) {
  const Path path{{}, crumbly};
  const Problem problem = problem_of_path({.bounds = wide_bounds}, path);
  const std::vector<Segment> tidy = tidied(problem, path, steering);
  EXPECT_LT(tidy.size(), crumbly.size());
  EXPECT_GT(shortest(tidy), 0.1);
  EXPECT_LE(cost_of(dear_gears, tidy), cost_of(dear_gears, crumbly) * (1 + 1e-4));
  const PathCheck check = check_path(problem, {{}, tidy}, {.steering = steering});
  EXPECT_TRUE(check.valid) << check.reason << as_code(tidy);
}

TEST(Tidied, LeavesCrumbsOut) {
  const std::vector<std::vector<Segment>> crumbly = {
      {{k, 8}, {-k, 1e-4}, {0, 12}, {k, 2e-3}, {-k, 6}},
      {{0, 5}, {k, 1e-3}, {0, 5}, {-k, 7}, {0, 3}},
      {{k, 8}, {0, 4}, {-k, 1e-3}, {-k, -3}, {0, -5}, {k, 1e-4}, {k, 9}, {0, 2}}};
  for (const auto& segments : crumbly) expect_no_crumbs(segments, Steering::reeds_shepp);
}

// Wheels that are turned a little and back again. The curvature stays continuous.
TEST(Tidied, LeavesTurnsOfTheWheelsByNothingOut) {
  constexpr double rate = 0.1;
  const auto turn = [](double curvature, double length) {
    const double way = curvature / rate;
    return std::vector<Segment>{{0, way, rate}, {curvature, length - way}, {curvature, way, -rate}};
  };
  const std::vector<Segment> nothing = {{0, 0.03, 0.05}, {0.0015, 0.03, -0.05}};
  const std::vector<Segment> curve = turn(0.12, 9);
  const std::vector<Segment> other = turn(0.08, 12);
  std::vector<std::vector<Segment>> crumbly(3);
  const auto add = [](std::vector<Segment>& path, const std::vector<Segment>& more) {
    path.insert(path.end(), more.begin(), more.end());
  };
  for (std::size_t at = 0; at < crumbly.size(); ++at) {  // at the begin, on the way, at the end
    std::vector<Segment>& path = crumbly[at];
    if (at == 0) add(path, nothing);
    add(path, {{0, 10}});
    add(path, curve);
    add(path, {{0, 4}});
    if (at == 1) add(path, nothing);
    add(path, {{0, 5}});
    add(path, other);
    add(path, {{0, 8}});
    if (at == 2) add(path, nothing);
  }
  for (const auto& segments : crumbly) expect_no_crumbs(segments, Steering::continuous);
}

// A turn of the wheels that goes on otherwise than before is no crumb to be left out.
TEST(Tidied, LeavesAContinuousCurvatureContinuous) {
  const Path path{{}, {{0, 10}, {0, 0.02, 0.1}, {0.002, 9}, {0.002, 0.02, -0.1}, {0, 10}}};
  const Problem problem = problem_of_path({.bounds = wide_bounds}, path);
  EXPECT_EQ(tidied(problem, path, Steering::continuous), path.segments);
}

// Without the short stroke the wheels would have to turn at once while the vehicle rolls; its
// neighbours could make up for its length.
TEST(Tidied, KeepsAStrokeAtWhichTheWheelsTurn) {
  const Path path{{},
                  {{0, 6}, {0, 1, 0.1}, {0.1, 8}, {0.1, -0.05}, {0, 6}, {0, 1, -0.1}, {-0.1, 6}}};
  const Problem problem = problem_of_path({.bounds = wide_bounds}, path);
  const Steering steering = Steering::continuous_between_stops;
  ASSERT_TRUE(check_path(problem, path, {.steering = steering}).valid);
  const std::vector<Segment> tidy = tidied(problem, path, steering);
  EXPECT_TRUE(check_path(problem, {{}, tidy}, {.steering = steering}).valid) << as_code(tidy);
}

// Pins beside the path that the tidy one hits, but not the path with its crumbs.
TEST(Tidied, KeepsACrumbWithoutWhichThePathIsBlocked) {
  const Path path{{}, {{0, 9}, {k, 0.02}, {0, 9}, {-k, 7}, {0, 3}}};
  const Path tidy{{}, tidied(problem_of_path({.bounds = wide_bounds}, path), path)};
  ASSERT_LT(tidy.segments.size(), path.segments.size());
  int pins = 0;
  for_each_case(7, 1000, [&](Rng& rng) {
    const double y = Vehicle{}.width / 2 * (uniform(0, 1, rng) < 0.5 ? -1 : 1);
    const Pose at = compose(pose_at(tidy, uniform(9, 18, rng)), {0, y, 0});
    const double aside = uniform(-0.02, 0.02, rng);
    const Polygon pin = box(at.x, at.y + aside, at.x + 1e-3, at.y + aside + 1e-3);
    const Problem problem = problem_of_path({.bounds = wide_bounds, .obstacles = {pin}}, path);
    if (!check_path(problem, path).valid || check_path(problem, tidy).valid) return;
    ++pins;
    const Path kept{{}, tidied(problem, path)};
    EXPECT_TRUE(check_path(problem, kept).valid) << as_code(pin);
  });
  EXPECT_GT(pins, is_sanitized ? -1 : 10);
}

TEST(Tidied, LeavesATidyPathAlone) {
  const Path path{{}, {{k, 8}, {0, 12}, {-k, 6}, {-k, -4}, {0, -9}}};
  const Problem problem = problem_of_path({.bounds = wide_bounds}, path);
  EXPECT_EQ(tidied(problem, path), path.segments);
  EXPECT_EQ(with_strokes(problem, path, 0.5), path.segments);
}

// What is longer than a crumb, or worth its price, stays.
TEST(Tidied, CostsNextToNothing) {
  for_each_case(1, 500, [](Rng& rng) {
    Path path{{}, {}};
    for (std::uint64_t i = 0, n = 2 + rng() % 8; i < n; ++i) {
      const double curvature = (static_cast<double>(rng() % 3) - 1) * k;
      const double size = rng() % 2 == 0 ? uniform(0.2, 15, rng) : std::exp2(uniform(-20, -3, rng));
      path.segments.push_back({curvature, rng() % 4 == 0 ? -size : size});
    }
    const Problem problem = problem_of_path({.bounds = wide_bounds}, path);
    const std::vector<Segment> tidy = tidied(problem, path);
    EXPECT_LE(tidy.size(), path.segments.size());
    EXPECT_LE(cost_of(dear_gears, tidy), cost_of(dear_gears, path.segments) * (1 + 1e-4) + 1e-12);
    const PathCheck check = check_path(problem, {{}, tidy});
    EXPECT_TRUE(check.valid) << check.reason << " " << as_code(path.segments);
  });
}

// A path along walls that a mended one would touch keeps its crumbs.
TEST(Tidied, StaysFree) {
  for_each_case(2, 200, [](Rng& rng) {
    const double crumb = std::exp2(uniform(-12, -4, rng));
    const Path path{{}, {{0, 9}, {k, crumb}, {0, 9}, {-k, 5}, {0, 4}}};
    const double near = -1.275 - uniform(0.001, 0.01, rng);  // of the side of the truck
    const Problem problem =
        problem_of_path({.bounds = wide_bounds, .obstacles = {box(-5, near - 1, 40, near)}}, path);
    if (!check_path(problem, path).valid) return;
    const std::vector<Segment> tidy = tidied(problem, path);
    EXPECT_TRUE(check_path(problem, {{}, tidy}).valid) << as_code(tidy);
  });
}

TEST(MinStroke, IsDrivenWhereThereIsRoom) {
  for_each_case(3, 300, [](Rng& rng) {
    Path path{{}, {}};
    double gear = 1;
    for (std::uint64_t i = 0, n = 2 + rng() % 4; i < n; ++i, gear = -gear) {
      for (std::uint64_t j = 0, m = 1 + rng() % 2; j < m; ++j) {
        const double curvature = (static_cast<double>(rng() % 3) - 1) * k;
        path.segments.push_back({curvature, gear * uniform(0.05, 3, rng)});
      }
    }
    const Problem problem = problem_of_path({.bounds = wide_bounds}, path);
    const std::vector<Segment> longer = with_strokes(problem, path, 2.0);
    const std::vector<double> driven = strokes(longer);
    for (const double stroke : driven) {
      EXPECT_TRUE(driven.size() == 1 || stroke >= 2 - 1e-6)
          << stroke << " " << as_code(path.segments) << " becomes " << as_code(longer);
    }
    const PathCheck check = check_path(problem, {{}, longer});
    EXPECT_TRUE(check.valid) << check.reason << " " << as_code(longer);
  });
}

// Between two walls there is none.
TEST(MinStroke, StaysShortBetweenWalls) {
  const Path path{{}, {{0, 0.5}, {k, -0.5}, {-k, 0.5}, {0, -0.4}}};
  const Problem problem = problem_of_path(
      {.bounds = wide_bounds, .obstacles = {box(6.7, -5, 7, 5), box(-2.7, -5, -2.5, 5)}}, path);
  ASSERT_TRUE(check_path(problem, path).valid) << check_path(problem, path).reason;
  const std::vector<Segment> driven = with_strokes(problem, path, 3.0);
  EXPECT_TRUE(check_path(problem, {{}, driven}).valid);
  for (const double stroke : strokes(driven)) EXPECT_LT(stroke, 3.0);
}

Problem road_to_turn_on() {
  return problem_of({0, -2, 0}, {0, 2, 3.141592653589793},
                    {box(-60, 6, 60, 8), box(-60, -8, 60, -6)});
}

TEST(Tidied, WhatIsPlannedUnderPricesHasNoCrumbs) {
  PlanOptions options{.budget = {.max_iterations = 3000}, .cost = by_length_and(2, 1)};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    options.budget.seed = seed;
    const PlanResult result = plan(road_to_turn_on(), options);
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_GT(shortest(result.path->segments), 1e-3) << as_code(result.path->segments);
    EXPECT_NEAR(result.anytime.back().cost, result.cost, 1e-9);
  }
}

TEST(MinStroke, IsAnOptionOfThePlanner) {
  PlanOptions options{.budget = {.max_iterations = 3000}, .cost = shortest_style};
  set_option(options, planner_named("anytime"), "min_stroke", "1.5");
  const PlanResult result = plan(problem_of({}, {0, 1.5, 0}, {}), options);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  for (const double stroke : strokes(result.path->segments)) EXPECT_GE(stroke, 1.5 - 1e-9);
}

// ---- with continuous curvature ----

constexpr Steering continuous_kinds[] = {Steering::continuous_between_stops, Steering::continuous};

double missing(const std::vector<double>& strokes, double least) {
  double sum = 0;
  for (const double stroke : strokes) sum += std::max(0.0, least - stroke);
  return strokes.size() == 1 ? 0 : sum;
}

// Short moves sideways and turns of the heading, on open ground.
TEST(MinStroke, IsDrivenWithContinuousCurvature) {
  int longer = 0, short_still = 0;
  for_each_case(4, 100, [&](Rng& rng) {
    const Pose goal{uniform(-3, 3, rng), uniform(-3, 3, rng), uniform(-1.5, 1.5, rng)};
    PlanOptions options{.budget = {.max_iterations = 200}, .cost = by_length_and(1.2, 0.1)};
    for (const Steering steering : continuous_kinds) {
      options.steering = steering;
      options.planner.set("min_stroke", 0.0);
      const PlanResult as_is = plan(problem_of({}, goal, {}), options);
      options.planner.set("min_stroke", 3.0);
      const PlanResult result = plan(problem_of({}, goal, {}), options);
      ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
      EXPECT_NEAR(result.anytime.back().cost, result.cost, 1e-9);
      const double before = missing(strokes(as_is.path->segments), 3);
      const double after = missing(strokes(result.path->segments), 3);
      EXPECT_LE(after, before + 1e-9) << as_code(result.path->segments);
      if (before > 0) ++(after < 1e-9 ? longer : short_still);
    }
  });
  if (!is_sanitized) {
    EXPECT_GT(longer, 9 * short_still) << short_still;
  }
}

// Among walls strokes lack no more than they did, and what does not lack anything stays as it was.
TEST(MinStroke, TakesNothingAwayWithContinuousCurvature) {
  for_each_case(5, 100, [&](Rng& rng) {
    const double left = uniform(2, 6, rng), right = uniform(2, 6, rng);
    const Problem problem = problem_of(
        {0, uniform(-0.5, 0.5, rng), uniform(-0.1, 0.1, rng)},
        {uniform(0, 4, rng), uniform(-0.5, 0.5, rng), std::numbers::pi + uniform(-0.1, 0.1, rng)},
        {box(-60, left, 60, left + 2), box(-60, -right - 2, 60, -right)});
    PlanOptions options{.budget = {.max_iterations = 600, .seed = rng()}, .cost = driver_style};
    options.steering = continuous_kinds[rng() % 2];
    const PlanResult as_is = plan(problem, options);
    options.planner.set("min_stroke", 4.0);
    const PlanResult result = plan(problem, options);
    ASSERT_EQ(result.status, as_is.status) << result.reason;
    if (!result.path) return;
    const double before = missing(strokes(as_is.path->segments), 4);
    EXPECT_LE(missing(strokes(result.path->segments), 4), before + 1e-9);
    if (before == 0) {
      EXPECT_EQ(result.path->segments, as_is.path->segments);
    }
  });
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does being near things cost, in the eyes of the planner and of the judge?
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"
#include "vandplan/search.h"

namespace vandplan {
namespace {

using search::ClearanceSampling;
using search::CostRule;

constexpr double half_width = 2.55 / 2;
constexpr CostRule careful{.clearance_weight = 2, .clearance_distance = 0.8};

CostOptions options_of(const CostRule& rule) {
  return {.reverse_weight = rule.reverse_weight,
          .gear_change_cost = rule.gear_change_cost,
          .curvature_change_cost = rule.curvature_change_cost,
          .clearance_weight = rule.clearance_weight,
          .clearance_distance = rule.clearance_distance};
}

double price_of(const Problem& problem, const CostRule& rule, const Path& path,
                ClearanceSampling sampling) {
  return search::clearance_cost(problem.task(), rule, Local(path.start), path.segments, sampling);
}

/// The sum of midpoints, a millimetre each, without any short cut.
double slow_price_of(const Problem& problem, const CostRule& rule, const Path& path,
                     double step = 1e-3) {
  double sum = 0.0;
  Pose pose = path.start;
  for (const Segment& segment : path.segments) {
    const double length = std::abs(segment.length);
    const double count = std::ceil(length / step);
    const double weight = segment.length > 0 ? rule.forward_weight : rule.reverse_weight;
    for (double i = 0.5; i < count; ++i) {
      const Pose there = advance(pose, part_of(segment, 0, length * i / count));
      const double clearance =
          problem.task().checker->clearance(Local(there), rule.clearance_distance);
      sum += weight * length / count * (1 - clearance / rule.clearance_distance);
    }
    pose = advance(pose, segment);
  }
  return rule.clearance_weight * sum;
}

/// A few segments among boxes and kerbs, some of which they may hit.
Problem random_yard(const Path& path, Rng& rng) {
  Surroundings yard{.bounds = wide_bounds};
  for (int i = 0; i < 12; ++i) {
    const double x = uniform(-30, 30, rng), y = uniform(-30, 30, rng);
    const Polygon thing = box(x, y, x + uniform(0.2, 6, rng), y + uniform(0.2, 6, rng));
    (i % 4 == 0 ? yard.kerbs : yard.obstacles).push_back(thing);
  }
  return problem_of_path(yard, path);
}

Path random_path(Rng& rng) {
  Path path{uniform_pose({-20, 20, -20, 20}, rng), {}};
  path.segments.resize(1 + rng() % 4);
  for (Segment& segment : path.segments) {
    segment = {uniform(-0.14, 0.14, rng), uniform(-9, 9, rng)};
    if (rng() % 3 == 0) {
      segment = {0, segment.length, segment.curvature / std::abs(segment.length)};
    }
  }
  return path;
}

TEST(ClearanceCost, BesideAWallIsInProportionToWhatIsMissing) {
  const Path ahead{{}, {{0, 10}}};
  const Polygon wall = box(-50, half_width + 0.2, 80, 9);
  const Problem problem = problem_of_path({.bounds = wide_bounds, .obstacles = {wall}}, ahead);
  // 0.6 of 0.8 m are missing.
  EXPECT_NEAR(price_of(problem, careful, ahead, ClearanceSampling::search), 10 * 2 * 0.75, 1e-9);
  EXPECT_NEAR(price_of(problem, careful, ahead, ClearanceSampling::answer), 10 * 2 * 0.75, 1e-9);
  const CostRule reversing{.reverse_weight = 3, .clearance_weight = 2, .clearance_distance = 0.8};
  const Path back{{10, 0, 0}, {{0, -10}}};
  EXPECT_NEAR(price_of(problem, reversing, back, ClearanceSampling::answer), 10 * 3 * 2 * 0.75,
              1e-9);
  EXPECT_NEAR(price_of(problem, search::reversed(reversing, 0), ahead, ClearanceSampling::answer),
              10 * 3 * 2 * 0.75, 1e-9);
}

// All along a little near to a wall at the side, and at last to one in front: what is missing from
// the distance grows from nothing to a decimetre there.
TEST(ClearanceCost, IsExactWhereAWallAheadBeginsToCount) {
  const Vehicle vehicle;
  const double beside = careful.clearance_distance - 1e-3;
  for (const double length : {10.03, 10.07, 10.11, 10.16}) {
    const double front = length + vehicle.wheelbase + vehicle.front_overhang;
    const double ahead = front + careful.clearance_distance - 0.1;
    const Path path{{}, {{0, length}}};
    const Problem problem = problem_of(path.start, end_pose(path),
                                       {box(-20, half_width + beside, ahead, half_width + 2),
                                        box(ahead, -3, ahead + 1, half_width + 2)});
    const double missing = 1e-3 * (length - 0.1 + 1e-3) + (0.1 * 0.1 - 1e-6) / 2;
    EXPECT_NEAR(price_of(problem, careful, path, ClearanceSampling::answer),
                careful.clearance_weight * missing / careful.clearance_distance, 2e-5)
        << length;
  }
}

TEST(ClearanceCost, OfAKerbIsThatOfTheWheels) {
  const Path ahead{{}, {{0, 10}}};
  const Vehicle narrow_track{.track_width = 2.15};
  const Polygon kerb = box(-50, half_width + 0.2, 80, 9);  // 0.4 m from the wheels
  const Problem problem =
      problem_of_path({.bounds = wide_bounds, .kerbs = {kerb}}, ahead, narrow_track);
  EXPECT_NEAR(price_of(problem, careful, ahead, ClearanceSampling::answer), 10 * 2 * 0.5, 1e-9);
}

TEST(ClearanceCost, IsNothingFarFromEverything) {
  const Path ahead{{}, {{0, 10}, {0, -4}}};
  const Problem near = problem_of_path(
      {.bounds = wide_bounds, .obstacles = {box(-50, -9, 80, -half_width - 0.81)}}, ahead);
  EXPECT_EQ(price_of(near, careful, ahead, ClearanceSampling::answer), 0);
  EXPECT_EQ(price_of(problem_of_path({.bounds = wide_bounds}, ahead), careful, ahead,
                     ClearanceSampling::search),
            0);
  EXPECT_EQ(price_of(near, {}, ahead, ClearanceSampling::answer), 0);
}

TEST(ClearanceCost, OfAnAnswerIsWithinAThousandthOfTheCost) {
  double worst_search = 0.0;
  for_each_case(1, 300, [&](Rng& rng) {
    const Path path = random_path(rng);
    const Problem problem = random_yard(path, rng);
    const CostRule rule{.reverse_weight = 2,
                        .clearance_weight = uniform(0, 5, rng),
                        .clearance_distance = std::exp(uniform(-2, 1, rng))};
    const double slow = slow_price_of(problem, rule, path);
    const double cost = slow + length(path);
    EXPECT_NEAR(price_of(problem, rule, path, ClearanceSampling::answer), slow, 1e-3 * cost);
    const double rough = price_of(problem, rule, path, ClearanceSampling::search);
    worst_search = std::max(worst_search, std::abs(rough - slow) / cost);
  });
  EXPECT_LT(worst_search, 0.06);
}

// Turning on the spot, all but: corners sweep past a box that is just out of their reach.
TEST(ClearanceCost, OfABodyThatSwingsAboutItsAxleIsAsExact) {
  for_each_case(5, 100, [&](Rng& rng) {
    const Path path{uniform_pose({-20, 20, -20, 20}, rng),
                    {{uniform(20, 100, rng), uniform(0.05, 0.3, rng)}}};
    const double beside = path.start.x + 6.2 + uniform(0, 0.3, rng);
    const Problem problem = problem_of_path(
        {.bounds = wide_bounds,
         .obstacles = {box(beside, path.start.y - 1, beside + 2, path.start.y + 1)}},
        path, Vehicle{.min_turning_radius = 0.01});
    const CostRule rule{.clearance_weight = 2, .clearance_distance = 2};
    const double slow = slow_price_of(problem, rule, path, 2e-5);
    const double cost = slow + length(path);
    EXPECT_NEAR(price_of(problem, rule, path, ClearanceSampling::answer), slow, 1e-3 * cost);
    const PathCheck check = check_path(problem, path, {.cost = StatedCost{cost, options_of(rule)}});
    EXPECT_TRUE(check.valid) << check.reason;
  });
}

TEST(ClearanceCost, EndsTheSumAboveTheCutoff) {
  for_each_case(2, 300, [](Rng& rng) {
    const Path path = random_path(rng);
    const Problem problem = random_yard(path, rng);
    const double whole = price_of(problem, careful, path, ClearanceSampling::search);
    const double cutoff = uniform(0, 1.5, rng) * whole;
    const double cut = search::clearance_cost(problem.task(), careful, Local(path.start),
                                              path.segments, ClearanceSampling::search, cutoff);
    if (whole <= cutoff) {
      EXPECT_EQ(cut, whole);
    } else {
      EXPECT_GT(cut, cutoff);
    }
  });
}

TEST(ClearanceCost, IsWorkedOutAgainByTheJudge) {
  int judged = 0;
  for_each_case(3, 600, [&](Rng& rng) {
    const Path path = random_path(rng);
    const Problem problem = random_yard(path, rng);
    const CostRule rule{.reverse_weight = 2,
                        .clearance_weight = uniform(0.5, 5, rng),
                        .clearance_distance = std::exp(uniform(-1, 1, rng))};
    if (!check_path(problem, path).valid) return;
    search::Driven driven;
    const double near = price_of(problem, rule, path, ClearanceSampling::answer);
    StatedCost stated{.cost = drive_cost(rule, path.segments, driven) + near,
                      .rule = options_of(rule)};
    const PathCheck check = check_path(problem, path, {.cost = stated});
    EXPECT_TRUE(check.valid) << check.reason;
    ++judged;
    stated.cost += 4e-3 * stated.cost;
    EXPECT_FALSE(check_path(problem, path, {.cost = stated}).valid);
  });
  EXPECT_GT(judged, cases(600) / 6);
}

// Where a path grazes the distance that counts, one sees a little where another sees nothing.
TEST(ClearanceCost, ALittleMoreThanNothingIsAccepted) {
  const Path ahead{{}, {{0, 100}}};
  const Problem problem = problem_of_path({.bounds = wide_bounds}, ahead);
  const auto is_valid = [&](double cost, double weight) {
    const CostOptions rule{
        .reverse_weight = 1, .curvature_change_cost = 0, .clearance_weight = weight};
    return check_path(problem, ahead, {.cost = StatedCost{.cost = cost, .rule = rule}}).valid;
  };
  EXPECT_TRUE(is_valid(100.01, 2));
  EXPECT_FALSE(is_valid(100.2, 2));
  EXPECT_FALSE(is_valid(100.01, 0));
}

// A claim that nobody can look at does not keep the judge busy.
TEST(ClearanceCost, OfAnAbsurdClaimIsSoonWorkedOut) {
  const Path ahead{{}, {{0, 100}}};
  const Problem problem = problem_of_path(
      {.bounds = wide_bounds, .obstacles = {box(-50, half_width + 0.01, 150, 9)}}, ahead);
  for (const double distance : {0.0, -1.0, 1e-300, std::nan("")}) {
    const StatedCost stated{
        .cost = 100,
        .rule = {.reverse_weight = 1, .clearance_weight = 1, .clearance_distance = distance}};
    EXPECT_TRUE(check_path(problem, ahead, {.cost = stated}).valid);
  }
}

// A truck through a gap that is 4 m wider than itself: in the middle of it when that is asked for.
TEST(ClearanceCost, KeepsPlansAwayFromThings) {
  const std::vector<Polygon> walls = {box(10, -60, 30, -4), box(10, half_width, 30, 60)};
  const Problem problem = problem_of({0, 0, 0}, {40, 0, 0}, walls);
  PlanOptions options{.budget = {.max_iterations = 5000}, .cost = shortest_style};
  const PlanResult shortest = plan(problem, options);
  options.cost.clearance_weight = 3;
  const PlanResult careful_plan = plan(problem, options);
  ASSERT_EQ(shortest.status, PlanStatus::solved);
  ASSERT_EQ(careful_plan.status, PlanStatus::solved) << careful_plan.reason;
  EXPECT_LT(*shortest.check->clearance, 0.01);
  EXPECT_GT(*careful_plan.check->clearance, 0.5);
  EXPECT_GE(careful_plan.cost, careful_plan.check->length - 1e-9);
  EXPECT_LE(careful_plan.lower_bound, careful_plan.cost);
  EXPECT_EQ(careful_plan.anytime.back().cost, careful_plan.cost);
  for (std::size_t i = 1; i < careful_plan.anytime.size(); ++i) {
    EXPECT_LT(careful_plan.anytime[i].cost, careful_plan.anytime[i - 1].cost);
  }
}

}  // namespace
}  // namespace vandplan

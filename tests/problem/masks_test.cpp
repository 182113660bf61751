// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Masks in the eyes of planners and of the judge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "problem/masks.h"
#include "support/cases.h"
#include "support/draws.h"
#include "support/grids.h"
#include "support/place_of_error.h"
#include "support/problems.h"
#include "support/zoned.h"
#include "vandplan/judge.h"
#include "vandplan/motion.h"
#include "vandplan/planner.h"
#include "vandplan/search.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using std::numbers::pi;

TEST(Masks, AreCoveredByRectangles) {
  for_each_case(5, 200, [](Rng& rng) {
    OccupancyGrid map = random_grid(9, 7, uniform(0.1, 0.9, rng), rng);
    map.origin = {0, 0, 0};
    map.resolution = 1;
    const std::vector<Polygon> rectangles = problem::rectangles_over(map);
    for (std::int32_t row = 0; row < map.rows; ++row) {
      for (std::int32_t column = 0; column < map.columns; ++column) {
        const auto at = static_cast<std::size_t>(row * map.columns + column);
        int count = 0;
        for (const Polygon& rectangle : rectangles) {
          count += contains(rectangle, Point{column + 0.5, row + 0.5}) ? 1 : 0;
        }
        EXPECT_EQ(count, (*map.cells)[at] == Cell::occupied ? 1 : 0) << column << " " << row;
      }
    }
  });
}

TEST(Masks, AreObstacles) {
  Scenario scenario = with_zones({0, 0, 0}, {40, 0, 0}, {});
  OccupancyGrid map = grid_of({"?.#", "..#", "..."}, 2.0, {16, -3, 0});
  scenario.masks = {{"keepout.yaml", map}};
  scenario.obstacles = {box(-30, -30, -20, -20)};
  const Problem problem = make_problem(scenario);
  EXPECT_EQ(problem.world()->fences(), 1U);
  const PathCheck check = check_path(problem, {{0, 0, 0}, {{0, 40}}});
  EXPECT_EQ(check.reason, "the footprint hits masks[0]");
  EXPECT_EQ(check.hit, (Hit{HitKind::mask, 0}));
  const PlanResult result = plan(problem, of_iterations(2000));
  if (is_sanitized && !result.path) return;
  EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
  scenario.start = {-25, -25, 0};
  EXPECT_EQ(plan(make_problem(scenario), of_iterations(10)).hit, (Hit{HitKind::obstacle, 0}));
}

// ---- Masks that limit speeds or have prices ----

/// A mask of cells of 2 m from (10, -2) on: two rows, of two columns each.
Mask four_cells(Mask mask, std::vector<std::uint8_t> percents) {
  mask.map = grid_of({"..", ".."}, 2.0, {10, -2, 0});
  mask.percents = std::make_shared<const std::vector<std::uint8_t>>(std::move(percents));
  return mask;
}

TEST(GradedMasks, PriceMetresCellByCell) {
  Scenario scenario = with_zones({0, 1, 0}, {30, 1, 0}, {});
  scenario.masks = {four_cells(cost_mask({}, 4), {0, 0, 50, Mask::unknown})};
  const Path path{{0, 1, 0}, {{0, 30}}};
  EXPECT_NEAR(cost_of(make_problem(scenario), path), 30 + 2 * 2, 1e-9);
  scenario.zones = {{.area = box(11, 0, 40, 2), .cost = 2}};
  EXPECT_NEAR(cost_of(make_problem(scenario), path), 10 + 3 + 6 + 2 * 18, 1e-9);
  EXPECT_FALSE(make_problem(scenario).world()->fences());
}

TEST(GradedMasks, AreJudged) {
  for_each_case(9, 200, [](Rng& rng) {
    OccupancyGrid map = random_grid(7, 5, 0.5, rng);
    map.resolution = any_size(0.1, 8, rng);
    map.origin = {uniform(-5, 20, rng), uniform(-10, 5, rng), uniform(-pi, pi, rng)};
    std::vector<std::uint8_t> percents(35);
    for (std::uint8_t& percent : percents) {
      percent = chance(0.3, rng) ? Mask::unknown : static_cast<std::uint8_t>(uniform(0, 101, rng));
    }
    Mask mask = cost_mask(map, uniform(0.1, 30, rng));
    mask.percents = std::make_shared<const std::vector<std::uint8_t>>(std::move(percents));
    Path path{{0, 0, 0}, {}};
    for (int i = 0; i < 3; ++i) {
      path.segments.push_back({uniform(-0.14, 0.14, rng), uniform(-12, 12, rng)});
    }
    if (chance(0.5, rng)) path.segments[0] = {0, 10};
    if (chance(0.5, rng)) path.segments[1] = {0, 10, 0.014};
    Scenario scenario = with_zones(path.start, end_pose(path), {});
    scenario.masks = {mask};
    const Problem problem = make_problem(scenario);
    const double cost = cost_of(problem, path);
    PathClaims claims{.cost = StatedCost{.cost = cost, .rule = shortest_style}};
    const PathCheck check = check_path(problem, path, claims);
    EXPECT_TRUE(check.valid) << check.reason;
    claims.cost->cost = 1.01 * cost + 0.1;
    EXPECT_FALSE(check_path(problem, path, claims).valid);
  });
}

TEST(GradedMasks, LimitSpeeds) {
  Scenario scenario = with_zones({0, 1, 0}, {30, 1, 0}, {});
  scenario.masks = {four_cells(speed_mask({}, 1), {0, 0, 50, 0})};
  const Path path{{0, 1, 0}, {{0, 30}}};
  const Problem problem = make_problem(scenario);
  const SpeedProfile speeds = speed_profile(path, problem.vehicle(), speed_options(problem, path));
  double slowest = 100;
  for (const Motion& motion : sampled(path, problem.vehicle(), speeds, 0.01)) {
    if (motion.pose.x < 10 || motion.pose.x > 12) continue;
    EXPECT_LE(motion.v, 0.5 + 1e-3);
    slowest = std::min(slowest, motion.v);
  }
  EXPECT_GT(slowest, 0.49);
  EXPECT_TRUE(check_drive(problem, {path, speeds}).valid);
  const DriveCheck fast = check_drive(problem, {path, speed_profile(path, problem.vehicle())});
  EXPECT_EQ(fast.reason.substr(0, 22), "the speed in a zone is");
}

TEST(GradedMasks, AreChecked) {
  const auto fault = [](const Mask& mask) {
    Scenario scenario = with_zones({0, 1, 0}, {30, 1, 0}, {});
    scenario.masks = {mask};
    return place_of_error([&] { check_scenario(scenario); });
  };
  EXPECT_EQ(fault(four_cells(cost_mask({}, 4), {0, 0, 0, 100})), "nothing");
  EXPECT_EQ(fault(four_cells(cost_mask({}, 4), {0, 0, 0})), "masks[0]");
  EXPECT_EQ(fault(four_cells(cost_mask({}, 4), {0, 0, 0, 101})), "masks[0]");
  EXPECT_EQ(fault(four_cells(cost_mask({}, 1000), {0, 0, 0, 100})), "masks[0]");
  EXPECT_EQ(fault(four_cells(cost_mask({}, -1), {0, 0, 0, 1})), "masks[0]");
  EXPECT_EQ(fault(four_cells(speed_mask({}, 4), {0, 0, 0, 99})), "nothing");
  EXPECT_EQ(fault(four_cells(speed_mask({}, 4), {0, 0, 0, 100})), "masks[0]");
  Mask fine = four_cells(speed_mask({}, 4), {0, 0, 0, 99});
  fine.map.resolution = 0.001;
  EXPECT_EQ(fault(fine), "masks[0].map.resolution");
}

}  // namespace
}  // namespace vandplan

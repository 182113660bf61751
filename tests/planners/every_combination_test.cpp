// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What the default planner knows it knows together: every vehicle with every steering, cost,
// margin, gap and least stroke, alone and among others, on open ground and in zones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "support/cases.h"
#include "support/grids.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

using std::numbers::pi;

enum class Who { truck, rig };
enum class Cost { length, driver, time };

/// What is asked for; 0 stands for no margin, no gap and no least stroke.
struct Wish {
  Who who;
  Steering steering;
  Cost cost;
  bool has_movers, has_zones;
  double margin, gap, min_stroke;
};

using Combination = std::tuple<Who, Steering, Cost, bool, bool, double, double, double>;

Wish wish_of(const Combination& combination) {
  const auto& [who, steering, cost, has_movers, has_zones, margin, gap, min_stroke] = combination;
  return {who, steering, cost, has_movers, has_zones, margin, gap, min_stroke};
}

std::string name_of_wish(const testing::TestParamInfo<Combination>& info) {
  const Wish wish = wish_of(info.param);
  constexpr const char* steerings[] = {"Arcs", "BetweenStops", "Continuous"};
  constexpr const char* costs[] = {"Length", "Driver", "Time"};
  std::string name = wish.who == Who::rig ? "Rig" : "Truck";
  name += steerings[static_cast<int>(wish.steering)];
  name += costs[static_cast<int>(wish.cost)];
  if (wish.has_movers) name += "Movers";
  if (wish.has_zones) name += "Zones";
  if (wish.margin > 0) name += "Margin";
  if (wish.gap > 0) name += "Gap";
  if (wish.min_stroke > 0) name += "Strokes";
  return name;
}

/// A zone of each kind around the dock, and masks: most of them lie in the way.
void add_zones(Scenario& scenario) {
  scenario.zones = {{.area = box(-2.4, 1, 2.4, 12), .gears = AllowedGears::reverse},
                    {.area = box(-40, 1, -6, 20), .direction = HeadingRange{-pi / 2, pi / 2}},
                    {.area = box(25, 38, 35, 44), .closed = true, .body = true},
                    {.area = box(-15, 25, -5, 35), .cost = 3},
                    {.area = box(-3, 14, 3, 16), .cost = 2, .body = true},
                    {.area = box(-12, 20, 12, 45), .max_speed = 0.8}};
  const OccupancyGrid map = grid_of({"#..#", "...."}, 4.0, {-8, 24, 0});
  scenario.masks = {cost_mask(map, 2), speed_mask(map, 2), {"", map}};
  scenario.masks[1].percents = std::make_shared<const std::vector<std::uint8_t>>(8, 40);
  scenario.masks[2].map.origin = {-38, 38, 0.5};
}

/// A dock to back up to; before it a car crosses the yard, through where a rig comes in its way.
Problem problem_for(const Wish& wish) {
  Scenario scenario = dock_for(wish.who == Who::rig ? semitrailer() : Vehicle{});
  if (wish.who == Who::truck) scenario.goal.y = 6;
  if (wish.has_movers) {
    scenario.moving = {{.outline = box(-2, -1, 2, 1),
                        .trajectory = {{0, {12, 28, -pi / 2}}, {14, {-6, 26, pi}}},
                        .after = Afterwards::leaves}};
  }
  if (wish.has_zones) add_zones(scenario);
  return make_problem(scenario);
}

PlanOptions options_for(const Wish& wish) {
  PlanOptions options;
  options.budget = {.max_iterations = is_sanitized ? 100 : 1000, .seed = 1};
  if (wish.cost == Cost::length) options.cost = shortest_style;
  if (wish.cost == Cost::time) options.cost.measure = CostMeasure::time;
  options.steering = wish.steering;
  options.clearance.margin = wish.margin;
  if (wish.gap > 0) options.budget.target_gap = wish.gap;
  options.planner.set("min_stroke", wish.min_stroke);
  return options;
}

/// By how much the strokes before and after gear changes are too short, in all [m].
double missing(const std::vector<Segment>& segments, double least) {
  std::vector<double> strokes;
  double gear = 0;
  for (const Segment& segment : segments) {
    if (segment.length * gear <= 0) strokes.push_back(0);
    strokes.back() += std::abs(segment.length);
    gear = segment.length;
  }
  if (strokes.size() < 2) return 0;
  double sum = 0;
  for (const double stroke : strokes) sum += std::max(0.0, least - stroke);
  return sum;
}

class EveryCombination : public testing::TestWithParam<Combination> {};

TEST_P(EveryCombination, IsPlannedAndHasWhatWasAskedFor) {
  const Wish wish = wish_of(GetParam());
  const Problem problem = problem_for(wish);
  const PlanOptions options = options_for(wish);
  const PlanResult result = plan(problem, options);
  if (is_sanitized && !result.path) return;  // in so few iterations
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  // The path, its cost and its steering, in the eyes of the judge.
  PathClaims claims{.clearance = options.clearance, .steering = wish.steering};
  claims.cost = StatedCost{.cost = result.cost, .rule = result.rule};
  const PathCheck check = check_path(problem, *result.path, claims);
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_GE(*check.clearance, wish.margin - 1e-6);
  EXPECT_NEAR(result.anytime.back().cost, result.cost, 1e-3 * result.cost);
  if (wish.cost == Cost::length && !wish.has_zones) {
    EXPECT_NEAR(result.cost, length(result.path->segments), 1e-9);
  }
  if (wish.cost == Cost::time) {
    const SpeedOptions limits = speed_options(problem, *result.path);
    const double fastest = speed_profile(*result.path, problem.vehicle(), limits).duration;
    EXPECT_NEAR(result.cost, fastest, 1e-6);
  }
  // Nobody is hit.
  EXPECT_EQ(result.speeds.has_value(), wish.has_movers);
  if (result.speeds) {
    const DriveCheck drive = check_drive(problem, {*result.path, *result.speeds}, {wish.margin});
    EXPECT_TRUE(drive.valid) << drive.reason;
    EXPECT_GE(*drive.clearance, wish.margin);
  }
  // Who stops early has proven the gap, and nobody proves too much.
  EXPECT_LE(result.lower_bound, result.cost);
  if (wish.gap > 0 && !wish.has_movers && result.iterations < *options.budget.max_iterations) {
    EXPECT_LE(result.cost, (1 + wish.gap) * result.lower_bound.value() + 1e-6);
  }
  if (is_sanitized) return;
  EXPECT_LT(missing(result.path->segments, wish.min_stroke), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(OfTheDefaultPlanner, EveryCombination,
                         testing::Combine(testing::Values(Who::truck, Who::rig),
                                          testing::Values(Steering::reeds_shepp,
                                                          Steering::continuous_between_stops,
                                                          Steering::continuous),
                                          testing::Values(Cost::length, Cost::driver, Cost::time),
                                          testing::Bool(), testing::Values(false),
                                          testing::Values(0.0, 0.3), testing::Values(0.0, 1.0),
                                          testing::Values(0.0, 4.0)),
                         name_of_wish);

INSTANTIATE_TEST_SUITE_P(OfTheDefaultPlannerInZones, EveryCombination,
                         testing::Combine(testing::Values(Who::truck, Who::rig),
                                          testing::Values(Steering::reeds_shepp,
                                                          Steering::continuous_between_stops,
                                                          Steering::continuous),
                                          testing::Values(Cost::length, Cost::driver, Cost::time),
                                          testing::Bool(), testing::Values(true),
                                          testing::Values(0.0, 0.3), testing::Values(0.0),
                                          testing::Values(0.0)),
                         name_of_wish);

}  // namespace
}  // namespace vandplan

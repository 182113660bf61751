// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Rules of zones, and masks, in the eyes of planners and of the judge.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "planners/pricing.h"
#include "problem/masks.h"
#include "support/cases.h"
#include "support/grids.h"
#include "support/place_of_error.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/motion.h"
#include "vandplan/planner.h"
#include "vandplan/search.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using std::numbers::pi;

Scenario with_zones(const Pose& start, const Pose& goal, std::vector<Zone> zones) {
  return {.name = "zones",
          .bounds = {-40, 80, -40, 40},
          .start = start,
          .goal = goal,
          .zones = std::move(zones)};
}

PlanOptions of_iterations(std::int64_t iterations) {
  PlanOptions options;
  options.budget.max_iterations = is_sanitized ? iterations / 20 : iterations;
  return options;
}

/// Whether a point of the path is in the area, more than a millimetre from its edge, in that gear.
bool drives_through(const Path& path, const Bounds& area, Gear gear) {
  for (const PathPoint& point : sampled(path, 0.01)) {
    const auto& [x, y, heading] = point.pose;
    const bool is_in = x > area.x_min + 1e-3 && x < area.x_max - 1e-3 && y > area.y_min + 1e-3 &&
                       y < area.y_max - 1e-3;
    if (is_in && point.gear == gear) return true;
  }
  return false;
}

TEST(Zones, PathsGoAroundClosedOnes) {
  const Zone closed{.name = "lawn", .area = box(15, -5, 25, 8), .closed = true};
  const Problem problem = make_problem(with_zones({0, 0, 0}, {40, 0, 0}, {closed}));
  const PlanResult result = plan(problem, of_iterations(3000));
  if (is_sanitized && !result.path) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_GT(result.path->segments.size(), 1U);
  EXPECT_FALSE(drives_through(*result.path, {15, 25, -5, 8}, Gear::forward));
  EXPECT_LT(result.cost, 46);
}

TEST(Zones, PathsKeepToTheGearsOfOnes) {
  // The shortest way to a goal that points back is in reverse.
  for (const AllowedGears gears : {AllowedGears::forward, AllowedGears::reverse}) {
    const bool is_forward = gears == AllowedGears::forward;
    const Zone ramp{.area = box(5, -30, 15, 30), .gears = gears};
    const double heading = is_forward ? pi : 0;
    const Problem problem = make_problem(with_zones({0, 0, heading}, {25, 0, heading}, {ramp}));
    const PlanResult result = plan(problem, of_iterations(4000));
    if (is_sanitized && !result.path) return;
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_FALSE(
        drives_through(*result.path, {5, 15, -30, 30}, is_forward ? Gear::reverse : Gear::forward));
    EXPECT_TRUE(
        drives_through(*result.path, {5, 15, -30, 30}, is_forward ? Gear::forward : Gear::reverse));
  }
}

TEST(Zones, OneWayStreetsAreLeftByTheOtherWay) {
  // Two lanes through a wall; one leads to the east, the other one to the west.
  Scenario scenario =
      with_zones({0, 0, 0}, {40, 0, 0},
                 {{.area = box(16, -9, 24, 0), .direction = HeadingRange{pi - 0.6, pi + 0.6}},
                  {.area = box(16, 0, 24, 9), .direction = HeadingRange{-0.6, 0.6}}});
  scenario.obstacles = {box(16, 9, 24, 40), box(16, -40, 24, -9)};
  for (const bool is_back : {false, true}) {
    if (is_back) {
      std::swap(scenario.start, scenario.goal);
      scenario.start.heading = scenario.goal.heading = pi;
    }
    const PlanResult result = plan(make_problem(scenario), of_iterations(4000));
    if (is_sanitized && !result.path) return;
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    for (const PathPoint& point : sampled(*result.path, 0.05)) {
      if (point.pose.x < 16 || point.pose.x > 24) continue;
      EXPECT_TRUE(is_back ? point.pose.y < 1e-3 : point.pose.y > -1e-3) << point.pose.y;
    }
  }
}

TEST(Zones, TheJudgeRefusesWhatBreaksARuleByAMillimetre) {
  const auto check = [](const Zone& zone, const Path& path) {
    return check_path(make_problem(with_zones(path.start, end_pose(path), {zone})), path);
  };
  const Zone closed{.name = "lawn", .area = box(10, -5, 20, 5), .closed = true};
  EXPECT_TRUE(check(closed, {{0, 0, 0}, {{0, 9.9999}}}).valid);
  const PathCheck in = check(closed, {{0, 0, 0}, {{0, 10.001}}});
  EXPECT_EQ(in.reason, "the rear axle is in zones[0] (lawn), which is closed");
  EXPECT_EQ(in.hit, (Hit{HitKind::zone, 0}));
  // A corner of a millimetre is cut.
  EXPECT_FALSE(
      check({.area = {{10, -1e-3}, {11, -3}, {9, -3}}, .closed = true}, {{0, -2e-3, 0}, {{0, 20}}})
          .valid);
  const Zone one_gear{.area = box(10, -5, 20, 5), .gears = AllowedGears::forward};
  EXPECT_TRUE(check(one_gear, {{0, 0, 0}, {{0, 30}}}).valid);
  EXPECT_TRUE(check(one_gear, {{0, 0, pi}, {{0, -9.9999}, {0, 5}}}).valid);
  EXPECT_EQ(check(one_gear, {{0, 0, pi}, {{0, -10.001}, {0, 5}}}).reason,
            "the rear axle is in zones[0], where the gears are: forward");
  const Zone street{.area = box(10, -5, 20, 5), .direction = HeadingRange{-0.5, 0.5}};
  EXPECT_TRUE(check(street, {{0, 0, 0}, {{0, 30}}}).valid);
  EXPECT_TRUE(check(street, {{30, 0, pi}, {{0, -30}}}).valid);
  EXPECT_EQ(check(street, {{30, 0, pi}, {{0, 30}}}).reason,
            "the rear axle is in zones[0], where the direction of travel is -0.5 to 0.5 rad");
  EXPECT_TRUE(check(street, {{10, 0, 0}, {{0.1, 5}}}).valid);
  EXPECT_FALSE(check(street, {{10, 0, 0}, {{0.1, 5.001}}}).valid);
  // The wheels turn on the way.
  EXPECT_TRUE(check(street, {{10, 0, 0}, {{0, std::sqrt(50), 0.02}}}).valid);
  EXPECT_FALSE(check(street, {{10, 0, 0}, {{0, 7.073, 0.02}}}).valid);
}

TEST(Zones, OfTheBodyHoldForTheTrailerToo) {
  Scenario scenario = with_zones({0, 0, 0}, {10, 0, 0},
                                 {{.area = box(-9, -1, -8, 1), .closed = true, .body = true}});
  scenario.vehicle = semitrailer();
  const PathCheck check = check_path(make_problem(scenario), {{0, 0, 0}, {{0, 10}}});
  EXPECT_EQ(check.reason, "the trailer is in zones[0], which is closed");
  scenario.zones[0].body = false;
  EXPECT_TRUE(check_path(make_problem(scenario), {{0, 0, 0}, {{0, 10}}}).valid);
}

TEST(Zones, AStartInAClosedOneIsInCollision) {
  const Zone closed{.name = "lawn", .area = box(-1, -1, 1, 1), .closed = true};
  const PlanResult result =
      plan(make_problem(with_zones({0, 0, 0}, {40, 0, 0}, {closed})), of_iterations(10));
  EXPECT_EQ(result.status, PlanStatus::start_in_collision);
  EXPECT_EQ(result.reason, "the rear axle is in zones[0] (lawn), which is closed");
  EXPECT_EQ(result.hit, (Hit{HitKind::zone, 0}));
  const PlanResult back =
      plan(make_problem(with_zones({40, 0, 0}, {0, 0, 0}, {closed})), of_iterations(10));
  EXPECT_EQ(back.status, PlanStatus::goal_in_collision);
}

TEST(Zones, AreChecked) {
  const auto fault = [](Zone zone) {
    return place_of_error([&] {
      check_scenario(
          with_zones({}, {9, 0, 0}, {{.area = box(0, 0, 1, 1), .closed = true}, std::move(zone)}));
    });
  };
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .closed = true}), "nothing");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1)}), "zones[1]");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .cost = 0.5}), "zones[1].cost");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .cost = 1001}), "zones[1].cost");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .max_speed = 0}), "zones[1].max_speed");
  EXPECT_EQ(fault({.area = {{0, 0}, {1, 1}}, .closed = true}), "zones[1].area");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .direction = HeadingRange{0, 7}}),
            "zones[1].direction");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .direction = HeadingRange{0, std::nan("")}}),
            "zones[1].direction");
}

TEST(Zones, AreRefusedByPlannersThatDoNotKnowTheGear) {
  const auto place = [](const Zone& zone) {
    const Problem problem = make_problem(with_zones({0, 0, 0}, {40, 0, 0}, {zone}));
    return place_of_error([&] { (void)plan(problem, planner_named("prm"), of_iterations(100)); });
  };
  EXPECT_EQ(place({.area = box(15, -5, 25, 5), .gears = AllowedGears::forward}), "zones");
  EXPECT_EQ(place({.area = box(15, -5, 25, 5), .direction = HeadingRange{-1, 1}}), "zones");
  EXPECT_EQ(place({.area = box(15, -5, 25, 5), .closed = true}), "nothing");
}

TEST(Zones, OfAllKindsAreHonouredByEveryPlanner) {
  const std::vector<Zone> zones = {{.area = box(10, -4, 14, 4), .direction = HeadingRange{-1, 1}},
                                   {.area = box(16, -4, 20, 4), .gears = AllowedGears::forward},
                                   {.area = box(22, -20, 24, -1), .closed = true, .body = true},
                                   {.area = box(26, -4, 30, 4), .cost = 2}};
  const Problem problem = make_problem(with_zones({0, 0, 0}, {40, 0, 0}, zones));
  for (const Planner& planner : planners()) {
    if (!planner.can(Capability::gears)) continue;
    const PlanResult result = plan(problem, planner, of_iterations(300));
    EXPECT_NE(result.status, PlanStatus::rejected) << planner.name << ": " << result.reason;
    EXPECT_NE(result.status, PlanStatus::no_path) << planner.name;
  }
}

/// Cost of a path by the options, as planners compute it.
double cost_of(const Problem& problem, const Path& path, const CostOptions& cost = {}) {
  return planning::Pricing(problem.task(), cost)
      .cost(path.segments, search::ClearanceSampling::answer);
}

TEST(PricesOfZones, AreIntegrals) {
  const std::vector<Zone> zones = {{.area = box(10, -5, 20, 5), .cost = 3},
                                   {.area = box(15, -1, 40, 5), .cost = 10}};
  const Problem problem = make_problem(with_zones({0, 0, 0}, {30, 0, 0}, zones));
  EXPECT_NEAR(cost_of(problem, {{0, 0, 0}, {{0, 30}}}), 10 + 5 * 3 + 5 * 30 + 10 * 10, 1e-9);
  const CostOptions twice{.reverse_weight = 2};
  EXPECT_NEAR(cost_of(problem, {{0, 0, 0}, {{0, 12}, {0, -12}}}, twice), 3 * (10 + 2 * 3), 1e-9);
  // A quarter of a circle of 10 m around (10, 10), half of it in the zone.
  const Zone half{.area = box(10 + 10 * std::sqrt(0.5), -50, 60, 50), .cost = 101};
  const Problem arc = make_problem(with_zones({10, 0, 0}, {20, 10, pi / 2}, {half}));
  EXPECT_NEAR(cost_of(arc, {{10, 0, 0}, {{0.1, 5 * pi}}}), 5 * pi * (1 + 100.0 / 2), 1e-7);
}

TEST(PricesOfZones, MultiplyThatOfCloseness) {
  Scenario scenario = with_zones({0, 0, 0}, {30, 0, 0}, {{.area = box(10, -5, 20, 5), .cost = 3}});
  scenario.obstacles = {box(-30, 1.775, 70, 3)};  // half a metre beside the body
  const CostOptions careful{.clearance_weight = 2, .clearance_distance = 1};
  EXPECT_NEAR(cost_of(make_problem(scenario), {{0, 0, 0}, {{0, 30}}}, careful), 2 * (20 + 10 * 3),
              0.05);
}

TEST(PricesOfZones, OfTheBodyCountWhileAnyPartIsThere) {
  Scenario scenario =
      with_zones({0, 0, 0}, {60, 0, 0}, {{.area = box(30, -5, 32, 5), .cost = 11, .body = true}});
  const Footprint body = footprint(Vehicle{});
  const Path path{{0, 0, 0}, {{0, 60}}};
  EXPECT_NEAR(cost_of(make_problem(scenario), path), 60 + 10 * (2 + body.front + body.rear), 0.02);
  scenario.vehicle = semitrailer();
  EXPECT_GT(cost_of(make_problem(scenario), path), 60 + 10 * (2 + 13));
}

TEST(PricesOfZones, AreJudged) {
  for_each_case(3, 300, [](Rng& rng) {
    std::vector<Zone> zones;
    for (int i = 0; i < 3; ++i) {
      const Point at{uniform(-5, 30, rng), uniform(-10, 10, rng)};
      const double size = uniform(0.5, 10, rng);
      zones.push_back({.area = {{at.x, at.y}, {at.x + size, at.y}, {at.x, at.y + size}},
                       .cost = uniform(1, 20, rng),
                       .body = i == 2});
    }
    Path path{{0, 0, 0}, {}};
    for (int i = 0; i < 3; ++i) {
      path.segments.push_back({uniform(-0.14, 0.14, rng), uniform(-12, 12, rng)});
    }
    const Problem problem = make_problem(with_zones(path.start, end_pose(path), zones));
    const double cost = cost_of(problem, path);
    PathClaims claims{.cost = StatedCost{.cost = cost, .rule = shortest_style}};
    const PathCheck check = check_path(problem, path, claims);
    EXPECT_TRUE(check.valid) << check.reason;
    claims.cost->cost = 1.05 * cost + 0.2;
    EXPECT_FALSE(check_path(problem, path, claims).valid);
  });
}

TEST(PricesOfZones, LeadAround) {
  const Zone mud{.name = "mud", .area = box(10, -8, 30, 3), .cost = 20};
  const Problem problem = make_problem(with_zones({0, 0, 0}, {40, 0, 0}, {mud}));
  const PlanResult result = plan(problem, of_iterations(4000));
  if (is_sanitized && !result.path) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LT(result.cost, 60);
  ASSERT_TRUE(result.lower_bound);
  EXPECT_LE(*result.lower_bound, result.cost);
}

TEST(SpeedsOfZones, HoldFromEdgeToEdge) {
  const Problem problem = make_problem(with_zones({0, 0, 0}, {60, 0, 0},
                                                  {{.area = box(20, -5, 40, 5), .max_speed = 0.5},
                                                   {.area = box(30, -5, 60, 5), .max_speed = 1}}));
  const Path path{{0, 0, 0}, {{0, 60}}};
  const SpeedOptions options = speed_options(problem, path);
  const SpeedProfile speeds = speed_profile(path, problem.vehicle(), options);
  for (const Motion& motion : sampled(path, problem.vehicle(), speeds, 0.01)) {
    const double most = motion.pose.x < 20 ? 100 : motion.pose.x < 40 ? 0.5 : 1;
    EXPECT_LE(motion.v, most + 1e-3) << motion.pose.x;
  }
  EXPECT_GT(speeds.duration, 40 + 20);
  EXPECT_LT(speeds.duration, 40 + 20 + 15);
  EXPECT_TRUE(check_drive(problem, {path, speeds}).valid);
  const DriveCheck fast = check_drive(problem, {path, speed_profile(path, problem.vehicle())});
  EXPECT_EQ(fast.reason.substr(0, 22), "the speed in a zone is");
}

TEST(SpeedsOfZones, CountInTheCostThatIsTheTime) {
  const Zone slow{.area = box(10, -8, 30, 3), .max_speed = 0.2};
  const Problem problem = make_problem(with_zones({0, 0, 0}, {40, 0, 0}, {slow}));
  PlanOptions options = of_iterations(3000);
  options.cost.measure = CostMeasure::time;
  const PlanResult result = plan(problem, options);
  if (is_sanitized && !result.path) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LT(result.cost, 60);  // straight on it takes 100 s and more
}

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

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Lanes and areas of a map, and what they mean for a vehicle.
#include "io/roads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/ground.h"
#include "support/cases.h"
#include "vandplan/input_error.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using std::numbers::pi;

Polygon box(double x_min, double x_max, double y_min, double y_max) {
  return {{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}};
}

/// A lane along the x axis from x to x + 20, driven to the right.
io::Lane lane_along(double x, double y_min, double y_max) {
  return {.name = "lane",
          .left = {{x, y_max}, {x + 20, y_max}},
          .right = {{x, y_min}, {x + 20, y_min}}};
}

RoadScenario scenario_of(const io::Roads& roads, const Pose& start, const Pose& goal,
                         const RoadRules& rules = {}) {
  RoadScenario result;
  result.file.scenario.vehicle = Vehicle{2.0, 0.5, 0.5, 1.5, 4.0};
  result.file.scenario.start = start;
  result.file.scenario.goal = goal;
  io::add_roads(roads, rules, result);
  return result;
}

/// Length of all walls [m], without their thickness.
double length_of_walls(const Scenario& scenario) {
  double sum = 0.0;
  for (const Polygon& wall : scenario.obstacles) {
    sum += std::hypot(wall[3].x - wall[0].x, wall[3].y - wall[0].y);
  }
  return sum;
}

TEST(Roads, WallsStandAroundTheUnionOfLanesAndAreas) {
  io::Roads roads;
  roads.lanes = {lane_along(0, 0, 4), lane_along(20, 0, 4)};
  roads.areas = {{box(5, 15, -6, 0)}, {box(8, 30, -9, -5)}};  // the second overlaps the first
  const Scenario scenario = scenario_of(roads, {2, 2, 0}, {38, 2, 0}).file.scenario;
  // The lanes have 40 m above, 30 m below and 4 m at each end; then the sides of both areas.
  EXPECT_NEAR(length_of_walls(scenario), 78 + (6 + 3 + 5) + (3 + 22 + 4 + 15), 0.05);
  EXPECT_EQ(scenario.bounds, (Bounds{-20, 60, -29, 24}));
}

TEST(Roads, ALaneThatTouchesItselfHasNoZoneInTheFrameOfTheScenario) {
  // A corner of the left edge is on the right edge. Rounding puts it on either side.
  for_each_case(9, 2000, [](Rng& rng) {
    const auto any = [&](double least, double most) {
      return std::round(uniform(least, most, rng) * 1e4) / 1e4;
    };
    const Point begin{any(-500, 500), any(-500, 500)};
    const Point half{any(8, 12), any(-1, 1)};
    const auto point_at = [&](int halves, double above) {
      return io::rounded({begin.x + halves * half.x, begin.y + halves * half.y + above});
    };
    io::Roads roads;
    roads.lanes = {{.name = "lane",
                    .left = {point_at(0, 3), point_at(1, 0), point_at(2, 3)},
                    .right = {point_at(0, 0), point_at(2, 0)}}};
    const Pose start{any(-500, 500), any(-500, 500), 0};
    EXPECT_NO_THROW(scenario_of(roads, start, start, {.open_edges = true}));
  });
}

TEST(Roads, WallsAreJustOutside) {
  io::Roads roads;
  roads.areas = {{box(0, 20, 0, 10)}};
  const Scenario scenario = scenario_of(roads, {4, 5, 0}, {15, 5, 0}).file.scenario;
  ASSERT_EQ(scenario.obstacles.size(), 4U);
  EXPECT_EQ(scenario.obstacles[0], (Polygon{{0, 0}, {0, -0.001}, {20, -0.001}, {20, 0}}));
}

TEST(Roads, NarrowGapsAreGround) {
  io::Roads roads;
  roads.lanes = {lane_along(0, 0, 4), lane_along(20.008, 0.003, 4.003)};
  const Scenario near = scenario_of(roads, {2, 2, 0}, {38, 2, 0}).file.scenario;
  EXPECT_NEAR(length_of_walls(near), 88, 0.05);
  roads.lanes[1] = lane_along(20.03, 0, 4);
  const Scenario apart = scenario_of(roads, {2, 2, 0}, {38, 2, 0}).file.scenario;
  EXPECT_NEAR(length_of_walls(apart), 96, 0.05);
}

// A line from the ground to a place beside it passes a wall.
TEST(Roads, NobodyLeavesTheGround) {
  for_each_case(1, 60, [](Rng& rng) {
    io::Roads roads;
    for (int i = 0; i < 6; ++i) {
      const Pose pose{uniform(0, 30, rng), uniform(0, 30, rng), uniform(-pi, pi, rng)};
      Polygon area;
      for (const auto& [x, y] : box(-uniform(2, 9, rng), 5, -3, uniform(2, 9, rng))) {
        const Pose corner = compose(pose, {x, y, 0});
        area.push_back({corner.x, corner.y});
      }
      roads.areas.push_back({area});
    }
    const auto is_on_ground = [&](const Point& point) {
      return std::any_of(roads.areas.begin(), roads.areas.end(),
                         [&](const io::MapArea& area) { return contains(area.outline, point); });
    };
    const Point corner = roads.areas[0].outline[0];
    const Point other = roads.areas[0].outline[2];
    const Pose middle{(corner.x + other.x) / 2, (corner.y + other.y) / 2, 0};
    const Scenario scenario = scenario_of(roads, middle, middle).file.scenario;
    for (int i = 0; i < 100; ++i) {
      const Point from{uniform(0, 30, rng), uniform(0, 30, rng)};
      const Point to{uniform(-10, 40, rng), uniform(-10, 40, rng)};
      if (!is_on_ground(from) || is_on_ground(to)) continue;
      const CollisionChecker checker(Footprint{0.01, 0.01, 0.01}, {-100, 100, -100, 100},
                                     scenario.obstacles);
      const double length = std::hypot(to.x - from.x, to.y - from.y);
      const LocalPose pose(Pose{from.x, from.y, std::atan2(to.y - from.y, to.x - from.x)});
      EXPECT_FALSE(checker.is_free(pose, Segment{0, length, 0}));
    }
  });
}

TEST(Roads, AOneWayLaneIsAZone) {
  io::Roads roads;
  roads.lanes = {lane_along(0, 0, 4)};
  const RoadScenario made = scenario_of(roads, {3, 2, 0}, {15, 2, 0});
  ASSERT_EQ(made.file.scenario.zones.size(), 1U);
  const Zone& zone = made.file.scenario.zones[0];
  EXPECT_EQ(zone.name, "lane");
  EXPECT_EQ(zone.area, (Polygon{{0, 0}, {20, 0}, {20, 4}, {0, 4}}));
  EXPECT_EQ(zone.direction, (HeadingRange{-1.5708, 1.5708}));
  EXPECT_EQ(made.notes[0], "lanes: 1, areas: 0, zones: 1");
  const Problem problem = make_problem(made.file.scenario);
  const CollisionChecker& checker = *problem.task().checker;
  const LocalPose ahead = to_local(*problem.world(), Pose{5, 2, 0});
  EXPECT_TRUE(checker.is_free(ahead, Segment{0, 5, 0}));
  EXPECT_FALSE(checker.is_free(to_local(*problem.world(), Pose{12, 2, 0}), Segment{0, -5, 0}));
  roads.lanes[0].is_one_way = false;
  EXPECT_TRUE(scenario_of(roads, {3, 2, 0}, {15, 2, 0}).file.scenario.zones.empty());
}

TEST(Roads, ABendIsDividedIntoZones) {
  io::Lane bend;
  for (int i = 0; i <= 18; ++i) {
    const double angle = i * pi / 18;  // half a turn to the left
    bend.left.push_back({10 * std::sin(angle), -10 * std::cos(angle)});
    bend.right.push_back({14 * std::sin(angle), -14 * std::cos(angle)});
  }
  io::Roads roads;
  roads.lanes = {bend};
  const Scenario scenario = scenario_of(roads, {0.5, -12, 0}, {0.5, 12, pi}).file.scenario;
  ASSERT_GE(scenario.zones.size(), 5U);
  ASSERT_LE(scenario.zones.size(), 7U);
  double area = 0.0;
  for (const Zone& zone : scenario.zones) {
    area += std::abs(io::twice_area(zone.area)) / 2;
    const Point& corner = zone.area[0];
    const double along = std::atan2(corner.x, -corner.y);  // direction of travel there
    const double middle = (zone.direction->from + zone.direction->to) / 2;
    EXPECT_LE(std::abs(wrap_angle(along - middle)), pi / 6);
  }
  EXPECT_NEAR(area, std::abs(io::twice_area(io::outline(bend))) / 2, 1e-9);
}

// The cuts between its zones stay in the lane, though the inner edge of each bend is shorter.
TEST(Roads, AWindingLaneKeepsAllZones) {
  io::Lane winding;
  io::Lane opposite;
  for (int i = 0; i <= 400; ++i) {
    const double x = i;
    const double y = 40 * std::sin(x / 40);
    const double slope = std::cos(x / 40);
    const double out = 3.5 / std::hypot(1.0, slope);
    winding.left.push_back({x, y});
    winding.right.push_back({x + out * slope, y - out});
    opposite.right.insert(opposite.right.begin(), {x - out * slope, y + out});
  }
  opposite.left.assign(winding.left.rbegin(), winding.left.rend());
  io::Roads roads;
  roads.lanes = {winding, opposite};
  const RoadScenario made = scenario_of(roads, {1, -0.5, 0.7}, {399, 40 * std::sin(9.975) - 1, 0});
  EXPECT_EQ(made.notes.size(), 1U) << made.notes.back();  // None is left out.
  double area = 0.0;
  for (const Zone& zone : made.file.scenario.zones) area += std::abs(io::twice_area(zone.area)) / 2;
  EXPECT_NEAR(area,
              (std::abs(io::twice_area(io::outline(winding))) +
               std::abs(io::twice_area(io::outline(opposite)))) /
                  2,
              1e-6);
}

TEST(Roads, LanesThatCrossHaveNoZoneThere) {
  io::Roads roads;
  io::Lane across{.left = {{8, -10}, {8, 14}}, .right = {{12, -10}, {12, 14}}};
  roads.lanes = {lane_along(0, 0, 4), across, lane_along(40, 0, 4)};
  const RoadScenario made = scenario_of(roads, {2, 2, 0}, {18, 2, 0});
  ASSERT_EQ(made.file.scenario.zones.size(), 1U);
  EXPECT_EQ(made.file.scenario.zones[0].area[0].x, 40);
  EXPECT_EQ(made.notes[1], "parts of one-way lanes open to both directions, where lanes cross: 2");
  // Lanes that merge keep their zones, and so do lanes side by side.
  io::Lane merging{.left = {{0, 8}, {20, 4}}, .right = {{0, 5}, {20, 1}}};
  io::Lane opposite{.left = {{20, 0}, {0, 0}}, .right = {{20, 4}, {0, 4}}};
  roads.lanes = {lane_along(0, 0, 4), merging};
  EXPECT_EQ(scenario_of(roads, {2, 2, 0}, {18, 2, 0}).file.scenario.zones.size(), 2U);
  roads.lanes = {lane_along(0, -4, 0), opposite};
  EXPECT_EQ(scenario_of(roads, {2, -2, 0}, {18, -2, 0}).file.scenario.zones.size(), 2U);
  // A wedge beside a lane, with a sharp corner at its begin, does not overlap it.
  const io::Lane wedge{.left = {{20, 4}, {0, 4}}, .right = {{20, 4}, {0, 8}}};
  roads.lanes = {lane_along(0, 0, 4), wedge};
  EXPECT_EQ(scenario_of(roads, {2, 2, 0}, {18, 2, 0}).file.scenario.zones.size(), 2U);
  opposite.is_one_way = false;
  roads.lanes = {lane_along(0, 0, 4), opposite};
  EXPECT_TRUE(scenario_of(roads, {2, 2, 0}, {18, 2, 0}).file.scenario.zones.empty());
}

TEST(Roads, SpeedLimitsAreZonesWithOrWithoutADirection) {
  io::Roads roads;
  io::Lane across{.name = "across", .left = {{8, -10}, {8, 14}}, .right = {{12, -10}, {12, 14}}};
  across.max_speed = 30 / 3.6;
  roads.lanes = {lane_along(0, 0, 4), across};
  const auto zones = [&](bool both_ways) {
    return scenario_of(roads, {2, 2, 0}, {18, 2, 0}, {.both_ways = both_ways, .open_edges = true})
        .file.scenario.zones;
  };
  // Lanes that cross lose their directions, not their limits.
  ASSERT_EQ(zones(false).size(), 1U);
  EXPECT_EQ(zones(false)[0].name, "across");
  EXPECT_EQ(zones(false)[0].max_speed, 8.3333);
  EXPECT_EQ(zones(false)[0].direction, std::nullopt);
  EXPECT_EQ(zones(true), zones(false));
  roads.lanes = {across};
  ASSERT_EQ(zones(false).size(), 1U);
  EXPECT_TRUE(zones(false)[0].direction);
  EXPECT_EQ(zones(false)[0].max_speed, 8.3333);
}

TEST(Roads, SpeedsHaveUnits) {
  EXPECT_EQ(io::speed_from(3, "m/s"), 3);
  EXPECT_DOUBLE_EQ(*io::speed_from(36, "km/h"), 10);
  EXPECT_DOUBLE_EQ(*io::speed_from(100, "mph"), 44.704);
  EXPECT_EQ(io::speed_from(3, "knots"), std::nullopt);
  EXPECT_EQ(io::speed_from(0, "m/s"), std::nullopt);
}

TEST(Roads, WhatIsLeftOutIsAWarning) {
  io::Roads roads;
  roads.lanes = {lane_along(0, 0, 4)};
  EXPECT_TRUE(scenario_of(roads, {2, 2, 0}, {18, 2, 0}).file.warnings.empty());
  roads.left_out = {{"signal", 3}, {"lane sidewalk", 1}};
  EXPECT_EQ(scenario_of(roads, {2, 2, 0}, {18, 2, 0}).file.warnings,
            std::vector<std::string>{"left out: lane sidewalk (1), signal (3)"});
}

TEST(Roads, WorkWithoutEndIsRefused) {
  io::Effort effort;
  EXPECT_NO_THROW(effort.spend(4'000'000'000));
  EXPECT_THROW(effort.spend(2'000'000'000), InputError);
}

TEST(Roads, RulesAreLeftOutOnRequest) {
  io::Roads roads;
  roads.lanes = {lane_along(0, 0, 4)};
  const Scenario scenario =
      scenario_of(roads, {30, 2, 0}, {15, 2, 0}, {.both_ways = true, .open_edges = true})
          .file.scenario;
  EXPECT_TRUE(scenario.zones.empty());
  EXPECT_TRUE(scenario.obstacles.empty());
}

TEST(Roads, StartAndGoalAreOnTheGround) {
  io::Roads roads;
  roads.lanes = {lane_along(0, 0, 4)};
  try {
    (void)scenario_of(roads, {30, 2, 0}, {15, 2, 0});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "start: is at 30, 2, beside all lanes and areas, expected a place on one of them");
  }
  EXPECT_THROW((void)scenario_of(roads, {3, 2, 0}, {15, 5, 0}), InputError);
  // One of a set of goals is enough, also without a corner on the ground.
  const auto with_goals = [&](const std::vector<GoalRegion>& goals) {
    RoadScenario result;
    result.file.scenario.vehicle = Vehicle{2.0, 0.5, 0.5, 1.5, 4.0};
    result.file.scenario.start = {3, 2, 0};
    result.file.scenario.goal_set = goals;
    io::add_roads(roads, {}, result);
  };
  const GoalRegion beside{.x = {10, 11}, .y = {6, 7}, .heading = any_heading};
  const GoalRegion across{.x = {10, 11}, .y = {-1, 7}, .heading = any_heading};
  EXPECT_THROW(with_goals({beside}), InputError);
  EXPECT_NO_THROW(with_goals({beside, across}));
}

}  // namespace
}  // namespace vandplan

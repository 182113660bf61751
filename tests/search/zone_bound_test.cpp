// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Do zones and masks add to every path what is proven, and is about that much proven?
#include "search/zone_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support/cases.h"
#include "support/draws.h"
#include "support/grids.h"
#include "support/problems.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

using search::MetreCost;
using std::numbers::pi;

/// The bound of a task after so many steps at most.
double bound_of(const Task& task, const MetreCost& cost, int steps = 30'000) {
  search::ZoneBound bound(task, 0, cost);
  for (int i = 0; i < steps && bound.step(); ++i) {
  }
  return bound.bound();
}

bool is_closed(const Scenario& scenario) {
  const Problem problem = make_problem(scenario);
  search::ZoneBound bound(problem.task(), 0);
  while (bound.step()) {
  }
  return bound.is_proven();
}

/// A wall of 8 m with a gate of 18 m on the way from (0, 0) to (40, 0), turned about the start.
Scenario turned_gate(double turn, std::vector<Zone> zones) {
  const auto turned = [turn](Polygon area) {
    for (Point& corner : area) {
      const Pose there = compose({0, 0, turn}, {corner.x, corner.y, 0});
      corner = {there.x, there.y};
    }
    return area;
  };
  Scenario scenario{.bounds = {-45, 45, -45, 45}, .start = {0, 0, turn}};
  scenario.goal = compose(scenario.start, {40, 0, 0});
  scenario.obstacles = {turned(box(16, 9, 24, 90)), turned(box(16, -90, 24, -9))};
  for (Zone& zone : zones) {
    zone.area = turned(zone.area);
    if (zone.direction) {
      zone.direction = HeadingRange{zone.direction->from + turn, zone.direction->to + turn};
    }
  }
  scenario.zones = std::move(zones);
  return scenario;
}

double bound_of(const Scenario& scenario, const MetreCost& cost) {
  const Problem problem = make_problem(scenario);
  return bound_of(problem.task(), cost);
}

TEST(ZoneBound, CountsADearZoneInTheOnlyGate) {
  // 5 m that cost twice as much more; ways along sides and diagonals lose 8 %, cells at the ends a
  // metre.
  const Zone dear{.area = box(17.5, -9, 22.5, 9), .cost = 3};
  const double added = bound_of(turned_gate(0, {dear}), {.priced = 1});
  EXPECT_GT(added, 0.9 * 10);
  EXPECT_LE(added, 10);
  const double all = bound_of(turned_gate(0, {dear}), {.anywhere = 1, .priced = 1});
  EXPECT_GT(all, 0.92 * 50 - 1.5);
  EXPECT_LE(all, 50);
}

TEST(ZoneBound, CountsNothingWhereThereIsAWayBesideADearZone) {
  const Zone half{.area = box(17.5, -9, 22.5, 5), .cost = 3};
  EXPECT_EQ(bound_of(turned_gate(0, {half}), {.priced = 1}), 0.0);
}

TEST(ZoneBound, MultipliesThePricesOfZones) {
  const Zone dear{.area = box(17.5, -9, 22.5, 9), .cost = 3};
  const Zone body{
      .area = box(19.9, -9, 20.1, 9), .cost = 2, .body = true};  // reaches 1.2 m further
  const double added = bound_of(turned_gate(0, {dear, body}), {.priced = 1});
  EXPECT_GT(added, 0.9 * (10 + 3 * 2.4));
  EXPECT_LE(added, 10 + 3 * 6.0);
}

TEST(ZoneBound, CountsTheSecondsOfSlowZones) {
  const Zone slow{.area = box(17.5, -9, 22.5, 9), .max_speed = 0.5};
  const MetreCost seconds{.second = 1, .top_speed = 2};
  const double added = bound_of(turned_gate(0, {slow}), seconds);
  EXPECT_GT(added, 0.9 * 7.5);
  EXPECT_LE(added, 7.5);
  EXPECT_EQ(bound_of(turned_gate(0, {slow}), {.second = 1, .top_speed = 0.4}), 0.0);
}

TEST(ZoneBound, LeavesOutSecondsWhereTheVehicleGainsSpeed) {
  const Zone slow{.area = box(17.5, -9, 22.5, 9), .max_speed = 0.5};
  MetreCost seconds{.second = 1, .top_speed = 2, .ramps = {20, 0}};
  EXPECT_GT(bound_of(turned_gate(0, {slow}), seconds), 0.9 * 3);
  EXPECT_LE(bound_of(turned_gate(0, {slow}), seconds), 4);
  seconds.ramps = {0, 23};
  EXPECT_EQ(bound_of(turned_gate(0, {slow}), seconds), 0.0);
}

TEST(ZoneBound, CountsTheLeastOfAMask) {
  const std::vector<std::string> rows(40, std::string(10, '.'));
  const OccupancyGrid map = grid_of(rows, 1, {15, -20, 0.1});
  std::vector<std::uint8_t> percents(400, 50);
  Scenario scenario = turned_gate(0, {});
  scenario.masks = {cost_mask(map, 4)};
  scenario.masks[0].percents = std::make_shared<const std::vector<std::uint8_t>>(percents);
  const double added = bound_of(scenario, {.priced = 1});
  EXPECT_GT(added, 0.85 * 20);
  EXPECT_LE(added, 20.2);
  for (std::size_t i = 0; i < 400; ++i) percents[i] = i % 10 < 5 ? 50 : 0;  // the left half
  scenario.masks[0].percents = std::make_shared<const std::vector<std::uint8_t>>(percents);
  EXPECT_GT(bound_of(scenario, {.priced = 1}), 0.85 * 10);
  EXPECT_LE(bound_of(scenario, {.priced = 1}), 10.2);
}

TEST(ZoneBound, KnowsThatHalfOfAllDirectionsIsOneWay) {
  for (int i = 0; i < cases(4); ++i) {
    const double turn = pi * i / 4 + (i < 2 ? 0.0 : 0.1 * i);
    const Zone against{.area = box(17, -9, 23, 9), .direction = HeadingRange{pi / 2, 3 * pi / 2}};
    EXPECT_TRUE(is_closed(turned_gate(turn, {against}))) << turn;
    const Zone along{.area = against.area, .direction = HeadingRange{-pi / 2, pi / 2}};
    EXPECT_FALSE(is_closed(turned_gate(turn, {along}))) << turn;
    const Zone more{.area = against.area, .direction = HeadingRange{1.5, 3 * pi / 2}};
    EXPECT_FALSE(is_closed(turned_gate(turn, {more}))) << turn;
  }
}

// A lattice over a large site takes neither time nor memory before it is flooded.
/// A zone from side to side, between bounds in y and other ones.
Scenario band(Zone zone, double edge) {
  zone.area = box(18, -edge, 30, edge);
  return {.bounds = {-10, 50, -20, 20}, .goal = {40, 0, 0}, .zones = {std::move(zone)}};
}

TEST(ZoneBound, KnowsThatNoWayLeadsBetweenAZoneAndTheBoundsOnItsEdge) {
  const HeadingRange west{2.6, 3.7};
  for (const Zone& zone : {Zone{.closed = true}, Zone{.direction = west}}) {
    for (const double edge : {20.0, 20.2, 25.0}) EXPECT_TRUE(is_closed(band(zone, edge))) << edge;
    EXPECT_FALSE(is_closed(band(zone, 19.999)));
  }
  const auto bound = [](double edge) {
    return bound_of(make_problem(band({.cost = 5}, edge)).task(), {.priced = 1.0});
  };
  EXPECT_NEAR(bound(20), bound(25), 1e-6);
  EXPECT_GT(bound(20), 0.9 * 4 * 12.0);
  EXPECT_EQ(bound(19.999), 0.0);
}

TEST(ZoneBound, KnowsThatAZoneBesideTheBoundsClosesNothing) {
  Scenario scenario{.bounds = {-10, 50, -0.3, 0.3}, .goal = {40, 0, 0}};
  scenario.zones = {{.area = box(-20, 0.3, 60, 9), .closed = true},
                    {.area = box(-20, -9, 60, -0.3), .closed = true}};
  EXPECT_FALSE(is_closed(scenario));
}

TEST(ZoneBound, HoldsOnlyCellsNearItsFloods) {
  const Zone street{.area = box(12, -12, 28, 12), .direction = HeadingRange{-pi / 2, pi / 2}};
  Scenario scenario = turned_gate(0.0, {street});
  scenario.bounds = {-500, 500, -500, 500};
  scenario.obstacles = {box(-499, -499, -498, -498), box(498, 498, 499, 499)};
  const Problem problem = make_problem(scenario);
  for (const MetreCost& cost : {MetreCost{}, MetreCost{.anywhere = 1}}) {
    search::ZoneBound bound(problem.task(), 0, cost);
    EXPECT_GT(bound.held(), 0);
    EXPECT_LT(bound.held(), 1000);
    for (int i = 0; i < 20 && bound.step(); ++i) {
    }
    EXPECT_LT(bound.held(), 100'000);
  }
}

TEST(ZoneBound, ProvesTheWayAroundAStreet) {
  for (const double turn : {0.0, 0.6}) {
    const Zone against{.area = box(12, -12, 28, 12), .direction = HeadingRange{pi / 2, 3 * pi / 2}};
    Scenario scenario = turned_gate(turn, {against});
    scenario.obstacles.clear();
    // Around a corner: 2 hypot(12, 12) + 16.
    const double around = bound_of(scenario, {.anywhere = 1});
    EXPECT_GT(around, 0.9 * 49.9);
    EXPECT_LE(around, 49.95);
  }
}

/// Zones and a mask with prices and speeds, and one-way streets, here and there.
Scenario any_ground(Rng& rng) {
  Scenario scenario{.bounds = {-30, 30, -30, 30}, .start = {0, 0, uniform(-pi, pi, rng)}};
  for (int i = static_cast<int>(uniform(1, 5, rng)); i > 0; --i) {
    const double x = uniform(-25, 25, rng), y = uniform(-25, 25, rng);
    const double turn = uniform(-pi, pi, rng);
    Zone zone{.body = chance(0.3, rng)};
    for (const Point& corner : box(0, 0, any_size(0.5, 40, rng), any_size(0.5, 40, rng))) {
      const Pose there = compose({x, y, turn}, {corner.x, corner.y, 0});
      zone.area.push_back({there.x, there.y});
    }
    zone.cost = chance(0.6, rng) ? any_size(1, 30, rng) : 1.001;
    if (chance(0.4, rng)) zone.max_speed = any_size(0.05, 3, rng);
    if (chance(0.3, rng)) {
      const double from = uniform(-pi, pi, rng);
      zone.direction = HeadingRange{from, from + (chance(0.5, rng) ? pi : uniform(1, 5, rng))};
    }
    scenario.zones.push_back(zone);
  }
  if (chance(0.3, rng)) {
    OccupancyGrid map = random_grid(20, 20, 0.5, rng);
    map.resolution = any_size(0.2, 3, rng);
    map.origin = {uniform(-30, 10, rng), uniform(-30, 10, rng), uniform(-pi, pi, rng)};
    scenario.masks.push_back(chance(0.5, rng) ? cost_mask(map, 5) : speed_mask(map, 10));
    std::vector<std::uint8_t> percents(400);
    for (std::uint8_t& percent : percents) {
      percent = chance(0.2, rng) ? Mask::unknown : static_cast<std::uint8_t>(uniform(0, 99, rng));
    }
    scenario.masks[0].percents =
        std::make_shared<const std::vector<std::uint8_t>>(std::move(percents));
  }
  return scenario;
}

/// Cost of a drive by what the checker says of its ground; the ramps count along the drive.
double cost_along(const Task& task, std::span<const Segment> drive, const MetreCost& cost) {
  double sum = 0.0, driven = 0.0;
  const double whole = length(drive);
  LocalState state = start_state(task);
  for (const Segment& segment : drive) {
    for (const GroundPart& part : task.checker->ground_along(state, segment)) {
      const double metres = part.end - part.begin;
      const double free = std::max(std::min(driven + part.end, whole - cost.ramps[1]) -
                                       std::max(driven + part.begin, cost.ramps[0]),
                                   0.0);
      sum += (cost.anywhere + cost.priced * (part.cost - 1)) * metres;
      sum += cost.second * std::max(1 / part.max_speed - 1 / cost.top_speed, 0.0) * free;
    }
    driven += std::abs(segment.length);
    state = advance(task.vehicle, state, segment);
  }
  return sum;
}

TEST(ZoneBound, HoldsForEveryDrive) {
  Rng rng(11);
  constexpr int some_steps = 1000;
  int free = 0, close = 0;
  for (int i = 0; i < cases(500); ++i) {
    Scenario scenario = any_ground(rng);
    scenario.vehicle.min_turning_radius = any_size(0.5, 8, rng);
    std::vector<Segment> drive;
    for (int k = static_cast<int>(uniform(1, 6, rng)); k > 0; --k) {
      const double turn = chance(0.4, rng) ? 0.0 : uniform(-1, 1, rng);
      drive.push_back(
          {turn / scenario.vehicle.min_turning_radius, any_sign(any_size(0.3, 20, rng), rng)});
    }
    scenario.goal = end_pose({scenario.start, drive});
    if (!contains(scenario.bounds, {scenario.goal.x, scenario.goal.y})) continue;
    const Problem problem = make_problem(scenario);
    const Task& task = problem.task();
    if (!task.checker->is_free(start_state(task), drive)) continue;
    ++free;
    const MetreCost cost{.anywhere = chance(0.5, rng) ? 0.0 : 1.0,
                         .priced = uniform(0, 1, rng),
                         .second = uniform(0.1, 1, rng),
                         .top_speed = uniform(0.5, 3, rng),
                         .ramps = {uniform(0, 5, rng), uniform(0, 5, rng)}};
    search::ZoneBound bound(task, 0, cost);
    for (int k = 0; k < some_steps && bound.step(); ++k) {
    }
    const double driven = cost_along(task, drive, cost);
    ASSERT_LE(bound.bound(), driven + 1e-6) << i;
    ASSERT_FALSE(bound.is_proven()) << i;
    search::ZoneBound way(task, 0);
    for (int k = 0; k < some_steps && way.step(); ++k) {
    }
    ASSERT_FALSE(way.is_proven()) << i;
    if (driven > 1 && bound.bound() > 0.85 * driven) ++close;
  }
  EXPECT_GT(free, cases(500) / 5);
  if (!is_sanitized) {
    EXPECT_GT(close, 20);
  }
}

}  // namespace
}  // namespace vandplan

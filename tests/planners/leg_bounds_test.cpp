// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// No drive past vias costs less than what is proven leg by leg, and little less is proven than the
// cheapest drive costs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stop_token>
#include <string>
#include <vector>

#include "planners/leg_bounds.h"
#include "planners/pricing.h"
#include "support/cases.h"
#include "support/draws.h"
#include "support/problems.h"
#include "vandplan/planner.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using std::numbers::pi;

constexpr std::int64_t some_work = 20'000;

Problem past(std::vector<Via> via, const Pose& goal, std::vector<Polygon> obstacles = {},
             const Pose& start = {}) {
  return make_problem({.bounds = {-500, 500, -500, 500},
                       .start = start,
                       .goal = goal,
                       .via = std::move(via),
                       .obstacles = std::move(obstacles)});
}

Via through(const Pose& pose) { return {{region_of_pose(pose)}}; }

Via in_any_heading(double x, double y) {
  GoalRegion region = region_of_pose({x, y, 0});
  region.heading = any_heading;
  return {{region}};
}

CostOptions dear_changes(double gear_change_cost = 5.0) {
  return {.forward_weight = 1.0, .reverse_weight = 2.0, .gear_change_cost = gear_change_cost};
}

double leg_bound(const Problem& problem, const CostOptions& cost, std::int64_t work = some_work) {
  const planning::Pricing pricing(problem.task(), cost);
  return planning::LegBounds(problem.task(), pricing, work).least();
}

TEST(LegBounds, CountZonesThatEveryWayOfALegLeadsThrough) {
  Scenario scenario{
      .bounds = {-10, 90, -20, 20}, .goal = {80, 0, 0}, .via = {in_any_heading(40, 0)}};
  scenario.zones = {{.area = box(15, -25, 25, 25), .cost = 3},
                    {.area = box(55, -25, 60, 25), .cost = 2}};
  PlanOptions options;
  options.budget.max_iterations = is_sanitized ? 500 : 60'000;
  const PlanResult result = plan(make_problem(scenario), options);
  ASSERT_TRUE(result.path);
  EXPECT_LE(*result.lower_bound, result.cost * (1 + 1e-9));
  if (!is_sanitized) {
    EXPECT_GT(*result.lower_bound, 80 + 0.8 * 25);
  }
}

// ---- What is proven is true ----

/// Segments of random lengths, gears and curvatures, or of shortest words between random poses.
std::vector<Segment> any_drive(double radius, Rng& rng) {
  std::vector<Segment> drive;
  Pose pose;
  for (int i = 0; i < 4; ++i) {
    const Pose next{uniform(-30, 30, rng), uniform(-30, 30, rng), uniform(-pi, pi, rng)};
    if (chance(0.5, rng)) {
      const Piece word = reeds_shepp(pose, next, radius);
      for (std::size_t k = 0; k < word.count; ++k) drive.push_back(word.segments[k]);
    } else {
      const double length = any_sign(any_size(0.01, 30, rng), rng);
      drive.push_back({uniform(-1, 1, rng) / radius, length});
    }
    pose = end_pose({{}, drive});
  }
  return drive;
}

/// A region that holds the pose: hardly more, or wide intervals, an area, or both ways.
GoalRegion any_region_around(const Pose& pose, Rng& rng) {
  const double off = 4e-7;  // a path need not be more exact
  GoalRegion region =
      region_of_pose({pose.x + uniform(-off, off, rng), pose.y + uniform(-off, off, rng),
                      pose.heading + uniform(-off, off, rng)});
  if (chance(0.4, rng)) return region;
  const auto wide = [&rng](double value, double most) {
    return Interval{value - uniform(0, most, rng), value + uniform(0, most, rng)};
  };
  if (chance(0.5, rng)) region.x = wide(pose.x, 5);
  if (chance(0.5, rng)) region.y = wide(pose.y, 5);
  if (chance(0.2, rng)) region.area = box(pose.x - 3, pose.y - 1, pose.x + 1, pose.y + 4);
  if (chance(0.3, rng)) region.heading = any_heading;
  if (chance(0.5, rng)) {
    const Interval heading = wide(pose.heading, 1);
    region.heading = {heading.least, heading.most};
  }
  if (chance(0.3, rng)) {
    region.either_way = true;
    region.heading = {region.heading.from + pi, region.heading.to + pi};
  }
  return region;
}

CostOptions any_prices(Rng& rng) {
  if (chance(0.25, rng)) return shortest_style;
  CostOptions cost = dear_changes(any_size(0.1, 20, rng));
  cost.reverse_weight = uniform(1, 3, rng);
  if (chance(0.3, rng)) cost.initial_gear = InitialGear::reverse;
  if (chance(0.3, rng)) cost.initial_gear = InitialGear::forward;
  if (chance(0.3, rng)) cost.measure = CostMeasure::time;
  if (cost.measure == CostMeasure::time) cost = {.measure = CostMeasure::time};
  return cost;
}

TEST(LegBounds, HoldForEveryDrive) {
  Rng rng(1);
  int close = 0;
  const int worlds = cases(500);
  for (int i = 0; i < worlds; ++i) {
    const double radius = Vehicle{}.min_turning_radius;
    const std::vector<Segment> drive = any_drive(radius, rng);
    std::vector<Via> via;
    Pose pose;
    for (const Segment& segment : drive) {
      if (chance(0.3, rng)) {
        const double share = chance(0.5, rng) ? 0.0 : uniform01(rng);
        const Pose there = advance(pose, part_of(segment, 0.0, share * std::abs(segment.length)));
        Via& added = via.emplace_back();
        added.any_of.push_back(any_region_around(there, rng));
        added.stop = share == 0.0 && chance(0.5, rng);
        if (chance(0.3, rng)) {
          added.any_of.push_back(any_region_around({uniform(-30, 30, rng), 3, 1}, rng));
        }
      }
      pose = advance(pose, segment);
    }
    const Problem problem = past(via, pose);
    const CostOptions cost = any_prices(rng);
    const planning::Pricing pricing(problem.task(), cost);
    const double least = pricing.cost(drive, search::ClearanceSampling::answer);
    for (const std::int64_t work : {std::int64_t{0}, some_work}) {
      const double bound = leg_bound(problem, cost, work);
      ASSERT_LE(bound, least * (1 + 1e-9) + 1e-9) << "world " << i << ", work " << work;
      close += bound > 0.9 * least ? 1 : 0;
    }
  }
  EXPECT_GE(close, worlds / 20);
}

// ---- Much is proven ----

TEST(LegBounds, TellHeadingsOfEachLeg) {
  const Problem problem = past({through({20, 10, pi}), through({5, 0, 2})}, {40, 0, 0});
  const double radius = problem.vehicle().min_turning_radius;
  const double legs = reeds_shepp_length({}, {20, 10, pi}, radius) +
                      reeds_shepp_length({20, 10, pi}, {5, 0, 2}, radius) +
                      reeds_shepp_length({5, 0, 2}, {40, 0, 0}, radius);
  EXPECT_LE(leg_bound(problem, shortest_style), legs);
  EXPECT_GE(leg_bound(problem, shortest_style), legs - 0.05);
}

TEST(LegBounds, TakeTheLeastOverASet) {
  Via gates = through({20, 30, 0});
  gates.any_of.push_back(region_of_pose({20, 1, 0}));
  EXPECT_NEAR(leg_bound(past({gates}, {40, 0, 0}), shortest_style),
              leg_bound(past({through({20, 1, 0})}, {40, 0, 0}), shortest_style), 1e-9);
}

TEST(LegBounds, LeaveOutPosesThatAreNotFree) {
  Via gates = through({20, 30, 0});
  gates.any_of.push_back(region_of_pose({20, 1, 0}));
  const std::vector<Polygon> on_the_near_one = {box(20, 0, 22, 2)};
  EXPECT_GT(leg_bound(past({gates}, {40, 0, 0}, on_the_near_one), shortest_style), 60);
}

TEST(LegBounds, CountGearChangesAtVias) {
  CostOptions cost{.gear_change_cost = 5.0};
  // Ahead to the via and back again: the gear changes there.
  const Problem there_and_back = past({through({20, 0, 0})}, {0, 0, 0});
  EXPECT_NEAR(leg_bound(there_and_back, cost), 20 + 5 + 20, 0.1);
  const Problem twice =
      past({through({20, 0, 0}), through({0, 0, 0}), through({20, 0, 0})}, {0, 0, 0});
  EXPECT_NEAR(leg_bound(twice, cost), 4 * 20 + 3 * 5, 0.1);
  cost.initial_gear = InitialGear::reverse;
  EXPECT_NEAR(leg_bound(there_and_back, cost), 5 + 20 + 5 + 20, 0.1);
  // A start that is the first via takes no gear.
  const Problem at_once = past({through({0, 0, 0})}, {-20, 0, 0});
  EXPECT_NEAR(leg_bound(at_once, cost), 20, 0.1);
}

// Straight on: nothing is left open. What is in one move or the other is in the longer one.
TEST(LegBounds, CountTheTimeOfStops) {
  const CostOptions time{.measure = CostMeasure::time};
  const auto bound = [&](const std::vector<bool>& stops, const CostOptions& cost) {
    std::vector<Via> via;
    for (const bool stop : stops) {
      via.push_back(through({10.0 * static_cast<double>(via.size() + 1), 0, 0}));
      via.back().stop = stop;
    }
    return leg_bound(past(via, {60, 0, 0}), cost);
  };
  const auto drive = [](double length) {
    const Problem alone = past({}, {length, 0, 0});
    return planning::Pricing(alone.task(), {.measure = CostMeasure::time})
        .cost(std::vector<Segment>{{0, length}}, search::ClearanceSampling::answer);
  };
  EXPECT_NEAR(bound({false, false}, time), drive(60), 0.01);
  EXPECT_NEAR(bound({false, true}, time), drive(20) + drive(40), 0.01);
  EXPECT_NEAR(bound({true, true}, time), 2 * drive(10) + drive(40), 0.01);
  CostOptions ahead = time;
  ahead.gears = AllowedGears::forward;
  EXPECT_NEAR(bound({true, true}, ahead), 2 * drive(10) + drive(40), 0.01);
  GoalRegion strip = region_of_pose({20, 0, 0});
  strip.x = {1, 40};
  Via anywhere{{strip}, true};
  EXPECT_NEAR(leg_bound(past({anywhere}, {60, 0, 0}), time), drive(1) + drive(59), 0.3);
  // A loop in one gear counts in its own move.
  const Problem loop = past({{{region_of_pose({0, 0, 0})}, true}, through({0, 3, 0})}, {0, 3, 0});
  EXPECT_GT(leg_bound(loop, ahead), 1.5 * leg_bound(loop, time));
}

TEST(LegBounds, HalveIntervals) {
  const Problem problem = past({in_any_heading(0, 12)}, {0, 0, 0});
  double least = 1e9;
  for (int i = 0; i < 3600; ++i) {
    const Pose via{0, 12, i * pi / 1800};
    const double radius = problem.vehicle().min_turning_radius;
    least =
        std::min(least, reeds_shepp_length({}, via, radius) + reeds_shepp_length(via, {}, radius));
  }
  EXPECT_LE(leg_bound(problem, shortest_style), least);
  EXPECT_GE(leg_bound(problem, shortest_style), 0.99 * least);
  EXPECT_LT(leg_bound(problem, shortest_style, 0), 0.9 * least);
}

// With many goals behind vias there are as many bounds to look at in the end.
TEST(LegBounds, StayAsTheyAreOnceTheBudgetIsInterrupted) {
  GoalRegion region = region_of_pose({20, 10, 0});
  region.x = {10, 30};
  const Problem problem = past({{{region}}}, {40, 0, 0});
  const planning::Pricing pricing(problem.task(), shortest_style);
  planning::LegBounds bounds(problem.task(), pricing, some_work);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(bounds.least(search::Budget({.stop = stop.get_token()})), 0);
  EXPECT_GT(bounds.least(search::Budget({})), 40);
}

TEST(LegBounds, TakeWhatIsProvenOfALeg) {
  const Problem problem = past({through({20, 0, 0})}, {40, 0, 0});
  const planning::Pricing pricing(problem.task(), shortest_style);
  planning::LegBounds bounds(problem.task(), pricing, some_work);
  EXPECT_NEAR(bounds.least(), 40, 0.05);
  bounds.raise(1, {20, 0, 0}, {40, 0, 0}, {.shortest = 50});
  EXPECT_NEAR(bounds.least(), 70, 0.05);
  bounds.raise(0, {0, 0, 0}, {20, 0, 0}, {.shortest_turn = 60});
  EXPECT_NEAR(bounds.least(), 110, 0.05);
  bounds.raise(0, {0, 0, 0}, {20, 0, 1}, {.shortest_turn = 1000});  // another pose
  bounds.raise(0, {0, 0, 0}, {20, 1, 0}, {.shortest = 1000});
  EXPECT_NEAR(bounds.least(), 110, 0.05);
}

// The way of a disc around the rear axle is the same for all headings.
TEST(LegBounds, TakeWhatIsProvenOfAPlace) {
  Problem problem = past({in_any_heading(20, 0)}, {40, 0, 0});
  const planning::Pricing pricing(problem.task(), shortest_style);
  for (const std::int64_t work : {std::int64_t{0}, some_work}) {
    planning::LegBounds bounds(problem.task(), pricing, work);
    EXPECT_NEAR(bounds.least(), 40, 0.05);
    bounds.raise(0, {0, 0, 0}, {20, 0, 3}, {.shortest = 30, .shortest_turn = 1000});
    EXPECT_NEAR(bounds.least(), 50, 0.05);
  }
  Vehicle truck;
  truck.rear_overhang = 0.0;  // now the disc is ahead of the axle
  problem =
      with_via(problem_in({.bounds = {-90, 90, -90, 90}}, {}, {40, 0, 0}, truck), problem.via());
  const planning::Pricing of_truck(problem.task(), shortest_style);
  planning::LegBounds bounds(problem.task(), of_truck, some_work);
  bounds.raise(0, {0, 0, 0}, {20, 0, 3}, {.shortest = 30});
  EXPECT_NEAR(bounds.least(), 40, 0.05);
}

TEST(LegBounds, OfAPlanSeeObstacles) {
  const Problem problem =
      past({through({20, 20, 0})}, {40, 0, 0}, {box(9, -40, 11, 30), box(29, -30, 31, 40)});
  PlanOptions options;
  options.budget.max_iterations = is_sanitized ? 200 : 20'000;
  options.cost = shortest_style;
  options.steering = Steering::reeds_shepp;
  const PlanResult result = plan(problem, options);
  if (is_sanitized && !result.path) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_GE(*result.lower_bound, is_sanitized ? 56 : 0.8 * result.cost);
}

}  // namespace
}  // namespace vandplan

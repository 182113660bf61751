// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The default planner with a trailer: exact ends, paths that the judge accepts, the same again.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "planners/rig/closer.h"
#include "support/cases.h"
#include "support/draws.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/rig.h"

namespace vandplan {
namespace {

constexpr double pi = std::numbers::pi;

Vehicle semitrailer() {
  Vehicle vehicle{3.6, 1.4, 0.9, 2.55, 5.9};
  vehicle.hitch = 0.6;
  vehicle.trailer = Trailer{7.7, 1.6, 4.3, 2.55};
  return vehicle;
}

/// A dock between two parked trailers, from a yard of 40 m: the rig has to reverse.
Scenario dock() {
  return {.name = "dock",
          .vehicle = semitrailer(),
          .bounds = {-40, 40, -2, 45},
          .start = {-20, 30, 0},
          .goal = {0, 13, pi / 2},
          .obstacles = {{{-40, 0}, {40, 0}, {40, 1}, {-40, 1}},
                        {{-5, 1}, {-2.4, 1}, {-2.4, 14}, {-5, 14}},
                        {{2.4, 1}, {5, 1}, {5, 14}, {2.4, 14}}}};
}

PlanOptions with_iterations(int iterations, std::uint64_t seed = 1) {
  PlanOptions options;
  options.cost = shortest_style;
  options.budget = {.max_iterations = iterations, .seed = seed};
  return options;
}

TEST(RigPlanning, BacksIntoADock) {
  const PlanResult result = plan(make_problem(dock()), with_iterations(cases(3000)));
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(result.check->valid);
  EXPECT_LE(result.check->largest_hitch_angle, 1.2 + 1e-9);
  EXPECT_GT(result.check->reverse_length, 5);
  EXPECT_LE(result.lower_bound, result.cost);
  EXPECT_LT(result.cost, 120);
  EXPECT_LE(result.cost, result.anytime.front().cost);
}

TEST(RigPlanning, RepeatsBitForBitAndDependsOnTheSeed) {
  const Problem problem = make_problem(dock());
  const PlanResult first = plan(problem, with_iterations(cases(1000), 3));
  const PlanResult again = plan(problem, with_iterations(cases(1000), 3));
  EXPECT_EQ(first.path, again.path);
  EXPECT_EQ(first.cost, again.cost);
}

TEST(RigPlanning, KeepsAMarginWithBothBodies) {
  PlanOptions options = with_iterations(cases(4000));
  options.clearance.margin = 0.4;
  const PlanResult result = plan(make_problem(dock()), options);
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_GE(*result.check->clearance, 0.4 - 1e-6);
}

TEST(RigPlanning, HitchAnglesAtTheEndsAreMet) {
  Scenario scenario = dock();
  scenario.obstacles.clear();
  scenario.start = {0, 20, 0};
  scenario.goal = {25, 25, 0.5};
  scenario.hitch_angles = {0.4, -0.3};
  const PlanResult result = plan(make_problem(scenario), with_iterations(cases(3000)));
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  RigState state{scenario.start, 0.4};
  for (const Segment& segment : result.path->segments) {
    state = advance(scenario.vehicle, state, segment);
  }
  EXPECT_NEAR(state.hitch_angle, -0.3, 1e-8);
  EXPECT_NEAR(state.pose.x, 25, 1e-8);
  EXPECT_NEAR(state.pose.heading, 0.5, 1e-8);
}

TEST(RigPlanning, AStartWhoseTrailerTouchesIsNamed) {
  Scenario scenario = dock();
  scenario.obstacles.push_back({{-27, 30}, {-26, 30}, {-26, 31}, {-27, 31}});
  const PlanResult result = plan(make_problem(scenario), with_iterations(10));
  EXPECT_EQ(result.status, PlanStatus::start_in_collision);
  EXPECT_EQ(result.reason, "the trailer's footprint hits obstacles[3]");
}

TEST(RigPlanning, KnowsNoTimes) {
  PlanOptions options = with_iterations(10);
  options.cost = driver_style;
  options.cost.measure = CostMeasure::time;
  EXPECT_THROW((void)plan(make_problem(dock()), options), InputError);
}

TEST(RigPlanning, WithPricesBothBodiesStayAway) {
  PlanOptions options = with_iterations(is_sanitized ? 200 : 20000);
  options.cost = driver_style;
  const PlanResult result = plan(make_problem(dock()), options);
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(result.check->valid);
}

// ---- Closing a gap ----

TEST(CloserLaw, ADriveIsBentUntilItEndsThere) {
  int closed = 0;
  int tried = 0;
  for_each_case(1, 300, [&](Rng& rng) {
    const Vehicle vehicle = semitrailer();
    rig::Closer closer(vehicle);
    std::vector<Segment> segments;
    RigState end{{0, 0, 0}, uniform(-0.3, 0.3, rng)};
    const RigState start = end;
    double largest = 0;
    for (int i = 0; i < 8; ++i) {
      segments.push_back({uniform(-0.13, 0.13, rng), any_sign(uniform(1, 5, rng), rng)});
      largest = std::max(largest, largest_hitch_angle(vehicle, end.hitch_angle, segments.back()));
      end = advance(vehicle, end, segments.back());
    }
    if (largest > 0.9) return;
    ++tried;
    end.pose.x += uniform(-0.5, 0.5, rng);
    end.pose.y += uniform(-0.5, 0.5, rng);
    end.pose.heading += uniform(-0.1, 0.1, rng);
    end.hitch_angle += uniform(-0.1, 0.1, rng);
    if (!closer.close(start, segments, end)) return;
    ++closed;
    RigState state = start;
    for (const Segment& segment : segments) {
      EXPECT_LE(std::abs(segment.curvature), 1 / 5.9);
      EXPECT_LE(largest_hitch_angle(vehicle, state.hitch_angle, segment), 1.2);
      state = advance(vehicle, state, segment);
    }
    EXPECT_NEAR(state.pose.x, end.pose.x, 1e-9);
    EXPECT_NEAR(state.pose.y, end.pose.y, 1e-9);
    EXPECT_NEAR(std::remainder(state.pose.heading - end.pose.heading, 2 * pi), 0, 1e-9);
    EXPECT_NEAR(state.hitch_angle, end.hitch_angle, 1e-9);
  });
  if (!is_sanitized) {  // a few say nothing of a share
    EXPECT_GE(closed, 0.85 * tried);
  }
}

}  // namespace
}  // namespace vandplan

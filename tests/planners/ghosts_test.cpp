// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What do searches for paths among moving obstacles go around?
#include "planners/ghosts.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <vector>

#include "support/problems.h"
#include "vandplan/planner.h"

namespace vandplan::in_time {
namespace {

constexpr double ghost_forever = std::numeric_limits<double>::infinity();

/// Drives along the x axis at 1 m/s, from x = -20 on, and stays at the end.
MovingObstacle drives_along(double duration) {
  return {.outline = box(-2, -1, 2, 1),
          .trajectory = {{0, {-20, 0, 0}}, {duration, {duration - 20, 0, 0}}}};
}

TEST(TriedGhosts, NoGhostIsTriedTwiceOrInsideAnother) {
  const std::vector<MovingObstacle> moving = {drives_along(100), drives_along(100)};
  TriedGhosts tried(moving);
  const Ghost from_3{0, 3, ghost_forever};
  const auto first = tried.with({}, from_3);
  ASSERT_TRUE(first);
  EXPECT_FALSE(tried.with({}, from_3));
  EXPECT_FALSE(tried.with(*first, {0, 5, 5}));
  EXPECT_TRUE(tried.with(*first, {1, 5, 5}));
  const auto larger = tried.with(*first, {0, 2, ghost_forever});
  ASSERT_TRUE(larger);
  ASSERT_EQ(larger->size(), 1U);
  EXPECT_EQ(larger->front().begin, 2);
}

TEST(TriedGhosts, WhatLeavesNoWayBeginsLater) {
  const std::vector<MovingObstacle> moving = {drives_along(100)};
  TriedGhosts tried(moving);
  const auto first = tried.with({}, {0, 4, ghost_forever});
  tried.add_blocked(*first);
  const auto later = tried.begun_later(*first);
  ASSERT_TRUE(later);
  EXPECT_EQ(later->front().begin, 6);
  const auto known = tried.with({}, {0, 3, ghost_forever});  // 3 s on has all that 4 s on has
  ASSERT_TRUE(known);
  EXPECT_EQ(known->front().begin, 5);
  EXPECT_FALSE(tried.begun_later({{0, 4, 4}}));
  EXPECT_FALSE(tried.begun_later({{{}, ghost_forever, ghost_forever}}));
}

TEST(TriedGhosts, DelaysGrowUntilTheObstacleIsAtRest) {
  const std::vector<MovingObstacle> moving = {drives_along(10'000)};
  TriedGhosts tried(moving);
  int count = 0;
  auto ghosts = tried.with({}, {0, 0, ghost_forever});
  while (ghosts) {
    ++count;
    tried.add_blocked(*ghosts);
    ghosts = tried.begun_later(*ghosts);
  }
  EXPECT_GT(count, 10);
  EXPECT_LT(count, 40);
}

Task task_among(const std::vector<MovingObstacle>& moving) {
  const Problem problem = problem_in({.bounds = wide_bounds}, {0, 0, 0}, {40, 30, 0});
  return with_moving(problem, moving).task();
}

TEST(TaskAround, LeavesOutWhoeverComesToTheStart) {
  const Task task = task_among({drives_along(60)});  // over the start, and on to x = 40
  const auto around = task_around(task, {{0, 0, ghost_forever}}, {});
  ASSERT_TRUE(around);
  EXPECT_EQ(around->moving.size(), task.moving.size());
  EXPECT_TRUE(around->checker->is_free(start_state(*around)));
  EXPECT_FALSE(around->checker->is_free(LocalPose({30, 0, 0})));
  EXPECT_FALSE(around->checker->is_free(LocalPose({-19, 0, 0})));
}

TEST(TaskAround, IsNoneIfTheLastGhostAddsNothing) {
  MovingObstacle leaves = drives_along(60);
  leaves.after = Afterwards::leaves;
  const Task task = task_among({leaves});
  const Ghost at_rest{{}, ghost_forever, ghost_forever};
  EXPECT_FALSE(task_around(task, {at_rest}, {}));
  EXPECT_FALSE(task_around(task, {{0, 40, 40}, at_rest}, {}));
  EXPECT_TRUE(task_around(task, {{0, 40, 40}}, {}));
  EXPECT_TRUE(task_around(task_among({drives_along(60)}), {at_rest}, {}));
}

// The vehicle gets out of the way before the gate. It need not wait until the lane is clear.
TEST(PlanAroundGhosts, LetsSomebodyThroughAGate) {
  using std::numbers::pi;
  Scenario scenario;
  scenario.bounds = {-25, 85, -25, 25};
  scenario.goal = {65.6, 0, 0};
  scenario.obstacles = {box(25.6, -25, 26.6, -2.73), box(25.6, 2.73, 26.6, 25)};
  scenario.vehicle = {.wheelbase = 4.5,
                      .front_overhang = 1.4,
                      .rear_overhang = 1.6,
                      .width = 2.55,
                      .min_turning_radius = 7};
  scenario.vehicle.limits.max_acceleration = 1;
  scenario.vehicle.limits.max_steering_rate = 0.5;
  scenario.vehicle.limits.max_speed = {3, 1.5};
  scenario.moving = {{box(-1.6, -1.27, 5.9, 1.27),
                      {{1.8, {55.6, 0, pi}}, {18.3, {15.6, 0, pi}}, {24.3, {5.6, -9, pi}}},
                      Afterwards::leaves}};
  PlanOptions options;
  options.budget.max_iterations = 8000;
  const PlanResult result = plan(scenario, options);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LT(result.speeds->duration, 41);  // 44 s if it waits on the straight path
}

}  // namespace
}  // namespace vandplan::in_time

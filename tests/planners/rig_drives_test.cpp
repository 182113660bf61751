// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// A rig follows a path of its tractor alone.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "planners/rig/behind_tractor.h"
#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/planner.h"
#include "vandplan/rig.h"

namespace vandplan::rig {
namespace {

using std::numbers::pi;

/// Where the commands lead from the start of the task.
RigState end_of(const Task& task, std::span<const Segment> commands) {
  RigState state{task.start, task.hitch_angles.start};
  for (const Segment& command : commands) state = advance(task.vehicle, state, command);
  return state;
}

void expect_free_drive_to_goal(const Task& task, std::span<const Segment> commands) {
  const RigState end = end_of(task, commands);
  EXPECT_LT(std::hypot(end.pose.x - task.goal.x, end.pose.y - task.goal.y), 1e-6);
  EXPECT_NEAR(std::remainder(end.pose.heading - task.goal.heading, 2 * pi), 0, 1e-6);
  EXPECT_NEAR(end.hitch_angle, task.hitch_angles.goal, 1e-6);
  EXPECT_TRUE(
      task.checker->rig_is_free(Local(RigState{task.start, task.hitch_angles.start}), commands));
}

/// Blocks of 70 m with streets of 14 m between them.
Problem blocks(Pose goal) {
  Scenario scenario{.vehicle = semitrailer(), .bounds = {-30, 300, -30, 300}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double x = 84.0 * i + 7, y = 84.0 * j + 7;
      scenario.obstacles.push_back({{x, y}, {x + 70, y}, {x + 70, y + 70}, {x, y + 70}});
    }
  }
  scenario.start = {42, 0, 0};
  scenario.goal = goal;
  return make_problem(scenario);
}

/// What of a path of the tractor alone becomes of the rig.
std::optional<std::vector<Segment>> followed(const Problem& problem) {
  const PlanOptions options =
      complete(default_planner(), {.budget = {.max_iterations = 20000}}, problem.vehicle());
  search::Budget budget(options.budget);
  return drive_behind_tractor(problem.task(), options,
                              {.radius = 1.3 * problem.vehicle().min_turning_radius,
                               .reverse_weight = 20,
                               .distance = 3,
                               .iterations = is_sanitized ? 500 : 4000,
                               .expansions = is_sanitized ? 500 : 4000},
                              budget);
}

TEST(DriveBehindTractor, LeadsARigThroughStreets) {
  const Problem problem = blocks({168, 210, pi / 2});
  const auto drive = followed(problem);
  if (is_sanitized && !drive) return;  // in so few iterations
  ASSERT_TRUE(drive);
  expect_free_drive_to_goal(problem.task(), *drive);
  EXPECT_GT(length(*drive), 300);
  if (is_sanitized) return;  // it is no short one in so few iterations
  EXPECT_LT(length(*drive), 400);
}

TEST(DriveBehindTractor, IsNoneWhereTheTractorHasNoPath) {
  Scenario scenario{.vehicle = semitrailer(), .bounds = {-60, 60, -60, 60}};
  scenario.goal = {40, 0, 0};
  scenario.obstacles = {{{19, -60}, {20, -60}, {20, 60}, {19, 60}}};
  EXPECT_FALSE(followed(make_problem(scenario)));
}

}  // namespace
}  // namespace vandplan::rig

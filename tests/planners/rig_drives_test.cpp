// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// A rig follows a path of its tractor alone.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include "planners/rig/behind_tractor.h"
#include "support/cases.h"
#include "support/problems.h"
#include "support/sites.h"
#include "vandplan/planner.h"
#include "vandplan/vehicle.h"

namespace vandplan::rig {
namespace {

using std::numbers::pi;

/// Where the segments lead from the start of the task.
State end_of(const Task& task, std::span<const Segment> segments) {
  State state{task.start, task.hitch_angles.start};
  for (const Segment& segment : segments) state = advance(task.vehicle, state, segment);
  return state;
}

void expect_free_drive_to_goal(const Task& task, std::span<const Segment> segments) {
  const State end = end_of(task, segments);
  EXPECT_LT(std::hypot(end.pose.x - task.goal.x, end.pose.y - task.goal.y), 1e-6);
  EXPECT_NEAR(std::remainder(end.pose.heading - task.goal.heading, 2 * pi), 0, 1e-6);
  EXPECT_NEAR(end.hitch_angle, task.hitch_angles.goal, 1e-6);
  EXPECT_TRUE(task.checker->is_free(start_state(task), segments));
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

/// The segments of a drive along the first path of the tractor; none if there is none. `site`: a
/// table of the site, or null.
std::optional<std::vector<Segment>> followed(const Problem& problem,
                                             const SiteTable* site = nullptr,
                                             std::int64_t work = is_sanitized ? 500 : 4000) {
  const PlanOptions options = complete(default_planner(), {}, problem.vehicle());
  const planning::Pricing pricing(problem.task(), options.cost);
  BehindTractor source(std::make_shared<const Setting>(problem.task(), options, pricing, site),
                       work, 1);
  const search::Budget budget({});
  for (std::int64_t done = 0; done < 2 * work;) {
    const anytime::Found found = source.work(2 * work - done, budget);
    done += found.iterations;
    if (found.drive) {
      return commands::Wheels(problem.vehicle(), problem.task().steering)
          .driven(found.drive->commands, {});
    }
  }
  return std::nullopt;
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

TEST(DriveBehindTractor, BeginsWithTheWayOfATable) {
  const Problem problem = blocks({168, 210, pi / 2});
  const PlanOptions options = complete(default_planner(), {}, problem.vehicle());
  const SiteTable table =
      make_site_table(problem, std::vector{problem.goal()}, options, sites::coarse).value();
  const std::int64_t work = 400;
  const auto drive = followed(problem, &table, work);
  ASSERT_TRUE(drive);
  expect_free_drive_to_goal(problem.task(), *drive);
  EXPECT_NE(followed(problem, nullptr, work), drive);
}

TEST(DriveBehindTractor, IsNoneWhereTheTractorHasNoPath) {
  Scenario scenario{.vehicle = semitrailer(), .bounds = {-60, 60, -60, 60}};
  scenario.goal = {40, 0, 0};
  scenario.obstacles = {{{19, -60}, {20, -60}, {20, 60}, {19, 60}}};
  EXPECT_FALSE(followed(make_problem(scenario)));
}

}  // namespace
}  // namespace vandplan::rig

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What becomes of a path that was good for a like problem?

#include <gtest/gtest.h>

#include "../support/cases.h"
#include "../support/problems.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

PlanOptions warm_iterations(std::int64_t count,
                            Steering steering = Steering::continuous_between_stops) {
  PlanOptions options{.steering = steering};
  options.budget.max_iterations = count;
  return options;
}

/// A wall between start and goal, so that the best path on open ground is not free.
const std::vector<Polygon> wall = {box(10, -8, 12, 8)};
constexpr Pose start{0, 0, 0};
constexpr Pose goal{25, 0, 0};

Path known_path(Steering steering = Steering::continuous_between_stops, std::int64_t count = 5000) {
  return plan(problem_of(start, goal, wall), warm_iterations(count, steering)).path.value();
}

TEST(WarmStart, ThePathItselfIsTheFirstOne) {
  const Problem problem = problem_of(start, goal, wall);
  const Path known = known_path();
  const PlanResult without = plan(problem, warm_iterations(0));
  EXPECT_EQ(without.status, PlanStatus::iteration_limit);
  const PlanResult with = plan(problem, warm_started(known), warm_iterations(0));
  ASSERT_EQ(with.status, PlanStatus::solved) << with.reason;
  const double cost = plan(problem, warm_iterations(5000)).cost;
  EXPECT_LE(with.cost, cost * (1 + 1e-9));
}

TEST(WarmStart, FollowsAGoalAndAStartThatMove) {
  const Path known = known_path();
  for (const double by : {-1.0, -0.1, 0.1, 1.0}) {
    const Pose end{goal.x + 2 * by, goal.y + by, 0.3 * by};
    const PlanResult to =
        plan(problem_of(start, end, wall), warm_started(known), warm_iterations(0));
    EXPECT_EQ(to.status, PlanStatus::solved) << by;
    const Pose begin{start.x + by, start.y - by, -0.3 * by};
    const PlanResult from =
        plan(problem_of(begin, goal, wall), warm_started(known), warm_iterations(0));
    EXPECT_EQ(from.status, PlanStatus::solved) << by;
  }
}

// Each leg begins with its part of the path, from wherever the vehicle is by now.
TEST(WarmStart, ThePartsOfAPathLeadFromViaToVia) {
  Problem problem = problem_of(start, goal, wall);
  GoalRegion second = region_of_pose({20, 14, 0});
  second.heading = any_heading;
  const std::vector<Via> vias = {{{region_of_pose({11, 12, 0})}}, {{second}}};
  const PlanResult first = plan(with_via(problem, vias), warm_iterations(4000));
  ASSERT_EQ(first.status, PlanStatus::solved) << first.reason;
  for (const double driven : {0.0, 0.5, 4.0}) {
    const Pose now = pose_at(*first.path, driven);
    const Problem later = with_via(problem_of(now, goal, wall), vias);
    EXPECT_EQ(plan(later, warm_iterations(100)).status, PlanStatus::iteration_limit);
    const PlanResult warm = plan(later, warm_started(*first.path), warm_iterations(100));
    ASSERT_EQ(warm.status, PlanStatus::solved) << warm.reason;
    EXPECT_LT(warm.cost, 1.2 * (first.cost - driven) + 1.0);
  }
  const Path standing{start, {}};
  EXPECT_EQ(plan(with_via(problem, vias), warm_started(standing), warm_iterations(100)).status,
            PlanStatus::iteration_limit);
}

// The longer a path was bent, the fewer places it has where the curvature is 0 and it can be moved.
TEST(WarmStart, DrivesPastWhatStandsInItsWay) {
  int solved = 0;
  for (const std::int64_t iterations : {500, 1000, 2000}) {
    const Path known = known_path(Steering::reeds_shepp, iterations);
    for (double s = 2.0; s < length(known) - 2.0; s += 1.0) {
      const Pose there = pose_at(known, s);
      std::vector<Polygon> more = wall;
      more.push_back(box(there.x - 0.1, there.y + 1.2, there.x + 0.1, there.y + 1.4));
      const PlanResult result = plan(problem_of(start, goal, more), warm_started(known),
                                     warm_iterations(0, Steering::reeds_shepp));
      solved += result.status == PlanStatus::solved;
    }
  }
  EXPECT_GE(solved, 20);
}

TEST(WarmStart, APathThatTheVehicleCannotDriveIsSteeredAnew) {
  Vehicle slow_wheels;
  slow_wheels.limits.max_curvature_rate = 0.05;
  const Vehicle wide_turns{.min_turning_radius = 9};
  const auto kinds = {Steering::reeds_shepp, Steering::continuous_between_stops,
                      Steering::continuous};
  for (const Steering before : kinds) {
    const Path known = known_path(before);
    for (const Steering now : kinds) {
      for (const Vehicle& vehicle : {Vehicle{}, slow_wheels, wide_turns}) {
        const Problem problem = problem_of(start, goal, wall, wide_bounds, vehicle);
        const PlanResult result = plan(problem, warm_started(known), warm_iterations(300, now));
        EXPECT_EQ(result.status, PlanStatus::solved)
            << name_of(before) << ", " << name_of(now) << ": " << result.reason;
      }
    }
  }
}

// Arcs that are wider than steering knows are cheaper where the wheels have a price.
TEST(WarmStart, WhatTheVehicleCanDriveStaysAsItWas) {
  const Path known{start, {{0.05, 10}, {-0.05, 10}, {0, 4}}};
  PlanOptions options = warm_iterations(0, Steering::reeds_shepp);
  options.cost = shortest_style;
  options.cost.curvature_change_cost = 100;
  const Problem problem = problem_of(start, end_pose(known), {});
  const PlanResult result = plan(problem, warm_started(known), options);
  EXPECT_NEAR(result.cost, 24 + 100 * 0.15, 1e-9);
}

TEST(WarmStart, ThePathIsBetteredBeforeOthersAreLookedFor) {
  const Problem problem = problem_of(start, goal, wall);
  PlanOptions first_path = warm_iterations(5000);
  first_path.budget.target_gap = 1000;
  const Path crooked = plan(problem, first_path).path.value();
  const double first = plan(problem, warm_started(crooked), warm_iterations(0)).cost;
  EXPECT_LT(plan(problem, warm_started(crooked), warm_iterations(50)).cost, first);
}

TEST(WarmStart, ThePathIsInTheFrameOfTheScenario) {
  Scenario far{.bounds = wide_bounds, .start = start, .goal = goal, .obstacles = wall};
  far = moved_by(far, 12345, -6789);
  const Path known = plan(far, warm_iterations(5000)).path.value();
  EXPECT_EQ(plan(make_problem(far), warm_started(known), warm_iterations(0)).status,
            PlanStatus::solved);
}

TEST(WarmStart, IsNeverRejectedWhateverHasChanged) {
  int known_ones = 0, solved = 0;
  for_each_case(1, 150, [&](Rng& rng) {
    const Bounds square{-25, 25, -25, 25};
    const auto boxes = [&](int count) {
      std::vector<Polygon> all;
      for (int i = 0; i < count; ++i) {
        const Pose corner = uniform_pose(square, rng);
        all.push_back(box(corner.x, corner.y, corner.x + 4, corner.y + 4));
      }
      return all;
    };
    const auto kind = [&] { return static_cast<Steering>(rng() % 3); };
    const std::vector<Polygon> before = boxes(5);
    const Pose from = uniform_pose(square, rng);
    const Pose to = uniform_pose(square, rng);
    const PlanResult old = plan(problem_of(from, to, before), warm_iterations(400, kind()));
    if (!old.path) return;
    ++known_ones;
    const double by = std::exp2(uniform(-8.0, 2.0, rng));
    const auto moved = [&](const Pose& pose) {
      return compose(pose, {uniform(-by, by, rng), uniform(-by, by, rng), uniform(-by, by, rng)});
    };
    const bool moves_start = rng() % 2 == 0;
    const Problem now =
        problem_of(moves_start ? moved(from) : from, moved(to), rng() % 2 == 0 ? before : boxes(6),
                   wide_bounds, {.min_turning_radius = uniform(5.0, 9.0, rng)});
    const PlanOptions options = warm_iterations(static_cast<std::int64_t>(rng() % 300), kind());
    const PlanResult result = plan(now, warm_started(*old.path), options);
    EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
    solved += result.status == PlanStatus::solved;
    PlanOptions shared = options;
    shared.budget.threads = 5;
    EXPECT_EQ(plan(now, warm_started(*old.path), shared).path, result.path);
  });
  if (is_sanitized) return;  // a few say nothing
  EXPECT_GT(known_ones, 75);
  EXPECT_GT(2 * solved, known_ones);
}

}  // namespace
}  // namespace vandplan

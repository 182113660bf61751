// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/smooth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/cases.h"
#include "../support/continuity.h"
#include "../support/problems.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

PlanOptions iterations(std::int64_t count, Steering steering) {
  PlanOptions options{.cost = shortest_style, .steering = steering};
  options.budget.max_iterations = count;
  return options;
}

/// A path of arcs and lines among boxes, if one is found soon.
std::optional<Path> jumping_path(const Problem& problem, std::uint64_t seed) {
  PlanOptions options = iterations(600, Steering::reeds_shepp);
  options.budget.seed = seed;
  return plan(problem, options).path;
}

Problem random_problem(Rng& rng) {
  const Bounds square{-25, 25, -25, 25};
  std::vector<Polygon> boxes;
  for (int i = 0; i < 5; ++i) {
    const Pose corner = uniform_pose(square, rng);
    boxes.push_back(box(corner.x, corner.y, corner.x + 4, corner.y + 4));
  }
  return problem_of(uniform_pose(square, rng), uniform_pose(square, rng), boxes,
                    {-60, 60, -60, 60});
}

/// How far the path gets from another one, as far as a few hundred places on it tell [m].
double largest_distance(const Path& path, const Path& other) {
  double largest = 0.0;
  const std::vector<PathPoint> points = sampled(other, 0.1);
  for (const PathPoint& p : sampled(path, 0.5)) {
    double nearest = 1e9;
    for (const PathPoint& q : points) {
      nearest = std::min(nearest, std::hypot(p.pose.x - q.pose.x, p.pose.y - q.pose.y));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

TEST(Smooth, WhatItGivesCanBeFollowedAndIsFree) {
  int paths = 0, smoothed = 0;
  for_each_case(1, 120, [&](Rng& rng) {
    const Problem problem = random_problem(rng);
    const std::optional<Path> path = jumping_path(problem, rng());
    if (!path || path->segments.empty()) return;
    ++paths;
    for (const Steering steering : {Steering::continuous_between_stops, Steering::continuous}) {
      for (const SmoothMethod method : {SmoothMethod::clothoids, SmoothMethod::optimised}) {
        const PlanResult result =
            plan(problem, smoother(*path, method), iterations(3000, steering));
        ASSERT_NE(result.status, PlanStatus::rejected) << result.reason;
        if (!result.path) continue;
        ++smoothed;
        expect_continuous(*result.path, problem, steering);
      }
    }
  });
  EXPECT_GE(smoothed, 4 * paths * 0.8);
}

// Around a box, with room on all sides: a metre of clothoids moves nothing far.
TEST(Smooth, ClothoidsStayNearThePath) {
  const Problem problem = problem_of({0, 0, 0}, {40, 10, 0}, {box(15, -3, 20, 6)});
  const std::optional<Path> path = jumping_path(problem, 1);
  ASSERT_TRUE(path);
  const PlanResult result = plan(problem, smoother(*path, SmoothMethod::clothoids),
                                 iterations(5000, Steering::continuous_between_stops));
  ASSERT_TRUE(result.path) << result.reason;
  EXPECT_LT(largest_distance(*result.path, *path), 1.0);
}

TEST(Smooth, AnOptimisedPathIsNoDearer) {
  const Problem problem = problem_of({0, 0, 0}, {40, 10, 0}, {box(15, -3, 20, 6)});
  const std::optional<Path> path = jumping_path(problem, 1);
  ASSERT_TRUE(path);
  const PlanOptions options = iterations(4000, Steering::continuous);
  const PlanResult near = plan(problem, smoother(*path, SmoothMethod::clothoids), options);
  const PlanResult best = plan(problem, smoother(*path, SmoothMethod::optimised), options);
  ASSERT_TRUE(near.path && best.path);
  EXPECT_LT(best.cost, near.cost);
}

// What can be followed as it is comes back as it is, or better.
TEST(Smooth, NeverMakesAGoodPathDearer) {
  for_each_case(2, 40, [](Rng& rng) {
    const Problem problem = random_problem(rng);
    const PlanOptions options = iterations(800, Steering::continuous);
    const PlanResult given = plan(problem, options);
    if (!given.path) return;
    const PlanResult same = plan(problem, smoother(*given.path, SmoothMethod::clothoids), options);
    ASSERT_TRUE(same.path) << same.reason;
    EXPECT_EQ(same.path->segments, given.path->segments);
    const PlanResult better =
        plan(problem, smoother(*given.path, SmoothMethod::optimised), options);
    ASSERT_TRUE(better.path) << better.reason;
    EXPECT_LE(better.cost, given.cost);
  });
}

// A path through a wall has no way beside it.
TEST(Smooth, SaysWhenItCannot) {
  const Problem problem = problem_of({0, 0, 0}, {40, 0, 0}, {box(15, -100, 20, 100)});
  const Path path{{0, 0, 0}, {{0, 40}}};
  const PlanResult result =
      plan(problem, smoother(path, SmoothMethod::clothoids), iterations(500, Steering::continuous));
  EXPECT_FALSE(result.path);
  EXPECT_NE(result.reason, "");
}

// Files of others may have segments of no length, and a path may come back to where it was.
TEST(Smooth, TakesSegmentsOfNoLengthAndPlacesThatAreOne) {
  const Problem problem = problem_of({0, 0, 0}, {40, 0, 0}, {});
  const std::vector<std::vector<Segment>> paths = {{{0, 20}, {0, 0}, {0, 0}, {0, 20}},
                                                   {{0, 0}, {0, 40}},
                                                   {{0, 40}, {0.1, 0}},
                                                   {{0, 10}, {0, -10}, {0, 40}},
                                                   {}};
  for (const auto& segments : paths) {
    for (const SmoothMethod method : {SmoothMethod::clothoids, SmoothMethod::optimised}) {
      const PlanResult result = plan(problem, smoother({problem.start(), segments}, method),
                                     iterations(300, Steering::continuous));
      EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
      if (result.path) expect_continuous(*result.path, problem, Steering::continuous);
    }
  }
}

TEST(Smooth, MethodsHaveNames) {
  EXPECT_EQ(smooth_method_named("clothoids"), SmoothMethod::clothoids);
  EXPECT_EQ(smooth_method_named("optimised"), SmoothMethod::optimised);
  EXPECT_THROW((void)smooth_method_named("splines"), InputError);
}

}  // namespace
}  // namespace vandplan

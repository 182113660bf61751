// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Drives along ways whose curvature jumps.
#include "planners/anytime/follow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "support/continuity.h"
#include "support/problems.h"
#include "support/radius.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using anytime::Follower;

constexpr std::array kinds_to_follow = {Steering::continuous_between_stops, Steering::continuous};

/// Left and right around things, and at last backwards.
std::vector<Segment> slalom() {
  std::vector<Segment> way;
  for (int i = 0; i < 6; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    way.push_back({side / default_radius, 8});
    way.push_back({-side / default_radius, 16});
    way.push_back({side / default_radius, 8});
    way.push_back({0, 9});
  }
  way.push_back({1 / default_radius, -12});
  way.push_back({0, -10});
  return way;
}

Problem problem_along(std::span<const Segment> way, std::vector<Polygon> obstacles = {}) {
  const Path path{{0, 0, 0}, {way.begin(), way.end()}};
  return problem_of(path.start, end_pose(path), std::move(obstacles), Bounds{-50, 400, -200, 200});
}

double distance_from(const Path& path, const Pose& place) {
  double least = 1e9;
  for (double s = 0.0; s < length(path); s += 0.3) {
    const Pose pose = pose_at(path, s);
    least = std::min(least, std::hypot(pose.x - place.x, pose.y - place.y));
  }
  return least;
}

/// What follows the way, if anything does; `steps` counts the work.
std::optional<Path> followed(const Task& task, std::span<const Segment> way, int* steps = nullptr) {
  const search::DrivenBeside ends = search::driven_at_ends(task);
  commands::Closer closer(task.vehicle, task.steering);
  Follower follower(task, ends, closer, 1);
  follower.follow(way);
  int count = 0;
  while (follower.step()) ++count;
  if (steps != nullptr) *steps = count;
  const auto drive = follower.drive();
  if (!drive) return std::nullopt;
  EXPECT_GT(follower.checks(), 0);
  const commands::Wheels wheels(task.vehicle, task.steering);
  return Path{task.start, wheels.driven(*drive, ends.before)};
}

// All of the way is as near as what turning the wheels takes: no part moves the others.
TEST(Follower, StaysNearTheWay) {
  const std::vector<Segment> way = slalom();
  const Problem problem = problem_along(way);
  for (const Steering steering : kinds_to_follow) {
    const Task task = task_of(problem, {}, steering);
    const std::optional<Path> path = followed(task, way);
    ASSERT_TRUE(path) << name_of(steering);
    expect_continuous(*path, problem, steering);
    const Path whole{task.start, way};
    double farthest = 0.0;
    for (double s = 0.0; s < length(whole); s += 5.0) {
      farthest = std::max(farthest, distance_from(*path, pose_at(whole, s)));
    }
    EXPECT_LT(farthest, 0.1 * default_radius) << name_of(steering);
    const Pose end = end_pose(*path);
    EXPECT_NEAR(std::hypot(end.x - task.goal.x, end.y - task.goal.y), 0.0, 1e-8);
  }
}

Polygon post(const Pose& at, double half) {
  return box(at.x - half, at.y - half, at.x + half, at.y + half);
}

bool is_free_beside(std::span<const Segment> way, const Polygon& obstacle) {
  const Problem problem = problem_along(way, {obstacle});
  return problem.task().checker->is_free(problem.task().start, way);
}

/// Posts that the way goes by, with next to no room.
std::vector<Polygon> posts_beside(std::span<const Segment> way, std::uint64_t seed) {
  const Path whole{{0, 0, 0}, {way.begin(), way.end()}};
  std::vector<Polygon> posts;
  Rng rng(seed);
  while (posts.size() < 15) {
    const Pose pose = pose_at(whole, uniform(15.0, 200.0, rng));
    const Pose place = compose(pose, {uniform(-1.0, 4.0, rng), uniform(-3.0, 3.0, rng), 0});
    if (!is_free_beside(way, post(place, 0.01))) continue;
    if (!is_free_beside(way, post(place, 0.03))) posts.push_back(post(place, 0.01));
  }
  return posts;
}

TEST(Follower, ChangesWhatRunsIntoSomething) {
  const std::vector<Segment> way = slalom();
  int plain = 0, driven = 0, changed = 0;
  const Problem open = problem_along(way);
  EXPECT_TRUE(followed(task_of(open, {}, Steering::continuous_between_stops), way, &plain));
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Problem problem = problem_along(way, posts_beside(way, seed));
    const Task task = task_of(problem, {}, Steering::continuous_between_stops);
    int steps = 0;
    const std::optional<Path> path = followed(task, way, &steps);
    if (!path) continue;
    ++driven;
    changed += steps > plain + 20;  // not just another part
    EXPECT_TRUE(task.checker->is_free(task.start, path->segments));
    expect_continuous(*path, problem, task.steering);
  }
  EXPECT_GE(driven, 6);
  EXPECT_GE(changed, 2);
}

TEST(Follower, GivesUpWhereNothingHelps) {
  const std::vector<Segment> way = slalom();
  const Problem problem = problem_along(way, {box(100, -200, 101, 200)});
  const Task task = task_of(problem, {}, Steering::continuous_between_stops);
  EXPECT_FALSE(followed(task, way));
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

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

Problem random_problem_to_smooth(Rng& rng) {
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
  for_each_case(1, 60, [&](Rng& rng) {
    const Problem problem = random_problem_to_smooth(rng);
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
    const Problem problem = random_problem_to_smooth(rng);
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

// ---- as the door that everybody calls ----

/// Options of a run, of every kind that a path is held to.
PlanOptions random_options(Rng& rng) {
  constexpr Steering steerings[] = {Steering::reeds_shepp, Steering::continuous_between_stops,
                                    Steering::continuous};
  PlanOptions options = iterations(600, steerings[rng() % 3]);
  options.budget.seed = rng();
  options.cost = {};
  switch (rng() % 4) {
    case 0:
      options.style = Style::shortest;
      break;
    case 1:
      options.cost.measure = CostMeasure::time;
      options.budget.max_iterations = 200;
      break;
    case 2:
      options.cost.reverse_weight = uniform(1, 10, rng);
      options.cost.gear_change_cost = uniform(0, 20, rng);
      break;
    default:
      break;
  }
  if (rng() % 2 == 0) options.clearance.margin = uniform(0, 0.5, rng);
  if (rng() % 4 == 0) options.planner.set("min_stroke", uniform(0.5, 2, rng));
  return options;
}

double shortest_stroke(const std::vector<Segment>& segments) {
  double least = 1e9, length = 0.0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    length += std::abs(segments[i].length);
    if (i + 1 < segments.size() && segments[i].length * segments[i + 1].length > 0) continue;
    least = std::min(least, std::exchange(length, 0.0));
  }
  return least;
}

/// Smooths a path that was planned with options, by what is stored of these. True if it got better.
bool expect_no_worse(const Problem& problem, const PlanOptions& options, SmoothMethod method,
                     std::int64_t trials = 100) {
  const PlanResult planned = plan(problem, options);
  if (!planned.path || planned.path->segments.empty()) return false;
  const PlanOptions in_force = complete(default_planner(), options, problem.vehicle());
  PlanOptions kept = smooth_options({}, settings_of(in_force));
  kept.budget.max_iterations = trials;
  const Smoothed smoothed = smooth(problem, *planned.path, method, kept);
  const PlanResult& result = smoothed.result;
  EXPECT_EQ(smoothed.options.clearance, in_force.clearance);
  EXPECT_EQ(smoothed.options.cost, in_force.cost);
  EXPECT_NEAR(smoothed.given_cost, planned.cost, 1e-9 * planned.cost);
  EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
  if (*in_force.steering != Steering::reeds_shepp) {
    EXPECT_EQ(smoothed.options.steering, in_force.steering);
    EXPECT_EQ(smoothed.given_fault, "");
  }
  if (!smoothed.given_fault.empty()) return false;  // the wheels cannot follow it
  EXPECT_TRUE(result.path) << result.reason;
  if (!result.path) return false;
  EXPECT_LE(result.cost, planned.cost * (1 + 1e-12));
  EXPECT_EQ(smoothed.is_given, result.path->segments == planned.path->segments);
  const PathCheck check = check_path(problem, *result.path,
                                     {.cost = StatedCost{result.cost, smoothed.options.cost},
                                      .clearance = smoothed.options.clearance,
                                      .steering = *smoothed.options.steering});
  EXPECT_TRUE(check.valid) << check.reason;
  return result.cost < planned.cost * (1 - 1e-9);
}

TEST(SmoothDoor, IsNeverWorseByTheOptionsOfTheRun) {
  int better = 0;
  for_each_case(3, 80, [&](Rng& rng) {
    const Problem problem = random_problem_to_smooth(rng);
    const PlanOptions options = random_options(rng);
    for (const SmoothMethod method : {SmoothMethod::clothoids, SmoothMethod::optimised}) {
      if (expect_no_worse(problem, options, method)) ++better;
    }
  });
  EXPECT_GE(better, cases(80) / 8);
}

TEST(SmoothDoor, IsNeverWorseForARig) {
  int better = 0;
  for_each_case(4, 8, [&](Rng& rng) {
    const Bounds square{-15, 15, -15, 15};
    const Problem problem = problem_of(uniform_pose(square, rng), uniform_pose(square, rng), {},
                                       {-60, 60, -60, 60}, semitrailer());
    for (const SmoothMethod method : {SmoothMethod::clothoids, SmoothMethod::optimised}) {
      if (expect_no_worse(problem, random_options(rng), method)) ++better;
    }
  });
  EXPECT_GE(better, 1);
}

/// Past two vias among boxes: a gate of some width and headings, and a place where it stands or
/// not.
Problem random_problem_past_vias(Rng& rng) {
  const Problem problem = random_problem_to_smooth(rng);
  Via gate{{{.x = {-3, 3}, .y = {8, 10}, .heading = {-0.5, 0.5}}}};
  if (rng() % 2 == 0) gate.any_of.front().heading = any_heading;
  const Via place{{region_of_pose(uniform_pose({-25, 25, -25, 25}, rng))}, rng() % 2 == 0};
  return with_via(problem, {gate, place});
}

TEST(SmoothDoor, KeepsViasAndIsNeverWorse) {
  int better = 0;
  for_each_case(5, 16, [&](Rng& rng) {
    const Problem problem = random_problem_past_vias(rng);
    PlanOptions options = random_options(rng);
    options.budget.max_iterations = 600;
    for (const SmoothMethod method : {SmoothMethod::clothoids, SmoothMethod::optimised}) {
      if (expect_no_worse(problem, options, method, 4000)) ++better;
    }
  });
  EXPECT_GE(better, cases(16) / 4);
}

TEST(SmoothDoor, SlidesAViaAlongItsSet) {
  const Problem alone = problem_of({0, 0, 0}, {40, 0, 0}, {});
  const GoalRegion strip{.x = {15, 25}, .y = {4, 12}, .heading = {-0.5, 0.5}};
  const Problem through_one_pose = with_via(alone, {{{region_of_pose({20, 11, 0.3})}}});
  const PlanOptions options = iterations(2000, Steering::continuous_between_stops);
  const PlanResult planned = plan(through_one_pose, options);
  if (is_sanitized && !planned.path) return;
  ASSERT_TRUE(planned.path) << planned.reason;
  const Problem problem = with_via(alone, {{{strip}}});
  PlanOptions more = options;
  more.budget.max_iterations = is_sanitized ? 200 : 10'000;
  const Smoothed smoothed = smooth(problem, *planned.path, SmoothMethod::optimised, more);
  ASSERT_EQ(smoothed.result.status, PlanStatus::solved) << smoothed.result.reason;
  ASSERT_EQ(smoothed.result.via.size(), 1U);
  if (is_sanitized) return;
  EXPECT_LE(smoothed.result.via[0].pose.y, 5);
  EXPECT_LE(smoothed.result.cost, 1.01 * plan(problem, more).cost);
}

// The wheels are turned at the via, or turn there at a stop. Each leg follows its part of the path.
TEST(SmoothDoor, FollowsAPathThatTurnsAtAVia) {
  const Path bend{{}, {{0, 5}, {0.1, 8}, {-0.1, 16}, {0.1, 8}, {0, 5}}};
  const Problem alone = problem_of({}, end_pose(bend), {});
  PlanOptions options;
  options.budget.max_iterations = 20;
  const auto smoothed = [&](double at, bool stop) {
    const Problem problem = with_via(alone, {{{region_of_pose(pose_at(bend, at))}, stop}});
    return smooth(problem, bend, SmoothMethod::optimised, options).result;
  };
  const PlanResult rolling = smoothed(21, false);
  EXPECT_EQ(rolling.status, PlanStatus::solved) << rolling.reason;
  EXPECT_LT(rolling.cost, 60);
  EXPECT_LT(smoothed(13, true).cost, 55);
}

// The second via lies on the way back, where the path has been before.
TEST(SmoothDoor, KeepsTheOrderOfVias) {
  const Problem problem =
      with_via(problem_of({0, 0, 0}, {0, 4, 0}, {}),
               {{{region_of_pose({20, 0, 0})}}, {{region_of_pose({10, 0, 0})}, true}});
  const PlanOptions options = iterations(3000, Steering::continuous_between_stops);
  const PlanResult planned = plan(problem, options);
  if (is_sanitized && !planned.path) return;
  ASSERT_TRUE(planned.path) << planned.reason;
  const Smoothed smoothed = smooth(problem, *planned.path, SmoothMethod::optimised, options);
  ASSERT_EQ(smoothed.result.via.size(), 2U) << smoothed.result.reason;
  EXPECT_LT(smoothed.result.via[0].s, smoothed.result.via[1].s);
  EXPECT_LE(smoothed.result.cost, planned.cost);
}

TEST(SmoothDoor, SmoothsUpToAStraightLastStretch) {
  const Problem alone = problem_of({0, 0, 0}, {40, 10, 0}, {});
  const PlanOptions options = iterations(3000, Steering::continuous_between_stops);
  GoalRegion dock = region_of_pose({40, 10, 0});
  dock.straight = 8;
  const Problem problem = with_goal_set(alone, {dock});
  const Problem detour = with_via(problem, {{{region_of_pose({20, 25, 0})}}});
  const PlanResult planned = plan(detour, options);
  if (is_sanitized && !planned.path) return;
  ASSERT_TRUE(planned.path) << planned.reason;
  for (const SmoothMethod method : {SmoothMethod::clothoids, SmoothMethod::optimised}) {
    const Smoothed smoothed = smooth(problem, *planned.path, method, options);
    ASSERT_EQ(smoothed.result.status, PlanStatus::solved) << smoothed.result.reason;
    EXPECT_TRUE(smoothed.result.goal);
    EXPECT_LE(smoothed.result.cost, planned.cost);
    if (is_sanitized || method == SmoothMethod::clothoids) continue;
    EXPECT_FALSE(smoothed.is_given);
    EXPECT_LE(smoothed.result.cost, 1.001 * plan(problem, options).cost);
    const Smoothed past_via = smooth(detour, *planned.path, method, options);
    EXPECT_EQ(past_via.result.via.size(), 1U) << past_via.result.reason;
  }
}

// The given path bends up to the goal, in the gear in which the line is driven, too.
TEST(SmoothDoor, StraightensTheLastStretch) {
  const PlanOptions options = iterations(3000, Steering::continuous_between_stops);
  for (const double gear : {1.0, -1.0}) {
    GoalRegion dock = region_of_pose({gear * 40, 10, 0});
    const Problem alone = problem_of({0, 0, 0}, {gear * 40, 10, 0}, {});
    PlanOptions bent = iterations(2000, Steering::reeds_shepp);
    bent.cost.gears = gear > 0 ? AllowedGears::forward : AllowedGears::reverse;
    const PlanResult planned = plan(alone, bent);
    if (is_sanitized && !planned.path) return;
    ASSERT_TRUE(planned.path) << planned.reason;
    dock.straight = 6;
    const Problem problem = with_goal_set(alone, {dock});
    ASSERT_FALSE(check_path(problem, *planned.path).valid);
    const Smoothed smoothed = smooth(problem, *planned.path, SmoothMethod::optimised, options);
    if (is_sanitized && !smoothed.result.path) return;
    ASSERT_TRUE(smoothed.result.path) << smoothed.result.reason;
    EXPECT_TRUE(check_path(problem, *smoothed.result.path).valid);
    EXPECT_GT(gear * smoothed.result.path->segments.back().length, 5.999);
  }
}

TEST(SmoothDoor, IsNeverWorseBeforeAStraightLastStretch) {
  int better = 0;
  for_each_case(7, 24, [&](Rng& rng) {
    Problem problem =
        rng() % 2 == 0 ? random_problem_to_smooth(rng) : random_problem_past_vias(rng);
    if (rng() % 4 == 0) {
      problem = problem_of(uniform_pose({-15, 15, -15, 15}, rng), {0, 0, 0}, {}, {-60, 60, -60, 60},
                           semitrailer());
    }
    GoalRegion dock = region_of_pose(problem.goal());
    dock.straight = uniform(0.5, 12, rng);
    dock.either_way = rng() % 2 == 0;
    problem = with_goal_set(problem, {dock});
    const PlanOptions options = random_options(rng);
    for (const SmoothMethod method : {SmoothMethod::clothoids, SmoothMethod::optimised}) {
      if (expect_no_worse(problem, options, method, 1000)) ++better;
    }
  });
  EXPECT_GE(better, cases(24) / 4);
}

/// A truck that drives 40 m along a wall.
Problem along_wall(double distance) {
  const double half_width = Vehicle{}.width / 2;
  return problem_of({0, 0, 0}, {40, 0, 0},
                    {box(-20, half_width + distance, 60, half_width + distance + 1)});
}

// Planners ask for a little more room than the judge, and find nothing here.
TEST(SmoothDoor, GivesAPathBackThatOnlyTheJudgePasses) {
  const Problem problem = along_wall(0.2e-3);
  const Path path{problem.start(), {{0, 40}}};
  const PlanOptions options = iterations(50, Steering::continuous);
  ASSERT_FALSE(plan(problem, smoother(path, SmoothMethod::optimised), options).path);
  const Smoothed smoothed = smooth(problem, path, SmoothMethod::optimised, options);
  EXPECT_TRUE(smoothed.is_given);
  EXPECT_EQ(smoothed.given_fault, "");
  EXPECT_EQ(smoothed.result.status, PlanStatus::solved);
  ASSERT_TRUE(smoothed.result.path);
  EXPECT_EQ(*smoothed.result.path, path);
  EXPECT_DOUBLE_EQ(smoothed.result.cost, 40.0);
  EXPECT_TRUE(smoothed.result.check->valid);
}

TEST(SmoothDoor, SaysWhatIsWrongWithAPathByTheOptions) {
  const Path path{{0, 0, 0}, {{0, 40}}};
  PlanOptions options = iterations(2000, Steering::continuous);
  options.clearance.margin = 0.05;
  const Smoothed smoothed = smooth(along_wall(0.1), path, SmoothMethod::optimised, options);
  EXPECT_EQ(smoothed.given_fault, "");
  options.clearance.margin = 0.3;
  const Smoothed other = smooth(along_wall(0.1), path, SmoothMethod::optimised, options);
  EXPECT_NE(other.given_fault, "");
  EXPECT_FALSE(other.result.path);
}

// Kept as it is, the judge would reject it.
TEST(SmoothDoor, MendsAPathThatTurnsTooSharply) {
  const Path path{{0, 0, 0}, {{1 / 6.5, 10}, {0, 20}}};
  const Problem problem = problem_of(path.start, end_pose(path), {});
  for (const Steering steering : {Steering::reeds_shepp, Steering::continuous}) {
    const Smoothed smoothed =
        smooth(problem, path, SmoothMethod::optimised, iterations(300, steering));
    EXPECT_EQ(smoothed.result.status, PlanStatus::solved) << smoothed.result.reason;
    EXPECT_NE(smoothed.given_fault, "");
    EXPECT_FALSE(smoothed.is_given);
  }
}

// Backwards into a slot, after a first stroke that is shorter than is asked for.
TEST(SmoothDoor, LengthensNoStrokeAtAPrice) {
  Scenario scenario;
  scenario.vehicle = {.wheelbase = 2.8, .width = 1.942, .min_turning_radius = 3.0};
  scenario.vehicle.front_overhang = scenario.vehicle.rear_overhang = 0.95;
  scenario.bounds = {-15, 15, -5, 30};
  scenario.start = {-5.37, 9.73, 2.606};
  scenario.goal = {-0.55, 15.2, -1.79};
  scenario.obstacles = {{{-16.4, 19.7}, {-1.81, 16.4}, {-2.83, 11.9}, {-17.5, 15.1}},
                        {{1.12, 15.8}, {15.8, 12.5}, {14.7, 7.9}, {0.1, 11.2}}};
  const Problem problem = make_problem(scenario);
  int lacking = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    PlanOptions options{.budget = {.max_iterations = 3000, .seed = seed}};
    const PlanResult planned = plan(problem, options);
    ASSERT_TRUE(planned.path);
    options.planner.set("min_stroke", 1.0);
    if (shortest_stroke(planned.path->segments) < 1) ++lacking;
    options.budget.max_iterations = 5000;
    const PlanResult smoothed =
        smooth(problem, *planned.path, SmoothMethod::optimised, options).result;
    ASSERT_TRUE(smoothed.path);
    EXPECT_LE(smoothed.cost, planned.cost);
    EXPECT_GE(shortest_stroke(smoothed.path->segments),
              std::min(1.0, shortest_stroke(planned.path->segments)) - 1e-9);
  }
  EXPECT_GT(lacking, 0);
}

TEST(SmoothDoor, MakesStrokesAsLongAsIsAskedFor) {
  const Path path{{0, 0, 0}, {{0, 10}, {0, -0.2}, {0, 0.2}, {0, 20}}};
  const Problem problem = problem_of(path.start, end_pose(path), {});
  PlanOptions options = iterations(500, Steering::continuous_between_stops);
  options.planner.set("min_stroke", 1.0);
  const Smoothed smoothed = smooth(problem, path, SmoothMethod::optimised, options);
  ASSERT_TRUE(smoothed.result.path);
  EXPECT_GE(shortest_stroke(smoothed.result.path->segments), 1.0 - 1e-9);
}

TEST(SmoothDoor, RefusesWhatCannotBe) {
  const Problem problem = problem_of({0, 0, 0}, {40, 0, 0}, {});
  const auto place = [](const Problem& given, const Path& path) {
    try {
      (void)smooth(given, path);
    } catch (const InputError& error) {
      return error.where();
    }
    return std::string("nothing");
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(place(problem, {{0, 0, 0}, {{0, nan}}}), "path");
  EXPECT_EQ(place(problem, {{nan, 0, 0}, {{0, 40}}}), "path");
  EXPECT_EQ(place({}, {{0, 0, 0}, {{0, 40}}}), "problem");
  const MovingObstacle car{.outline = box(-2, -1, 2, 1), .trajectory = {{0, {20, 30, 0}}}};
  EXPECT_EQ(place(with_moving(problem, std::vector{car}), {{0, 0, 0}, {{0, 40}}}), "moving");
}

using Settings = std::vector<Setting>;

TEST(SmoothOptions, OfTheRunWinOverTheScenario) {
  const Settings scenario = {{"margin", "0.1"}, {"margin_ramp", "3"}, {"style", "shortest"}};
  EXPECT_EQ(smooth_options(scenario, {}).style, Style::shortest);
  EXPECT_EQ(smooth_options(scenario, {}).clearance, (ClearanceOptions{0.1, 3}));
  const Settings stored = {{"margin", "0.3"},          {"reverse_weight", "7"},
                           {"cost", "prices"},         {"min_stroke", "0.5"},
                           {"steering", "continuous"}, {"region", "bounds"},
                           {"of_somebody_else", "3"}};
  const PlanOptions options = smooth_options(scenario, stored);
  EXPECT_EQ(options.clearance, (ClearanceOptions{0.3, 3}));
  EXPECT_EQ(options.cost.reverse_weight, 7.0);
  EXPECT_EQ(options.steering, Steering::continuous);
  EXPECT_EQ(options.planner.number("min_stroke"), 0.5);
  const PlanOptions driver =
      smooth_options(Settings{{"reverse_weight", "5"}}, Settings{{"style", "shortest"}});
  EXPECT_EQ(driver.cost.reverse_weight, std::nullopt);
}

TEST(SmoothOptions, TakeNoBudgetOfTheRun) {
  const Settings stored = {{"seed", "5"}, {"max_iterations", "3"}, {"time_limit", "9"}};
  EXPECT_EQ(smooth_options({}, stored).budget, BudgetOptions{});
}

TEST(SmoothOptions, OfARunByTimeHaveNoPrices) {
  const std::vector<Setting> stored = {
      {"cost", "time"}, {"reverse_weight", "2"}, {"gear_change_cost", "5"}};
  const PlanOptions options = smooth_options({}, stored);
  EXPECT_EQ(options.cost.measure, CostMeasure::time);
  EXPECT_NO_THROW((void)complete(smoother({}, {}), options));
  EXPECT_THROW((void)complete(smoother({}, {}), smooth_options(stored, {})), InputError);
}

TEST(SmoothOptions, TakeJumpsOfTheCurvatureOut) {
  const Settings arcs = {{"steering", "reeds-shepp"}};
  const auto steering_of = [](const PlanOptions& options) {
    return complete(smoother({}, SmoothMethod::optimised), options).steering;
  };
  EXPECT_EQ(steering_of(smooth_options({}, arcs)), Steering::continuous_between_stops);
  EXPECT_EQ(steering_of(smooth_options(arcs, {})), Steering::reeds_shepp);
  EXPECT_EQ(steering_of(smooth_options(Settings{{"steering", "continuous"}}, arcs)),
            Steering::continuous);
  EXPECT_EQ(steering_of({.style = Style::shortest}), Steering::continuous_between_stops);
}

TEST(SmoothOptions, ThatAreNoGoodAreNamed) {
  try {
    (void)smooth_options({}, Settings{{"min_stroke", "far"}});
    ADD_FAILURE() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "min_stroke");
  }
}

TEST(Smooth, MethodsHaveNames) {
  EXPECT_EQ(smooth_method_named("clothoids"), SmoothMethod::clothoids);
  EXPECT_EQ(smooth_method_named("optimised"), SmoothMethod::optimised);
  EXPECT_THROW((void)smooth_method_named("splines"), InputError);
}

}  // namespace
}  // namespace vandplan

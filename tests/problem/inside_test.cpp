// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// The whole body stays in one area, in the eyes of the checker, of planners and of the judge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "problem/fences.h"
#include "support/cases.h"
#include "support/collision_oracle.h"
#include "support/draws.h"
#include "support/place_of_error.h"
#include "support/problems.h"
#include "support/zoned.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/replanner.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using std::numbers::pi;

/// Two arms of 12 m that meet at the origin, to the east and to the north.
const Polygon corner_of_two = {{-6, -6}, {60, -6}, {60, 6}, {6, 6}, {6, 60}, {-6, 60}};

Scenario in_area(const Pose& start, const Pose& goal, std::vector<Polygon> inside) {
  return {.name = "inside",
          .bounds = wide_bounds,
          .start = start,
          .goal = goal,
          .inside = std::move(inside)};
}

/// Whether a point is in that corner, with some room for rounding.
bool is_in_corner(const Point& p) {
  constexpr double room = 1e-6;
  const bool in_east = p.x > -6 - room && p.x < 60 + room && std::abs(p.y) < 6 + room;
  const bool in_north = p.y > -6 - room && p.y < 60 + room && std::abs(p.x) < 6 + room;
  return in_east || in_north;
}

TEST(Inside, ThePathGoesRoundTheCornerOfTheArea) {
  const Problem problem = make_problem(in_area({40, 0, pi}, {0, 40, pi / 2}, {corner_of_two}));
  const PlanResult result = plan(problem, of_iterations(3000));
  if (is_sanitized && !result.path) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  for (const PathPoint& point : sampled(*result.path, 0.05)) {
    for (const Point& corner : corners(footprint(problem.vehicle()), point.pose)) {
      EXPECT_TRUE(is_in_corner(corner)) << corner.x << " " << corner.y;
    }
  }
}

TEST(Inside, TheJudgeRefusesWhatLeavesByAMillimetre) {
  const double front = footprint(Vehicle{}).front;
  const Problem problem = make_problem(in_area({0, 0, 0}, {30, 0, 0}, {box(-10, -4, 40, 4)}));
  const auto check = [&](double ahead) {
    return check_path(problem, {{0, 0, 0}, {{0, ahead}, {0, 30 - ahead}}});
  };
  EXPECT_TRUE(check(40 - front).valid) << check(40 - front).reason;  // it touches the edge
  EXPECT_TRUE(check(39.9 - front).valid);
  const PathCheck out = check(40 - front + 1e-3);
  EXPECT_FALSE(out.valid);
  EXPECT_EQ(out.hit, (Hit{HitKind::inside, 0}));
  EXPECT_EQ(out.reason, "the footprint hits the edge of inside[0]");
}

TEST(Inside, WhoBeginsOutsideIsInCollision) {
  const std::vector<Polygon> areas = {box(-10, -4, 40, 4), box(100, -4, 140, 4)};
  const auto status = [&](const Pose& start, const Pose& goal) {
    return plan(make_problem(in_area(start, goal, areas)), of_iterations(400)).status;
  };
  EXPECT_EQ(status({0, 0, 0}, {30, 0, 0}), PlanStatus::solved);
  EXPECT_EQ(status({0, 20, 0}, {30, 0, 0}), PlanStatus::start_in_collision);
  EXPECT_EQ(status({0, 0, 0}, {30, 20, 0}), PlanStatus::goal_in_collision);
  EXPECT_EQ(status({-9.5, 0, 0}, {30, 0, 0}), PlanStatus::start_in_collision);  // its rear
  const PlanResult outside =
      plan(make_problem(in_area({0, 20, 0}, {30, 0, 0}, areas)), of_iterations(10));
  EXPECT_EQ(outside.reason, "the rear axle begins outside of what the vehicle stays inside of");
  EXPECT_EQ(outside.hit, (Hit{HitKind::inside, 0}));
}

TEST(Inside, ThereIsNoWayFromOneAreaToAnother) {
  const std::vector<Polygon> areas = {box(-10, -10, 40, 10), box(42, -10, 100, 10)};
  const PlanResult result =
      plan(make_problem(in_area({0, 0, 0}, {60, 0, 0}, areas)), of_iterations(100'000));
  EXPECT_EQ(result.status, PlanStatus::no_path) << name_of(result.status);
}

TEST(Inside, HitsKeepTheirNumbers) {
  Scenario scenario = in_area({0, 0, 0}, {30, 0, 0}, {box(-50, -40, 50, 40)});
  scenario.obstacles = {box(0, 30, 5, 35), box(20, -1, 21, 1)};
  const PathCheck check = check_path(make_problem(scenario), {{0, 0, 0}, {{0, 30}}});
  EXPECT_EQ(check.hit, (Hit{HitKind::obstacle, 1}));
  EXPECT_EQ(check.reason, "the footprint hits obstacles[1]");
  scenario.goal = {20.5, 0, 0};
  EXPECT_EQ(plan(make_problem(scenario), of_iterations(10)).hit, (Hit{HitKind::obstacle, 1}));
}

TEST(Inside, TheMarginIsKeptFromTheEdge) {
  const Problem problem = make_problem(in_area({0, 0, 0}, {30, 0, 0}, {box(-10, -1.5, 50, 10)}));
  PlanOptions options = of_iterations(500);
  options.clearance.margin = 0.3;  // there is 0.225 m
  EXPECT_EQ(plan(problem, options).status, PlanStatus::start_in_collision);
  options.clearance.margin = 0.2;
  EXPECT_EQ(plan(problem, options).status, PlanStatus::solved);
}

TEST(Inside, AreasHaveNothingInCommon) {
  const auto fault = [](std::vector<Polygon> areas) {
    return place_of_error([&] { check_scenario(in_area({}, {9, 0, 0}, std::move(areas))); });
  };
  EXPECT_EQ(fault({box(0, 0, 10, 10), box(11, 0, 20, 10)}), "nothing");
  EXPECT_EQ(fault({box(0, 0, 10, 10), box(10, 0, 20, 10)}), "inside[1]");
  EXPECT_EQ(fault({box(0, 0, 10, 10), box(2, 2, 3, 3)}), "inside[1]");
  EXPECT_EQ(fault({box(2, 2, 3, 3), box(20, 0, 21, 1), box(0, 0, 10, 10)}), "inside[2]");
  EXPECT_EQ(fault({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}), "inside[0]");
  EXPECT_EQ(fault({{{0, 0}, {10, 10}}}), "inside[0]");
}

/// A zigzag from south to north, and what is between it and a border.
Polygon zigzag(Rng& rng) {
  Polygon line;
  for (double y = -20; y < 21; y += 8) line.push_back({uniform(-6, 6, rng), y});
  return line;
}
Polygon beside(Polygon line, double border, double by) {
  for (Point& p : line) p.x += by;
  line.push_back({border, 20});
  line.push_back({border, -20});
  return line;
}

// Far from the origin too: areas that touch along a line or at a corner, overlap, are one in the
// other or twice the same.
TEST(Inside, NoTwoAreasWithACommonPointAreTaken) {
  for_each_case(41, 300, [](Rng& rng) {
    const Polygon line = zigzag(rng);
    const Polygon one = beside(line, 25, 0);
    Polygon other = one;
    switch (rng() % 5) {
      case 0:  // twice the same, from another corner on
        std::rotate(other.begin(), other.begin() + static_cast<std::ptrdiff_t>(rng() % 5),
                    other.end());
        break;
      case 1:  // one in the other
        for (Point& p : other) p = {15 + p.x / 50, p.y / 50};
        break;
      case 2:  // a common corner
        other = {line[2], {line[2].x - 9, line[2].y - 0.1}, {line[2].x - 9, line[2].y + 0.1}};
        break;
      case 3:  // a common part of a side
        other = {{25, -3}, {30, -3}, {30, 9}, {25, 9}};
        break;
      default:  // common ground
        other = beside(line, -25, any_size(1e-9, 9, rng));
        break;
    }
    if (chance(0.5, rng)) std::reverse(other.begin(), other.end());
    const double far = chance(0.5, rng) ? 0 : any_sign(any_size(1, 1e5, rng), rng);
    std::vector<Polygon> areas = {one, box(60, 60, 70, 70), other};
    if (chance(0.5, rng)) std::swap(areas[0], areas[2]);
    for (Polygon& area : areas) {
      for (Point& p : area) p = {p.x + far, p.y - far};
    }
    Scenario scenario = in_area({15 + far, -far, 0}, {16 + far, -far, 0}, areas);
    scenario.bounds = {-50 + far, 100 + far, -50 - far, 100 - far};
    EXPECT_EQ(place_of_error([&] { check_scenario(scenario); }), "inside[2]");
  });
}

/// How much room the body has to the edge of the one area that it is in, wherever it was looked
/// for along the path [m]; below 0 if it is in none at some place.
double room_in_one(const std::vector<Polygon>& areas, const Vehicle& vehicle, const Path& path) {
  const OracleBody body(vehicle);
  double most = -1.0;
  for (const Polygon& area : areas) {
    double room = 1e9;
    for (const PathPoint& point : sampled(path, 0.02)) {
      if (!contains(std::span<const Point>(area), Point{point.pose.x, point.pose.y})) room = -1.0;
      for (std::size_t i = 0; i < area.size() && room > 0.0; ++i) {
        const Point side[] = {area[i], area[(i + 1) % area.size()]};
        room = std::min(room, gap_between(body.at(point.pose), side).distance);
      }
      if (room <= 0.0) break;
    }
    most = std::max(most, room > 0.0 ? room : -1.0);
  }
  return most;
}

// Areas that nearly touch are no more one than others: neither checker nor judge lets a body from
// one to the other, or be half in each.
TEST(Inside, ABodyStaysInOneAreaHoweverNearTheOtherIs) {
  int in = 0, out = 0;
  for_each_case(42, 400, [&](Rng& rng) {
    const Polygon line = zigzag(rng);
    const double apart = chance(0.5, rng) ? any_size(1e-9, 1e-5, rng) : any_size(1e-5, 3, rng);
    const std::vector<Polygon> areas = {beside(line, -25, -apart / 2), beside(line, 25, apart / 2)};
    Vehicle vehicle = any_body(rng);
    vehicle.outline.clear();
    vehicle.min_turning_radius = 4;
    const Pose start{any_sign(uniform(2, 20, rng), rng), uniform(-15, 15, rng),
                     uniform(-pi, pi, rng)};
    const Path path{start, {{uniform(-0.25, 0.25, rng), any_sign(any_size(0.01, 12, rng), rng)}}};
    const Problem problem =
        problem_in({.bounds = {-90, 90, -90, 90}, .inside = areas}, start, end_pose(path), vehicle);
    const bool is_free = problem.task().checker->is_free(Local(start)) &&
                         problem.task().checker->is_free(Local(start), path.segments);
    const PathCheck check = check_path(problem, path);
    const double room = room_in_one(areas, vehicle, path);
    if (room < 0.0) {
      ++out;
      EXPECT_FALSE(is_free) << as_code(path);
      EXPECT_FALSE(check.valid) << as_code(path);
    } else if (room > 0.05 + 0.005 * OracleBody(vehicle).reach()) {
      ++in;
      EXPECT_TRUE(is_free) << as_code(path);
      EXPECT_TRUE(check.valid) << check.reason << as_code(path);
    }
  });
  EXPECT_GE(in, cases(400) / 20);
  EXPECT_GE(out, cases(400) / 8);
}

TEST(Inside, FencesStandOutsideOfTheirSides) {
  for (const bool is_reversed : {false, true}) {
    Polygon area = corner_of_two;
    if (is_reversed) area = {area.rbegin(), area.rend()};
    const std::vector<Polygon> local = problem::local_areas({area, box(100, 0, 110, 10)}, {});
    const std::vector<Polygon> fences = problem::fences_around(local);
    ASSERT_EQ(fences.size(), 10U);
    for (std::size_t i = 0; i < 6; ++i) {
      Point middle{};
      for (const Point& corner : fences[i]) {
        middle = {middle.x + corner.x / 4, middle.y + corner.y / 4};
      }
      const double out =
          std::max(std::min(std::abs(middle.x) - 6, std::abs(middle.y) - 6),
                   std::max({-6 - middle.x, -6 - middle.y, middle.x - 60, middle.y - 60}));
      EXPECT_GT(out, 1e-7);
      EXPECT_LT(out, 1e-6);
    }
  }
}

TEST(Inside, TheTrailerStaysInsideToo) {
  Scenario scenario = in_area({0, 0, 0}, {20, 0, 0}, {box(-30, -4, 40, 4)});
  scenario.vehicle = semitrailer();
  EXPECT_EQ(plan(make_problem(scenario), of_iterations(2000)).status, PlanStatus::solved);
  scenario.inside = {box(-8, -4, 40, 4)};  // the end of the trailer is outside
  EXPECT_EQ(plan(make_problem(scenario), of_iterations(100)).status,
            PlanStatus::start_in_collision);
  EXPECT_FALSE(check_path(make_problem(scenario), {{0, 0, 0}, {{0, 20}}}).valid);
}

TEST(Inside, ARigIsInOneArea) {
  Scenario scenario =
      in_area({0, 0, 0}, {10, 0, 0}, {box(-2, -30, 40, 30), box(-30, -30, -2.5, 30)});
  scenario.vehicle = Vehicle{};
  scenario.vehicle.hitch = -1.6;
  scenario.vehicle.trailer = Trailer{.wheelbase = 8, .front_overhang = -4};
  EXPECT_EQ(plan(make_problem(scenario), of_iterations(100)).status,
            PlanStatus::start_in_collision);
  EXPECT_EQ(check_path(make_problem(scenario), {{0, 0, 0}, {{0, 10}}}).reason,
            "the axle of the trailer begins outside of what the vehicle stays inside of");
}

TEST(Inside, AnAxleMayStandOnTheEdge) {
  Scenario scenario = in_area({}, {}, {box(-20, -20, 20, 20)});
  scenario.vehicle.rear_overhang = 0;
  for (const Pose& pose :
       {Pose{-20, 0, 0}, Pose{20, 0, pi}, Pose{0, 20, -pi / 2}, Pose{0, -20, pi / 2}}) {
    scenario.start = scenario.goal = pose;
    const PathCheck check = check_path(make_problem(scenario), {pose, {}});
    EXPECT_TRUE(check.valid) << check.reason;
  }
}

TEST(Inside, ItHoldsWhilePlanningAnew) {
  Scenario scenario = in_area({40, 0, pi}, {0, 40, pi / 2}, {corner_of_two});
  scenario.obstacles = {box(70, 70, 71, 71)};
  ReplanOptions options;
  options.plan.budget.max_iterations = 3000;
  Replanner replanner(scenario, options);
  EXPECT_TRUE(replanner.tick(0.0).reaches_goal || is_sanitized);
  replanner.patch({.removed = {0}});
  replanner.patch({.added = {{7, box(-6, 10, 6, 11)}}});
  const ReplanAnswer& answer = replanner.tick(0.1);
  EXPECT_FALSE(answer.reaches_goal);  // there is no way around outside of the area
}

TEST(Inside, WhatIsRandomStaysInside) {
  for_each_case(99, 40, [](Rng& rng) {
    Scenario scenario = in_area({30, uniform(-2, 2, rng), uniform(-pi, pi, rng)},
                                {uniform(-1, 1, rng), 40, uniform(-pi, pi, rng)}, {corner_of_two});
    const Problem problem = make_problem(scenario);
    PlanOptions options = of_iterations(600);
    options.steering = chance(0.5, rng) ? Steering::reeds_shepp : Steering::continuous;
    const PlanResult result = plan(problem, options);
    EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
    if (!result.path) return;
    for (const PathPoint& point : sampled(*result.path, 0.1)) {
      for (const Point& corner : corners(footprint(problem.vehicle()), point.pose)) {
        EXPECT_TRUE(is_in_corner(corner)) << corner.x << " " << corner.y;
      }
    }
  });
}

}  // namespace
}  // namespace vandplan

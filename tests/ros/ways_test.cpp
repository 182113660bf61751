// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Which way does a robot take past via points and over ground that costs more?

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ros/adapter/planner.h"
#include "ros/yard.h"
#include "vandplan/judge.h"

namespace vandplan::ros {
namespace {

using std::numbers::pi;

Planner planner_before_wall() {
  Planner planner;
  planner.take(walled_room().view());
  return planner;
}

Answer way_of(const Request& request) { return planner_before_wall().plan(request); }

/// Least distance of the poses of an answer from a place.
double nearest_to(const Answer& answer, const Pose& place) {
  double least = HUGE_VAL;
  for (const PathPose& at : answer.poses) {
    least = std::min(least, std::hypot(at.pose.x - place.x, at.pose.y - place.y));
  }
  return least;
}

/// Whether the judge finds that a path passes these places of the rear axle, in their order.
bool passes(const Answer& answer, const Request& request, const std::vector<Via>& vias) {
  const auto world = std::make_shared<const World>(ground_of(walled_room().view(), {}), Point{});
  const Problem problem =
      make_problem(world, request.vehicle, request.start, request.goals.front());
  return answer.path && check_path(with_via(problem, vias), *answer.path, {}).valid;
}

TEST(RosWays, PassesViaPointsInTheirOrder) {
  Request request = small_request(left, right);
  const Pose first{15, 10, 0}, second{5, 10, 3};  // not the shorter order
  request.viapoints = {{first}, {second}};
  const Answer answer = way_of(request);
  ASSERT_EQ(answer.outcome, Outcome::solved) << answer.message;
  EXPECT_TRUE(passes(answer, request, {{{region_of_pose(first)}}, {{region_of_pose(second)}}}));
  EXPECT_GT(length(*answer.path), 35.0);  // straight lines in the other order: 25 m
  EXPECT_GE(answer.cost, length(*answer.path) - 1e-6);
  request.rear_axle = 0.1;
  EXPECT_TRUE(passes(way_of(request), small_request({3.1, 3, 0}, {17.1, 3, 0}),
                     {{{region_of_pose({15.1, 10, 0})}}}))
      << "base_link passes them";
}

TEST(RosWays, AViaPointThatIsTakenOrOutsideIsNamed) {
  Request request = small_request(left, right, 10);
  const auto with_second = [&](const ViaPoint& second) {
    request.viapoints = {{{5, 10, 0}}, second};
    return way_of(request);
  };
  for (const bool any_heading : {false, true}) {
    const Answer blocked = with_second({{10, 3, 0}, any_heading});
    EXPECT_EQ(blocked.outcome, Outcome::goal_occupied);
    EXPECT_EQ(blocked.message, "via point 2 is not free");
    const Answer outside = with_second({{10, 30, 0}, any_heading});
    EXPECT_EQ(outside.outcome, Outcome::goal_outside_map);
    EXPECT_EQ(outside.message, "via point 2 is off the costmap");
  }
  const Pose beside_wall{9.6, 3, 0};  // with its front in the wall, but not with its side
  EXPECT_EQ(with_second({beside_wall}).outcome, Outcome::goal_occupied);
  EXPECT_NE(with_second({beside_wall, true}).outcome, Outcome::goal_occupied);
  request.options.clearance.margin = 0.3;
  EXPECT_EQ(with_second({beside_wall, true}).outcome, Outcome::goal_occupied) << "too near";
}

TEST(RosWays, AViaPointMayHaveAnyHeading) {
  Request request =
      small_request({3, 10, 0}, {17, 10, 0}, 3000, {{"steering", std::string("reeds-shepp")}});
  request.viapoints = {{{10, 10, pi / 2}}};
  const double turned = way_of(request).cost;
  request.viapoints.front().any_heading = true;
  const Answer free = way_of(request);
  ASSERT_EQ(free.outcome, Outcome::solved) << free.message;
  EXPECT_NEAR(free.cost, 14.0, 0.01) << "straight through";
  EXPECT_GT(turned, free.cost + 0.5);
  EXPECT_LT(nearest_to(free, {10, 10, 0}), 0.1);
}

// What made a kink before: each way to a via point was planned alone, with straight wheels there.
TEST(RosWays, APathDoesNotStopAtAViaPoint) {
  Request request = small_request({3, 10, 0}, {17, 10, 0}, 4000);
  request.viapoints = {{{10, 11, 0}, true}};
  const Answer answer = way_of(request);
  ASSERT_EQ(answer.outcome, Outcome::solved) << answer.message;
  const std::vector<Segment>& segments = answer.path->segments;
  for (std::size_t i = 1; i < segments.size(); ++i) {
    const Segment& before = segments[i - 1];
    if (before.gear() != segments[i].gear()) continue;
    const double end = before.curvature + before.curvature_rate * std::abs(before.length);
    EXPECT_NEAR(end, segments[i].curvature, 1e-6) << i;
  }
}

TEST(RosWays, ARobotStandsAtAViaPointThatItCannotDriveThrough) {
  Request request = small_request({3, 10, 0}, {17, 10, 0}, 3000);
  const Pose across{10, 10, pi / 2};
  request.viapoints = {{across}};
  const Answer answer = way_of(request);
  ASSERT_EQ(answer.outcome, Outcome::solved) << answer.message;
  EXPECT_TRUE(passes(answer, request, {{{region_of_pose(across)}, true}}));
  request.viapoints = {{{10, 11.6, pi / 2}}};  // nearer to the edge than its front
  EXPECT_EQ(way_of(request).outcome, Outcome::goal_occupied);
}

TEST(RosWays, AChangeOfGearAtAViaPointCosts) {
  const Pose ahead{6, 3, 0}, behind{4, 3, 0};
  const auto wish = [](const Pose& start, const Pose& goal) {
    return small_request(start, goal, 3000, {{"gear_change_cost", 1.0}});
  };
  Request request = wish(ahead, ahead);
  request.viapoints = {{behind}};
  const double apart = way_of(wish(ahead, behind)).cost + way_of(wish(behind, ahead)).cost;
  EXPECT_NEAR(way_of(request).cost, apart + 1.0, 0.01);
}

/// Length of the path of an answer in cells of a range, by its poses.
double length_in(const Answer& answer, const CellRange& range) {
  double sum = 0.0;
  for (std::size_t i = 1; i < answer.poses.size(); ++i) {
    const Pose& a = answer.poses[i - 1].pose;
    const Pose& b = answer.poses[i].pose;
    const double x = (a.x + b.x) * 5 - range.column, y = (a.y + b.y) * 5 - range.row;
    if (x < 0 || y < 0 || x > range.columns || y > range.rows) continue;
    sum += std::hypot(b.x - a.x, b.y - a.y);
  }
  return sum;
}

TEST(RosWays, GradedCostsHaveAPrice) {
  const CellRange dear{60, 95, 80, 12};
  OwnedCostmap room = walled_room();
  room.fill(dear, 252);
  Planner planner;
  planner.take(room.view());
  const auto planned = [&](double penalty) {
    planner.forget();
    return planner.plan(small_request({3, 10, 0}, {17, 10, 0}, 3000, {{"cost_penalty", penalty}}));
  };
  const Answer straight = planned(0.0);
  ASSERT_EQ(straight.outcome, Outcome::solved) << straight.message;
  EXPECT_NEAR(straight.cost, 14.0, 1e-6);
  EXPECT_NEAR(length_in(straight, dear), 8.0, 0.2);
  const Answer around = planned(2.0);
  ASSERT_EQ(around.outcome, Outcome::solved) << around.message;
  EXPECT_LT(length_in(around, dear), 0.2);
  EXPECT_LT(around.cost, 15.0);
  // 25 of 252 is 10 percent: not worth a detour.
  room.fill(dear, 25);
  planner.take(room.view());
  EXPECT_NEAR(planned(0.5).cost, 14.0 + 8.0 * 0.5 * 0.1, 0.01);
}

TEST(RosWays, CostsThatHaveChangedHaveTheirNewPrice) {
  OwnedCostmap room = walled_room();
  Planner planner;
  planner.take(room.view());
  const Request request = small_request({3, 10, 0}, {17, 10, 0}, 3000);
  EXPECT_NEAR(planner.plan(request).cost, 14.0, 1e-6);
  const auto world = planner.world();
  const CellRange dear{60, 80, 20, 40};  // across the whole way
  room.fill(dear, 126);
  planner.take(room.view());
  EXPECT_NEAR(planner.plan(request).cost, 14.0 + 2.0 * 2.0 * 0.5, 0.01);
  room.fill(dear, unknown_cost);
  planner.take(room.view());
  EXPECT_NEAR(planner.plan(request).cost, 14.0, 1e-6) << "unknown is not dear";
  EXPECT_EQ(planner.world(), world) << "patched";
}

TEST(RosWays, TheLastPathPastViaPointsIsTheFirstOfTheNextCall) {
  Request request = small_request(left, right, 4000);
  request.viapoints = {{{5, 10, 0}}, {{15, 10, 0}, true}};
  Planner planner = planner_before_wall();
  const Answer first = planner.plan(request);
  ASSERT_EQ(first.outcome, Outcome::solved) << first.message;
  request.options.budget.max_iterations = 100;
  EXPECT_EQ(way_of(request).outcome, Outcome::timed_out) << "from nothing it takes longer";
  const Answer again = planner.plan(request);
  ASSERT_EQ(again.outcome, Outcome::solved) << again.message;
  EXPECT_LT(again.cost, 1.1 * first.cost);
}

}  // namespace
}  // namespace vandplan::ros

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ros/adapter/goals.h"
#include "ros/yard.h"
#include "support/place_of_error.h"
#include "vandplan/judge.h"

namespace vandplan::ros {
namespace {

using std::numbers::pi;

/// A planner that knows the room with a wall.
Planner planner_in_room() {
  Planner planner;
  planner.take(walled_room().view());
  return planner;
}

Answer answer_to(const Request& request) { return planner_in_room().plan(request); }

TEST(RosPlanner, PlansAroundAWall) {
  const Answer answer = answer_to(small_request(left, right));
  ASSERT_EQ(answer.outcome, Outcome::solved) << answer.message;
  EXPECT_EQ(answer.message, "");
  EXPECT_EQ(answer.poses.front().pose, left);
  EXPECT_NEAR(answer.poses.back().pose.x, right.x, 1e-6);
  EXPECT_NEAR(answer.poses.back().pose.y, right.y, 1e-6);
  EXPECT_GT(answer.cost, 14.0);
  double highest = 0.0;
  for (std::size_t i = 1; i < answer.poses.size(); ++i) {
    const Pose& a = answer.poses[i - 1].pose;
    const Pose& b = answer.poses[i].pose;
    EXPECT_LE(std::hypot(b.x - a.x, b.y - a.y), 0.1 + 1e-3) << "a cell";
    highest = std::max(highest, b.y);
  }
  EXPECT_GT(highest, 8.0) << "above the wall";
}

TEST(RosPlanner, AnswersAreThoseOfTheLibrary) {
  const Request request = small_request(left, right);
  const Answer answer = answer_to(request);
  Scenario scenario{.vehicle = request.vehicle, .start = left, .goal = right};
  const Surroundings ground = ground_of(walled_room().view(), {});
  scenario.map = ground.map;
  scenario.masks = ground.masks;
  scenario.bounds = ground.bounds;
  const PlanResult result = vandplan::plan(scenario, request.options);
  EXPECT_EQ(answer.path, result.path);
  EXPECT_EQ(answer.cost, result.cost);
}

TEST(RosPlanner, SaysWhatIsOccupiedOrOutside) {
  const auto outcome = [](const Pose& start, const Pose& goal) {
    const Answer answer = answer_to(small_request(start, goal, 10));
    EXPECT_NE(answer.message, "");
    EXPECT_TRUE(answer.poses.empty());
    EXPECT_FALSE(answer.path);
    return answer.outcome;
  };
  EXPECT_EQ(outcome({10, 3, 0}, right), Outcome::start_occupied);
  EXPECT_EQ(outcome({9.5, 3, 0}, right), Outcome::start_occupied) << "its front";
  EXPECT_EQ(outcome({0.05, 3, 0}, right), Outcome::start_occupied) << "beyond the edge";
  EXPECT_EQ(outcome(left, {10, 3, 0}), Outcome::goal_occupied);
  EXPECT_EQ(outcome({-1, 3, 0}, right), Outcome::start_outside_map);
  EXPECT_EQ(outcome({3, 12.1, 0}, right), Outcome::start_outside_map);
  EXPECT_EQ(outcome({20.1, 3, 0}, right), Outcome::start_outside_map);
  EXPECT_EQ(outcome({3, -0.1, 0}, right), Outcome::start_outside_map);
  EXPECT_EQ(outcome(left, {21, 3, 0}), Outcome::goal_outside_map);
  EXPECT_EQ(outcome({-1, 3, 0}, {21, 3, 0}), Outcome::start_outside_map) << "the start first";
}

TEST(RosPlanner, SaysWhenThereIsNoPathOrNoTime) {
  Planner planner;
  OwnedCostmap room = walled_room();
  room.fill({98, 80, 4, 40}, nav2_lethal_cost);
  planner.take(room.view());
  EXPECT_EQ(planner.plan(small_request(left, right, 100000)).outcome, Outcome::no_path);
  EXPECT_EQ(answer_to(small_request(left, {16, 3, 3}, 0)).outcome, Outcome::timed_out);
  Request late = small_request(left, right);
  late.options.budget = {.time_limit = 0.0};
  EXPECT_EQ(answer_to(late).outcome, Outcome::timed_out);
}

TEST(RosPlanner, WaitsForTheFirstPathAsLongAsItsPatienceLasts) {
  Request request = small_request(left, right);
  request.options.budget = {.time_limit = 0.0};
  EXPECT_EQ(answer_to(request).outcome, Outcome::timed_out);
  request.patience = 1000.0;
  EXPECT_EQ(answer_to(request).outcome, Outcome::solved) << "soon, with its first path";
  std::stop_source source;
  source.request_stop();
  request.stop = source.get_token();
  EXPECT_EQ(answer_to(request).outcome, Outcome::cancelled);
}

TEST(RosPlanner, AWrongRequestIsInvalid) {
  const auto message = [](const Request& request) {
    const Answer answer = answer_to(request);
    EXPECT_EQ(answer.outcome, Outcome::invalid);
    return answer.message.substr(0, answer.message.find(':'));
  };
  const Request good = small_request(left, right);
  Request wrong = good;
  wrong.goals.clear();
  EXPECT_EQ(message(wrong), "goals");
  wrong = good;
  wrong.start.x = NAN;
  EXPECT_EQ(message(wrong), "start.x");
  wrong = good;
  wrong.goals.front().heading = HUGE_VAL;
  EXPECT_EQ(message(wrong), "goal.heading");
  wrong = good;
  wrong.viapoints = {{{NAN, 0, 0}}};
  EXPECT_EQ(message(wrong), "goal.x");
  wrong = good;
  wrong.vehicle.width = -1;
  EXPECT_EQ(message(wrong), "vehicle.width");
  wrong = good;
  wrong.options.clearance.margin = -1;
  EXPECT_EQ(message(wrong), "margin");
  wrong = good;
  wrong.cost_rule.cost_penalty = 1000;
  EXPECT_EQ(message(wrong), "masks[0]");
  wrong = good;
  wrong.heading = GoalHeading::any;
  wrong.rear_axle = 0.1;
  EXPECT_EQ(message(wrong), "goal_heading_mode");
  Planner nothing_known;
  EXPECT_EQ(nothing_known.plan(good).message, "costmap: is missing, expected one to plan on");
  EXPECT_EQ(nothing_known.world(), nullptr);
}

TEST(RosPlanner, UnknownCellsAndLethalCostsAreAsTheRuleSays) {
  OwnedCostmap room = walled_room();
  room.fill({98, 80, 4, 40}, unknown_cost);
  Planner planner;
  planner.take(room.view());
  EXPECT_EQ(planner.plan(small_request(left, right)).outcome, Outcome::solved);
  EXPECT_NE(planner.plan(small_request(left, right, 2000, {{"allow_unknown", false}})).outcome,
            Outcome::solved);
  room.fill({98, 80, 4, 40}, 253);
  planner.take(room.view());
  EXPECT_EQ(planner.plan(small_request(left, right)).outcome, Outcome::solved) << "only inflated";
  EXPECT_NE(
      planner.plan(small_request(left, right, 2000, {{"lethal_cost", std::int64_t{253}}})).outcome,
      Outcome::solved);
}

TEST(RosPlanner, TheHeadingOfTheGoalMayBeFree) {
  const Pose goal{3, 9, pi};
  const auto end = [&](const std::string& mode, double rear_axle = 0.0) {
    const Answer answer = answer_to(
        small_request(left, goal, 3000, {{"goal_heading_mode", mode}, {"rear_axle", rear_axle}}));
    EXPECT_EQ(answer.outcome, Outcome::solved) << answer.message;
    EXPECT_EQ(answer.goal, 0U);
    const Pose last = answer.poses.empty() ? Pose{} : answer.poses.back().pose;
    EXPECT_NEAR(std::hypot(last.x - goal.x, last.y - goal.y), 0, 1e-5) << "base_link";
    return std::abs(wrap_angle(last.heading - goal.heading));
  };
  EXPECT_NEAR(end("DEFAULT"), 0, 1e-5);
  const double either = end("BIDIRECTIONAL");
  EXPECT_LT(std::min(either, pi - either), 1e-5);
  const double shifted = end("BIDIRECTIONAL", 0.1);
  EXPECT_LT(std::min(shifted, pi - shifted), 1e-5);
  EXPECT_GT(end("ALL_DIRECTION"), 0.1) << "neither way is the cheapest";
}

TEST(RosPlanner, BothWaysAreGoalsOfTheSameIndex) {
  Request request = small_request(left, right);
  request.goals = {left, right};
  request.heading = GoalHeading::either_way;
  request.rear_axle = 0.1;
  const Goals goals = goals_of(request);
  EXPECT_EQ(goals.origins, (std::vector<std::size_t>{0, 0, 1, 1}));
  EXPECT_NEAR(goals.regions[0].x.least, 3.1, 1e-12);
  EXPECT_NEAR(goals.regions[1].x.least, 2.9, 1e-12);
  EXPECT_NEAR(std::abs(goals.regions[1].heading.from), pi, 1e-12);
}

TEST(RosPlanner, TheCheapestOfSeveralGoalsIsReached) {
  Request request = small_request(left, right);
  request.goals = {right, {21, 3, 0}, {6, 3, 0}};
  const Answer answer = answer_to(request);
  ASSERT_EQ(answer.outcome, Outcome::solved) << answer.message;
  EXPECT_EQ(answer.goal, 2U);
  request.goals = {{10, 3, 0}, right};
  EXPECT_EQ(answer_to(request).goal, 1U) << "the only one that is free";
  request.goals = {{10, 3, 0}, {10, 4, 0}};
  EXPECT_EQ(answer_to(request).outcome, Outcome::goal_occupied);
  request.goals = {{21, 3, 0}, {21, 4, 0}};
  EXPECT_EQ(answer_to(request).outcome, Outcome::goal_outside_map);
}

TEST(RosPlanner, ATakenGoalMayBeMissedByTheTolerance) {
  const Pose goal{9.4, 3, 0};  // the front is 0.1 m in the wall
  const auto reached = [&](double tolerance) {
    return answer_to(small_request(left, goal, 3000, {{"tolerance", tolerance}}));
  };
  EXPECT_EQ(reached(0.0).outcome, Outcome::goal_occupied);
  EXPECT_EQ(reached(0.05).outcome, Outcome::goal_occupied);
  const Answer near = reached(0.3);
  ASSERT_EQ(near.outcome, Outcome::solved) << near.message;
  EXPECT_TRUE(near.used_slack);
  const Pose end = near.poses.back().pose;
  EXPECT_LE(std::abs(end.x - goal.x), 0.3 + 1e-6);
  EXPECT_LE(std::abs(end.y - goal.y), 0.3 + 1e-6);
  EXPECT_NEAR(end.heading, 0, 1e-5);
  const Answer exact = answer_to(small_request(left, {7, 3, 0}, 3000, {{"tolerance", 0.3}}));
  EXPECT_FALSE(exact.used_slack);
  EXPECT_NEAR(exact.poses.back().pose.x, 7, 1e-5) << "a free goal is reached exactly";
}

TEST(RosPlanner, SlackLiesAlongTheGoalsHeading) {
  Request request = small_request(left, {5, 6, pi / 2});
  request.slack = {.ahead = 2, .aside = 0, .heading = 0.2};
  const GoalRegion region = goals_beside(request).regions.front();
  const Bounds box = bounding_box(region.area);
  EXPECT_NEAR(box.x_max - box.x_min, 0.002, 1e-9) << "a box has an area";
  EXPECT_NEAR(box.y_min, 4, 1e-9);
  EXPECT_NEAR(box.y_max, 8, 1e-9);
  EXPECT_NEAR(region.heading.from, pi / 2 - 0.2, 1e-12);
  EXPECT_NEAR(region.heading.to, pi / 2 + 0.2, 1e-12);
  EXPECT_FALSE(region.either_way);
  request.heading = GoalHeading::either_way;
  EXPECT_TRUE(goals_beside(request).regions.front().either_way);
  request.heading = GoalHeading::any;
  EXPECT_EQ(goals_beside(request).regions.front().heading, any_heading);
  request.heading = GoalHeading::given;
  request.slack.heading = 100;
  EXPECT_EQ(goals_beside(request).regions.front().heading, any_heading);
}

TEST(RosPlanner, TheRearAxleNeedNotBeAtBaseLink) {
  const Request request = small_request(left, right, 2000, {{"rear_axle", -0.05}});
  const Answer answer = answer_to(request);
  ASSERT_EQ(answer.outcome, Outcome::solved) << answer.message;
  EXPECT_NEAR(answer.path->start.x, 2.95, 1e-12);
  EXPECT_NEAR(answer.poses.front().pose.x, 3, 1e-12);
  EXPECT_NEAR(answer.poses.back().pose.x, 17, 1e-5);
}

TEST(RosPlanner, MarginsGearsAndPricesHold) {
  const Answer wide = answer_to(small_request(left, right, 3000, {{"margin", 0.5}}));
  ASSERT_EQ(wide.outcome, Outcome::solved) << wide.message;
  const Surroundings ground = ground_of(walled_room().view(), {});
  const Request request = small_request(left, right);
  const Problem problem =
      make_problem(std::make_shared<const World>(ground, Point{}), request.vehicle, left, right);
  const PathClaims margin{.clearance = {.margin = 0.5}};
  EXPECT_TRUE(check_path(problem, *wide.path, margin).valid);
  const Answer forward =
      answer_to(small_request({6, 3, 0}, {4, 3, 0}, 3000, {{"gears", std::string("forward")}}));
  ASSERT_EQ(forward.outcome, Outcome::solved) << forward.message;
  for (const PathPose& pose : forward.poses) EXPECT_EQ(pose.gear, Gear::forward);
  const Answer cheap = answer_to(small_request({6, 3, 0}, {4, 3, 0}));
  EXPECT_EQ(cheap.poses.back().gear, Gear::reverse);
}

TEST(RosPlanner, APathElsewhereIsNoStart) {
  const auto after = [](const Request& first, const Request& second) {
    Planner planner = planner_in_room();
    EXPECT_EQ(planner.plan(first).outcome, Outcome::solved);
    const Answer answer = planner.plan(second);
    EXPECT_EQ(answer.outcome, Outcome::solved);
    return answer.path->segments;
  };
  const Pose begin{3, 3, 0};
  const Request path = small_request(begin, {7, 9, 1}, 500);
  const Request nothing = small_request(begin, begin, 0);  // a world with the same origin
  const Request far_away = small_request({13, 3, 0}, {17, 9, 1}, 500);
  EXPECT_EQ(after(path, far_away), after(nothing, far_away));
  const Request back = small_request(begin, {3, 5, 1}, 500);
  EXPECT_EQ(after(path, back), after(nothing, back));
  const Request further = small_request(begin, {7, 9.5, 1}, 500);
  EXPECT_NE(after(path, further), after(nothing, further));
}

TEST(RosPlanner, TheLastPathIsTheFirstOfTheNextCall) {
  Planner planner = planner_in_room();
  const Answer first = planner.plan(small_request(left, right));
  ASSERT_EQ(first.outcome, Outcome::solved);
  const Answer again = planner.plan(small_request(left, right, 0));
  ASSERT_EQ(again.outcome, Outcome::solved) << "without an iteration";
  EXPECT_LE(again.cost, first.cost * (1 + 1e-9));
  // The robot has driven half of it.
  const Path& path = *again.path;
  const Pose half = pose_at(path, length(path) / 2);
  const Answer rest = planner.plan(small_request(half, right, 0));
  ASSERT_EQ(rest.outcome, Outcome::solved) << rest.message;
  EXPECT_NEAR(rest.cost, again.cost / 2, again.cost / 4);
  planner.forget();
  EXPECT_EQ(planner.plan(small_request(left, right, 0)).outcome, Outcome::timed_out);
  EXPECT_EQ(planner.plan(small_request(left, left, 0)).outcome, Outcome::solved) << "no metre";
  EXPECT_EQ(planner.plan(small_request(left, right, 0)).outcome, Outcome::timed_out)
      << "a path without a metre is no start";
}

TEST(RosPlanner, OnlyWhatHasChangedIsLookedAtAgain) {
  Planner planner = planner_in_room();
  OwnedCostmap room = walled_room();
  EXPECT_EQ(planner.plan(small_request(left, right)).outcome, Outcome::solved);
  const auto world = planner.world();
  room.fill({98, 80, 4, 40}, nav2_lethal_cost);
  planner.take(room.view());
  EXPECT_EQ(planner.plan(small_request(left, right)).outcome, Outcome::no_path);
  EXPECT_EQ(planner.world(), world) << "patched";
  room.fill({98, 40, 4, 20}, 0);
  planner.take(room.view());
  EXPECT_EQ(planner.plan(small_request(left, right)).outcome, Outcome::solved);
  EXPECT_EQ(planner.world(), world);
  OwnedCostmap other(200, 120, 0.1, {0.1, 0, 0});
  planner.take(other.view());
  EXPECT_EQ(planner.plan(small_request(left, right)).outcome, Outcome::solved);
  EXPECT_NE(planner.world(), world) << "it has moved";
}

TEST(RosPlanner, PosesAreBlockedByCellsAndTheEdge) {
  Planner planner = planner_in_room();
  const Vehicle vehicle = small_request(left, right).vehicle;
  const auto blocked = [&](const std::vector<Pose>& poses) {
    return planner.is_blocked(poses, vehicle, {});
  };
  EXPECT_FALSE(blocked({}));
  EXPECT_FALSE(blocked({left, right}));
  EXPECT_TRUE(blocked({left, {9.5, 3, 0}, right}));
  EXPECT_TRUE(blocked({{19.8, 3, 0}}));
  EXPECT_TRUE(blocked({{NAN, 3, 0}}));
  Planner nothing_known;
  EXPECT_EQ(place_of_error([&] { (void)nothing_known.is_blocked({}, vehicle, {}); }), "costmap");
}

TEST(RosPlanner, WithoutAnyLimitItEndsByItself) {
  Request request = small_request(left, {6, 3, 0});
  request.options.budget = {.target_gap = 1000};
  EXPECT_EQ(answer_to(request).outcome, Outcome::solved);
}

}  // namespace
}  // namespace vandplan::ros

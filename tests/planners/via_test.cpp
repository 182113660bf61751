// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// A path passes its vias, with every vehicle, steering and cost; and no metre is wasted on them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stop_token>
#include <string>
#include <tuple>
#include <vector>

#include "planners/via_chain.h"
#include "support/cases.h"
#include "support/combined.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/motion.h"
#include "vandplan/planner.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using std::numbers::pi;

PlanOptions via_options(std::int64_t iterations) {
  PlanOptions options;
  options.budget.max_iterations = is_sanitized ? iterations / 20 : iterations;
  return options;
}

PlanOptions via_by_length(std::int64_t iterations) {
  PlanOptions options = via_options(iterations);
  options.cost = shortest_style;
  options.steering = Steering::reeds_shepp;
  return options;
}

Scenario yard(std::vector<Via> via, std::vector<Polygon> obstacles = {}) {
  return {.bounds = {-60, 100, -60, 60},
          .goal = {40, 0, 0},
          .via = std::move(via),
          .obstacles = std::move(obstacles)};
}

Via at(const Pose& pose, bool stop = false) { return {{region_of_pose(pose)}, stop}; }

Via anyhow(double x, double y, bool stop = false) {
  GoalRegion region = region_of_pose({x, y, 0});
  region.heading = any_heading;
  return {{region}, stop};
}

TEST(Via, IsPassedOnTheWay) {
  const Problem problem = make_problem(yard({at({20, 10, 0})}));
  const PlanResult result = plan(problem, via_by_length(20'000));
  if (is_sanitized && !result.path) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  ASSERT_EQ(result.via.size(), 1U);
  EXPECT_NEAR(result.via[0].pose.y, 10, 2e-6);
  const double radius = problem.vehicle().min_turning_radius;
  const double legs = reeds_shepp_length({}, {20, 10, 0}, radius) +
                      reeds_shepp_length({20, 10, 0}, {40, 0, 0}, radius);
  EXPECT_NEAR(result.cost, legs, 1e-3 * legs);
  EXPECT_LE(*result.lower_bound, result.cost);
  EXPECT_GE(*result.lower_bound, 2 * std::hypot(20, 10) - 1e-4);
}

// A one-way ring around a house. The shortest chain has poses beside the house that nobody gets to.
TEST(Via, IsPassedAtAnotherPoseWhereOneIsHardToReach) {
  Via above = anyhow(0, 12, true);
  above.any_of[0].y = {12, 27};
  Scenario scenario{
      .bounds = {-60, 60, -60, 60},
      .start = {0, -20, 0},
      .goal = {-15, -20, 0},
      .via = {anyhow(30, 0), above, anyhow(-30, 0)},
      .obstacles = {box(-20, -10, 20, 10), box(-40, -30, 40, -29), box(-40, 29, 40, 30),
                    box(-40, -30, -39, 30), box(39, -30, 40, 30)}};
  scenario.zones = {{.area = box(-20, -29, 20, -10), .direction = HeadingRange{-0.9, 0.9}},
                    {.area = box(20, -10, 39, 10), .direction = HeadingRange{0.7, 2.5}},
                    {.area = box(-20, 10, 20, 29), .direction = HeadingRange{2.2, 4.1}},
                    {.area = box(-39, -10, -20, 10), .direction = HeadingRange{3.8, 5.6}}};
  const PlanResult result = plan(make_problem(scenario), via_options(8000));
  if (is_sanitized && !result.path) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LT(result.cost, 150);
}

TEST(Via, CostsNothingOnTheStraightWay) {
  for (const bool stop : {false, true}) {
    const PlanResult result =
        plan(make_problem(yard({at({10, 0, 0}, stop), anyhow(30, 0, stop)})), via_options(20'000));
    if (is_sanitized && !result.path) return;
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_NEAR(result.cost, 40, 0.01);
  }
}

TEST(Via, TakesTheTimeOfAStop) {
  PlanOptions options;
  options.budget.max_iterations = 4000;
  options.cost.measure = CostMeasure::time;
  const auto result = [&](bool stop) {
    return plan(make_problem(yard({at({20, 0, 0}, stop)})), options);
  };
  const auto time_of_line = [](double length) {
    return speed_profile({{}, {{0.0, length}}}, Vehicle{}).duration;
  };
  EXPECT_NEAR(result(false).cost, time_of_line(40), 1e-6);
  EXPECT_NEAR(result(true).cost, 2 * time_of_line(20), 1e-6);
}

TEST(Via, BestHeadingIsFound) {
  const PlanResult any = plan(make_problem(yard({anyhow(20, 10)})), via_by_length(40'000));
  if (is_sanitized && !any.path) return;
  ASSERT_TRUE(any.path) << any.reason;
  for (int i = 0; i < 12; ++i) {
    const double heading = -pi + i * pi / 6;
    const PlanResult one = plan(make_problem(yard({at({20, 10, heading})})), via_by_length(4000));
    EXPECT_LE(any.cost, one.path ? 1.005 * one.cost : any.cost) << heading;
  }
}

TEST(Via, IsDrivenThroughWithoutAKink) {
  PlanOptions options = via_options(20'000);
  options.steering = Steering::continuous_between_stops;
  for (const Pose& pose : {Pose{20, 6, 0}, Pose{20, 10, 1}, Pose{10, -8, -0.5}}) {
    const Problem problem = make_problem(yard({at(pose)}));
    const PlanResult result = plan(problem, options);
    if (is_sanitized && !result.path) return;
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;  // so says the judge
  }
}

TEST(Via, OrderCounts) {
  const auto cost = [](std::vector<Via> via) {
    return plan(make_problem(yard(std::move(via))), via_by_length(20'000)).cost;
  };
  if (is_sanitized) return;
  const double ahead = cost({anyhow(10, 0), anyhow(30, 0)});
  const double back = cost({anyhow(30, 0), anyhow(10, 0)});
  EXPECT_NEAR(ahead, 40, 0.01);
  EXPECT_NEAR(back, 80, 0.5);
}

TEST(Via, AnyOfTakesTheCheapest) {
  Via gates = at({20, 30, 0});
  gates.any_of.push_back(region_of_pose({20, 1, 0}));
  const PlanResult result = plan(make_problem(yard({gates})), via_by_length(20'000));
  if (is_sanitized && !result.path) return;
  ASSERT_TRUE(result.path) << result.reason;
  EXPECT_NEAR(result.via[0].pose.y, 1, 1e-5);
}

TEST(Via, ProvesThatOneIsBlocked) {
  const PlanResult result =
      plan(make_problem(yard({at({20, 20, 0})}, {box(19, 19, 21, 21)})), via_options(2000));
  EXPECT_EQ(result.status, PlanStatus::no_path);
  EXPECT_EQ(result.reason, "the pose of via[0] is not free");
}

TEST(Via, OfAPoseThatIsTakenProvesThatThereIsNoPathWhateverTheOthersAre) {
  const PlanResult result =
      plan(make_problem(yard({at({20, 0, 0}), anyhow(30, 0)}, {box(19, -1, 21, 1)})),
           via_by_length(100));
  EXPECT_EQ(result.status, PlanStatus::no_path);
  EXPECT_EQ(result.reason, "the pose of via[0] is not free");
}

TEST(Via, BehindAClosedGateIsOutOfReachWhateverTheHeading) {
  PlanOptions until_proof = via_by_length(0);
  until_proof.budget.max_iterations = 20'000;
  Scenario scenario = yard({anyhow(30, 0)}, {box(20, -90, 21, -3), box(20, 3, 21, 90)});
  scenario.zones = {{.area = box(19, -3, 22, 3), .closed = true}};
  const PlanResult result = plan(make_problem(scenario), until_proof);
  EXPECT_EQ(result.status, PlanStatus::no_path);
  EXPECT_TRUE(result.reason.starts_with("on the way to via[0]: proven")) << result.reason;
  scenario.via = {anyhow(10, 0)};  // the goal is behind the gate
  EXPECT_EQ(plan(make_problem(scenario), until_proof).status, PlanStatus::no_path);
}

TEST(Via, InANarrowSlotIsFoundOrProvenToBeTaken) {
  const auto through = [](double room) {
    const Via area{{{.area = {{10, -10}, {30, -10}, {30, 7}, {10, 7}}, .heading = any_heading}}};
    const double side = 1.275 + room / 2;
    return plan(make_problem(yard({area}, {box(8, -25, 32, -side), box(8, side, 32, 25)})),
                via_options(20'000));
  };
  EXPECT_TRUE(is_sanitized || through(0.1).path);
  EXPECT_EQ(through(-0.1).status, PlanStatus::no_path);
}

TEST(Via, LooksAtNoPoseOnceTheBudgetIsInterrupted) {
  const Problem problem = make_problem(yard({anyhow(20, 10), at({30, 0, 0})}));
  std::stop_source stop;
  const search::Budget budget({.stop = stop.get_token()});
  const planning::ViaNodes all(problem.task(), {}, budget);
  EXPECT_GT(all.looked_at(0), 0U);
  EXPECT_FALSE(all.is_cut_short());
  stop.request_stop();
  const planning::ViaNodes none(problem.task(), {}, budget);
  EXPECT_EQ(none.looked_at(0), 0U);
  EXPECT_TRUE(none.is_cut_short());
  EXPECT_FALSE(none.are_all());
}

// Most headings are against the one-way street around the via.
TEST(Via, OfAnyHeadingIsPassedAsAStreetAllows) {
  for (const bool stop : {false, true}) {
    Scenario scenario = yard({anyhow(20, 0, stop)});
    scenario.zones = {{.area = box(18, -2, 22, 2), .direction = HeadingRange{1.59, 1.61}}};
    PlanOptions options = via_options(2000);
    options.cost.gears = AllowedGears::forward;
    const PlanResult result = plan(make_problem(scenario), options);
    if (is_sanitized && !result.path) continue;
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  }
  Scenario against = yard({at({20, 0, 0})});
  against.zones = {{.area = box(14, -6, 26, 6), .direction = HeadingRange{1.4, 1.8}}};
  const PlanResult none = plan(make_problem(against), via_options(2000));
  EXPECT_EQ(none.status, PlanStatus::no_path);
  EXPECT_EQ(none.reason,
            "the pose of via[0] is not free, or zones do not let the vehicle pass there");
}

TEST(Via, IsPassedByEveryPlanner) {
  const Problem problem = make_problem(yard({at({20, 6, 0}), anyhow(30, 3, true)}));
  for (const Planner& planner : planners()) {
    PlanOptions options = via_options(6000);
    if (honours(planner, "region")) options.planner.set("region", "scene");
    const PlanResult result = plan(problem, planner, options);
    EXPECT_NE(result.status, PlanStatus::rejected) << planner.name << ": " << result.reason;
  }
}

// ---- Everything together ----

enum class Pulls { nothing, trailer };
using ViaCombination = std::tuple<Pulls, Steering, CostMeasure, bool, double, bool>;

class OnTheWay : public testing::TestWithParam<ViaCombination> {};

std::string name_of_via(const testing::TestParamInfo<ViaCombination>& info) {
  const auto& [who, steering, measure, has_movers, margin, stop] = info.param;
  constexpr const char* steerings[] = {"Arcs", "BetweenStops", "Continuous"};
  std::string name = who == Pulls::trailer ? "Rig" : "Truck";
  name += steerings[static_cast<int>(steering)];
  if (measure == CostMeasure::time) name += "Time";
  if (has_movers) name += "Movers";
  if (margin > 0) name += "MarginAndZones";
  if (stop) name += "Stop";
  return name;
}

TEST_P(OnTheWay, EverythingIsPlanned) {
  const auto& [who, steering, measure, has_movers, margin, stop] = GetParam();
  GoalRegion gate{.x = {18, 22}, .y = {8, 10}, .heading = {-0.3, 0.3}};
  if (who == Pulls::trailer) gate.hitch_angle = {-0.2, 0.2};
  Scenario scenario = yard({{{gate}, stop}}, {box(14, -6, 16, 3)});
  scenario.goal = {60, 4, 0};
  if (who == Pulls::trailer) scenario.vehicle = semitrailer();
  if (has_movers) scenario.moving = {car_across(40)};
  if (margin > 0) {
    scenario.zones = {{.area = box(22, -5, 34, 20), .max_speed = 1.5},
                      {.area = box(44, -20, 50, 20), .direction = HeadingRange{-pi / 2, pi / 2}},
                      {.area = box(4, -3, 10, 3), .cost = 2, .body = true}};
  }
  const PlanOptions options = combined(steering, measure, margin, 2500, 200);
  const Problem problem = make_problem(scenario);
  const PlanResult result = plan(problem, options);
  if (!is_planned(result)) return;
  EXPECT_EQ(result.via.size(), 1U);
  const Path& path = *result.path;
  const SpeedProfile fastest = speed_profile(path, problem.vehicle(), speed_options(problem, path));
  if (measure == CostMeasure::time) {
    EXPECT_NEAR(result.cost, fastest.duration, 1e-6);
  }
  const SpeedProfile& speeds = result.speeds ? *result.speeds : fastest;
  EXPECT_EQ(check_drive(problem, {path, speeds}, {margin}).reason, "");
}

INSTANTIATE_TEST_SUITE_P(OfTheDefaultPlanner, OnTheWay,
                         testing::Combine(testing::Values(Pulls::nothing, Pulls::trailer),
                                          testing::Values(Steering::reeds_shepp,
                                                          Steering::continuous_between_stops,
                                                          Steering::continuous),
                                          testing::Values(CostMeasure::prices, CostMeasure::time),
                                          testing::Bool(), testing::Values(0.0, 0.3),
                                          testing::Bool()),
                         name_of_via);

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Times along paths, and ways around, among what moves.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "moving/yielding.h"
#include "planners/refuges.h"
#include "support/cases.h"
#include "support/problems.h"
#include "support/radius.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using std::numbers::pi;

/// A car of 4 m by 2 m.
const Polygon car = box(-2, -1, 2, 1);

/// Crosses x = 15 from the right at 2.5 m/s: in the way of a truck along the x axis from 3.49 s to
/// 6.11 s.
MovingObstacle crossing() {
  return {.outline = car, .trajectory = {{0, {15, -12, pi / 2}}, {16, {15, 28, pi / 2}}}};
}

moving::Yielding yielding(const Path& path, const std::vector<MovingObstacle>& moving,
                          const Vehicle& vehicle = {}, double margin = 0) {
  return moving::yielding_speeds(path, vehicle, {.moving = moving, .margin = margin});
}

DriveCheck judged(const Path& path, const SpeedProfile& speeds,
                  const std::vector<MovingObstacle>& moving, const Vehicle& vehicle = {},
                  double margin = 0) {
  const Problem problem = problem_of_path({.bounds = wide_bounds}, path, vehicle);
  return check_drive(with_moving(problem, moving), {path, speeds}, {.margin = margin});
}

const Path ahead{{0, 0, 0}, {{0, 20}}};

TEST(Yielding, IsTheFastestDriveWhereNobodyIsMet) {
  MovingObstacle fast = crossing();
  fast.trajectory.back().t = 8;
  const moving::Yielding found = yielding(ahead, {fast});
  ASSERT_TRUE(found.speeds);
  EXPECT_EQ(found.states, 0);
  EXPECT_EQ(found.speeds->duration, speed_profile(ahead, {}).duration);
}

TEST(Yielding, LetsACarPassAndIsNearTheFastestDriveThatDoes) {
  const moving::Yielding found = yielding(ahead, {crossing()});
  ASSERT_TRUE(found.speeds);
  const DriveCheck check = judged(ahead, *found.speeds, {crossing()});
  EXPECT_TRUE(check.valid) << check.reason;
  // At full speed at 8.1 m when the car is past, at 6.11 s: 8.775 m at 2.5 m/s, and 2.5 s of
  // braking.
  const double best = 6.11 + 8.775 / 2.5 + 2.5;
  EXPECT_GE(found.speeds->duration, best - 0.01);
  EXPECT_LE(found.speeds->duration, 1.05 * best);
}

TEST(Yielding, TheMarginIsKept) {
  const moving::Yielding found = yielding(ahead, {crossing()}, {}, 1.0);
  ASSERT_TRUE(found.speeds);
  EXPECT_TRUE(judged(ahead, *found.speeds, {crossing()}, {}, 1.0).valid);
  EXPECT_GT(found.speeds->duration, yielding(ahead, {crossing()}).speeds->duration + 0.3);
}

TEST(Yielding, StandsOnTheWayWhereItMayNotWaitAtTheStart) {
  // One car comes through the start after 6 s, the other one blocks the way for 20 s.
  const MovingObstacle behind{.outline = car,
                              .trajectory = {{0, {0, -17, pi / 2}}, {15, {0, 20, pi / 2}}}};
  const MovingObstacle lorry{.outline = car,
                             .trajectory = {{0, {25, 0, pi / 2}}, {20, {25, 0, pi / 2}}},
                             .after = Afterwards::leaves};
  const Path path{{0, 0, 0}, {{0, 40}}};
  const moving::Yielding found = yielding(path, {behind, lorry});
  ASSERT_TRUE(found.speeds);
  const DriveCheck check = judged(path, *found.speeds, {behind, lorry});
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_GT(found.speeds->duration, 20);
}

TEST(Yielding, FindsNothingWhereSomebodyStaysInTheWay) {
  const MovingObstacle parks{.outline = car,
                             .trajectory = {{0, {15, -12, pi / 2}}, {4, {15, 0, pi / 2}}}};
  const moving::Yielding found = yielding(ahead, {parks});
  EXPECT_FALSE(found.speeds);
  EXPECT_LT(found.states, 200'000);  // it ends by itself
}

TEST(Yielding, SeesAtOnceThatNobodyGetsThrough) {
  const MovingObstacle parks{.outline = car,
                             .trajectory = {{0, {15, -12, pi / 2}}, {4, {15, 0, pi / 2}}}};
  EXPECT_LT(yielding(ahead, {parks}).states, 1500);  // boxes, and no state
}

TEST(Yielding, DoesNoMoreWorkThanItMay) {
  std::vector<MovingObstacle> many;
  for (int i = 0; i < 20; ++i) {
    many.push_back(crossing());
    for (TimedPose& row : many.back().trajectory) row.t += i;
  }
  constexpr std::int64_t most = 300;
  const moving::Yielding found =
      moving::yielding_speeds(ahead, {}, {.moving = many, .most_states = most});
  EXPECT_LE(found.states, 2 * most);
  EXPECT_GT(yielding(ahead, many).states, 2 * most);
}

TEST(Yielding, AVehicleWithALimitOfJerkBeginsLater) {
  Vehicle vehicle;
  vehicle.limits.max_jerk = 1.0;
  const moving::Yielding found = yielding(ahead, {crossing()}, vehicle);
  ASSERT_TRUE(found.speeds);
  const DriveCheck check = judged(ahead, *found.speeds, {crossing()}, vehicle);
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_GT(found.speeds->standing, 0);
}

TEST(Yielding, BeginsNoLaterThanIsOfInterest) {
  Vehicle vehicle;
  vehicle.limits.max_jerk = 1.0;
  const SpeedProfile best = *yielding(ahead, {crossing()}, vehicle).speeds;
  const std::vector<MovingObstacle> moving = {crossing()};
  moving::Traffic traffic{.moving = moving, .longest = best.duration - 0.01};
  const moving::Yielding shorter = moving::yielding_speeds(ahead, vehicle, traffic);
  EXPECT_FALSE(shorter.speeds);
  EXPECT_GT(shorter.states, 0);
  traffic.longest = best.duration + 0.01;
  EXPECT_TRUE(moving::yielding_speeds(ahead, vehicle, traffic).speeds);
  traffic.most_states = shorter.states / 2;
  const moving::Yielding cut_off = moving::yielding_speeds(ahead, vehicle, traffic);
  EXPECT_FALSE(cut_off.speeds);
  EXPECT_TRUE(cut_off.is_cut_off);
}

// Two neighbouring numbers have none between them.
TEST(Yielding, AnObstacleMayJump) {
  const double t = 40.0;
  const MovingObstacle jumps{
      .outline = car, .trajectory = {{t, {60, 5, 0}}, {std::nextafter(t, 50.0), {60, -5, 0}}}};
  const Path path{{0, 0, 0}, {{0, 80}}};
  const moving::Yielding found = yielding(path, {crossing(), jumps});
  ASSERT_TRUE(found.speeds);
  EXPECT_TRUE(judged(path, *found.speeds, {crossing(), jumps}).valid);
}

TEST(InTime, AnObstacleWhoseCircleTouchesTheStartIsNotThere) {
  // 2 m ahead of the truck; the circle around the outline reaches just to it.
  const MovingObstacle stands{.outline = box(-3, -4, 3, 4), .trajectory = {{0, {10.9, 0, 0}}}};
  const Problem problem =
      with_moving(make_problem(world_of({.bounds = wide_bounds}), {}, {0, 0, 0}, {-20, 0, 0}),
                  std::vector{stands});
  PlanOptions options;
  options.budget.max_iterations = 1000;
  const PlanResult result = plan(problem, options);
  EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
}

TEST(InTime, SaysWhyTheVehicleCannotStayWhereItIs) {
  const Problem problem =
      with_moving(make_problem(world_of({.bounds = wide_bounds}), {}, {15, 0, 0}, {15, 0, 0}),
                  std::vector{crossing()});
  PlanOptions options;
  options.budget.max_iterations = 100;
  EXPECT_EQ(plan(problem, options).reason,
            "the goal is the start, and something that moves comes there");
}

TEST(YieldingLaw, WhatIsFoundIsGoodInTheEyesOfTheJudge) {
  int found = 0;
  for_each_case(1, 150, [&](Rng& rng) {
    std::vector<Segment> segments;
    for (int i = 0; i < 3; ++i) {
      const double sign = uniform01(rng) < 0.3 ? -1 : 1;
      segments.push_back({uniform(-0.14, 0.14, rng), sign * uniform(2, 15, rng)});
    }
    const Path path{{0, 0, uniform(-pi, pi, rng)}, segments};
    std::vector<MovingObstacle> moving;
    for (int k = 0; k < 4; ++k) {
      MovingObstacle& mover = moving.emplace_back(MovingObstacle{.outline = car});
      double t = 0;
      for (int i = 0; i < 3; ++i) {
        mover.trajectory.push_back(
            {t, {uniform(-25, 25, rng), uniform(-25, 25, rng), uniform(-pi, pi, rng)}});
        t += uniform(2, 10, rng);
      }
      if (uniform01(rng) < 0.7) mover.after = Afterwards::leaves;
    }
    const double margin = uniform01(rng) < 0.5 ? 0.0 : 0.3;
    const moving::Yielding yields = yielding(path, moving, {}, margin);
    if (!yields.speeds) return;
    found += yields.states > 0;
    const DriveCheck check = judged(path, *yields.speeds, moving, {}, margin);
    EXPECT_TRUE(check.valid) << check.reason << " at " << check.t.value_or(-1) << " s";
  });
  if (!is_sanitized) {
    EXPECT_GT(found, cases(150) / 10);
  }
}

TEST(YieldingLaw, NobodyHitsATrailerEither) {
  int found = 0;
  for_each_case(2, 250, [&](Rng& rng) {
    Vehicle rig{3.6, 1.4, 0.9, 2.55, 5.9};
    rig.hitch = uniform(-1, 1, rng);
    rig.trailer = Trailer{uniform(4, 8, rng), 1.6, 4.3, 2.55};
    State state{{0, 0, uniform(-pi, pi, rng)}, uniform(-0.5, 0.5, rng)};
    const State start = state;
    Path path{start.pose, {}};
    for (int i = 0; i < 3; ++i) {
      const double sign = uniform01(rng) < 0.3 ? -1 : 1;
      const Segment segment{uniform(-0.1, 0.1, rng), sign * uniform(2, 15, rng)};
      if (largest_hitch_angle(rig, state.hitch_angle, segment) > rig.max_hitch_angle) continue;
      path.segments.push_back(segment);
      state = advance(rig, state, segment);
    }
    std::vector<MovingObstacle> moving;
    for (int k = 0; k < 2; ++k) {
      MovingObstacle& mover = moving.emplace_back(MovingObstacle{.outline = car});
      double t = 0;
      for (int i = 0; i < 3; ++i) {
        mover.trajectory.push_back(
            {t, {uniform(-40, 40, rng), uniform(-40, 40, rng), uniform(-pi, pi, rng)}});
        t += uniform(2, 10, rng);
      }
      if (uniform01(rng) < 0.9) mover.after = Afterwards::leaves;
    }
    const double margin = uniform01(rng) < 0.5 ? 0.0 : 0.3;
    const moving::Traffic traffic{
        .moving = moving, .margin = margin, .start_hitch_angle = start.hitch_angle};
    const moving::Yielding yields = moving::yielding_speeds(path, rig, traffic);
    if (!yields.speeds) return;
    found += yields.states > 0;
    const Problem problem =
        with_moving(make_problem(world_of({.bounds = wide_bounds}), rig, start.pose, state.pose, {},
                                 {start.hitch_angle, state.hitch_angle}),
                    moving);
    const DriveCheck check = check_drive(problem, {path, *yields.speeds}, {.margin = margin});
    EXPECT_TRUE(check.valid) << check.reason << " at " << check.t.value_or(-1) << " s";
  });
  if (!is_sanitized) {
    EXPECT_GT(found, cases(250) / 20);
  }
}

// ---- the planner ----

PlanOptions few_iterations() {
  PlanOptions options;
  options.budget.max_iterations = 1500;
  return options;
}

Problem street_among(const std::vector<MovingObstacle>& moving) {
  const Problem problem = problem_in({.bounds = {-20, 60, -9, 9}}, {0, 0, 0}, {40, 0, 0});
  return with_moving(problem, moving);
}

TEST(PlanInTime, WaitsOrGoesRoundAndRepeatsBitForBit) {
  const Problem problem = street_among({crossing()});
  const PlanResult result = plan(problem, few_iterations());
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  ASSERT_TRUE(result.speeds);
  EXPECT_TRUE(result.drive_check->valid);
  EXPECT_LT(result.speeds->duration, 23);  // 18.5 s without the car
  const PlanResult again = plan(problem, few_iterations());
  EXPECT_EQ(again.path, result.path);
  EXPECT_EQ(again.speeds->duration, result.speeds->duration);
  EXPECT_EQ(again.iterations, result.iterations);
  EXPECT_LE(result.iterations, 1500);
}

TEST(PlanInTime, DoesTheSameAtFirstWhateverTheBudget) {
  const Problem problem = street_among(std::vector{crossing()});
  PlanOptions options;
  options.budget.max_iterations = 1000;
  const PlanResult few = plan(problem, options);
  options.budget.max_iterations = 8000;
  const PlanResult many = plan(problem, options);
  ASSERT_EQ(few.status, PlanStatus::solved) << few.reason;
  ASSERT_EQ(many.status, PlanStatus::solved) << many.reason;
  EXPECT_EQ(few.anytime.front().iteration, many.anytime.front().iteration);
  EXPECT_LT(few.anytime.front().iteration, 100);
  EXPECT_LE(many.cost + 2 * many.speeds->duration, few.cost + 2 * few.speeds->duration + 1e-9);
}

TEST(PlanInTime, TheTraceHasTheCostOfEachBestPath) {
  // The car stands in the way for 30 s: the straight path is waited on, then another is found.
  const MovingObstacle stands{.outline = car,
                              .trajectory = {{0, {20, 0, pi / 2}}, {30, {20, 0, pi / 2}}},
                              .after = Afterwards::leaves};
  PlanOptions options;
  options.budget.max_iterations = 3'000;
  const PlanResult result = plan(street_among({stands}), options);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  ASSERT_GT(result.anytime.size(), 1U);
  EXPECT_NEAR(result.anytime.front().cost, 40, 1e-6);
  EXPECT_GT(result.cost, 40.001);
  EXPECT_EQ(result.anytime.back().cost, result.cost);
}

TEST(PlanInTime, GoesRoundWhoStays) {
  const MovingObstacle parks{.outline = car,
                             .trajectory = {{0, {20, -12, pi / 2}}, {4, {20, -1, pi / 2}}}};
  const PlanResult result = plan(street_among({parks}), few_iterations());
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(result.drive_check->valid);
  EXPECT_GT(length(*result.path), 40.1);
}

TEST(PlanInTime, PlansTheFastestDriveIfTimeIsTheCost) {
  PlanOptions options = few_iterations();
  options.cost.measure = CostMeasure::time;
  const PlanResult result = plan(street_among({crossing()}), options);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(result.drive_check->valid);
  EXPECT_LE(result.cost, result.speeds->duration + 1e-6);
}

/// Far from everything.
std::vector<MovingObstacle> far_away() {
  return {{.outline = car, .trajectory = {{0, {500, 0, 0}}}}};
}

TEST(PlanInTime, CountsTheSecondsOfTheWholeDrive) {
  const Problem alone = problem_of({0, 0, 0}, {40, 0, 0},
                                   {box(12, -20, 13, 3), box(26, -3, 27, 20)}, {-10, 50, -20, 20});
  const PlanResult by_prices = plan(alone, few_iterations());
  const PlanResult by_seconds = plan(with_moving(alone, far_away()), few_iterations());
  ASSERT_EQ(by_prices.status, PlanStatus::solved) << by_prices.reason;
  ASSERT_EQ(by_seconds.status, PlanStatus::solved) << by_seconds.reason;
  const double fastest = speed_profile(*by_prices.path, {}).duration;
  EXPECT_LT(by_seconds.cost + 2 * by_seconds.speeds->duration,
            0.97 * (by_prices.cost + 2 * fastest));
}

TEST(PlanInTime, DrivesNoCrumbs) {
  for (const double x : {28.0, 38.0}) {  // somebody stops there, and somebody else comes along
    Scenario scenario;
    scenario.bounds = {-20, 90, -8, 8};
    scenario.goal = {70, -2, 0};
    scenario.vehicle.limits.max_acceleration = 1;
    scenario.vehicle.limits.max_speed = {3, 1.5};
    const Polygon truck = box(-1.6, -1.27, 5.9, 1.27);
    scenario.moving = {{truck, {{0, {x - 15, -1, 0}}, {5, {x, -1, 0}}}},
                       {truck, {{0, {85, 3, pi}}, {20, {-10, 3, pi}}}, Afterwards::leaves}};
    PlanOptions options;
    options.budget.max_iterations = 3000;
    const PlanResult result = plan(scenario, options);
    ASSERT_TRUE(result.path);
    for (const Segment& segment : result.path->segments) {
      EXPECT_GT(std::abs(segment.length), 0.05);
    }
  }
}

// The straight path lets it pass, which takes 3 to 5 s. Drives that bend behind it do not wait.
TEST(PlanInTime, BendsBehindWhoCrosses) {
  Scenario scenario{.bounds = {-20, 90, -20, 20}, .goal = {70, 0, 0}};
  scenario.vehicle.limits.max_acceleration = 1;
  scenario.vehicle.limits.max_speed = {3, 1.5};
  PlanOptions options;
  options.budget.max_iterations = 6000;
  for (const double y : {25.0, 28.0, 30.0}) {
    scenario.moving = {{.outline = box(-1.6, -1.27, 5.9, 1.27),
                        .trajectory = {{0, {40, -y, pi / 2}}, {20, {40, 40 - y, pi / 2}}},
                        .after = Afterwards::leaves}};
    const Path straight{{0, 0, 0}, {{0, 70}}};
    const moving::Yielding waits = yielding(straight, scenario.moving, scenario.vehicle);
    const PlanResult result = plan(scenario, options);
    ASSERT_TRUE(waits.speeds && result.path);
    EXPECT_LT(result.speeds->duration, waits.speeds->duration - 0.5);
    EXPECT_LT(result.cost + 2 * result.speeds->duration, 70 + 2 * waits.speeds->duration - 0.8);
  }
}

TEST(PlanInTime, SpendsTheWholeBudgetBeforeItGivesUp) {
  // A slot 1.2 m longer than the vehicle: a tenth of the budget finds no way into it.
  const Vehicle vehicle{
      .wheelbase = 3, .front_overhang = 1, .rear_overhang = 1, .width = 2, .min_turning_radius = 6};
  const Problem alone =
      problem_of({-10, 3, 0}, {0, 0, 0}, {box(-19, -1.5, -1.6, 1.2), box(4.6, -1.5, 19, 1.2)},
                 {-20, 20, -2, 6}, vehicle);
  PlanOptions options;
  options.budget.max_iterations = 1000;
  ASSERT_EQ(plan(alone, options).status, PlanStatus::iteration_limit);
  options.budget.max_iterations = 10'000;
  EXPECT_EQ(plan(with_moving(alone, far_away()), options).status, PlanStatus::solved);
}

TEST(PlanInTime, KnowsThatWhoStaysInTheGoalLeavesNoPath) {
  const MovingObstacle parks{.outline = car,
                             .trajectory = {{0, {42, -12, pi / 2}}, {4, {42, 0, pi / 2}}}};
  const PlanResult result = plan(street_among({parks}), few_iterations());
  EXPECT_EQ(result.status, PlanStatus::no_path);
  EXPECT_EQ(result.reason, "moving[0] stays where the goal is, or nearer to it than the margin");
}

TEST(PlanInTime, ClaimsNoProofWhereItFindsNothing) {
  // A wall comes across the street for good, and the goal is behind it.
  const MovingObstacle wall{.outline = box(-0.5, -12, 0.5, 12),
                            .trajectory = {{0, {20, 40, 0}}, {4, {20, 0, 0}}}};
  const PlanResult result = plan(street_among({wall}), few_iterations());
  EXPECT_EQ(result.status, PlanStatus::iteration_limit);
  EXPECT_EQ(result.reason,
            "there are paths, but none on which a drive was found that meets nothing");
}

/// A road for one, with a lay-by on the left from x = 10 to x = 40.
Problem road_with_lay_by(const std::vector<MovingObstacle>& moving) {
  const Problem alone = problem_of(
      {0, 0, 0}, {70, 0, 0},
      {box(-60, -3, 130, -2.1), box(-60, 2.1, 10, 3), box(40, 2.1, 130, 3), box(10, 5.6, 40, 6.5)},
      {-60, 130, -6.5, 6.5});
  return with_moving(alone, moving);
}

/// Comes along the road and over the start.
const MovingObstacle oncoming{.outline = car,
                              .trajectory = {{0, {80, 0, pi}}, {110, {-58, 0, pi}}},
                              .after = Afterwards::leaves};

TEST(PlanInTime, WaitsInALayByUntilWhoComesTowardsItIsPast) {
  PlanOptions options;
  options.budget.max_iterations = 8'000;
  for (const std::uint64_t seed : {1U, 2U}) {
    options.budget.seed = seed;
    const PlanResult result = plan(road_with_lay_by({oncoming}), options);
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_TRUE(result.drive_check->valid);
    EXPECT_LT(result.speeds->duration, 110);
  }
}

/// Number of places where the curvature jumps and the vehicle rolls on in the same gear.
int jumps_while_rolling(const std::vector<Segment>& segments) {
  int jumps = 0;
  for (std::size_t i = 1; i < segments.size(); ++i) {
    const Segment& before = segments[i - 1];
    const double end = curvature_at(before, std::abs(before.length));
    if (before.gear() != segments[i].gear()) continue;
    if (std::abs(segments[i].curvature - end) * default_radius > 1e-6) ++jumps;
  }
  return jumps;
}

TEST(Refuges, LeaveAndJoinAPathWithoutAJumpOfTheCurvatureWhereTheVehicleRolls) {
  // Full lock to the left, the wheels turn over, and full lock to the right. The vehicle changes
  // gear and does the same backwards.
  const double lock = 1 / default_radius;
  const double rate = max_curvature_rate(Vehicle{});
  const Path path{{0, 0, 0},
                  {{lock, 6},
                   {lock, 2 * lock / rate, -rate},
                   {-lock, 6},
                   {lock, -6},
                   {lock, -2 * lock / rate, -rate},
                   {-lock, -6}}};
  const std::vector<MovingObstacle> afar = {
      {.outline = car, .trajectory = {{0, {90, 60, 0}}, {60, {-90, 60, 0}}}}};
  const Problem problem = with_moving(problem_of_path({.bounds = {-99, 99, -99, 99}}, path), afar);
  const Task task = task_of(problem, {}, Steering::continuous_between_stops);
  const PlanOptions options = complete(default_planner());
  in_time::Refuges refuges(task, search::cost_rule(options.cost), options);
  int detours = 0, changes = 0;
  constexpr int draws = 100;
  for (int draw = 0; draw < draws; ++draw) {
    const auto detour = refuges.draw({task.start, path.segments}, 0);
    if (!detour) continue;
    ++detours;
    EXPECT_EQ(jumps_while_rolling(detour->there), 0);
    EXPECT_EQ(jumps_while_rolling(detour->onward), 0);
    if (detour->there.front() == path.segments.front()) ++changes;
  }
  EXPECT_GT(detours, draws / 4);
  EXPECT_GT(changes, 0);  // some leave the path behind its beginning
}

TEST(Refuges, LeaveNoCrumbsWhereTheyLeaveAPathOrComeBack) {
  const double lock = 1 / default_radius;
  const double rate = max_curvature_rate(Vehicle{});
  const Path path{{0, 0, 0},
                  {{0, lock / rate, rate}, {lock, 0.02}, {lock, lock / rate, -rate}, {0, 50}}};
  const std::vector<MovingObstacle> afar = {
      {.outline = car, .trajectory = {{0, {90, 90, 0}}, {60, {-90, 90, 0}}}}};
  const Problem problem = with_moving(problem_of_path({.bounds = {-99, 99, -99, 99}}, path), afar);
  const Task task = task_of(problem, {}, Steering::continuous_between_stops);
  const PlanOptions options = complete(default_planner());
  in_time::Refuges refuges(task, search::cost_rule(options.cost), options);
  const auto crumbs = [](const std::vector<Segment>& segments) {
    return std::ranges::count_if(
        segments, [](const Segment& segment) { return std::abs(segment.length) < 0.05; });
  };
  std::ptrdiff_t before = 0, after = 0;
  for (int draw = 0; draw < 40; ++draw) {
    const auto detour = refuges.draw({task.start, path.segments}, 0);
    if (!detour) continue;
    std::vector<Segment> way = detour->there;
    way.insert(way.end(), detour->onward.begin(), detour->onward.end());
    const std::vector<Segment> tidied = refuges.tidied(way);
    before += crumbs(way);
    after += crumbs(tidied);
    const Pose end = end_pose({path.start, tidied});
    EXPECT_LT(std::hypot(end.x - problem.goal().x, end.y - problem.goal().y), 1e-6);
  }
  EXPECT_GT(before, 20);
  EXPECT_LT(after, before / 2);  // some cost too much to leave out
}

TEST(PlanInTime, GoesOnWithoutADriveUntilTheBudgetIsSpent) {
  // A wall comes along the road and over the lay-by.
  MovingObstacle wall = oncoming;
  wall.outline = box(-1, -9, 1, 9);
  PlanOptions options;
  options.budget.max_iterations = 12'000;
  const PlanResult result = plan(road_with_lay_by({wall}), options);
  EXPECT_EQ(result.status, PlanStatus::iteration_limit);
  EXPECT_EQ(result.iterations, 12'000);
}

TEST(PlanInTime, EndsWhereSomebodyComesToTheStartThatIsAGoalOfASet) {
  const MovingObstacle over_the_start{.outline = car,
                                      .trajectory = {{20, {-30, 0, 0}}, {60, {30, 0, 0}}},
                                      .after = Afterwards::leaves};
  const Problem problem =
      with_goal_set(street_among({over_the_start}), {region_of_pose({0, 0, 0})});
  PlanOptions options;
  options.budget.max_iterations = 1'000;
  const PlanResult result = plan(problem, options);
  EXPECT_EQ(result.status, PlanStatus::node_limit) << "no search is left";
  EXPECT_FALSE(result.path);
}

TEST(PlanInTime, LooksForDrivesThatWaitLittleFirst) {
  // Every 8 s a car crosses, for five minutes.
  std::vector<MovingObstacle> stream;
  for (int i = 0; i < 40; ++i) {
    MovingObstacle& car_of_stream = stream.emplace_back(crossing());
    for (TimedPose& row : car_of_stream.trajectory) row.t += 8 * i;
    car_of_stream.after = Afterwards::leaves;
    car_of_stream.trajectory.insert(car_of_stream.trajectory.begin(),
                                    {8.0 * i - 1.0, {15, -60, pi / 2}});
  }
  PlanOptions options;
  options.budget.max_iterations = 50;
  const PlanResult result = plan(street_among(stream), options);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LT(result.speeds->duration, 40);
}

TEST(PlanInTime, LooksForBetterTimesAlongAPathThatIsTheShortest) {
  const MovingObstacle shuttle{
      .outline = box(-3, -1.1, 3, 1.1),
      .trajectory = {{25, {25, 20, -pi / 2}}, {35, {25, -12, -pi / 2}}, {45, {25, 20, -pi / 2}}},
      .after = Afterwards::leaves};
  const Problem problem = street_among({shuttle});
  PlanOptions options;
  options.budget.max_iterations = 6'000;
  const PlanResult result = plan(problem, options);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  const moving::Yielding best = yielding({{0, 0, 0}, {{0, 40}}}, {shuttle});
  EXPECT_LE(result.cost + 2 * result.speeds->duration, 40 + 2 * best.speeds->duration + 1e-6);
}

TEST(PlanInTime, StaysWhereItIsIfThatIsTheGoal) {
  const Problem problem = problem_in({.bounds = wide_bounds}, {0, 0, 0}, {0, 0, 0});
  const PlanResult stays = plan(with_moving(problem, std::vector{crossing()}), few_iterations());
  EXPECT_EQ(stays.status, PlanStatus::solved) << stays.reason;
  EXPECT_EQ(stays.speeds->duration, 0);
  MovingObstacle over = crossing();
  for (TimedPose& row : over.trajectory) row.pose.x = 2;
  const PlanResult hit = plan(with_moving(problem, std::vector{over}), few_iterations());
  EXPECT_NE(hit.status, PlanStatus::solved);
  EXPECT_NE(hit.status, PlanStatus::rejected);
}

TEST(PlanInTime, OtherPlannersRefuse) {
  try {
    (void)plan(street_among({crossing()}), planner_named("rrt-opt-bound"), {});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "moving: is not honoured by rrt-opt-bound, expected one of the planners that honour "
              "it: anytime");
  }
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The default planner with a trailer: exact ends, paths that the judge accepts, the same again.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "lab/grown_tree.h"
#include "planners/commands/closer.h"
#include "planners/pricing.h"
#include "planners/towed.h"
#include "support/cases.h"
#include "support/draws.h"
#include "support/problems.h"
#include "vandplan/files.h"
#include "vandplan/judge.h"
#include "vandplan/motion.h"
#include "vandplan/planner.h"
#include "vandplan/steering.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using std::numbers::pi;

Scenario dock() { return dock_for(semitrailer()); }

PlanOptions with_iterations(int iterations, std::uint64_t seed = 1) {
  PlanOptions options;
  options.cost = shortest_style;
  options.budget = {.max_iterations = iterations, .seed = seed};
  return options;
}

TEST(RigPlanning, TheNumberOfThreadsDoesNotMatter) {
  PlanOptions options = with_iterations(cases(3000));
  options.cost = driver_style;
  const PlanResult one = plan(make_problem(dock()), options);
  options.budget.threads = 3;
  const PlanResult three = plan(make_problem(dock()), options);
  EXPECT_EQ(one.cost, three.cost);
  EXPECT_EQ(one.anytime.size(), three.anytime.size());
  ASSERT_EQ(one.path.has_value(), three.path.has_value());
  if (one.path) {
    EXPECT_EQ(one.path->segments, three.path->segments);
  }
}

TEST(RigPlanning, AKnownPathIsTheFirstOne) {
  const Problem problem = make_problem(dock());
  const PlanResult known = plan(problem, with_iterations(cases(3000)));
  if (is_sanitized && !known.path) return;
  Scenario moved = dock();
  moved.start.x += 0.2;
  const PlanResult warm =
      plan(make_problem(moved), warm_started(*known.path), with_iterations(cases(500)));
  ASSERT_FALSE(warm.anytime.empty());
  EXPECT_EQ(warm.anytime.front().iteration, 0);
  EXPECT_LT(warm.anytime.front().cost, 1.05 * known.cost);
}

/// Proposes one path in each step, and keeps what it hears.
class Yesterday final : public PathSource {
 public:
  Yesterday(LocalPath path, double& heard) : path_(std::move(path)), heard_(heard) {}
  [[nodiscard]] std::optional<LocalPath> propose() override { return path_; }
  [[nodiscard]] bool has_work() const override { return true; }
  void hear(const LocalPath&, double cost) override { heard_ = cost; }

 private:
  LocalPath path_;
  double& heard_;
};

TEST(RigPlanning, ASourceProposesPathsOfTheTractor) {
  const Problem problem = make_problem(dock());
  const PlanResult known = plan(problem, with_iterations(cases(3000)));
  if (is_sanitized && !known.path) return;
  double heard = 0;
  const LocalPath path{problem.task().start, known.path->segments};
  const Planner planner =
      with_sources({{.name = "yesterday", .make = [&](const auto&, const auto&) {
                       return std::make_unique<Yesterday>(path, heard);
                     }}});
  const PlanResult result = plan(problem, planner, with_iterations(300));
  ASSERT_TRUE(result.path);
  EXPECT_LE(result.cost, known.cost * (1 + 1e-9));
  EXPECT_GT(heard, 0);
}

TEST(RigPlanning, BacksIntoADock) {
  const PlanResult result = plan(make_problem(dock()), with_iterations(cases(3000)));
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(result.check->valid);
  EXPECT_LE(result.check->largest_hitch_angle, 1.2 + 1e-9);
  EXPECT_GT(result.check->reverse_length, 5);
  EXPECT_LE(result.lower_bound, result.cost);
  EXPECT_LT(result.cost, 120);
  EXPECT_LE(result.cost, result.anytime.front().cost);
}

TEST(RigPlanning, KeepsWhatTheLastIterationFinds) {
  const Problem problem = make_problem(dock());
  const PlanResult all = plan(problem, with_iterations(3000));
  ASSERT_EQ(all.status, PlanStatus::solved);
  const auto first = static_cast<int>(all.anytime.front().iteration);
  EXPECT_EQ(plan(problem, with_iterations(first)).status, PlanStatus::solved);
  EXPECT_EQ(plan(problem, with_iterations(first - 1)).status, PlanStatus::iteration_limit);
}

TEST(RigPlanning, RepeatsBitForBitAndDependsOnTheSeed) {
  const Problem problem = make_problem(dock());
  const PlanResult first = plan(problem, with_iterations(cases(1000), 3));
  const PlanResult again = plan(problem, with_iterations(cases(1000), 3));
  EXPECT_EQ(first.path, again.path);
  EXPECT_EQ(first.cost, again.cost);
}

class TreesWithATrailer : public testing::TestWithParam<std::string> {};

// Every tree of the thesis: on open ground with hitch angles at both ends, and past a wall.
TEST_P(TreesWithATrailer, ReachTheGoal) {
  Scenario scenario = dock();
  scenario.goal = {-10, 20, pi};
  scenario.hitch_angles = {0.3, -0.2};
  PlanOptions options = with_iterations(cases(400), 3);
  options.planner.set("keep_tree", true);
  const Planner planner = planner_named(GetParam());
  const PlanResult result = plan(make_problem(scenario), planner, options);
  EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(result.check->valid);
  EXPECT_GT(result.check->largest_hitch_angle, 0.29);
  EXPECT_GT(result.tree->poses.size(), 10u);
  EXPECT_NEAR(result.cost, length(*result.path), 1e-9);
  EXPECT_EQ(plan(make_problem(scenario), planner, options).path, result.path);
}

INSTANTIATE_TEST_SUITE_P(RigPlanning, TreesWithATrailer,
                         testing::Values("rrt-bsc-euc", "rrt-bsc-hlut-4", "rrt-bsc-rs-goal",
                                         "rrt-opt-euc-goal", "rrt-opt-hlut-4", "rrt-opt-bound"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::erase(name, '-');
                           return name;
                         });

// Two nodes at one pose: only their hitch angles say from which of them a state is near.
TEST(RigPlanning, TablesRankNodesByTheirHitchAngles) {
  const Scenario scenario = dock();
  const Problem problem = make_problem(scenario);
  const PlanOptions options = complete(planner_named("rrt-bsc-hlut-4"), {}, scenario.vehicle);
  const State bent{problem.task().start, 0.9};
  const State sample = advance(scenario.vehicle, bent, {0, 6});
  const auto nearest = [&](search::Estimate estimate) {
    planning::GrownTree tree(problem.task(), options, estimate, search::RankBy::length);
    (void)tree.add(bent, {0, 20.0});
    return tree.first(1, sample).front().id;
  };
  EXPECT_EQ(nearest(search::Estimate::euclid), 0);
  EXPECT_EQ(nearest(search::Estimate::hlut_1), 1);
  EXPECT_EQ(nearest(search::Estimate::hlut_4), 1);
}

// In reverse a trailer runs away from rounding: edges that are exact each by itself end elsewhere
// one after the other.
TEST(RigPlanning, TheWayThroughATreeIsExactAsAWhole) {
  const Vehicle vehicle = semitrailer();
  const double curvature = 0.03;
  State state{{0, 0, 0}, 0.1};
  for (int i = 0; i < 200; ++i)
    state.hitch_angle = hitch_angle_after(vehicle, state.hitch_angle, {curvature, 1});
  int kept = 0, refused = 0;
  Rng rng(1);
  for (int edges = 2; edges <= 40; edges += 2) {
    std::vector<State> states = {{{0, 0, 0}, state.hitch_angle}};
    for (int i = 0; i < edges; ++i) {
      states.push_back({advance(states.back().pose, {curvature, -7}),
                        state.hitch_angle + uniform(-0.05, 0.05, rng)});
    }
    SCOPED_TRACE(edges);
    const Problem problem =
        make_problem(world_of({.bounds = {-500, 500, -500, 500}}), vehicle, states.front().pose,
                     states.back().pose, {}, {state.hitch_angle, states.back().hitch_angle});
    const PlanOptions options = complete(planner_named("rrt-bsc-euc"), {}, vehicle);
    planning::GrownTree tree(problem.task(), options, search::Estimate::euclid,
                             search::RankBy::length);
    search::NodeId last = 0;
    for (int i = 1; i < edges; ++i) {
      const auto edge = tree.try_edge(last, states[static_cast<std::size_t>(i)]);
      ASSERT_TRUE(edge);
      last = tree.add(states[static_cast<std::size_t>(i)], *edge);
    }
    const auto to_goal = tree.try_edge(last, tree.goal());
    ASSERT_TRUE(to_goal);
    if (!tree.keep_way(*to_goal)) {
      ++refused;
      continue;
    }
    ++kept;
    PlannerAnswer answer;
    tree.report(options, *to_goal, PlanStatus::node_limit, answer);
    const PathCheck check = check_path(problem, {problem.start(), *answer.segments}, {});
    EXPECT_TRUE(check.valid) << edges << " edges: " << check.reason;
  }
  EXPECT_GT(kept, 3);
  EXPECT_GT(refused, 0);
}

// A post where the trailer cuts the corner that its tractor drives round: no edge leads there.
TEST(RigPlanning, TreesCheckTheTrailer) {
  Scenario scenario = dock();
  scenario.start = {-30, 35, 0};
  scenario.goal = {-8, 20, -pi / 2};
  PlanOptions options = with_iterations(60);
  options.planner.set("goal_bias", 0.5);
  const Planner planner = planner_named("rrt-opt-hlut-4");
  const PlanResult free = plan(make_problem(scenario), planner, options);
  ASSERT_EQ(free.status, PlanStatus::solved);
  int tried = 0;
  State state{scenario.start, 0.0};
  for (const Segment& segment : free.path->segments) {
    for (double driven = 0.25; driven < std::abs(segment.length); driven += 0.25) {
      const Pose axle = trailer_pose(
          scenario.vehicle, advance(scenario.vehicle, state, part_of(segment, 0.0, driven)));
      Scenario blocked = scenario;
      blocked.obstacles.push_back({{axle.x - 0.1, axle.y - 0.1},
                                   {axle.x + 0.1, axle.y - 0.1},
                                   {axle.x + 0.1, axle.y + 0.1},
                                   {axle.x - 0.1, axle.y + 0.1}});
      Scenario alone = blocked;
      alone.vehicle.trailer.reset();
      if (!check_path(make_problem(alone), *free.path, {}).valid) continue;
      ++tried;
      EXPECT_NE(plan(make_problem(blocked), planner, options).status, PlanStatus::rejected);
    }
    state = advance(scenario.vehicle, state, segment);
  }
  EXPECT_GT(tried, 0);
}

TEST(RigPlanning, KeepsAMarginWithBothBodies) {
  PlanOptions options = with_iterations(cases(4000));
  options.clearance.margin = 0.4;
  const PlanResult result = plan(make_problem(dock()), options);
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_GE(*result.check->clearance, 0.4 - 1e-6);
}

TEST(RigPlanning, HitchAnglesAtTheEndsAreMet) {
  Scenario scenario = dock();
  scenario.obstacles.clear();
  scenario.start = {0, 20, 0};
  scenario.goal = {25, 25, 0.5};
  scenario.hitch_angles = {0.4, -0.3};
  const PlanResult result = plan(make_problem(scenario), with_iterations(cases(3000)));
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  State state{scenario.start, 0.4};
  for (const Segment& segment : result.path->segments) {
    state = advance(scenario.vehicle, state, segment);
  }
  EXPECT_NEAR(state.hitch_angle, -0.3, 1e-8);
  EXPECT_NEAR(state.pose.x, 25, 1e-8);
  EXPECT_NEAR(state.pose.heading, 0.5, 1e-8);
}

TEST(RigPlanning, AStartWhoseTrailerTouchesIsNamed) {
  Scenario scenario = dock();
  scenario.obstacles.push_back({{-27, 30}, {-26, 30}, {-26, 31}, {-27, 31}});
  const PlanResult result = plan(make_problem(scenario), with_iterations(10));
  EXPECT_EQ(result.status, PlanStatus::start_in_collision);
  EXPECT_EQ(result.reason, "the trailer's footprint hits obstacles[3]");
}

TEST(RigPlanning, ProvesThatNoTrailerGetsOutOfACage) {
  // The wall's opening lets the tractor through, and the wider trailer not.
  Scenario scenario = dock();
  scenario.vehicle.trailer->width = 3.2;
  scenario.start = {-15, 20, 0};
  scenario.goal = {25, 20, 0};
  scenario.obstacles = {{{9, -50}, {10, -50}, {10, 18.6}, {9, 18.6}},
                        {{9, 21.5}, {10, 21.5}, {10, 90}, {9, 90}}};
  const PlanResult none = plan(make_problem(scenario), with_iterations(100000));
  EXPECT_EQ(none.status, PlanStatus::no_path);
  EXPECT_EQ(none.reason, "proven: nothing as wide as the trailer gets from the start to the goal");
  scenario.vehicle.width = 3.1;
  const PlanResult neither = plan(make_problem(scenario), with_iterations(100000));
  EXPECT_EQ(neither.status, PlanStatus::no_path);
  EXPECT_EQ(neither.reason,
            "proven: nothing as wide as the vehicle gets from the start to the goal");
}

TEST(RigPlanning, TheBoundIsThatOfTheTrailerWhereItIsTheDearer) {
  // The trailer has to turn round, the tractor next to nothing.
  Scenario scenario = dock();
  scenario.obstacles.clear();
  scenario.vehicle.max_hitch_angle = 1.0;
  scenario.start = {0, 20, 0};
  scenario.hitch_angles = {-1.0, 1.0};
  scenario.goal = {2, 20, 0};
  const Problem problem = make_problem(scenario);
  const Task& task = problem.task();
  const double bound = planning::cost_lower_bound(task, {});
  EXPECT_GT(bound, 2 * reeds_shepp_length(scenario.start, scenario.goal, 5.9));
  const PlanResult result = plan(problem, with_iterations(cases(4000)));
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_GE(result.lower_bound, 0.999 * bound);
  EXPECT_GE(result.cost, bound);
}

// What is proven is never above what a drive costs: random drives, with prices, of rigs with
// hitches ahead of the rear axle and behind it.
TEST(RigBoundLaw, NoDriveCostsLess) {
  for_each_case(1, 2000, [&](Rng& rng) {
    Scenario scenario{.name = "any", .vehicle = semitrailer(), .bounds = {-500, 500, -500, 500}};
    Vehicle& vehicle = scenario.vehicle;
    vehicle.hitch = uniform(-2, 1, rng);
    vehicle.trailer->wheelbase = uniform(3, 9, rng);
    vehicle.max_hitch_angle = uniform(0.5, 1.4, rng);
    State state{{0, 0, 0}, uniform(-1, 1, rng) * vehicle.max_hitch_angle};
    scenario.hitch_angles.start = state.hitch_angle;
    std::vector<Segment> segments;
    for (int i = 0; i < 6; ++i) {
      const Segment segment{uniform(-1, 1, rng) / 5.9, any_sign(uniform(0.1, 8, rng), rng)};
      if (largest_hitch_angle(vehicle, state.hitch_angle, segment) > vehicle.max_hitch_angle)
        continue;
      segments.push_back(segment);
      state = advance(vehicle, state, segment);
    }
    scenario.goal = state.pose;
    scenario.hitch_angles.goal = state.hitch_angle;
    search::CostRule rule;
    rule.reverse_weight = uniform(1, 4, rng);
    rule.gear_change_cost = uniform(0, 5, rng);
    search::Driven driven;
    const double cost = search::drive_cost(rule, segments, driven);
    EXPECT_LE(planning::cost_lower_bound(make_problem(scenario).task(), rule), cost + 1e-9);
  });
}

TEST(RigBound, KnowsThatATrailerMayGoFartherThanItsTractor) {
  Scenario scenario{.name = "swing", .vehicle = semitrailer(), .bounds = {-50, 50, -50, 50}};
  Vehicle& vehicle = scenario.vehicle;
  vehicle.min_turning_radius = 3;
  vehicle.hitch = -2;
  vehicle.trailer->wheelbase = 4;
  vehicle.max_hitch_angle = 0.9;
  const Segment arc{1.0 / 3, 0.3};
  const State from{{0, 0, 0}, std::atan(2.0 / 3)};
  const State to = advance(vehicle, from, arc);
  scenario.goal = to.pose;
  scenario.hitch_angles = {from.hitch_angle, to.hitch_angle};
  const Problem problem = make_problem(scenario);
  const Task& task = problem.task();
  EXPECT_LE(planning::cost_lower_bound(task, {}), arc.length + 1e-12);
  EXPECT_GT(planning::cost_lower_bound(task, {}), 0.95 * arc.length);
}

TEST(RigPlanning, WhereTheCostIsTheTimeDrivesAreFaster) {
  PlanOptions options = with_iterations(is_sanitized ? 200 : 4000);
  options.cost = driver_style;
  options.steering = Steering::continuous_between_stops;
  const PlanResult by_prices = plan(make_problem(dock()), options);
  options.cost = {.measure = CostMeasure::time};
  const PlanResult by_time = plan(make_problem(dock()), options);
  if (is_sanitized) return;
  ASSERT_EQ(by_prices.status, PlanStatus::solved) << by_prices.reason;
  ASSERT_EQ(by_time.status, PlanStatus::solved) << by_time.reason;
  EXPECT_LT(by_time.cost, 0.95 * speed_profile(*by_prices.path, semitrailer()).duration);
}

TEST(RigPlanning, WheelsThatTurnSlowlyAreTriedWhereTheCostIsTheTime) {
  PlanOptions options = with_iterations(is_sanitized ? 200 : 6000);
  options.cost.measure = CostMeasure::time;
  Scenario scenario = dock();
  const PlanResult result = plan(make_problem(scenario), options);
  scenario.vehicle.limits.max_curvature_rate = 0.5 * max_curvature_rate(scenario.vehicle);
  const PlanResult slow_wheels = plan(make_problem(scenario), options);
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  ASSERT_EQ(slow_wheels.status, PlanStatus::solved) << slow_wheels.reason;
  EXPECT_LT(result.cost, 1.03 * slow_wheels.cost);
}

TEST(RigPlanning, SteersBetweenStopsWhereTheCostIsTheTime) {
  PlanOptions options;
  EXPECT_EQ(complete(default_planner(), options, semitrailer()).steering, Steering::reeds_shepp);
  options.cost.measure = CostMeasure::time;
  EXPECT_EQ(complete(default_planner(), options, semitrailer()).steering,
            Steering::continuous_between_stops);
  options.steering = Steering::reeds_shepp;
  EXPECT_EQ(complete(default_planner(), options, semitrailer()).steering, Steering::reeds_shepp);
}

// No drive takes less time than is proven, whatever its path, limits and gears are.
TEST(RigBoundLaw, NoDriveTakesLess) {
  for_each_case(2, 1000, [&](Rng& rng) {
    Scenario scenario{.name = "any", .vehicle = semitrailer(), .bounds = {-500, 500, -500, 500}};
    Vehicle& vehicle = scenario.vehicle;
    vehicle.hitch = uniform(-2, 1, rng);
    vehicle.max_hitch_angle = uniform(0.5, 1.4, rng);
    vehicle.limits.max_speed = {uniform(0.5, 9, rng), uniform(0.5, 9, rng)};
    vehicle.limits.max_acceleration = uniform(0.3, 3, rng);
    if (uniform01(rng) < 0.5) vehicle.limits.max_braking = uniform(0.3, 5, rng);
    State state{{0, 0, 0}, uniform(-1, 1, rng) * vehicle.max_hitch_angle};
    scenario.hitch_angles.start = state.hitch_angle;
    std::vector<Segment> segments;
    for (std::uint64_t i = 0, n = 1 + rng() % 4; i < n; ++i) {
      const double sharpest = rng() % 2 == 0 ? 0.0 : 1 / 5.9;
      const Segment segment{uniform(-1, 1, rng) * sharpest, any_sign(uniform(0.1, 20, rng), rng)};
      if (largest_hitch_angle(vehicle, state.hitch_angle, segment) > vehicle.max_hitch_angle)
        continue;
      segments.push_back(segment);
      state = advance(vehicle, state, segment);
    }
    scenario.goal = state.pose;
    scenario.hitch_angles.goal = state.hitch_angle;
    const Problem problem = make_problem(scenario);
    CostOptions time = shortest_style;
    time.measure = CostMeasure::time;
    const double duration = speed_profile({{0, 0, 0}, segments}, vehicle).duration;
    const planning::Pricing seconds(problem.task(), time);
    EXPECT_LE(planning::cost_lower_bound(problem.task(), seconds), duration + 1e-6);
    EXPECT_EQ(seconds.cost(segments, 0), duration);
    const planning::Pricing both(problem.task(), shortest_style, 2.0);
    EXPECT_LE(planning::cost_lower_bound(problem.task(), both), both.cost(segments, 0) + 1e-6);
    EXPECT_NEAR(both.cost(segments, 0), length(segments) + 2 * duration, 1e-9);
  });
}

/// The shortest stroke before or after a gear change [m].
double shortest_stroke(std::span<const Segment> segments) {
  std::vector<double> strokes(1);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (i > 0 && segments[i].length * segments[i - 1].length < 0) strokes.push_back(0);
    strokes.back() += std::abs(segments[i].length);
  }
  return *std::ranges::min_element(strokes);
}

TEST(RigPlanning, StrokesAreAsLongAsIsAskedFor) {
  int short_ones = 0;  // without being asked
  for (const Pose& goal : {Pose{0, 3, 0}, Pose{-3, 2, 0.3}, Pose{0, 5, 0.5}}) {
    const Problem problem = problem_of({0, 0, 0}, goal, {}, wide_bounds, semitrailer());
    for (const Steering steering : {Steering::reeds_shepp, Steering::continuous}) {
      PlanOptions options = with_iterations(is_sanitized ? 200 : 2000);
      options.steering = steering;
      const PlanResult as_is = plan(problem, options);
      options.planner.set("min_stroke", 6.0);
      const PlanResult result = plan(problem, options);
      if (is_sanitized) return;
      ASSERT_EQ(as_is.status, PlanStatus::solved) << as_is.reason;
      ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
      short_ones += shortest_stroke(as_is.path->segments) < 6 ? 1 : 0;
      EXPECT_GE(shortest_stroke(result.path->segments), 6 - 1e-9);
      EXPECT_LT(result.cost, as_is.cost + 20);
    }
  }
  EXPECT_GE(short_ones, 3);
}

TEST(RigPlanning, WithPricesBothBodiesStayAway) {
  PlanOptions options = with_iterations(is_sanitized ? 200 : 8000);
  options.cost = driver_style;
  const PlanResult result = plan(make_problem(dock()), options);
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(result.check->valid);
}

Polygon rectangle_of(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

Vehicle drawbar() {
  Vehicle vehicle{4.5, 1.4, 1.6, 2.55, 7.0};
  vehicle.hitch = -1.6;
  vehicle.max_hitch_angle = 0.9;
  vehicle.trailer = Trailer{5.8, -1.0, 3.6, 2.55};
  return vehicle;
}

TEST(RigPlanning, DrivesForwardOnOpenGroundWhereThatIsCheaper) {
  Scenario scenario{.vehicle = drawbar(), .bounds = {-60, 60, -60, 60}};
  scenario.goal = tractor_pose(scenario.vehicle, {-20, 15, 3.0}, 0.0);
  scenario.hitch_angles.start = 0.8;
  PlanOptions options = with_iterations(cases(12000));
  options.cost = driver_style;
  options.steering = Steering::reeds_shepp;
  const PlanResult result = plan(make_problem(scenario), options);
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LT(result.cost, 56.1);
}

// A drive that backs up by a metre or three is found sooner, and no search among both gears leads
// away from it.
TEST(RigPlanning, DrivesAroundWhereBackingUpIsDear) {
  const auto expect_around = [](const Scenario& yard, double reverse_weight, double enough,
                                int iterations = 10000) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      PlanOptions options = with_iterations(is_sanitized ? 100 : iterations, seed);
      options.cost = driver_style;
      options.cost.reverse_weight = reverse_weight;
      options.steering = Steering::reeds_shepp;
      const PlanResult result = plan(make_problem(yard), options);
      ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
      if (is_sanitized) continue;
      EXPECT_LT(result.cost, enough) << seed;
    }
  };
  Scenario wide{.vehicle = drawbar(), .bounds = {-40, 40, -40, 40}};
  wide.start = {-8.59, 0.57, 2.81};
  wide.goal = {9.51, 12.53, -1.886};
  wide.obstacles = {{{-2.54, -17.27}, {2.47, -21.41}, {4.19, -19.33}, {-0.83, -15.19}},
                    {{-30.06, 7.65}, {-29.84, 5.59}, {-25.01, 6.11}, {-25.23, 8.17}},
                    {{26.13, -24.3}, {28.56, -24.2}, {28.51, -23.1}, {26.08, -23.2}},
                    {{8.79, -27.62}, {13.33, -30.68}, {16.74, -25.64}, {12.2, -22.57}},
                    {{18.2, 27.21}, {14.03, 36.43}, {11.29, 35.19}, {15.47, 25.97}}};
  expect_around(wide, 33.7, 76);
  Scenario narrow{.vehicle = vehicle_named("car-caravan"), .bounds = {-27, 53, -51, 29}};
  narrow.start = {-0.047616, 0.296107, -0.596035};
  narrow.goal = {3.238909, 0.406755, -2.996121};
  narrow.hitch_angles = {-0.549476, -0.358251};
  narrow.obstacles = {{{-6.52, 13.06}, {1.89, 5.75}, {5.14, 9.49}, {-3.27, 16.8}},
                      {{15.53, 0.45}, {19.98, 8.33}, {17.79, 9.57}, {13.34, 1.69}}};
  expect_around(narrow, 123.2662, 110);
  // Backing up by 6 m costs 64.3 m.
  Scenario open{.vehicle = semitrailer(), .bounds = {-60, 60, -60, 60}};
  open.goal = {6, 6, pi / 2};
  expect_around(open, 5, 57.5, 80000);
}

// Prices decide what is cheap, and not whether and when there is a path.
TEST(RigPlanning, TheFirstPathComesAsSoonUnderAnyPrices) {
  Scenario scenario{.vehicle = semitrailer(), .bounds = {-60, 60, -2, 14}};
  scenario.start = {14, 5, 0};
  scenario.goal = {3.2, 0, 0};
  scenario.obstacles = {rectangle_of(-60, -2.6, 60, -1.6), rectangle_of(-60, 11, 60, 12),
                        rectangle_of(-27.24, -1.275, -10.84, 1.275),
                        rectangle_of(10.84, -1.275, 27.24, 1.275)};
  const Problem problem = make_problem(scenario);
  std::vector<std::int64_t> first;
  for (const CostOptions& cost :
       {driver_style, shortest_style, CostOptions{.reverse_weight = 1000.0}}) {
    PlanOptions options = with_iterations(is_sanitized ? 100 : 20000);
    options.cost = cost;
    options.steering = Steering::reeds_shepp;
    const PlanResult result = plan(problem, options);
    if (is_sanitized) return;
    ASSERT_EQ(result.status, PlanStatus::solved) << *cost.reverse_weight;
    first.push_back(result.anytime.front().iteration);
  }
  EXPECT_EQ(first[1], first[0]);
  EXPECT_EQ(first[2], first[0]);
}

// Blocks of 70 m with streets of 14 m between them: the tractor's way leads through.
TEST(RigPlanning, FollowsItsTractorOverAWholeSite) {
  Scenario scenario{.vehicle = semitrailer(), .bounds = {-30, 900, -30, 900}};
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) {
      const double x = 84.0 * i + 7, y = 84.0 * j + 7;
      scenario.obstacles.push_back(rectangle_of(x, y, x + 70, y + 70));
    }
  }
  scenario.start = {42, 0, 0};
  scenario.goal = {588, 714, pi / 2};
  PlanOptions options = with_iterations(is_sanitized ? 100 : 2500);
  options.cost = driver_style;
  options.steering = Steering::reeds_shepp;
  const PlanResult result = plan(make_problem(scenario), options);
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LT(result.check->reverse_length, 30);
}

// ---- Closing a gap ----

/// From a state along commands to where they lead.
bool closes(const State& from, std::vector<commands::Command> commands) {
  const Vehicle vehicle = semitrailer();
  State end = from;
  for (const auto& command : commands) end = advance(vehicle, end, command.at_once());
  return commands::Closer(vehicle).close(from, commands, end);
}

TEST(Closer, RefusesWhatRoundingWouldBend) {
  const double wheelbase = semitrailer().trailer->wheelbase;
  // In reverse a change grows by e in each length of the trailer, forward it vanishes.
  const double angle = 1e-6;
  EXPECT_TRUE(closes({{}, angle}, {{0, -9 * wheelbase}}));
  EXPECT_FALSE(closes({{}, angle}, {{0, -10 * wheelbase}}));
  EXPECT_FALSE(closes({{}, angle}, {{0, -10 * wheelbase}, {0, 20 * wheelbase}}));
  EXPECT_TRUE(closes({{}, angle}, {{0, 20 * wheelbase}, {0, -9 * wheelbase}}));
  EXPECT_FALSE(closes({{}, angle}, {{0, 20 * wheelbase}, {0, -10 * wheelbase}}));
  // Exactly straight it stays.
  EXPECT_TRUE(closes({}, {{0, -20 * wheelbase}}));
  EXPECT_FALSE(closes({}, {{1e-3, 1}, {0, -10 * wheelbase}}));
}

TEST(CloserLaw, ADriveIsBentUntilItEndsThere) {
  int closed = 0;
  int tried = 0;
  for_each_case(1, 300, [&](Rng& rng) {
    const Vehicle vehicle = semitrailer();
    commands::Closer closer(vehicle);
    std::vector<commands::Command> commands;
    State end{{0, 0, 0}, uniform(-0.3, 0.3, rng)};
    const State start = end;
    double largest = 0;
    for (int i = 0; i < 8; ++i) {
      commands.push_back({uniform(-0.13, 0.13, rng), any_sign(uniform(1, 5, rng), rng)});
      const Segment segment = commands.back().at_once();
      largest = std::max(largest, largest_hitch_angle(vehicle, end.hitch_angle, segment));
      end = advance(vehicle, end, segment);
    }
    if (largest > 0.9) return;
    ++tried;
    end.pose.x += uniform(-0.5, 0.5, rng);
    end.pose.y += uniform(-0.5, 0.5, rng);
    end.pose.heading += uniform(-0.1, 0.1, rng);
    end.hitch_angle += uniform(-0.1, 0.1, rng);
    if (!closer.close(start, commands, end)) return;
    ++closed;
    State state = start;
    for (const commands::Command& command : commands) {
      const Segment segment = command.at_once();
      EXPECT_LE(std::abs(segment.curvature), 1 / 5.9);
      EXPECT_LE(largest_hitch_angle(vehicle, state.hitch_angle, segment), 1.2);
      state = advance(vehicle, state, segment);
    }
    EXPECT_NEAR(state.pose.x, end.pose.x, 1e-9);
    EXPECT_NEAR(state.pose.y, end.pose.y, 1e-9);
    EXPECT_NEAR(std::remainder(state.pose.heading - end.pose.heading, 2 * pi), 0, 1e-9);
    EXPECT_NEAR(state.hitch_angle, end.hitch_angle, 1e-9);
  });
  if (!is_sanitized) {  // a few say nothing of a share
    EXPECT_GE(closed, 0.85 * tried);
  }
}

}  // namespace
}  // namespace vandplan

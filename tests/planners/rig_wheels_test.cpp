// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Drives of rigs whose wheels turn no faster than they can: chains of commands, their closing, and
// what the default planner makes of them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "planners/commands/closer.h"
#include "planners/commands/wheels.h"
#include "support/cases.h"
#include "support/continuity.h"
#include "support/draws.h"
#include "support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using commands::Command;
using search::Driven;

using std::numbers::pi;
constexpr std::array kinds_for_rigs = {Steering::continuous_between_stops, Steering::continuous};

Vehicle towing_vehicle() {
  Vehicle vehicle{3.6, 1.4, 0.9, 2.55, 5.9};
  vehicle.hitch = 0.6;
  vehicle.trailer = Trailer{7.7, 1.6, 4.3, 2.55};
  return vehicle;
}

/// Wheels that may be anywhere before `continuous` drives, and may jump before others.
search::DrivenBeside ends_for(Steering steering, double before, double after = Driven::any) {
  if (steering == Steering::continuous_between_stops) return {};
  return {{0, before}, {0, after}};
}

std::vector<Command> any_commands(int count, Rng& rng) {
  std::vector<Command> commands;
  for (int i = 0; i < count; ++i) {
    commands.push_back({uniform(-1, 1, rng) / 5.9, any_sign(uniform(0.2, 5, rng), rng)});
  }
  return commands;
}

State end_of(const Vehicle& vehicle, State state, const std::vector<Segment>& segments) {
  for (const Segment& segment : segments) state = advance(vehicle, state, segment);
  return state;
}

double largest_angle(const Vehicle& vehicle, State state, const std::vector<Segment>& segments) {
  double largest = std::abs(state.hitch_angle);
  for (const Segment& segment : segments) {
    largest = std::max(largest, largest_hitch_angle(vehicle, state.hitch_angle, segment));
    state = advance(vehicle, state, segment);
  }
  return largest;
}

/// The problem of a drive on open ground.
Problem problem_along(const Vehicle& vehicle, const State& from, const State& to,
                      const EndCurvatures& curvatures = {}) {
  return make_problem(world_of({.bounds = {-500, 500, -500, 500}}), vehicle, from.pose, to.pose,
                      curvatures, {from.hitch_angle, to.hitch_angle});
}

// ---- Chains of commands ----

TEST(RigWheelsLaw, EveryChainOfCommandsIsAContinuousDrive) {
  const Vehicle vehicle = towing_vehicle();
  for_each_case(1, 2000, [&](Rng& rng) {
    for (const Steering steering : kinds_for_rigs) {
      const commands::Wheels wheels(vehicle, steering);
      const double first = uniform(-1, 1, rng) / 5.9;
      const std::vector<Command> commands = any_commands(6, rng);
      const Driven before = ends_for(steering, first).before;
      const std::vector<Segment> driven = wheels.driven(commands, before);
      const double last = search::last_driven(driven.back()).curvature;
      const Problem problem = problem_along(vehicle, {}, {{1, 0, 0}, 0.0},
                                            {first, std::clamp(last, -1 / 5.9, 1 / 5.9)});
      expect_continuous({{}, driven}, problem, steering);
      const std::vector<Segment> at_once =
          commands::Wheels(vehicle, Steering::reeds_shepp).driven(commands, {});
      EXPECT_NEAR(length(driven), length(at_once), 1e-9);
      EXPECT_EQ(gear_changes(driven), gear_changes(at_once));
    }
  });
}

// What is driven is led along by its own commands, and by tidy ones.
TEST(RigWheelsLaw, CommandsLeadAlongWhatIsDriven) {
  const Vehicle vehicle = towing_vehicle();
  for_each_case(2, 2000, [&](Rng& rng) {
    for (const Steering steering : kinds_for_rigs) {
      const commands::Wheels wheels(vehicle, steering);
      const search::DrivenBeside ends = ends_for(steering, uniform(-1, 1, rng) / 5.9);
      const std::vector<Command> commands = any_commands(6, rng);
      const std::vector<Segment> driven = wheels.driven(commands, ends.before);
      const Pose end = end_pose({{}, driven});
      for (const auto& chain :
           {wheels.commands(driven, ends), wheels.tidied(commands, ends.before)}) {
        EXPECT_LE(chain.size(), commands.size());
        const Pose there = end_pose({{}, wheels.driven(chain, ends.before)});
        EXPECT_NEAR(there.x, end.x, 1e-7);
        EXPECT_NEAR(there.y, end.y, 1e-7);
      }
    }
  });
}

// Half of what it takes to turn the wheels is driven before a jump: the drive stays beside the
// arcs.
TEST(RigWheels, LeadAlongArcsWhoseCurvatureJumps) {
  const std::vector<Segment> arcs = {{0, 8}, {0.1, 6}, {-0.1, 7}};
  const std::vector<Segment> back = {{0, 8}, {0.05, 6}, {-0.1, -7}};
  for (const Steering steering : kinds_for_rigs) {
    const commands::Wheels wheels(towing_vehicle(), steering);
    const search::DrivenBeside ends = ends_for(steering, 0.0);
    const Pose rolled = end_pose({{}, wheels.driven(wheels.commands(arcs, ends), ends.before)});
    EXPECT_NEAR(rolled.x, end_pose({{}, arcs}).x, 0.05);
    EXPECT_NEAR(rolled.y, end_pose({{}, arcs}).y, 0.05);
    const Pose backed = end_pose({{}, wheels.driven(wheels.commands(back, ends), ends.before)});
    EXPECT_NEAR(backed.x, end_pose({{}, back}).x, 0.3);
    EXPECT_NEAR(backed.y, end_pose({{}, back}).y, 0.3);
  }
}

// A stroke that closing a chain left next to nothing of is none, or the wheels would turn there
// that do not once it is left out.
TEST(RigWheels, DoNotTurnAtAStrokeOfAHairsBreadth) {
  const commands::Wheels wheels(towing_vehicle(), Steering::continuous_between_stops);
  const std::vector<Command> with = {{0.1, -4}, {-0.1, 1e-12}, {-0.1, -3}};
  const std::vector<Command> without = {{0.1, -4}, {-0.1, -3}};
  EXPECT_EQ(wheels.driven(with, {}), wheels.driven(without, {}));
  EXPECT_EQ(wheels.driven(wheels.tidied(with, {}), {}), wheels.driven(with, {}));
}

TEST(RigWheels, AreFreeForArcsAndLines) {
  const commands::Wheels wheels(towing_vehicle(), Steering::reeds_shepp);
  const std::vector<Segment> arcs = {{0.1, 4}, {-0.1, 3}, {0.1, -2}};
  EXPECT_EQ(wheels.driven(wheels.commands(arcs, {}), {}), arcs);
  EXPECT_EQ(wheels.commands(arcs, {}), (std::vector<Command>{{0.1, 4}, {-0.1, 3}, {0.1, -2}}));
}

// ---- Closing a gap ----

class ContinuousCloser : public testing::TestWithParam<Steering> {};

TEST_P(ContinuousCloser, BendsADriveUntilItEndsThere) {
  const Steering steering = GetParam();
  const Vehicle vehicle = towing_vehicle();
  const commands::Wheels wheels(vehicle, steering);
  commands::Closer closer(vehicle, steering);
  int closed = 0, tried = 0;
  for_each_case(1, 400, [&](Rng& rng) {
    const State start{{0, 0, 0}, uniform(-0.3, 0.3, rng)};
    std::vector<Command> commands = any_commands(8, rng);
    const double last = commands.back().curvature;
    const search::DrivenBeside ends = ends_for(steering, uniform(-1, 1, rng) / 5.9, last);
    const std::vector<Segment> first = wheels.driven(commands, ends.before);
    if (largest_angle(vehicle, start, first) > 0.9) return;
    ++tried;
    State end = end_of(vehicle, start, first);
    end.pose.x += uniform(-0.5, 0.5, rng);
    end.pose.y += uniform(-0.5, 0.5, rng);
    end.pose.heading += uniform(-0.1, 0.1, rng);
    end.hitch_angle += uniform(-0.1, 0.1, rng);
    if (!closer.close(start, commands, end, ends)) return;
    ++closed;
    const std::vector<Segment> driven = wheels.driven(commands, ends.before);
    for (const Command& command : commands) EXPECT_LE(std::abs(command.curvature), 1 / 5.9);
    EXPECT_LE(largest_angle(vehicle, start, driven), 1.2);
    const State there = end_of(vehicle, start, driven);
    EXPECT_NEAR(there.pose.x, end.pose.x, 1e-9);
    EXPECT_NEAR(there.pose.y, end.pose.y, 1e-9);
    EXPECT_NEAR(std::remainder(there.pose.heading - end.pose.heading, 2 * pi), 0, 1e-9);
    EXPECT_NEAR(there.hitch_angle, end.hitch_angle, 1e-9);
    expect_continuous({{}, driven},
                      problem_along(vehicle, start, {{1, 0, 0}, 0.0},
                                    {ends.after.is_known() ? ends.before.curvature : 0.0,
                                     ends.after.is_known() ? ends.after.curvature : 0.0}),
                      steering);
  });
  RecordProperty("closed", closed);
  RecordProperty("tried", tried);
  if (!is_sanitized) {  // a few say nothing of a share
    EXPECT_GE(closed, 0.78 * tried) << closed << " of " << tried;
  }
}

std::string kind_name(const testing::TestParamInfo<Steering>& info) {
  return info.param == Steering::continuous ? "throughout" : "between_stops";
}

INSTANTIATE_TEST_SUITE_P(RigWheels, ContinuousCloser, testing::ValuesIn(kinds_for_rigs), kind_name);

// The trailer goes on folding up while the wheels turn back, and unfolds then.
TEST(RigWheels, ACloserHoldsTheHitchAngleInsideOfAClothoid) {
  const Vehicle vehicle = towing_vehicle();
  const commands::Wheels wheels(vehicle, Steering::continuous);
  commands::Closer closer(vehicle, Steering::continuous);
  const search::DrivenBeside ends{{1, 1 / 5.9}, {}};
  for (const double angle : {1.15, 1.198}) {
    const State start{{0, 0, 0}, angle};
    std::vector<Command> commands = {{-1 / 5.9, 6}};
    const std::vector<Segment> driven = wheels.driven(commands, ends.before);
    const State end = end_of(vehicle, start, driven);
    ASSERT_LT(end.hitch_angle, angle);
    const bool is_held = largest_angle(vehicle, start, driven) <= vehicle.max_hitch_angle;
    EXPECT_EQ(is_held, angle < 1.19);
    EXPECT_EQ(closer.close(start, commands, end, ends), is_held);
  }
}

// ---- Planning ----

class ContinuousRigs : public testing::TestWithParam<Steering> {};

PlanOptions steered(Steering steering, int iterations) {
  PlanOptions options;
  options.cost = driver_style;
  options.steering = steering;
  options.budget = {.max_iterations = iterations, .seed = 1};
  return options;
}

/// Expects all that is promised of a drive.
void expect_drive(const Problem& problem, const PlanResult& result, Steering steering) {
  EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
  if (!result.path) return;
  EXPECT_TRUE(result.check->valid);
  EXPECT_LE(result.lower_bound, result.cost);
  expect_continuous(*result.path, problem, steering);
  const Vehicle& vehicle = problem.vehicle();
  const State from{problem.start(), problem.hitch_angles().start};
  EXPECT_LE(largest_angle(vehicle, from, result.path->segments), vehicle.max_hitch_angle + 1e-12);
  const State end = end_of(vehicle, from, result.path->segments);
  EXPECT_NEAR(end.pose.x, problem.goal().x, 1e-9);
  EXPECT_NEAR(end.pose.y, problem.goal().y, 1e-9);
  EXPECT_NEAR(std::remainder(end.pose.heading - problem.goal().heading, 2 * pi), 0, 1e-9);
  EXPECT_NEAR(end.hitch_angle, problem.hitch_angles().goal, 1e-9);
}

TEST_P(ContinuousRigs, BackIntoADock) {
  const Problem problem = make_problem(dock_for(towing_vehicle()));
  PlanOptions options = steered(GetParam(), cases(2000));
  const PlanResult result = plan(problem, options);
  expect_drive(problem, result, GetParam());
  options.budget.threads = 3;
  EXPECT_EQ(plan(problem, options).path, result.path);
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_GT(result.check->reverse_length, 5);
  EXPECT_LT(result.cost, result.anytime.front().cost);
}

// Open ground, any hitch angles; throughout also wheels that are turned at both ends.
TEST_P(ContinuousRigs, GetFromAnyStateToAnyOther) {
  int solved = 0, tried = 0;
  for_each_case(3, 20, [&](Rng& rng) {
    const auto any_state = [&] {
      return State{{uniform(-20, 20, rng), uniform(-20, 20, rng), uniform(-pi, pi, rng)},
                   uniform(-0.8, 0.8, rng)};
    };
    EndCurvatures curvatures;
    if (GetParam() == Steering::continuous) {
      curvatures = {uniform(-1, 1, rng) / 5.9, uniform(-1, 1, rng) / 5.9};
    }
    const Problem problem = problem_along(towing_vehicle(), any_state(), any_state(), curvatures);
    const PlanResult result = plan(problem, steered(GetParam(), 1000));
    expect_drive(problem, result, GetParam());
    ++tried;
    solved += result.path ? 1 : 0;
  });
  EXPECT_GE(solved, 0.9 * tried) << solved << " of " << tried;
}

INSTANTIATE_TEST_SUITE_P(RigWheels, ContinuousRigs, testing::ValuesIn(kinds_for_rigs), kind_name);

// With nobody asking, a driver's rig has arcs and lines: docs/algorithms/trailers.md says why.
TEST(RigWheels, TurnAtOnceUnlessTheyAreAskedNotTo) {
  const PlanOptions options = complete(default_planner(), {}, towing_vehicle());
  EXPECT_EQ(options.steering, Steering::reeds_shepp);
}

}  // namespace
}  // namespace vandplan

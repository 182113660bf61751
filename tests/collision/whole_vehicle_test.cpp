// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does every check look at the trailer?

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "support/problems.h"
#include "vandplan/collision.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/search.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using search::Connector;

constexpr double angle = 0.8;
const LocalState straight(LocalPose({0, 0, 0}));
const LocalState bent(State{{0, 0, 0}, angle});

/// A post of 20 cm in the middle of the trailer's axle.
Polygon post_under_trailer(const State& state) {
  const auto [x, y, heading] = trailer_pose(semitrailer(), state);
  return box(x - 0.1, y - 0.1, x + 0.1, y + 0.1);
}

/// The rig among obstacles, with the start in `from` and the goal 1 m ahead.
Problem rig_among(const State& from, const std::vector<Polygon>& obstacles) {
  const Vehicle rig = semitrailer();
  const State to = advance(rig, from, Segment{0.0, 1.0});
  return make_problem({.vehicle = rig,
                       .bounds = {-60, 60, -60, 60},
                       .start = from.pose,
                       .goal = to.pose,
                       .hitch_angles = {from.hitch_angle, to.hitch_angle},
                       .obstacles = obstacles});
}

/// A rig whose trailer stands on a post.
struct Standing {
  explicit Standing(const LocalState& in)
      : state(in), problem(rig_among(in, {post_under_trailer(in)})) {}

  LocalState state;
  Problem problem;
};

Piece ahead(double length) {
  Piece piece;
  piece.segments[piece.count++] = {0.0, length};
  piece.length = std::abs(length);
  return piece;
}

TEST(WholeVehicle, ATrailerOnAPostIsFoundByTheChecker) {
  for (const Standing& rig : {Standing(straight), Standing(bent)}) {
    const CollisionChecker& checker = *rig.problem.task().checker;
    const std::vector<Segment> way = {{0.0, 0.1}, {0.1, 0.1}};
    EXPECT_TRUE(checker.tractor_is_free(Local(rig.state.pose)));
    EXPECT_TRUE(checker.tractor_is_free(Local(rig.state.pose), way));
    EXPECT_FALSE(checker.is_free(rig.state));
    EXPECT_FALSE(checker.is_free(rig.state, way[0]));
    EXPECT_FALSE(checker.is_free(rig.state, way));
    EXPECT_FALSE(checker.is_free(rig.state, std::vector<Segment>{}));
    EXPECT_EQ(checker.clearance(rig.state, 10.0), 0.0);
  }
}

TEST(WholeVehicle, ATrailerOnAPostIsFoundByTheConnector) {
  for (const Standing& rig : {Standing(straight), Standing(bent)}) {
    Connector connector(rig.problem.task());
    EXPECT_FALSE(connector.is_free(rig.state));
    EXPECT_FALSE(connector.is_free(rig.state, Segment{0.0, 0.1}));
    EXPECT_FALSE(connector.is_free(rig.state, ahead(0.1)));
    EXPECT_FALSE(connector.connect(rig.state, rig.problem.task().goal));
    EXPECT_EQ(connector.free_prefix(rig.state, ahead(1.0)).count, 0);
  }
}

TEST(WholeVehicle, ATrailerOnAPostIsFoundByPlannersAndTheJudge) {
  for (const Standing& rig : {Standing(straight), Standing(bent)}) {
    const PlanResult result = plan(rig.problem, default_planner(), {});
    EXPECT_EQ(result.status, PlanStatus::start_in_collision);
    const PathCheck check = check_path(rig.problem, {rig.problem.start(), {{0.0, 1.0}}});
    EXPECT_EQ(check.reason, "the trailer's footprint hits obstacles[0]");
  }
}

TEST(WholeVehicle, ABarePoseHasItsTrailerStraightBehind) {
  const LocalPose pose(straight.pose);
  const Standing rig(straight), folded(bent);
  EXPECT_FALSE(rig.problem.task().checker->is_free(pose));
  EXPECT_FALSE(rig.problem.task().checker->is_free(pose, Segment{0.0, 1.0}));
  EXPECT_EQ(rig.problem.task().checker->clearance(pose, 10.0), 0.0);
  EXPECT_FALSE(Connector(rig.problem.task()).is_free(pose));
  EXPECT_TRUE(rig.problem.task().checker->is_free(bent));
  EXPECT_TRUE(folded.problem.task().checker->is_free(pose));
  EXPECT_GT(folded.problem.task().checker->clearance(pose, 10.0), 0.0);
}

// Backwards the trailer reaches the post, and the tractor stays away from it.
TEST(WholeVehicle, ATrailerEndsTheFreePartOfAPiece) {
  const State later = advance(semitrailer(), straight, Segment{0.0, -12.0});
  const Problem problem = rig_among(straight, {post_under_trailer(later)});
  Connector connector(problem.task());
  const Piece way = ahead(-12.0);
  EXPECT_FALSE(connector.is_free(straight, way));
  EXPECT_TRUE(problem.task().checker->tractor_is_free(Local(straight.pose), way.view()));
  const Piece free = connector.free_prefix(straight, way);
  EXPECT_GT(free.length, 0.0);
  EXPECT_LT(free.length, 12.0);
  EXPECT_TRUE(connector.is_free(straight, free));
}

TEST(WholeVehicle, WhatIsNearTheTrailerCosts) {
  const search::CostRule careful{.clearance_weight = 1.0, .clearance_distance = 0.5};
  const auto [x, y, heading] = trailer_pose(semitrailer(), straight);
  const Problem problem = rig_among(straight, {box(x - 3, y + 1.5, x + 3, y + 2)});
  const Task& task = problem.task();
  const Segment way{0.0, 1.0};
  const double cost =
      search::clearance_cost(task, careful, straight, {&way, 1}, search::ClearanceSampling::answer);
  EXPECT_NEAR(cost, 1 - (1.5 - 2.55 / 2) / 0.5, 1e-3);
  EXPECT_NEAR(Connector(task, careful).clearance_cost(straight, {&way, 1}), cost, 1e-3);
  EXPECT_NEAR(Connector(task, careful).clearance_cost(task.start, {&way, 1}), cost, 1e-3);
}

TEST(WholeVehicle, AHitchAngleThatIsNotFiniteIsNotFree) {
  const Problem problem = rig_among(straight, {});
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const LocalState state(State{{0, 0, 0}, wrong});
    EXPECT_FALSE(problem.task().checker->is_free(state));
    EXPECT_EQ(problem.task().checker->clearance(state, 10.0), 0.0);
  }
}

TEST(WholeVehicle, TheHitchAngleOfAVehicleAloneMeansNothing) {
  Vehicle tractor = semitrailer();
  tractor.trailer.reset();
  const Problem problem = make_problem({.vehicle = tractor,
                                        .bounds = {-60, 60, -60, 60},
                                        .start = {0, 0, 0},
                                        .goal = {9, 0, 0},
                                        .obstacles = {post_under_trailer(bent)}});
  const CollisionChecker& checker = *problem.task().checker;
  EXPECT_TRUE(checker.is_free(bent));
  EXPECT_EQ(checker.clearance(bent, 10.0), checker.clearance(straight, 10.0));
}

TEST(WholeVehicle, TasksKnowTheirStates) {
  const Problem problem = rig_among(bent, {});
  EXPECT_EQ(start_state(problem.task()), bent);
  EXPECT_EQ(goal_state(problem.task()).pose, problem.task().goal);
  EXPECT_EQ(goal_state(problem.task()).hitch_angle, problem.hitch_angles().goal);
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
TEST(WholeVehicle, OldNamesAnswerAlike) {
  const Standing rig(straight);
  const CollisionChecker& checker = *rig.problem.task().checker;
  const RigState old{{0, 0, 0}, angle};
  EXPECT_TRUE(checker.rig_is_free(Local(old)));
  EXPECT_FALSE(checker.rig_is_free(straight));
  EXPECT_FALSE(checker.rig_is_free(straight, Segment{0.0, 1.0}));
  EXPECT_EQ(checker.rig_clearance(Local(old), 10.0), checker.clearance(bent, 10.0));
  const search::CostRule careful{.clearance_weight = 1.0, .clearance_distance = 5.0};
  const Segment way{0.0, 1.0};
  const auto cost = [&](auto function) {
    return function(rig.problem.task(), careful, bent, std::span(&way, 1),
                    search::ClearanceSampling::search, 100.0);
  };
  EXPECT_GT(cost(search::rig_clearance_cost), 0.0);
  EXPECT_EQ(cost(search::rig_clearance_cost), cost(search::clearance_cost));
}
#pragma GCC diagnostic pop

}  // namespace
}  // namespace vandplan

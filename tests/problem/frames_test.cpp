// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does the compiler refuse a pose of the scenario's frame where a local one is meant?

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "support/problems.h"
#include "vandplan/graphs.h"
#include "vandplan/judge.h"
#include "vandplan/search.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using search::Connector;
using search::GoalEstimate;
using search::Tree;

using Segments = std::span<const Segment>;

// Local values are as large as others, and cost as little to copy.
static_assert(sizeof(LocalPose) == sizeof(Pose) && std::is_trivially_copyable_v<LocalPose>);

static_assert(std::is_convertible_v<LocalPose, Pose>);
static_assert(!std::is_convertible_v<Pose, LocalPose> && std::is_constructible_v<LocalPose, Pose>);

// What each door takes: as a pose P, a state S, a point Q or a box B.
template <class P>
concept PoseToCheck = requires(const CollisionChecker& checker, const P& p) {
  checker.is_free(p);
};
template <class P>
concept ArcToCheck = requires(const CollisionChecker& checker, const P& p) {
  checker.is_free(p, Segment{});
};
template <class P>
concept WayToCheck = requires(const CollisionChecker& checker, const P& p) {
  checker.is_free(p, Segments{});
};
template <class P>
concept PoseToMeasure = requires(const CollisionChecker& checker, const P& p) {
  checker.clearance(p, 1.0);
};
template <class Q>
concept PointToLookAt = requires(const CollisionChecker& checker, const Q& q) {
  checker.map_is_within(q, 1.0);
};
template <class Q>
concept PointToMeasure = requires(const CollisionChecker& checker, const Q& q) {
  checker.map_distance(q);
};
template <class Q>
concept CentreOfRamp = requires(const Q& q) {
  MarginRamp{q, 0.0, 1.0};
};
template <class P>
concept EndOfTask = std::is_assignable_v<decltype(Task::start)&, P> &&
    std::is_assignable_v<decltype(Task::goal)&, P>;
template <class P>
concept EndOfRoute = requires(const Roadmap& roadmap, const P& p, const LocalPose& local) {
  roadmap.route(p, local);
}
|| requires(const Roadmap& roadmap, const P& p, const LocalPose& local) {
  roadmap.route(local, p);
};
template <class B>
concept RegionOfRoadmap = std::is_assignable_v<decltype(RoadmapOptions::region)&, B>;
template <class P>
concept PoseToEstimate = std::is_invocable_v<decltype(GoalEstimate::length)&, P> ||
    std::is_invocable_v<decltype(RouteOptions::estimate)&, P>;
template <class P>
concept EndToConnect = requires(Connector& connector, const P& p, const LocalPose& local) {
  connector.connect(p, local);
}
|| requires(Connector& connector, const P& p, const LocalPose& local) {
  connector.connect(local, p);
};
template <class P>
concept EndToSteer = requires(Connector& connector, const P& p, const LocalPose& local) {
  connector.steer(p, local);
}
|| requires(Connector& connector, const P& p, const LocalPose& local) {
  connector.steer(local, p);
};
template <class P>
concept EndToPrice = requires(Connector& connector, const P& p, const LocalPose& local) {
  connector.least_cost(p, local);
}
|| requires(Connector& connector, const P& p, const LocalPose& local) {
  connector.least_cost(local, p);
};
template <class P>
concept BeginOfPiece = requires(Connector& connector, const P& p) {
  connector.is_free(p, Piece{});
}
|| requires(Connector& connector, const P& p) { connector.free_prefix(p, Piece{}); }
|| requires(Connector& connector, const P& p) { connector.is_free(p, Segment{}); };
template <class P>
concept PoseToConnect = requires(Connector& connector, const P& p) {
  connector.is_free(p);
};
template <class P>
concept BeginToPrice = requires(const Connector& connector, const P& p) {
  connector.clearance_cost(p, Segments{});
}
|| requires(const Task& task, const P& p) {
  search::clearance_cost(task, {}, p, Segments{}, search::ClearanceSampling::search);
};
template <class P>
concept Node = std::is_constructible_v<Tree, P, std::size_t> || requires(Tree& tree, const P& p) {
  tree.add(p, 0, 0.0);
};
template <class P>
concept FromScenario = requires(const World& world, const P& p) {
  to_local(world, p);
};
template <class P>
concept FromWorld = requires(const World& world, const P& p) {
  to_scenario(world, p);
};

template <class P>
concept EveryPose =
    PoseToCheck<P> && ArcToCheck<P> && WayToCheck<P> && PoseToMeasure<P> && EndOfTask<P> &&
    EndOfRoute<P> && PoseToEstimate<P> && EndToConnect<P> && EndToSteer<P> && EndToPrice<P> &&
    BeginOfPiece<P> && PoseToConnect<P> && BeginToPrice<P> && Node<P> && FromWorld<P>;
static_assert(EveryPose<LocalPose>);
static_assert(!PoseToCheck<Pose> && !ArcToCheck<Pose> && !WayToCheck<Pose>);
static_assert(!PoseToMeasure<Pose> && !EndOfTask<Pose> && !EndOfRoute<Pose>);
static_assert(!PoseToEstimate<Pose> && !EndToConnect<Pose> && !EndToSteer<Pose>);
static_assert(!EndToPrice<Pose> && !BeginOfPiece<Pose> && !PoseToConnect<Pose>);
static_assert(!BeginToPrice<Pose> && !Node<Pose>);

// Checks take states, and poses as states with the trailer straight behind.
template <class S>
concept EveryState = PoseToCheck<S> && ArcToCheck<S> && WayToCheck<S> && PoseToMeasure<S> &&
    BeginOfPiece<S> && PoseToConnect<S> && BeginToPrice<S>;
static_assert(EveryState<LocalState>);
static_assert(!PoseToCheck<State> && !ArcToCheck<State> && !WayToCheck<State>);
static_assert(!PoseToMeasure<State> && !BeginOfPiece<State> && !PoseToConnect<State>);
static_assert(!BeginToPrice<State>);
static_assert(std::is_convertible_v<Pose, State> && std::is_convertible_v<LocalPose, LocalState>);
static_assert(!std::is_convertible_v<Pose, LocalState>);
static_assert(!std::is_convertible_v<LocalState, LocalPose>);

static_assert(PointToLookAt<Local<Point>> && PointToMeasure<Local<Point>>);
static_assert(CentreOfRamp<Local<Point>> && RegionOfRoadmap<Local<Bounds>>);
static_assert(!PointToLookAt<Point> && !PointToMeasure<Point>);
static_assert(!CentreOfRamp<Point> && !RegionOfRoadmap<Bounds>);

// Nobody moves a pose twice.
static_assert(FromScenario<Pose> && !FromScenario<LocalPose>);
static_assert(FromScenario<State> && !FromScenario<LocalState>);
static_assert(!FromWorld<Pose>);

// What is driven from a local pose is local.
static_assert(std::is_same_v<decltype(advance(LocalPose(), Segment{})), LocalPose>);
static_assert(std::is_same_v<decltype(advance(Pose(), Segment{})), Pose>);
static_assert(std::is_same_v<decltype(advance(Vehicle(), LocalState(), Segment{})), LocalState>);
static_assert(std::is_same_v<decltype(advance(Vehicle(), State(), Segment{})), State>);
static_assert(std::is_same_v<decltype(compose(LocalPose(), Pose())), LocalPose>);
static_assert(std::is_same_v<decltype(search::end_of(LocalPose(), Piece{})), LocalPose>);

/// A wall 16 m ahead of a start that is far from the scenario's origin.
Scenario far_yard() {
  return {.bounds = {3'999'950.0, 4'000'050.0, -70'050.0, -69'950.0},
          .start = {4'000'000.0, -70'000.0, 0.0},
          .goal = {4'000'000.0, -69'980.0, 0.0},
          .obstacles = {box(4'000'020.0, -70'010.0, 4'000'024.0, -69'990.0)}};
}

const Pose in_wall{4'000'021.0, -70'000.0, 0.0};
const Pose beside_it{4'000'010.0, -70'000.0, 0.0};

TEST(Frames, APoseInAWallFarAwayIsOccupiedAtEveryDoor) {
  const Problem problem = make_problem(far_yard());
  const World& world = *problem.world();
  const CollisionChecker& checker = *world.checker(problem.vehicle());
  Connector connector(problem.task());
  for (const Pose& pose : {in_wall, beside_it}) {
    const bool is_free = pose == beside_it;
    const LocalPose local = to_local(world, pose);
    EXPECT_EQ(checker.is_free(local), is_free);
    EXPECT_EQ(checker.is_free(local, Segment{0.0, 0.5}), is_free);
    EXPECT_EQ(checker.clearance(local, 10.0) > 0.0, is_free);
    EXPECT_EQ(checker.is_free(to_local(world, State{pose, 0.1})), is_free);
    EXPECT_EQ(checker.tractor_is_free(local), is_free);
    EXPECT_EQ(connector.is_free(local), is_free);
    EXPECT_EQ(connector.connect(local, local).has_value(), is_free);
    EXPECT_EQ(to_scenario(world, local), pose);
  }
  EXPECT_FALSE(connector.connect(to_local(world, beside_it), to_local(world, in_wall)));
}

TEST(Frames, AMapFarAwayHasItsObstaclesWhereTheyAre) {
  Scenario scenario = far_yard();
  scenario.obstacles = {};
  std::vector<Cell> cells(10'000, Cell::free);
  cells[100 * 40 + 80] = Cell::occupied;  // 20.25 m ahead of the start, 0.25 m to the left
  scenario.map = OccupancyGrid{.origin = {3'999'980.0, -70'020.0, 0.0},
                               .resolution = 0.5,
                               .columns = 100,
                               .rows = 100,
                               .cells = cells};
  const Problem problem = make_problem(scenario);
  const LocalPose at = to_local(*problem.world(), {4'000'020.25, -69'999.75, 0.0});
  const Local<Point> there(Point{at.x, at.y});
  const Local<Point> elsewhere(Point{at.x - 10.0, at.y});
  EXPECT_TRUE(problem.task().checker->map_is_within(there, 0.1));
  EXPECT_FALSE(problem.task().checker->map_is_within(elsewhere, 0.1));
  EXPECT_LE(problem.task().checker->map_distance(there).least, 0.0);
  EXPECT_GT(problem.task().checker->map_distance(elsewhere).least, 5.0);
}

TEST(Frames, ARoadmapKnowsAWayBetweenPosesThatWereMadeLocal) {
  const Problem problem = make_problem(far_yard());
  const World& world = *problem.world();
  const Roadmap roadmap = build_roadmap(world, problem.vehicle(), {.nodes = 300});
  const auto route =
      roadmap.route(to_local(world, problem.start()), to_local(world, problem.goal())).route;
  ASSERT_TRUE(route);
  EXPECT_EQ(to_scenario(world, route->poses.back()), problem.goal());
  const PathCheck check =
      check_path(problem, {to_scenario(world, route->poses.front()), route->segments});
  EXPECT_TRUE(check.valid) << check.reason;
}

}  // namespace
}  // namespace vandplan

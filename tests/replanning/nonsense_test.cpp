// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What do lengths, paths, movers, trailers and the judge say to nonsense?

#include <gtest/gtest.h>

#include <vector>

#include "support/numbers.h"
#include "support/place_of_error.h"
#include "tables/rig_table.h"
#include "vandplan/collision.h"
#include "vandplan/drive.h"
#include "vandplan/judge.h"
#include "vandplan/motion.h"
#include "vandplan/planner.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

const Pose there{10, 3, 1};
const Path straight{{}, {{0, 10}}};
const Path endless{{}, {{0, infinity}}};

Problem problem_on_open_ground() {
  Scenario scenario;
  scenario.bounds = {-50, 50, -50, 50};
  scenario.goal = {10, 0, 0};
  return make_problem(scenario);
}

TEST(Nonsense, LengthsOfNoTurningRadiusAreRefused) {
  const HeuristicTable table = thesis_table(1);
  for (const double radius : {-7.0, 0.0, nan, infinity}) {
    EXPECT_EQ(place_of_error([&] { (void)reeds_shepp({}, there, radius); }), "radius");
    EXPECT_EQ(place_of_error([&] { (void)reeds_shepp_length({}, there, radius); }), "radius");
    EXPECT_EQ(place_of_error([&] { (void)reeds_shepp_words({}, there, radius); }), "radius");
    EXPECT_EQ(place_of_error([&] { (void)dubins({}, there, radius); }), "radius");
    EXPECT_EQ(place_of_error([&] { (void)dubins_length({}, there, radius); }), "radius");
    EXPECT_EQ(place_of_error([&] { (void)dubins_words({}, there, radius); }), "radius");
    EXPECT_EQ(place_of_error([&] { (void)length_bounds({}, there, radius); }), "radius");
    EXPECT_EQ(place_of_error([&] { (void)table.distance({}, there, radius); }), "radius");
    EXPECT_EQ(place_of_error([&] { (void)NearestNodes(radius); }), "radius");
  }
}

TEST(Nonsense, ColumnsOfOtherSizesAreRefused) {
  const std::vector<float> one(1);
  const PoseColumns nodes{one, one, one};
  std::vector<float> low(1), many(1000);
  const std::vector<Pose> two(2);
  std::vector<double> three(3);
  const HeuristicTable table = thesis_table(1);
  EXPECT_EQ(place_of_error([&] { reeds_shepp_lengths(nodes, there, 7, many); }), "nodes");
  EXPECT_EQ(place_of_error([&] { length_bounds(nodes, there, 7, low, many); }), "nodes");
  EXPECT_EQ(place_of_error([&] { table.distances(nodes, there, 7, many); }), "nodes");
  EXPECT_EQ(place_of_error([&] { reeds_shepp_lengths(two, {&there, 1}, 7, three); }), "from");
  EXPECT_EQ(place_of_error([&] { reeds_shepp_lengths({&there, 1}, two, 7, three); }), "to");
}

TEST(Nonsense, TablesThatAreNotThereAreRefused) {
  for (const int number : {-1, 0, 5}) {
    EXPECT_EQ(place_of_error([&] { (void)thesis_table_options(number); }), "number");
    EXPECT_EQ(place_of_error([&] { (void)thesis_table(number); }), "number");
  }
  EXPECT_EQ(place_of_error([&] { (void)embedded_rig_table({}); }), "vehicle.trailers");
  EXPECT_EQ(place_of_error([&] { (void)rig_length_bound({}, {}, {}); }), "vehicle.trailers");
  Vehicle rig;
  rig.trailer.emplace();
  const RigTable table = embedded_rig_table(rig);
  EXPECT_EQ(place_of_error([&] { (void)table.scaled(nan); }), "factor");
}

TEST(Nonsense, NodesThatCannotBeAreRefused) {
  NearestNodes nodes(7);
  EXPECT_EQ(place_of_error([&] { nodes.add({nan, 0, 0}); }), "pose");
  EXPECT_EQ(place_of_error([&] { nodes.add({0, infinity, 0}); }), "pose");
  EXPECT_EQ(nodes.size(), 0U);
  nodes.add({});
  EXPECT_EQ(place_of_error([&] { (void)nodes.nearest({nan, 0, 0}); }), "sample");
  EXPECT_EQ(place_of_error([&] { (void)nodes.nearest({0, 0, nan}, {.count = 2}); }), "sample");
  EXPECT_EQ(place_of_error([&] {
              (void)nodes.nearest_in_any_order({0, infinity, 0}, {.count = 2});
            }),
            "sample");
  nodes.remove(0);
  for (const std::int32_t node : {-1, 0, 1}) {
    EXPECT_EQ(place_of_error([&] { nodes.remove(node); }), "node") << node;
  }
}

TEST(Nonsense, PathsAndStepsThatCannotBeAreRefused) {
  for (const double step : {0.0, -1.0, nan, 1e-300}) {
    EXPECT_EQ(place_of_error([&] { (void)sampled(straight, step); }), "step") << step;
  }
  EXPECT_EQ(sampled(straight, infinity).size(), 2U);
  EXPECT_EQ(place_of_error([&] { (void)sampled(endless, 0.1); }), "segments[0]");
  Vehicle without_wheels;
  without_wheels.wheelbase = 0;
  EXPECT_EQ(place_of_error([&] { (void)speed_profile(straight, without_wheels); }),
            "vehicle.wheelbase");
  EXPECT_EQ(place_of_error([&] { (void)speed_profile(straight, {}, {.start_curvature = nan}); }),
            "start_curvature");
}

TEST(Nonsense, SteeringAnglesThatCannotBeAreRefused) {
  for (const double angle : {0.0, -0.5, 1.6, 35.0, nan}) {
    EXPECT_EQ(place_of_error([&] { (void)turning_radius(4.5, angle); }), "max_steering_angle");
  }
  EXPECT_EQ(place_of_error([&] { (void)turning_radius(0, 0.5); }), "wheelbase");
}

TEST(Nonsense, MoversWithoutATrajectoryAreNowhere) {
  const MovingObstacle mover;
  EXPECT_EQ(pose_at(mover, 1.0), std::nullopt);
  EXPECT_EQ(growth_at(mover, 1.0), 0.0);
  EXPECT_EQ(end_of_motion({&mover, 1}), 0.0);
  const TimedPath drive{straight, speed_profile(straight, {})};
  EXPECT_EQ(place_of_error([&] { (void)first_meeting(drive, {}, {&mover, 1}, 0); }), "moving[0]");
  EXPECT_EQ(place_of_error([&] { (void)first_meeting(drive, {}, {}, nan); }), "margin");
  EXPECT_EQ(place_of_error([&] {
              (void)first_meeting({straight, {}}, {}, {}, 0);
            }),
            "drive.speeds");
}

TEST(Nonsense, CellsThatAreNotThereAreUnknown) {
  OccupancyGrid map{.columns = 1000, .rows = 1000};
  EXPECT_TRUE(is_blocked(map, 999, 999));
  map.cells = std::vector<Cell>(1, Cell::free);
  EXPECT_FALSE(is_blocked(map, 0, 0));
  EXPECT_TRUE(is_blocked(map, 999, 999));
  map.unknown_is_free = true;
  EXPECT_FALSE(is_blocked(map, 999, 999));
}

TEST(Nonsense, AVehicleWithoutATrailerHasNoHitchAngle) {
  const Vehicle truck;
  const std::string where = "vehicle.trailers";
  EXPECT_EQ(place_of_error([&] { (void)trailer_pose(truck, {}); }), where);
  EXPECT_EQ(place_of_error([&] { (void)tractor_pose(truck, {}, 0); }), where);
  EXPECT_EQ(place_of_error([&] { (void)hitch_rate(truck, 0, 0.1); }), where);
  EXPECT_EQ(place_of_error([&] { (void)largest_hitch_angle(truck, 0, {0.1, 1}); }), where);
  EXPECT_EQ(place_of_error([&] { (void)sampled_hitch_angles(truck, straight, 0, 0); }), "step");
}

// A checker says free of nothing that it cannot look at.
TEST(Nonsense, WhatIsNotFiniteIsNotFree) {
  const Problem problem = problem_on_open_ground();
  const CollisionChecker& checker = *problem.task().checker;
  for (const Segment& segment : {Segment{0, nan}, Segment{nan, 1}, Segment{0, infinity},
                                 Segment{0, 1, nan}, Segment{0, 1, infinity}}) {
    EXPECT_FALSE(checker.is_free(LocalPose{}, segment));
  }
  EXPECT_EQ(checker.clearance(Local(Pose{nan, 0, 0}), 5), 0.0);
  EXPECT_EQ(place_of_error([&] { (void)problem.world()->checker({}, {.wanted = nan}); }), "margin");
  EXPECT_EQ(place_of_error([&] { (void)task_of(problem, {.margin = nan}); }), "margin");
}

// The judge throws nothing: what it cannot look at is not valid.
TEST(Nonsense, TheJudgePassesNothingThatItCannotSee) {
  const Problem problem = problem_on_open_ground();
  const TimedPath drive{straight, speed_profile(straight, {})};
  EXPECT_FALSE(check_path(Problem{}, straight).valid);
  EXPECT_FALSE(check_drive(Problem{}, drive).valid);
  EXPECT_FALSE(check_company(Problem{}, drive).valid);
  ASSERT_TRUE(check_path(problem, straight).valid);
  for (const double margin : {nan, -1.0}) {
    EXPECT_FALSE(check_path(problem, straight, {.clearance = {.margin = margin}}).valid);
    EXPECT_FALSE(check_path(problem, straight, {.clearance = {0.1, margin}}).valid);
    EXPECT_FALSE(check_drive(problem, drive, {.margin = margin}).valid);
  }
  EXPECT_FALSE(check_company(problem, {straight, {}}).valid);
  ASSERT_TRUE(check_drive(problem, drive).valid);
  EXPECT_FALSE(check_drive(problem, drive, {.start_speed = nan}).valid);
  TimedPath endless_drive = drive;
  endless_drive.speeds.duration = nan;
  EXPECT_FALSE(check_drive(problem, endless_drive).valid);
  TimedPath stopping = drive;
  stopping.speeds.stops = {{.t = 1, .s = 1, .pause = nan}};
  EXPECT_EQ(check_drive(problem, stopping).reason, "stops[0] is not finite");
}

TEST(Nonsense, AProblemThatNobodyMadeIsNotDriven) {
  EXPECT_EQ(place_of_error([&] { (void)drive(Problem{}, straight); }), "problem");
  EXPECT_EQ(place_of_error([&] { (void)executable(Problem{}, straight); }), "problem");
}

TEST(Nonsense, ABoundThatIsNoNumberIsRejected) {
  const Planner liar{
      .name = "liar", .summary = "", .function = [](const Task&, const PlanOptions&) {
        return PlannerAnswer{
            .status = PlanStatus::solved, .segments = straight.segments, .lower_bound = nan};
      }};
  const PlanResult result = plan(problem_on_open_ground(), liar);
  EXPECT_EQ(result.status, PlanStatus::rejected);
  EXPECT_NE(result.reason.find("lower bound"), std::string::npos);
  EXPECT_EQ(place_of_error([&] { (void)warm_started(endless); }), "segments[0]");
}

}  // namespace
}  // namespace vandplan

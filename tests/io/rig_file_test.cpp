// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Trailers in files: scenarios, vehicles, results.

#include <gtest/gtest.h>

#include <string>

#include "support/reader_test.h"
#include "vandplan/files.h"
#include "vandplan/result_file.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

const std::string lengths =
    "wheelbase: 3.6, front_overhang: 1.4, rear_overhang: 0.9, width: 2.55, min_turning_radius: 6";
const std::string trailer = "{wheelbase: 8.1, front_overhang: 1.2, rear_overhang: 4.3, width: 2.5}";

/// A scenario on lines 1 to 6.
std::string scenario_with(const std::string& vehicle, const std::string& start,
                          const std::string& goal) {
  return "name: dock\nvehicle: {" + lengths + vehicle +
         "}\nbounds: {x: [-90, 90], y: [-90, 90]}\nstart: {x: 0, y: 0, heading: 0" + start +
         "}\ngoal: {" + goal + "}\nobstacles: []\n";
}

std::string with_trailer(const std::string& start, const std::string& goal) {
  return scenario_with(", hitch: 0.5, max_hitch_angle: 1.1, trailers: [" + trailer + "]", start,
                       goal);
}

const std::string usual_goal = "x: 9, y: 4, heading: 1, hitch_angles: [-0.2]";

class RigFile : public ReaderTest {
 protected:
  std::string fault_of(const std::string& text) {
    return message_of([&] { return scenario_from_yaml(text, "s.yaml"); });
  }
};

TEST_F(RigFile, EveryKeyIsReadAndWritten) {
  const ScenarioFile file =
      scenario_from_yaml(with_trailer(", hitch_angles: [0.3]", usual_goal), "s.yaml");
  const Scenario& scenario = file.scenario;
  EXPECT_EQ(scenario.vehicle.hitch, 0.5);
  EXPECT_EQ(scenario.vehicle.max_hitch_angle, 1.1);
  EXPECT_EQ(scenario.vehicle.trailer, (Trailer{8.1, 1.2, 4.3, 2.5}));
  EXPECT_EQ(scenario.hitch_angles, (EndHitchAngles{0.3, -0.2}));
  const Scenario again = scenario_from_yaml(to_yaml(file), "t.yaml").scenario;
  EXPECT_EQ(again.vehicle, scenario.vehicle);
  EXPECT_EQ(again.hitch_angles, scenario.hitch_angles);
  EXPECT_EQ(make_problem(scenario).hitch_angles(), scenario.hitch_angles);
}

TEST_F(RigFile, WithoutAngleTheTrailerIsStraightBehind) {
  const Scenario scenario =
      scenario_from_yaml(with_trailer("", "x: 9, y: 4, heading: 1"), "s.yaml").scenario;
  EXPECT_EQ(scenario.hitch_angles, EndHitchAngles{});
}

TEST_F(RigFile, AGoalOfTheTrailerIsOneOfTheTractor) {
  const Scenario scenario =
      scenario_from_yaml(
          with_trailer("", "trailer: {x: 5, y: 4, heading: 0.5}, hitch_angles: [0.25]"), "s.yaml")
          .scenario;
  EXPECT_EQ(scenario.hitch_angles.goal, 0.25);
  EXPECT_EQ(scenario.goal.heading, 0.75);
  const Pose axle = trailer_pose(scenario.vehicle, {scenario.goal, 0.25});
  EXPECT_NEAR(axle.x, 5, 1e-14);
  EXPECT_NEAR(axle.y, 4, 1e-14);
  EXPECT_NEAR(axle.heading, 0.5, 1e-15);
}

TEST_F(RigFile, EveryGoalOfARowHasItsAngle) {
  std::string text = with_trailer("", usual_goal);
  const std::size_t at = text.find("goal:");
  text.replace(at, text.find('\n', at) - at,
               "goals:\n  - {distance: 1, goal: {x: 9, y: 0, heading: 0, hitch_angles: [0.5]}}\n"
               "  - {distance: 2, goal: {x: 19, y: 0, heading: 0}}");
  const ScenarioFile file = scenario_from_yaml(text, "s.yaml");
  EXPECT_EQ(make_problems(file)[0].hitch_angles(), (EndHitchAngles{0, 0.5}));
  EXPECT_EQ(make_problems(file)[1].hitch_angles(), EndHitchAngles{});
}

TEST_F(RigFile, WhatIsWrongIsNamedWithItsLine) {
  const auto fault_with = [&](const std::string& vehicle) {
    return fault_of(scenario_with(vehicle, "", "x: 9, y: 4, heading: 1"));
  };
  EXPECT_EQ(fault_with(", trailers: [" + trailer + ", " + trailer + "]"),
            "s.yaml:2: vehicle.trailers: has 2 trailers, expected one: more are not covered");
  EXPECT_EQ(fault_with(", trailers: []"),
            "s.yaml:2: vehicle.trailers: has 0 trailers, expected one: more are not covered");
  EXPECT_EQ(fault_with(", hitch: 1"),
            "s.yaml:2: vehicle.hitch: is given without a trailer, expected trailers beside it");
  EXPECT_EQ(fault_with(", max_hitch_angle: 3.2, trailers: [" + trailer + "]"),
            "s.yaml:2: vehicle.max_hitch_angle: is 3.2, expected more than 0 and less than "
            "3.1415 rad");
  EXPECT_EQ(fault_with(", trailers: [{wheelbase: 0, front_overhang: 1, rear_overhang: 1, width: "
                       "2}]"),
            "s.yaml:2: vehicle.trailers[0].wheelbase: is 0, expected more than 0 m");
  EXPECT_EQ(fault_with(", trailers: [{wheelbase: 2, front_overhang: -3, rear_overhang: 1, width: "
                       "2}]"),
            "s.yaml:2: vehicle.trailers[0].front_overhang: is -3, expected a body that begins "
            "ahead of the axle, at least -2");
  EXPECT_TRUE(fault_with(", trailers: [{wheelbase: 2, length: 3}]")
                  .starts_with("s.yaml:2: vehicle.trailers[0]: unknown key "));
}

TEST_F(RigFile, AnglesThatCannotBeAreNamed) {
  EXPECT_EQ(fault_of(with_trailer(", hitch_angles: [0.1, 0.2]", usual_goal)),
            "s.yaml:4: start.hitch_angles: has 2 angles, expected 1, one for each trailer");
  EXPECT_EQ(fault_of(with_trailer(", hitch_angles: [-1.2]", usual_goal)),
            "s.yaml:4: start.hitch_angles: has -1.2, expected at most max_hitch_angle, 1.1 rad");
  EXPECT_EQ(fault_of(scenario_with("", ", hitch_angles: [0]", "x: 9, y: 4, heading: 1")),
            "s.yaml:4: start.hitch_angles: are given without a trailer, expected trailers of the "
            "vehicle");
  EXPECT_EQ(fault_of(scenario_with("", "", "trailer: {x: 9, y: 4, heading: 1}")),
            "s.yaml:5: goal.trailer: is given without a trailer, expected trailers of the vehicle");
}

TEST_F(RigFile, TheCatalogueHasRigsThatStandOnTheGround) {
  for (const std::string name : {"tractor-semitrailer", "truck-drawbar-trailer", "car-caravan"}) {
    const Vehicle vehicle = vehicle_named(name);
    EXPECT_TRUE(vehicle.trailer) << name;
    check_vehicle(vehicle);
    EXPECT_EQ(scenario_from_yaml("name: a\nvehicle: " + name +
                                     "\nbounds: {x: [-9, 9], y: [-9, 9]}\nstart: {x: 0, y: 0, "
                                     "heading: 0}\ngoal: {x: 1, y: 0, heading: 0}\nobstacles: []\n",
                                 "s.yaml")
                  .scenario.vehicle,
              vehicle);
  }
  const Vehicle semitrailer = vehicle_named("tractor-semitrailer");
  const Footprint tractor = footprint(semitrailer);
  const Trailer& behind = *semitrailer.trailer;
  EXPECT_NEAR(tractor.front - semitrailer.hitch + behind.wheelbase + behind.rear_overhang, 16.4,
              1e-12);
}

TEST_F(RigFile, ResultsCarryTheAngleOfEveryPose) {
  const ScenarioFile file =
      scenario_from_yaml(with_trailer(", hitch_angles: [0.3]", usual_goal), "s.yaml");
  ResultRecord record{.scenario = "dock", .planner = "anytime"};
  record.result.status = PlanStatus::solved;
  record.result.path = Path{{0, 0, 0}, {{0.1, 2}, {0, -1}}};
  const std::string written = folder_.put("r.json", results_to_json(file, {record}));
  const ResultRecord read = read_results(written, file).front();
  EXPECT_EQ(read.claims.start_hitch_angle, 0.3);
  ASSERT_FALSE(read.claims.poses.empty());
  const Vehicle& vehicle = file.scenario.vehicle;
  const State half = advance(vehicle, {{0, 0, 0}, 0.3}, {0.1, 2});
  EXPECT_EQ(read.claims.poses.front().hitch_angle, 0.3);
  EXPECT_EQ(read.claims.poses.back().hitch_angle, advance(vehicle, half, {0, -1}).hitch_angle);
}

TEST_F(RigFile, PlannersWithoutTrailersNameThoseThatKnowThem) {
  const Scenario scenario = scenario_from_yaml(with_trailer("", usual_goal), "s.yaml").scenario;
  const std::string fault =
      message_of([&] { return plan(make_problem(scenario), planner_named("rrt-connect"), {}); });
  EXPECT_TRUE(
      fault.starts_with("planner: rrt-connect plans for a vehicle without a trailer, expected "
                        "one of those that know trailers: anytime, rrt-... (28)"))
      << fault;
  PlanOptions options;
  options.steering = Steering::continuous;
  const Planner tree = planner_named("rrt-bsc-euc");
  EXPECT_EQ(message_of([&] { return plan(make_problem(scenario), tree, options); }),
            "steering: is continuous, expected reeds-shepp for a vehicle with a trailer, or a "
            "planner that steers it so: anytime");
}

}  // namespace
}  // namespace vandplan

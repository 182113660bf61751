// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Are the limits of a vehicle read, checked and written?

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/cases.h"
#include "support/reader_test.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

const std::string truck =
    "wheelbase: 4.5, front_overhang: 1.4, rear_overhang: 1.6, width: 2.55, min_turning_radius: 7";

std::string scenario_with(const std::string& vehicle) {
  return "name: a\nvehicle: " + vehicle +
         "\nbounds: {x: [-9, 9], y: [-9, 9]}\nstart: {x: 0, y: 0, heading: 0}\n"
         "goal: {x: 1, y: 0, heading: 0}\nobstacles: []\n";
}

Vehicle vehicle_read(const std::string& vehicle) {
  return scenario_from_yaml(scenario_with(vehicle), "s.yaml").scenario.vehicle;
}

std::string message_for_vehicle(const std::string& vehicle) {
  try {
    (void)vehicle_read(vehicle);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The line that states the vehicle, as it is written.
std::string written(const Vehicle& vehicle) {
  Scenario scenario = scenario_from_yaml(scenario_with("{" + truck + "}"), "s.yaml").scenario;
  scenario.vehicle = vehicle;
  const std::string text = to_yaml(scenario);
  const std::size_t begin = text.find("vehicle: ") + 9;
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST(VehicleFile, WithoutLimitsItHasTheDefaults) {
  EXPECT_EQ(vehicle_read("{" + truck + "}").limits, DrivingLimits{});
}

TEST(VehicleFile, EveryLimitIsRead) {
  const Vehicle vehicle = vehicle_read(
      "{" + truck +
      ", max_steering_rate: 0.71, max_curvature_rate: 0.08, max_speed: {forward: 3, "
      "reverse: 2}, max_acceleration: 1.1, max_braking: 1.2, max_lateral_acceleration: 1.6, "
      "max_jerk: 2.5}");
  EXPECT_EQ(vehicle.limits, (DrivingLimits{.max_steering_rate = 0.71,
                                           .max_curvature_rate = 0.08,
                                           .max_speed = {3, 2},
                                           .max_acceleration = 1.1,
                                           .max_braking = 1.2,
                                           .max_lateral_acceleration = 1.6,
                                           .max_jerk = 2.5}));
  EXPECT_EQ(vehicle_read("{" + truck + ", max_speed: {reverse: 2}}").limits.max_speed,
            (GearSpeeds{GearSpeeds{}.forward, 2}));
  EXPECT_EQ(vehicle_read("{" + truck + ", max_jerk: none}").limits, DrivingLimits{});
}

TEST(VehicleFile, WhatALimitMayNotBeIsSaid) {
  EXPECT_EQ(message_for_vehicle("{" + truck + ", max_jerk: -2}"),
            "s.yaml:2: vehicle.max_jerk: is -2, expected 0.001 to 1000 m/s^3");
  EXPECT_EQ(message_for_vehicle("{" + truck + ", max_steering_rate: 0}"),
            "s.yaml:2: vehicle.max_steering_rate: is 0, expected 0.001 to 1000 rad/s");
  EXPECT_EQ(message_for_vehicle("{" + truck + ", max_curvature_rate: 0}"),
            "s.yaml:2: vehicle.max_curvature_rate: is 0, expected 0.001 to 1000 1/m^2");
  EXPECT_EQ(message_for_vehicle("{" + truck + ", max_speed: {forward: 0}}"),
            "s.yaml:2: vehicle.max_speed.forward: is 0, expected 0.001 to 1000 m/s");
  EXPECT_EQ(message_for_vehicle("{" + truck + ", max_speed: {reverse: 1e9}}"),
            "s.yaml:2: vehicle.max_speed.reverse: is 1e+09, expected 0.001 to 1000 m/s");
  EXPECT_EQ(message_for_vehicle("{" + truck + ", max_acceleration: 0}"),
            "s.yaml:2: vehicle.max_acceleration: is 0, expected 0.001 to 1000 m/s^2");
  EXPECT_EQ(message_for_vehicle("{" + truck + ", max_braking: 0}"),
            "s.yaml:2: vehicle.max_braking: is 0, expected 0.001 to 1000 m/s^2");
  EXPECT_EQ(message_for_vehicle("{" + truck + ", max_lateral_acceleration: 0}"),
            "s.yaml:2: vehicle.max_lateral_acceleration: is 0, expected 0.001 to 1000 m/s^2");
  EXPECT_EQ(message_for_vehicle("{" + truck + ", max_speed: 3}"),
            "s.yaml:2: vehicle.max_speed: is \"3\", expected a map of keys");
  EXPECT_EQ(message_for_vehicle("{" + truck + ", max_speed: {forwards: 3}}"),
            "s.yaml:2: vehicle.max_speed: unknown key \"forwards\", did you mean forward? Expected "
            "one of forward, "
            "reverse");
  EXPECT_EQ(message_for_vehicle("{" + truck + ", max_acceleration: none}"),
            "s.yaml:2: vehicle.max_acceleration: is \"none\", expected a number");
}

// Files, and the hashes that stores keep of them, stay as they were before there were limits.
TEST(VehicleFile, UsualLimitsAreNotWritten) {
  EXPECT_EQ(written(Vehicle{}), "{" + truck + "}");
  EXPECT_EQ(written(vehicle_named("tpcap-car")),
            "{wheelbase: 2.8, front_overhang: 0.96, rear_overhang: 0.929, width: 1.942, "
            "min_turning_radius: 3.005593}");
}

TEST(VehicleFile, TheLengthsOfAVehicleOfTheCatalogueBringItsLimits) {
  for (const std::string& name : vehicle_names()) {
    const Vehicle named = vehicle_named(name);
    EXPECT_EQ(vehicle_read(written(named)), named) << name;
    EXPECT_NE(named.limits.max_steering_rate, 0) << name;
  }
  Vehicle slow = vehicle_named("tpcap-car");
  slow.limits.max_speed = {};
  EXPECT_EQ(vehicle_read(written(slow)), slow);
}

TEST(VehicleFile, AnOutlineReadsBackAndBringsTheLengthsOfItsBox) {
  const Vehicle vehicle = vehicle_read(
      "{wheelbase: 3.6, min_turning_radius: 6, outline: [[5, -0.5], [5, 0.7], [-0.9, 1.2], [-0.9, "
      "-1]]}");
  EXPECT_EQ(vehicle.outline, (Polygon{{5, -0.5}, {5, 0.7}, {-0.9, 1.2}, {-0.9, -1}}));
  EXPECT_DOUBLE_EQ(vehicle.front_overhang, 1.4);
  EXPECT_EQ(vehicle.rear_overhang, 0.9);
  EXPECT_EQ(vehicle.width, 2.4);
  EXPECT_EQ(vehicle_read(written(vehicle)), vehicle);
  Vehicle rig = vehicle_named("tractor-semitrailer");
  rig.trailer->outline = {{9, -1}, {9, 1}, {-4, 1.2}, {-4, -1.2}};
  EXPECT_EQ(vehicle_read(written(rig)), rig);
}

TEST(VehicleFile, AnyLimitsReadBackUnchanged) {
  for_each_case(1, 300, [](Rng& rng) {
    const auto size = [&] { return uniform(0.01, 10, rng); };
    Vehicle vehicle = uniform01(rng) < 0.5 ? Vehicle{} : vehicle_named("city-bus");
    DrivingLimits& limits = vehicle.limits;
    if (uniform01(rng) < 0.5) limits.max_steering_rate = size();
    if (uniform01(rng) < 0.5) limits.max_curvature_rate = size();
    if (uniform01(rng) < 0.5) limits.max_speed.forward = size();
    if (uniform01(rng) < 0.5) limits.max_speed.reverse = size();
    if (uniform01(rng) < 0.5) limits.max_acceleration = size();
    if (uniform01(rng) < 0.5) limits.max_braking = size();
    if (uniform01(rng) < 0.5) limits.max_lateral_acceleration = size();
    if (uniform01(rng) < 0.5) limits.max_jerk = size();
    EXPECT_EQ(vehicle_read(written(vehicle)), vehicle);
  });
}

/// The lines that vehicle and footprint files are refused with, without their folder.
class FilesOfVehicles : public ReaderTest {
 protected:
  FootprintVehicle around(const std::string& text, double wheelbase = 0.3, double rear_axle = 0,
                          bool rectangle = true) {
    return read_footprint({.file = folder_.put("a.yaml", text),
                           .wheelbase = wheelbase,
                           .min_turning_radius = 0.5,
                           .rear_axle = rear_axle,
                           .rectangle = rectangle});
  }
  std::string refusal(const std::string& text, double wheelbase = 0.3) {
    return message_of([&] { return around(text, wheelbase); });
  }
};

TEST_F(FilesOfVehicles, AVehicleFileReadsBackExactly) {
  Vehicle vehicle = vehicle_named("coach");
  vehicle.wheelbase += 0.1;
  vehicle.limits.max_speed.forward = 1.75;
  EXPECT_EQ(read_vehicle(folder_.put("v.yaml", to_yaml(vehicle))), vehicle);
  EXPECT_EQ(read_vehicle(folder_.put("v.yaml", "{" + truck + "}")),
            vehicle_read("{" + truck + "}"));
  const auto refused = [&](const std::string& text) {
    return message_of([&] { return read_vehicle(folder_.put("v.yaml", text)); });
  };
  EXPECT_EQ(refused("coach"), "v.yaml:1: is no vehicle, expected a map of lengths");
  const auto outlined = [&](const std::string& outline) {
    return refused("wheelbase: 4.5\nmin_turning_radius: 7\noutline: " + outline + "\n");
  };
  EXPECT_EQ(outlined("[]"), "v.yaml:3: outline: has 0 corners, expected at least 3");
  EXPECT_EQ(outlined("[[5, 1], [-1, 0]]"), "v.yaml:3: outline: has 2 corners, expected at least 3");
  EXPECT_EQ(outlined("[[5, 1], [-1, 1], [2, 0], [-1, -1], [5, -1]]"),
            "v.yaml:3: outline: is not convex, expected a convex polygon");
  EXPECT_EQ(outlined("[[5, 1], [1, 1], [1, -1], [5, -1]]"),
            "v.yaml:3: outline: does not hold [0, 0], expected a body around the midpoint of its "
            "axle");
  EXPECT_EQ(refused("wheelbase: 4.5\nfront_overhang: 1\nrear_overhang: 1\nwidth: -2\n"
                    "min_turning_radius: 7\n"),
            "v.yaml:4: width: is -2, expected more than 0 m");
}

// Corners 0.1 m behind and 0.4 m before the axle, 0.2 m to the right and 0.25 m to the left.
const std::string corners = "[[0.4, 0.2], [0.4, -0.2], [-0.1, -0.2], [-0.1, 0.25]]";

TEST_F(FilesOfVehicles, ARectangleIsPutAroundAFootprint) {
  const std::string of_nav2 =
      "local_costmap:\n  ros__parameters:\n    footprint: \"" + corners + "\"\n";
  for (const std::string& text : {corners, "\"" + corners + "\"", of_nav2,
                                  "a: {footprint: []}\nb: {footprint: " + corners + "}\n"}) {
    const FootprintVehicle made = around(text);
    EXPECT_EQ(made.vehicle.rear_overhang, 0.1) << text;
    EXPECT_EQ(made.vehicle.front_overhang, 0.1);
    EXPECT_EQ(made.vehicle.width, 0.5);
    EXPECT_EQ(made.vehicle.min_turning_radius, 0.5);
    EXPECT_NEAR(made.footprint_area, 0.2125, 1e-12);
    EXPECT_NEAR(made.added_area, 0.0375, 1e-12);
    EXPECT_NEAR(made.added_width, 0.05, 1e-12);
  }
  const Vehicle moved = around(corners, 0.3, 0.05).vehicle;  // the axle is 5 cm ahead of the origin
  EXPECT_EQ(moved.rear_overhang, 0.15);
  EXPECT_EQ(moved.front_overhang, 0.05);
}

TEST_F(FilesOfVehicles, AConvexFootprintIsTheOutline) {
  const FootprintVehicle made = around(corners, 0.3, 0.05, false);
  EXPECT_EQ(made.vehicle.outline,
            (Polygon{{0.35, 0.2}, {0.35, -0.2}, {-0.15, -0.2}, {-0.15, 0.25}}));
  EXPECT_EQ(made.vehicle.rear_overhang, 0.15);
  EXPECT_EQ(made.added_area, 0);
  const std::string concave = "[[0.4, 0.2], [0.4, -0.2], [-0.1, -0.2], [0.1, 0], [-0.1, 0.2]]";
  EXPECT_TRUE(around(concave, 0.3, 0, false).vehicle.outline.empty());
  EXPECT_NEAR(around(concave, 0.3, 0, false).added_area, 0.04, 1e-12);
  const std::string box = "[[0.4, 0.2], [0.4, -0.2], [-0.1, -0.2], [-0.1, 0.2]]";
  EXPECT_TRUE(around(box, 0.3, 0, false).vehicle.outline.empty());
}

TEST_F(FilesOfVehicles, FootprintsThatCannotBeUsedHaveOneLineEach) {
  EXPECT_EQ(refusal("a: 1\n"),
            "a.yaml:1: has no footprint, expected a key of that name with corners");
  EXPECT_EQ(refusal("a:\n  footprint: \"[[1, 2], [3, x], [0, 0]]\"\n"),
            "a.yaml:2: a.footprint: [1][1]: is \"x\", expected a number");
  EXPECT_EQ(refusal("[[1, 2], [3, 4]]"), "a.yaml:1: has 2 corners, expected at least 3");
  EXPECT_EQ(refusal("a: {footprint: " + corners + "}\nb: {footprint: [[1, 0], [0, 1], [0, 0]]}\n"),
            "a.yaml:2: b.footprint: is another footprint than that on line 1, expected one; put it "
            "into a file of its own");
  EXPECT_EQ(refusal(corners, 0.5),
            "a.yaml: has a footprint with x from -0.1 to 0.4 m, but axles at 0 "
            "and 0.5 m, expected them within it");
  EXPECT_EQ(refusal(corners, -1), "a.yaml: vehicle.wheelbase: is -1, expected more than 0 m");
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/freespace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/place_of_error.h"

namespace vandplan::ros {
namespace {

constexpr FreespaceVehicle car{
    .length = 4.9, .width = 2.0, .base_length = 2.8, .max_steering = 0.6, .base2back = 1.1};

TEST(RosFreespace, AShapeIsAVehicle) {
  const Vehicle vehicle = vehicle_of(car, 0.5);
  EXPECT_EQ(vehicle.wheelbase, 2.8);
  EXPECT_NEAR(vehicle.front_overhang, 1.0, 1e-12);
  EXPECT_EQ(vehicle.rear_overhang, 1.1);
  EXPECT_EQ(vehicle.width, 2.0);
  EXPECT_NEAR(vehicle.min_turning_radius, 2.8 / std::tan(0.3), 1e-12);
  FreespaceVehicle wrong = car;
  wrong.width = 0.0;
  EXPECT_EQ(place_of_error([&] { (void)vehicle_of(wrong, 1); }), "vehicle.width");
  wrong = car;
  wrong.max_steering = 0.0;
  EXPECT_EQ(place_of_error([&] { (void)vehicle_of(wrong, 1); }), "max_steering_angle");
  wrong = car;
  wrong.length = 3.0;  // shorter than from its rear to the front axle
  EXPECT_EQ(vehicle_of(wrong, 1).front_overhang, 0.0);
}

TEST(RosFreespace, ParametersOfAutowareAreOptions) {
  const Request request = request_of({.time_limit = 1500,
                                      .reverse_weight = 3,
                                      .direction_change_weight = 4,
                                      .lateral_goal_range = 0.5,
                                      .longitudinal_goal_range = 2,
                                      .angle_goal_range = 12,
                                      .obstacle_threshold = 70},
                                     car);
  EXPECT_EQ(request.options.budget.time_limit, 1.0);
  EXPECT_EQ(request.patience, 0.5);
  EXPECT_EQ(request.options.cost.reverse_weight, 4.0) << "Autoware's is on top of the metre";
  EXPECT_EQ(request.options.cost.gear_change_cost, 4.0);
  EXPECT_EQ(request.slack.ahead, 1.0);
  EXPECT_EQ(request.slack.aside, 0.25);
  EXPECT_NEAR(request.slack.heading, 6 * std::numbers::pi / 180, 1e-12);
  EXPECT_EQ(request.cost_rule, (CostRule{.lethal_cost = 70, .allow_unknown = false}));
  const Request low = request_of({.reverse_weight = -0.5, .direction_change_weight = -1}, car);
  EXPECT_EQ(low.options.cost.reverse_weight, 1.0);
  EXPECT_EQ(low.options.cost.gear_change_cost, 0.0);
}

TEST(RosFreespace, AVehicleIsDescribedInEitherWay) {
  const struct {
    double wheel_base_m = 2.8, front_overhang_m = 9.0, rear_overhang_m = 1.1;
    double max_steer_angle_rad = 0.6, vehicle_length_m = 4.9, vehicle_width_m = 2.0;
  } info;
  const struct {
    double length = 4.9, width = 2.0, base_length = 2.8, max_steering = 0.6, base2back = 1.1;
  } shape;
  for (const FreespaceVehicle& made : {freespace_vehicle(info), freespace_vehicle(shape)}) {
    EXPECT_EQ(made.length, 4.9);
    EXPECT_EQ(made.width, 2.0);
    EXPECT_EQ(made.base_length, 2.8);
    EXPECT_EQ(made.max_steering, 0.6);
    EXPECT_EQ(made.base2back, 1.1);
  }
}

TEST(RosFreespace, TheTimeLimitIsForTheFirstPath) {
  const Request usual = request_of({}, car);
  EXPECT_EQ(usual.options.budget.time_limit, 1.0);
  EXPECT_EQ(usual.patience, 29.0);
  const Request hasty = request_of({.time_limit = 300}, car);
  EXPECT_EQ(hasty.options.budget.time_limit, 0.3);
  EXPECT_EQ(hasty.patience, 0.0);
  const Request own = request_of({}, car, {{"time_limit", 5.0}});
  EXPECT_EQ(own.options.budget.time_limit, 5.0);
  EXPECT_EQ(own.patience, 0.0);
}

TEST(RosFreespace, OwnValuesTakePrecedence) {
  const Request request = request_of({}, car,
                                     {{"reverse_weight", 5.0},
                                      {"margin", 0.2},
                                      {"max_steering_rate", 0.7},
                                      {"goal_heading_mode", std::string("BIDIRECTIONAL")}});
  EXPECT_EQ(request.options.cost.reverse_weight, 5.0);
  EXPECT_EQ(request.options.clearance.margin, 0.2);
  EXPECT_EQ(request.vehicle.limits.max_steering_rate, 0.7);
  EXPECT_EQ(request.heading, GoalHeading::either_way);
  const Request fastest = request_of({}, car, {{"cost", std::string("time")}});
  EXPECT_EQ(fastest.options.cost.measure, CostMeasure::time);
  EXPECT_FALSE(fastest.options.cost.reverse_weight) << "no price counts";
  EXPECT_EQ(place_of_error([] { (void)request_of({}, car, {{"speed", 1.0}}); }), "speed");
  EXPECT_EQ(place_of_error([] { (void)request_of({.time_limit = -1}, car); }), "time_limit");
  EXPECT_EQ(place_of_error([] { (void)request_of({.obstacle_threshold = 0}, car); }),
            "lethal_cost");
}

TEST(RosFreespace, WaypointsRepeatThePoseWhereTheGearChanges) {
  using enum Gear;
  const PathPose poses[] = {{{0, 0, 0}, reverse, 0, false},
                            {{-1, 0, 0}, forward, 0, true},
                            {{0, 1, 0}, forward, 0, false}};
  const auto waypoints = waypoints_of(poses);
  ASSERT_EQ(waypoints.size(), 4U);
  const bool is_back[] = {true, true, false, false};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(waypoints[i].is_back, is_back[i]) << i;
  EXPECT_EQ(waypoints[1].pose, waypoints[2].pose);
  EXPECT_TRUE(waypoints_of({}).empty());
}

}  // namespace
}  // namespace vandplan::ros

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/robot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ros/yard.h"
#include "support/cases.h"
#include "support/place_of_error.h"

namespace vandplan::ros {
namespace {

std::string wrong_part(const Robot& robot, const Chassis& chassis = {}) {
  return place_of_error([&] { (void)vehicle_of(robot, chassis); });
}

TEST(RosRobot, ARectangleIsOneOfLengths) {
  const Vehicle vehicle = vehicle_of(small_robot(), {.wheelbase = 0.4});
  EXPECT_TRUE(vehicle.outline.empty());
  EXPECT_EQ(vehicle.wheelbase, 0.4);
  EXPECT_EQ(vehicle.front_overhang, 0.1);
  EXPECT_EQ(vehicle.rear_overhang, 0.1);
  EXPECT_EQ(vehicle.width, 0.4);
  EXPECT_EQ(vehicle.min_turning_radius, 0.4);
  EXPECT_EQ(vehicle_of(small_robot(), {}).wheelbase, 0.5) << "to the front of the body";
}

TEST(RosRobot, TheRearAxleMovesTheBody) {
  const Vehicle vehicle = vehicle_of(small_robot(), {.wheelbase = 0.3, .rear_axle = 0.1});
  EXPECT_EQ(vehicle.rear_overhang, 0.2);
  EXPECT_EQ(vehicle.front_overhang, 0.1);
}

TEST(RosRobot, OtherBodiesKeepTheirOutline) {
  const Robot uneven{.footprint = {{0.5, 0.3}, {-0.1, 0.3}, {-0.1, -0.2}, {0.5, -0.2}}};
  EXPECT_EQ(vehicle_of(uneven, {}).outline, uneven.footprint);
  EXPECT_EQ(vehicle_of(uneven, {}).width, 0.6);
  const Robot narrow{.footprint = {{0.5, 0.1}, {-0.1, 0.2}, {-0.1, -0.2}, {0.5, -0.1}}};
  EXPECT_EQ(vehicle_of(narrow, {}).outline, narrow.footprint);
  const Vehicle long_wheels = vehicle_of(small_robot(), {.wheelbase = 0.7});
  EXPECT_EQ(long_wheels.outline, small_robot().footprint) << "wheels beyond the body";
  EXPECT_EQ(long_wheels.front_overhang, -0.2);
}

TEST(RosRobot, ABodyThatIsNotConvexGetsItsHull) {
  const Robot arrow{.footprint = {{0.5, 0}, {-0.2, 0.3}, {-0.1, 0}, {-0.2, -0.3}}};
  const Polygon hull = vehicle_of(arrow, {}).outline;
  EXPECT_EQ(hull, (Polygon{{-0.2, -0.3}, {0.5, 0}, {-0.2, 0.3}}));
}

TEST(RosRobot, AHullHoldsAllCorners) {
  for_each_case(5, 2000, [](Rng& rng) {
    Robot robot;
    const auto corners = static_cast<int>(uniform(3, 12, rng));
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * 3.14159 * i / corners;
      const double radius = uniform(0.1, 1, rng);
      robot.footprint.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const Polygon hull = vehicle_of(robot, {.wheelbase = 0.1}).outline;
    ASSERT_TRUE(is_convex(hull));
    for (const Point& corner : robot.footprint) {
      for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point& a = hull[i];
        const Point& b = hull[(i + 1) % hull.size()];
        ASSERT_GE((b.x - a.x) * (corner.y - a.y) - (b.y - a.y) * (corner.x - a.x), -1e-8);
      }
    }
  });
}

TEST(RosRobot, ARoundBodyLiesInsideOfItsPolygon) {
  const Vehicle vehicle = vehicle_of({.radius = 0.3}, {});
  ASSERT_EQ(vehicle.outline.size(), 16U);
  EXPECT_TRUE(is_convex(vehicle.outline));
  EXPECT_NEAR(inner_radius(vehicle), 0.3, 1e-8);
  for (const Point& corner : vehicle.outline) EXPECT_LT(std::hypot(corner.x, corner.y), 0.306);
}

TEST(RosRobot, AWrongBodyIsRefused) {
  EXPECT_EQ(wrong_part({}), "footprint");
  EXPECT_EQ(wrong_part({.footprint = {{1, 0}, {0, 1}}}), "footprint");
  EXPECT_EQ(wrong_part({.footprint = {{1, 0}, {0, 1}, {NAN, 0}}}), "footprint");
  EXPECT_EQ(wrong_part({.footprint = {{1, 0}, {0, 1}, {0, -HUGE_VAL}}}), "footprint");
  EXPECT_EQ(wrong_part({.footprint = {{-1, -1}, {0, 0}, {1, 1}}}), "footprint") << "no area";
  EXPECT_EQ(wrong_part({.footprint = {{2, 1}, {1, 1}, {1, -1}, {2, -1}}}), "footprint") << "ahead";
  EXPECT_EQ(wrong_part({.footprint = {{1, 2}, {-1, 2}, {-1, 1}, {1, 1}}}), "footprint") << "aside";
  EXPECT_EQ(wrong_part({.radius = 0.0}), "footprint");
  EXPECT_EQ(wrong_part({.radius = NAN}), "footprint");
  EXPECT_EQ(wrong_part(small_robot(), {.rear_axle = 0.6}), "wheelbase");
  EXPECT_EQ(wrong_part(small_robot(), {.wheelbase = -1.0}), "wheelbase");
  EXPECT_EQ(wrong_part(small_robot(), {.min_turning_radius = 0.0}), "vehicle.min_turning_radius");
}

}  // namespace
}  // namespace vandplan::ros

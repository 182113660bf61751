// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vandplan {
namespace {

const Vehicle truck{.wheelbase = 4,
                    .front_overhang = 1,
                    .rear_overhang = 2,
                    .width = 3,
                    .min_turning_radius = 7,
                    .track_width = 2.5};

TEST(Vehicle, AnOutlineTakesThePlaceOfTheLengths) {
  Vehicle lift = truck;
  lift.outline = {{-1, 1}, {4, 0.5}, {4, -1.2}, {-1, -1}};  // clockwise
  EXPECT_EQ(footprint(lift), (Footprint{.rear = 1, .front = 4, .half_width = 1.2}));
  EXPECT_EQ(body_outline(lift), (Polygon{{-1, -1}, {4, -1.2}, {4, 0.5}, {-1, 1}}));
  EXPECT_NEAR(inner_radius(lift), 0.9 / std::hypot(1, 0.1), 1e-12);
  EXPECT_FALSE(same_lengths(truck, lift));
  EXPECT_EQ(body_outline(truck), (Polygon{{-2, -1.5}, {5, -1.5}, {5, 1.5}, {-2, 1.5}}));
  Trailer drawbar{.wheelbase = 5, .front_overhang = -2, .rear_overhang = 3, .width = 2};
  EXPECT_EQ(footprint(drawbar), (Footprint{.rear = 3, .front = 3, .half_width = 1}));
  drawbar.outline = {{2, 0}, {-1, 0.5}, {-1, -0.5}};
  EXPECT_EQ(footprint(drawbar), (Footprint{.rear = 1, .front = 2, .half_width = 0.5}));
}

TEST(Vehicle, ItsOutlineCountsFromTheRearAxle) {
  EXPECT_EQ(footprint(truck), (Footprint{.rear = 2, .front = 5, .half_width = 1.5}));
}

TEST(Vehicle, ItsWheelsReachFromAxleToAxle) {
  EXPECT_EQ(wheel_footprint(truck), (Footprint{.rear = 0, .front = 4, .half_width = 1.25}));
  Vehicle plain = truck;
  plain.track_width.reset();
  EXPECT_EQ(wheel_footprint(plain).half_width, 1.5);
}

TEST(Vehicle, ItsCornersAreCounterClockwiseFromTheRearRight) {
  const auto [a, b, c, d] = corners(footprint(truck), {10, 20, std::numbers::pi / 2});
  const auto expect_at = [](const Point& p, double x, double y) {
    EXPECT_NEAR(p.x, x, 1e-12);
    EXPECT_NEAR(p.y, y, 1e-12);
  };
  expect_at(a, 11.5, 18);
  expect_at(b, 11.5, 25);
  expect_at(c, 8.5, 25);
  expect_at(d, 8.5, 18);
}

// Whatever is nearest to the axle: a side, the rear or the front.
TEST(Vehicle, TheInnerRadiusIsTheLeastDistanceToTheOutline) {
  EXPECT_EQ(inner_radius(Footprint{.rear = 2, .front = 5, .half_width = 1.5}), 1.5);
  EXPECT_EQ(inner_radius(Footprint{.rear = 0.2, .front = 5, .half_width = 1.5}), 0.2);
  EXPECT_EQ(inner_radius(Footprint{.rear = 2, .front = 0.7, .half_width = 1.5}), 0.7);
  EXPECT_EQ(inner_radius(Footprint{.rear = 0, .front = 5, .half_width = 1.5}), 0);
}

}  // namespace
}  // namespace vandplan

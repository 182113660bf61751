// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/convex.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/cases.h"
#include "support/collision_oracle.h"
#include "support/draws.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using geometry::counter_clockwise, geometry::signed_distance;

TEST(Convex, OrientationAndShape) {
  const Polygon square = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  EXPECT_EQ(counter_clockwise(square), square);
  EXPECT_EQ(counter_clockwise({{0, 1}, {2, 1}, {2, 0}, {0, 0}}), square);
  EXPECT_TRUE(is_convex(square));
  EXPECT_TRUE(is_convex(Polygon{{0, 0}, {1, 0}, {2, 0}, {2, 1}}));  // a corner on a side
  EXPECT_FALSE(is_convex(Polygon{{0, 0}, {2, 0}, {1, 0.1}, {0, 1}}));
}

TEST(Convex, DistancesArePositiveOutside) {
  const Polygon square = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  EXPECT_EQ(signed_distance(square, {5, 5}), 5);
  EXPECT_EQ(signed_distance(square, {0.5, 0.25}), -0.25);
  EXPECT_EQ(signed_distance(square, {2, 0.5}), 0);
  EXPECT_EQ(geometry::squared_distance(square, {3, -1}, {3, 4}), 1);
  EXPECT_EQ(geometry::squared_distance(square, {0.5, 0.5}, {0.5, 0.5}), 0);
  EXPECT_EQ(geometry::squared_distance(square, {-1, 0.5}, {9, 0.5}), 0);
}

TEST(ConvexLaw, TheDistanceOfASideIsThatOfTheOracle) {
  int apart = 0;
  int met = 0;
  for_each_case(1, 20000, [&](Rng& rng) {
    const Polygon body = body_outline(any_body(rng));
    const auto any_point = [&] { return Point{uniform(-9, 9, rng), uniform(-9, 9, rng)}; };
    const std::array<Point, 2> side = {any_point(), any_point()};
    const double distance = std::sqrt(geometry::squared_distance(body, side[0], side[1]));
    EXPECT_NEAR(distance, gap_between(body, side).distance, 1e-12) << as_code(body);
    distance > 0 ? ++apart : ++met;
  });
  EXPECT_GT(apart, cases(2000));
  EXPECT_GT(met, cases(2000));
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/collision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../support/problems.h"

namespace vandplan {
namespace {

using std::numbers::pi;
constexpr Bounds wide{-100, 100, -100, 100};
// x from -1 to 4, y from -1 to 1.
constexpr Footprint body{.rear = 1, .front = 4, .half_width = 1};

CollisionChecker among(const std::vector<Polygon>& obstacles) { return {body, wide, obstacles}; }

TEST(Collision, NothingIsHitInAnEmptyWorld) {
  EXPECT_TRUE(among({}).is_free(LocalPose({0, 0, 0})));
  EXPECT_TRUE(among({}).is_free(LocalPose({0, 0, 0}), Segment{0.1, 300}));
}

TEST(Collision, AVehicleWhollyInsideAnObstacleCollides) {
  const auto checker = among({box(-20, -20, 20, 20)});
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0.3})));
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0.3}), Segment{0, 1}));
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0.3}), Segment{0.1, -1}));
}

TEST(Collision, AnObstacleWhollyInsideTheFootprintCollides) {
  const auto checker = among({box(1, -0.1, 1.2, 0.1)});
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0})));
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), Segment{0, 1}));
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), Segment{-0.1, 1}));
}

TEST(Collision, AnObstacleWhollyInsideTheSweptAreaCollides) {
  const auto checker = among({box(29.9, -0.1, 30.1, 0.1)});
  EXPECT_TRUE(checker.is_free(LocalPose({0, 0, 0})));
  EXPECT_TRUE(checker.is_free(LocalPose({60, 0, 0})));
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), Segment{0, 60}));
  EXPECT_FALSE(checker.is_free(LocalPose({60, 0, 0}), Segment{0, -60}));
}

TEST(Collision, TouchingIsAHitAndTwoMillimetresAreNot) {
  // The left side of the body is at y = 1.
  EXPECT_FALSE(among({box(-10, 1.0, 30, 2)}).is_free(LocalPose({0, 0, 0}), Segment{0, 20}));
  EXPECT_FALSE(among({box(-10, 1.0001, 30, 2)}).is_free(LocalPose({0, 0, 0}), Segment{0, 20}));
  EXPECT_TRUE(among({box(-10, 1.002, 30, 2)}).is_free(LocalPose({0, 0, 0}), Segment{0, 20}));
}

TEST(Collision, DrivingUpToAWallEndsTwoMillimetresBeforeIt) {
  const auto checker = among({box(10, -5, 11, 5)});  // the front is at x + 4
  EXPECT_TRUE(checker.is_free(LocalPose({0, 0, 0}), Segment{0, 5.998}));
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), Segment{0, 6.0}));
  EXPECT_TRUE(checker.is_free(LocalPose({12.002, 0, 0}), Segment{0, 10}));
  EXPECT_FALSE(checker.is_free(LocalPose({12.1, 0, 0}), Segment{0, -0.1}));
}

TEST(Collision, TheOuterFrontCornerSwingsWiderThanTheRearAxle) {
  // Heading -90 degrees and turning left about (6, 0): the outer front corner, 4 m ahead and 1 m to
  // the right, runs on a circle of radius hypot(4, 7) and passes its lowest point.
  const double outer = std::hypot(4, 7);
  const Pose from{0, 0, -pi / 2};
  const Segment half_turn{1.0 / 6, pi * 6};
  EXPECT_FALSE(among({box(-5, -outer - 2, 20, -outer)}).is_free(Local(from), half_turn));
  EXPECT_FALSE(among({box(-5, -outer - 2, 20, -outer - 0.0001)}).is_free(Local(from), half_turn));
  EXPECT_TRUE(among({box(-5, -outer - 2, 20, -outer - 0.002)}).is_free(Local(from), half_turn));
}

TEST(Collision, TheInnerSideLeavesADiscAroundTheTurningCentre) {
  // Turning left about (0, 6), the inner side stays 5 m from the centre.
  const Segment turn{1.0 / 6, 2 * pi * 6};
  const auto square = [](double r) {  // with a corner at distance r below the centre
    return Polygon{{0, 6 - r}, {1, 6}, {0, 7}, {-1, 6}};
  };
  EXPECT_TRUE(among({square(4.998)}).is_free(LocalPose({0, 0, 0}), turn));
  EXPECT_FALSE(among({square(4.9999)}).is_free(LocalPose({0, 0, 0}), turn));
}

TEST(Collision, TheTailSwingsOutBehindTheRearAxle) {
  // Turning left about (0, 6): the outer rear corner (-1, -1) swings to y = 6 - sqrt(1 + 49).
  const double lowest = 6 - std::sqrt(50.0);
  const Segment turn{1.0 / 6, 1.5};
  EXPECT_FALSE(among({box(-3, -3, 0.5, lowest + 0.0001)}).is_free(LocalPose({0, 0, 0}), turn));
  EXPECT_TRUE(among({box(-3, -3, 0.5, lowest - 0.002)}).is_free(LocalPose({0, 0, 0}), turn));
}

TEST(Collision, ACornerClippedBetweenPosesATenthOfAMetreApartIsAHit) {
  // The tip of the triangle reaches 0.1 mm into the strip that the front right corner sweeps in
  // the middle of a step; at both ends of the step the body is clear of it.
  const double outer = std::hypot(4, 7);
  const double angle = -0.4;  // of the tip, seen from the turning centre (0, 6)
  const auto at = [&](double r, double a) { return Point{r * std::cos(a), 6 + r * std::sin(a)}; };
  const auto checker = among({{at(outer - 0.0001, angle), at(12, angle - 0.2), at(12, angle)}});
  const double corner = std::atan2(-7, 4);
  const double middle = (angle - corner) * 6;  // driven when the corner passes the tip
  const Pose before = advance({0, 0, 0}, {1.0 / 6, middle - 0.05});
  EXPECT_TRUE(checker.is_free(Local(before)));
  EXPECT_TRUE(checker.is_free(Local(advance(before, {1.0 / 6, 0.1}))));
  EXPECT_FALSE(checker.is_free(Local(before), Segment{1.0 / 6, 0.1}));
}

TEST(Collision, ATurnOfMoreThanACircleSeesWhatLiesJustBehind) {
  const auto checker = among({box(-2.2, -1, -1.2, 1)});
  const double circle = 2 * pi * 6;
  EXPECT_TRUE(checker.is_free(LocalPose({0, 0, 0}), Segment{1.0 / 6, circle / 2}));
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), Segment{1.0 / 6, circle}));
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), Segment{1.0 / 6, 2.5 * circle}));
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), Segment{1.0 / 6, -2.5 * circle}));
  EXPECT_TRUE(
      among({box(-1, 5, 1, 7)}).is_free(LocalPose({0, 0, 0}), Segment{1.0 / 6, 7.3 * circle}));
}

TEST(Collision, ATurningCentreInsideTheFootprintSweepsADisc) {
  // Radius 0.5 m: the centre (0, 0.5) is in the body, whose far corner is hypot(4, 1.5) away.
  const double far = std::hypot(4, 1.5);
  const Segment turn{2, 2 * pi * 0.5};
  EXPECT_TRUE(among({box(-8, -1, -far - 0.002, 1)}).is_free(LocalPose({0, 0, 0}), turn));
  EXPECT_FALSE(among({box(-8, -1, -far + 0.01, 1)}).is_free(LocalPose({0, 0, 0}), turn));
  EXPECT_FALSE(among({box(-4, 0.4, -3.9, 0.6)}).is_free(LocalPose({0, 0, 0}), turn));
}

// Ten metres ahead the wheels reach from x = 10 to 14.5, the body from 8.4 to 15.9.
TEST(Collision, KerbsAreForWheelsAndWallsForBodies) {
  const auto is_free = [](const Surroundings& surroundings) {
    return CollisionChecker(Vehicle{.track_width = 2.2}, surroundings)
        .is_free(LocalPose({0, 0, 0}), {0, 10});
  };
  const Bounds bounds{-100, 100, -100, 100};
  for (const Polygon& over : {box(15, -1, 17, 1), box(-3, -1, -0.1, 1), box(5, 1.15, 8, 3)}) {
    EXPECT_TRUE(is_free({.bounds = bounds, .kerbs = {over}}));
    EXPECT_FALSE(is_free({.bounds = bounds, .obstacles = {over}}));
  }
  for (const Polygon& under : {box(14, -1, 17, 1), box(5, 1.05, 8, 3), box(-30, -30, 30, 30)}) {
    EXPECT_FALSE(is_free({.bounds = bounds, .kerbs = {under}}));
  }
}

TEST(Collision, NearlyStraightArcsAreArcs) {
  // After 200 m at curvature 1e-5 the body is 0.2 m to the left and turned by 2 mrad.
  const Segment arc{1e-5, 200};
  const CollisionChecker left{body, {-300, 300, -300, 300}, {{box(195, 1.15, 204, 2)}}};
  EXPECT_FALSE(left.is_free(LocalPose({0, 0, 0}), arc));
  EXPECT_TRUE(left.is_free(LocalPose({0, 0, 0}), Segment{0, 200}));
  EXPECT_TRUE(left.is_free(LocalPose({0, 0, 0}), Segment{-1e-5, 200}));
  for (const double curvature : {1e-7, 1e-9, 1e-12, -1e-9, 1e-300}) {
    const CollisionChecker checker{body, {-300, 300, -300, 300}, {{box(100, 1.004, 204, 2)}}};
    EXPECT_TRUE(checker.is_free(LocalPose({0, 0, 0}), Segment{curvature, 200})) << curvature;
    const CollisionChecker touched{body, {-300, 300, -300, 300}, {{box(100, 0.998, 204, 2)}}};
    EXPECT_FALSE(touched.is_free(LocalPose({0, 0, 0}), Segment{curvature, 200})) << curvature;
  }
}

TEST(Collision, AConcaveObstacleIsFreeInItsPocket) {
  // A U open to the right: its pocket is x > 0, -2 < y < 2.
  Polygon pocket{{-5, -5}, {20, -5}, {20, -2}, {-2, -2}, {-2, 2}, {20, 2}, {20, 5}, {-5, 5}};
  for (int orientation = 0; orientation < 2; ++orientation) {
    const auto checker = among({pocket});
    EXPECT_TRUE(checker.is_free(LocalPose({0, 0, 0})));
    EXPECT_TRUE(checker.is_free(LocalPose({0, 0, 0}), Segment{0, 30}));
    EXPECT_FALSE(checker.is_free(LocalPose({0, 0, pi / 2})));
    EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), Segment{0, -1.5}));
    EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), Segment{0.2, 4}));
    EXPECT_FALSE(checker.is_free(LocalPose({-3.5, -3.5, 0})));
    std::reverse(pocket.begin(), pocket.end());
  }
}

TEST(Collision, ASliverOfAMillimetreIsSeen) {
  const auto checker = among({box(30, -50, 30.001, 50)});
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), Segment{0, 60}));
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), Segment{0.01, 60}));
}

TEST(Collision, TheRearAxleMayTouchTheBoundsAndTheBodyMayHangOver) {
  const CollisionChecker checker{body, {0, 10, 0, 10}, {}};
  EXPECT_TRUE(checker.is_free(LocalPose({0, 0, 0})));
  EXPECT_TRUE(checker.is_free(LocalPose({10, 10, 0})));
  EXPECT_FALSE(checker.is_free(LocalPose({10.001, 5, 0})));
  EXPECT_TRUE(checker.is_free(LocalPose({0, 5, 0}), Segment{0, 10}));
  EXPECT_FALSE(checker.is_free(LocalPose({0, 5, 0}), Segment{0, 10.001}));
}

TEST(Collision, TheBulgeOfAnArcCountsForTheBounds) {
  // Left turn of radius 3 about (5, 5): starts and ends at x = 5, reaches x = 8 between.
  const Segment half_turn{1.0 / 3, pi * 3};
  const auto within = [&](double x_max) { return CollisionChecker{body, {0, x_max, 0, 20}, {}}; };
  EXPECT_TRUE(within(8.001).is_free(LocalPose({5, 2, 0}), half_turn));
  EXPECT_FALSE(within(7.999).is_free(LocalPose({5, 2, 0}), half_turn));
  EXPECT_TRUE(within(7.999).is_free(LocalPose({5, 2, 0}), Segment{1.0 / 3, 3}));
  EXPECT_FALSE(within(7.999).is_free(LocalPose({5, 8, 0}), Segment{-1.0 / 3, pi * 3}));
  EXPECT_FALSE(within(7.999).is_free(LocalPose({5, 8, pi}), Segment{1.0 / 3, -pi * 3}));
  // More than a circle reaches every side of it: y from 2 to 8, x from 2 to 8.
  const CollisionChecker tight{body, {1.999, 8.001, 1.999, 8.001}, {}};
  EXPECT_TRUE(tight.is_free(LocalPose({5, 2, 0}), Segment{1.0 / 3, 30}));
  const CollisionChecker cut{body, {2.001, 9, 1, 9}, {}};
  EXPECT_FALSE(cut.is_free(LocalPose({5, 2, 0}), Segment{1.0 / 3, 30}));
}

TEST(Collision, AnEdgeIsFreeIfAllItsSegmentsAre) {
  const auto checker = among({box(20, -2, 22, 2)});
  const Segment up_to_it[] = {{0, 10}, {0, -5}, {0.1, 3}};
  EXPECT_TRUE(checker.is_free(LocalPose({0, 0, 0}), up_to_it));
  const Segment through_it[] = {{0, 10}, {0, -5}, {0, 40}, {0.1, 3}};
  EXPECT_FALSE(checker.is_free(LocalPose({0, 0, 0}), through_it));
  EXPECT_TRUE(checker.is_free(LocalPose({0, 0, 0}), std::span<const Segment>{}));
  EXPECT_FALSE(checker.is_free(LocalPose({20, 0, 0}), std::span<const Segment>{}));
}

// ---- Clothoids ----

TEST(CollisionOfClothoids, TheyAreSweptAsTheyAreDriven) {
  // From straight ahead to a radius of 5 m within 10 m: at the end the heading is 1 rad.
  const Segment bend{0, 10, 0.02};
  const Pose end = advance({0, 0, 0}, bend);
  EXPECT_NEAR(end.heading, 1, 1e-15);
  EXPECT_TRUE(among({}).is_free(LocalPose({0, 0, 0}), bend));
  // A thorn that points at the front, where that is at the end.
  const auto thorn = [&](double ahead) {
    Polygon polygon;
    for (const Point& p : {Point{4 + ahead, 0.5}, Point{5, -0.5}, Point{5, 1.5}}) {
      const Pose at = compose(end, {p.x, p.y, 0});
      polygon.push_back({at.x, at.y});
    }
    return polygon;
  };
  EXPECT_FALSE(among({thorn(-1e-4)}).is_free(LocalPose({0, 0, 0}), bend));
  EXPECT_TRUE(among({thorn(1.1e-3)}).is_free(LocalPose({0, 0, 0}), bend));
  // The way goes on from where the clothoid ends.
  const Segment on[] = {bend, {0, 0.5}};
  EXPECT_FALSE(among({thorn(0.3)}).is_free(LocalPose({0, 0, 0}), on));
  EXPECT_TRUE(among({thorn(0.3)}).is_free(LocalPose({0, 0, 0}), bend));
}

TEST(CollisionOfClothoids, TheAxleIsHeldToTheBoundsOnThemNotOnArcs) {
  // Through the unit spiral's northernmost place, where it has turned by half a turn.
  const Segment spiral{0, 3, pi};
  const Pose top = advance({0, 0, 0}, {0, std::sqrt(2.0), pi});
  const Bounds around{-10, 10, -10, 10};
  const auto below = [&](double y_max) {
    Bounds bounds = around;
    bounds.y_max = y_max;
    return CollisionChecker(body, bounds, {}).is_free(LocalPose({0, 0, 0}), spiral);
  };
  EXPECT_TRUE(below(top.y + 1e-12));
  EXPECT_FALSE(below(top.y - 1e-12));
}

TEST(CollisionOfClothoids, WhatWindsWithoutEndIsNotAccepted) {
  for (const Segment& segment : {Segment{0, 1, 1e300}, Segment{0, 1e300, 1e-300},
                                 Segment{1e300, -1e300, 1}, Segment{0, 1, std::nan("")}}) {
    EXPECT_FALSE(among({}).is_free(LocalPose({0, 0, 0}), segment));
  }
  EXPECT_TRUE(among({}).is_free(LocalPose({0, 0, 0}), Segment{0, 0, 1}));
}

}  // namespace
}  // namespace vandplan

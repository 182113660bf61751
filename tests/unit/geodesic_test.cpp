// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geodesic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../support/cases.h"
#include "../support/problems.h"

namespace vandplan {
namespace {

constexpr double disc = 1.275;  // [m] half the width of the default truck

double bound_of(const Problem& problem) {
  Geodesic geodesic(*problem.world, problem.start, problem.goal);
  while (geodesic.step()) {
  }
  return geodesic.bound();
}

TEST(Geodesic, IsTheDistanceWhereNothingIsInTheWay) {
  EXPECT_DOUBLE_EQ(bound_of(problem_of({0, 0, 0}, {30, 40, 0}, {})), 50.0);
  EXPECT_DOUBLE_EQ(bound_of(problem_of({0, 0, 0}, {30, 0, 0}, {box(10, 3, 20, 5)})), 30.0);
}

// A disc around a wall with corners (14, 8) and (16, 8): two tangents, two arcs, the top.
TEST(Geodesic, IsJustBelowTheWayOfADiscAroundAWall) {
  const double corner = std::hypot(14, 8);
  const double tangent = std::sqrt(corner * corner - disc * disc);
  const double slope = std::atan2(8, 14) + std::asin(disc / corner);
  const double way = 2 * (tangent + disc * slope) + 2;
  const double bound = bound_of(problem_of({0, 0, 0}, {30, 0, 0}, {box(14, -8, 16, 8)}));
  EXPECT_LE(bound, way);
  EXPECT_GT(bound, 0.995 * way);
}

// 2.4 m between two walls: too narrow for the disc, which has to go around one of them.
TEST(Geodesic, DoesNotPassAGapThatIsTooNarrow) {
  const std::vector<Polygon> walls = {box(14, -30, 16, -1.2), box(14, 1.2, 16, 30)};
  EXPECT_GT(bound_of(problem_of({0, 0, 0}, {30, 0, 0}, walls)), 60.0);
}

TEST(Geodesic, PassesAGapThatIsWideEnough) {
  const std::vector<Polygon> walls = {box(14, -30, 16, -1.3), box(14, 1.3, 16, 30)};
  EXPECT_DOUBLE_EQ(bound_of(problem_of({0, 0, 0}, {30, 0, 0}, walls)), 30.0);
}

TEST(Geodesic, DoesNotSlipBetweenTwoSidesOfOneWall) {
  const std::vector<Polygon> wall = {
      {{14, -30}, {16, -30}, {16, 0}, {16, 30}, {14, 30}, {14, 0}}};  // corners in the middle, too
  EXPECT_GT(bound_of(problem_of({0, 0, 0}, {30, 0, 0}, wall)), 60.0);
}

// A way of points that keep their distance is never shorter than the bound.
TEST(Geodesic, NeverExceedsAWayThatKeepsItsDistance) {
  for_each_case(11, 200, [](Rng& rng) {
    std::vector<Polygon> boxes;
    for (int i = 0; i < 6; ++i) {
      const double x = uniform(5, 30, rng);
      const double y = uniform(-15, 15, rng);
      boxes.push_back(box(x, y, x + uniform(0.1, 6, rng), y + uniform(0.1, 6, rng)));
    }
    const Problem problem = problem_of({0, 0, 0}, {42, 0, 0}, boxes);
    const auto is_clear = [&](const Point& p, const Point& q) {
      for (double t = 0; t <= 1; t += 0.002) {
        const Point at{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
        for (const Polygon& b : boxes) {
          const double dx = std::max({b[0].x - at.x, at.x - b[2].x, 0.0});
          const double dy = std::max({b[0].y - at.y, at.y - b[2].y, 0.0});
          if (std::hypot(dx, dy) < disc) return false;
        }
      }
      return true;
    };
    const double bound = bound_of(problem);
    for (int i = 0; i < 20; ++i) {
      const Point via{uniform(0, 42, rng), uniform(-20, 20, rng)};
      if (!is_clear({0, 0}, via) || !is_clear(via, {42, 0})) continue;
      const double way = std::hypot(via.x, via.y) + std::hypot(42 - via.x, via.y);
      ASSERT_LE(bound, way + 1e-9) << as_code(via) << as_code(boxes);
    }
  });
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does the judge add up what being near things costs?

#include "judge/near_cost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/collision.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

constexpr CostOptions rule{
    .reverse_weight = 3.0, .clearance_weight = 2.0, .clearance_distance = 1.0};

double judged(const std::vector<Polygon>& obstacles, const Path& path) {
  const Surroundings surroundings{.obstacles = obstacles};
  const judge::Track track = judge::integrate(path);
  const judge::Ground ground(surroundings);
  const judge::Body body{track, ground, judge::outlines_of(Vehicle{})};
  const std::vector<judge::PricedPart> whole =
      judge::priced_parts(Surroundings{}, Vehicle{}, track, nullptr, judge::AtEdge::inside);
  return judge::near_cost({&body, 1}, rule, whole);
}

/// Slow and obvious: a place every two millimetres, seen by the checker of planners.
double added_up(const std::vector<Polygon>& obstacles, const Path& path) {
  const Bounds bounds{-1000, 1000, -1000, 1000};
  const CollisionChecker checker(Vehicle{}, {.bounds = bounds, .obstacles = obstacles});
  double sum = 0.0;
  Pose from = path.start;
  for (const Segment& segment : path.segments) {
    const double length = std::abs(segment.length);
    const auto count = static_cast<int>(length / 0.002) + 1;
    double near = 0.0;
    for (int i = 0; i < count; ++i) {
      const Segment driven = part_of(segment, 0.0, length * (i + 0.5) / count);
      const double clearance =
          checker.clearance(Local(advance(from, driven)), *rule.clearance_distance);
      near += std::max(0.0, 1 - clearance / *rule.clearance_distance) * length / count;
    }
    sum += near * (segment.length < 0 ? *rule.reverse_weight : 1.0);
    from = advance(from, segment);
  }
  return *rule.clearance_weight * sum;
}

// Far from everything in its middle, near at both ends: the middle tells of no more than it sees.
TEST(NearCost, CountsTheEndsOfAStretchThatIsFarFromEverythingInItsMiddle) {
  const Path path{{0, 0, 0}, {{0, 60}}};
  const std::vector<Polygon> obstacles{box(-2, 1.6, 3, 3), box(60, 1.6, 66, 3)};
  const double expected = added_up(obstacles, path);
  EXPECT_GT(expected, 4);
  EXPECT_NEAR(judged(obstacles, path), expected, 1e-3 * expected);
}

// Near in the last decimetre alone, from nothing at its beginning to a tenth: a triangle.
TEST(NearCost, IsExactWhereAHundredMetresComeNearAWallOnlyAtTheirEnd) {
  const Path path{{0, 0, 0}, {{0, 100}}};
  const Vehicle vehicle;
  const double wall = 100 + vehicle.wheelbase + vehicle.front_overhang + 0.9;
  EXPECT_NEAR(judged({box(wall, -3, wall + 1, 3)}, path), 2 * 0.1 * 0.1 / 2, 2e-4);
}

TEST(NearCost, IsNothingFarFromEverything) {
  const Path path{{0, 0, 0}, {{0, 60}}};
  EXPECT_EQ(judged({box(-2, 2.3, 66, 3)}, path), 0.0);
}

TEST(NearCost, IsWhatPlacesEveryTwoMillimetresAddUpTo) {
  for_each_case(18, 60, [](Rng& rng) {
    Path path{{0, 0, uniform(-3, 3, rng)}, {}};
    for (int i = 0; i < 4; ++i) {
      path.segments.push_back({uniform(-1.0 / 7, 1.0 / 7, rng), uniform(-12, 16, rng)});
    }
    std::vector<Polygon> obstacles;
    for (int i = 0; i < 12; ++i) {
      const double x = uniform(-25, 25, rng);
      const double y = uniform(-25, 25, rng);
      obstacles.push_back(box(x, y, x + uniform(0.1, 4, rng), y + uniform(0.1, 4, rng)));
    }
    const double expected = added_up(obstacles, path);
    EXPECT_NEAR(judged(obstacles, path), expected, 2e-3 * expected + 1e-3);
  });
}

}  // namespace
}  // namespace vandplan

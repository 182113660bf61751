// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What does a verdict cost? Counted, not timed: looks, what is measured at them, and what is
// remembered.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "judge/along.h"
#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using std::numbers::pi;

/// Buildings of 10 m, 30 m apart, in so many rows and columns around the origin.
std::vector<Polygon> yard(int columns) {
  std::vector<Polygon> polygons;
  for (int i = 0; i < columns * columns; ++i) {
    const double x = (i % columns - columns / 2) * 30.0;
    const double y = (i / columns - columns / 2) * 30.0;
    polygons.push_back(box(x - 5, y - 5, x + 5, y + 5));
  }
  return polygons;
}

/// Between two rows of buildings.
Path street(double length, int segments) {
  Path path{{-length / 2, 15, 0}, {}};
  for (int i = 0; i < segments; ++i) path.segments.push_back({0, length / segments});
  return path;
}

judge::Nearest judged(const std::vector<Polygon>& obstacles, const Path& path) {
  const Surroundings surroundings{.obstacles = obstacles};
  const judge::Track track = judge::integrate(path);
  const judge::Ground ground(surroundings);
  return judge::nearest_along({track, ground, judge::outlines_of(Vehicle{})});
}

TEST(CostOfAVerdict, GrowsWithTheLogarithmOfWhatStandsAround) {
  const Path path{{-15, 15, 0}, {{0, 8}, {1.0 / 7, 7 * pi / 2}, {0, 8}, {-1.0 / 7, 7 * pi / 2}}};
  const judge::Effort few = judged(yard(4), path).effort;
  const judge::Effort many = judged(yard(200), path).effort;
  EXPECT_LE(many.looks, 2 * few.looks);
  EXPECT_LE(many.visited, 8 * few.visited);
  EXPECT_LE(many.visited, 100 * many.looks);
}

TEST(CostOfAVerdict, RemembersPartsOfThePathWhateverStandsAround) {
  const Path path = street(1000, 500);
  const judge::Effort few = judged(yard(4), path).effort;
  const judge::Effort many = judged(yard(100), path).effort;
  EXPECT_GE(many.parts, 500U);
  EXPECT_LE(many.parts, 600U);
  EXPECT_LE(few.parts, 600U);
}

TEST(CostOfAVerdict, GrowsWithTheLengthOfThePathAtMost) {
  const std::vector<Polygon> obstacles = yard(200);
  const judge::Effort near = judged(obstacles, street(600, 20)).effort;
  const judge::Effort far = judged(obstacles, street(6000, 200)).effort;
  EXPECT_LE(far.visited, 15 * near.visited);
}

TEST(CostOfAVerdict, OfACollisionAtTheEndIsThatOfAGoodPath) {
  std::vector<Polygon> obstacles = yard(100);
  const Path path = street(2000, 50);
  const judge::Nearest good = judged(obstacles, path);
  EXPECT_NEAR(good.clearance, 10 - 1.275, 1e-3);
  obstacles.push_back(box(1005, 14, 1006, 16));
  const judge::Nearest bad = judged(obstacles, path);
  ASSERT_TRUE(bad.touch);
  EXPECT_LE(bad.effort.visited, 2 * good.effort.visited);
}

// Half a millimetre beside a wall of 100 km, and at last against a post. A walk of a millimetre at
// a time would take 10^8 looks.
TEST(CostOfAVerdict, IsSmallAlongAWallHoweverNearItIs) {
  const Path path{{0, 0, 0}, {{0, 1e5}}};
  std::vector<Polygon> obstacles = {box(-10, 1.2755, 1e5 + 10, 2)};
  EXPECT_LE(judged(obstacles, path).effort.looks, 100U);
  obstacles.push_back(box(1e5, -1, 1e5 + 1, 1));
  const judge::Nearest bad = judged(obstacles, path);
  ASSERT_TRUE(bad.touch);
  EXPECT_NEAR(static_cast<double>(bad.touch->t), 1e5 - 5.9, 1e-3);
  EXPECT_LE(bad.effort.looks, 1000U);
}

// A polygon of 10^5 corners, most of them on the other side: its sides are a tree, too.
TEST(CostOfAVerdict, GrowsWithTheLogarithmOfTheCornersOfAPolygon) {
  const auto wheel = [](int corners) {
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * pi * i / corners;
      const double reach = i % 2 == 0 ? 100 : 90;
      polygon.push_back({reach * std::cos(angle), reach * std::sin(angle)});
    }
    return polygon;
  };
  const Path path{{104, -20, pi / 2}, {{0, 40}}};
  const judge::Nearest few = judged({wheel(1000)}, path);
  const judge::Nearest many = judged({wheel(100000)}, path);
  EXPECT_NEAR(few.clearance, many.clearance, 0.1);
  EXPECT_LE(many.effort.visited, 20 * few.effort.visited);
  // And whoever stands in it is seen without looking at them all.
  const judge::Nearest inside = judged({wheel(100000)}, {{50, 0, 0}, {{0, 10}}});
  ASSERT_TRUE(inside.touch);
  EXPECT_LE(inside.effort.visited, 3000U);
}

// Needles side by side, slanted: no box around one of them is narrow.
TEST(CostOfAVerdict, IsSmallBesideSlantedNeedles) {
  std::vector<Polygon> needles;
  for (int i = 0; i < 2000; ++i) {
    const double x = 10 + i * 0.01;
    needles.push_back({{x, 0}, {x + 0.002, 0}, {x + 300, 300}});
  }
  // 7 m beside the first one, along it.
  const Path path{{100, 100, pi / 4}, {{0, 50}}};
  const judge::Effort effort = judged(needles, path).effort;
  EXPECT_LE(effort.visited, 400 * effort.looks);
}

// A fence of 3 km in every other street: few long things among many small ones.
TEST(CostOfAVerdict, IsSmallBetweenFencesThroughTheWholeYard) {
  std::vector<Polygon> obstacles = yard(100);
  const Path path = street(1000, 10);
  const judge::Effort without = judged(obstacles, path).effort;
  for (int i = -25; i < 25; ++i) {
    const double y = 15 + 60 * i + 30;
    obstacles.push_back(box(-1500, y, 1500, y + 0.1));
  }
  const judge::Effort with = judged(obstacles, path).effort;
  EXPECT_LE(with.visited * without.looks, 2 * without.visited * with.looks);
}

TEST(CostOfAVerdict, HasTheTreeMadeWhereThePathIsAndOnce) {
  const Surroundings surroundings{.obstacles = yard(200)};
  const judge::Ground ground(surroundings);
  const judge::Track track = judge::integrate(street(300, 10));
  const judge::Body body{track, ground, judge::outlines_of(Vehicle{})};
  const std::size_t made = judge::nearest_along(body).effort.made;
  EXPECT_GT(made, 20U);
  EXPECT_LE(made, 40000U / 40);
  EXPECT_EQ(judge::nearest_along(body).effort.made, 0U);
}

/// How much is measured at a look beside a wall through so many cells of 5 cm in a row and
/// column, where nothing further away than `most` is asked for.
std::size_t measured_beside_a_wall(std::int32_t cells, double half, double most) {
  const auto count = static_cast<std::size_t>(cells);
  std::vector<Cell> ground(count * count);
  constexpr std::ptrdiff_t row = 60;
  std::fill_n(ground.begin() + row * cells, count, Cell::occupied);
  const Surroundings surroundings{.map = OccupancyGrid{.origin = {-20, -5, 0},
                                                       .resolution = 0.05,
                                                       .columns = cells,
                                                       .rows = cells,
                                                       .cells = std::move(ground),
                                                       .unknown_is_free = true}};
  const judge::Outlines truck = judge::outlines_of(Vehicle{});
  const judge::View view = judge::view_of({{0, -8, 0.3}, -0.1, half});
  judge::Effort effort;
  (void)judge::Ground(surroundings).clearance(view, truck, most, effort);
  return effort.visited;
}

TEST(CostOfAVerdict, IsThatOfWhatIsNearOnALargeMap) {
  for (const double half : {0.0, 2.0}) {
    EXPECT_LE(measured_beside_a_wall(4096, half, 8), measured_beside_a_wall(1024, half, 8));
  }
}

TEST(CostOfAVerdict, IsSmallWhereAPassageIsNearerThanAnybodyAskedFor) {
  // It is cut in two whatever the cells of the wall say.
  EXPECT_LE(measured_beside_a_wall(512, 2, 20), 30U);
}

TEST(CostOfAVerdict, HasAWorldsTreeMadeOnce) {
  const auto world = world_of({.bounds = {-1e4, 1e4, -1e4, 1e4}, .obstacles = yard(10)});
  const auto ground = [&] {
    return world->kept(typeid(judge::Ground), [&]() -> std::shared_ptr<const void> {
      ADD_FAILURE() << "it is made again";
      return nullptr;
    });
  };
  const Path path = street(100, 2);
  EXPECT_TRUE(check_path(make_problem(world, {}, path.start, end_pose(path)), path).valid);
  EXPECT_NE(ground(), nullptr);
}

}  // namespace
}  // namespace vandplan

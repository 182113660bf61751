// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Is "there is no path" said where walls close every way, and never where a path is known?
#include "search/enclosure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../support/cases.h"
#include "../support/collision_oracle.h"
#include "../support/draws.h"
#include "../support/problems.h"
#include "search/open_rows.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

bool is_closed(const Task& task) {
  search::Enclosure enclosure(task);
  while (enclosure.step()) {
  }
  return enclosure.is_proven();
}

bool is_closed(const Problem& problem) { return is_closed(problem.task()); }

const Vehicle without_rear{.rear_overhang = 0.0};

/// Four thin walls around a room, each `gap` short of the next one.
std::vector<Polygon> room(const Point& middle, double half, double gap = 0.0) {
  const auto [x, y] = middle;
  const double w = 0.02;
  return {box(x - half, y - half, x + half - gap, y - half + w),
          box(x + half - w, y - half, x + half, y + half - gap),
          box(x - half + gap, y + half - w, x + half, y + half),
          box(x - half, y - half + gap, x - half + w, y + half)};
}

TEST(Enclosure, OfSeveralGoalsTellsWhetherAnyCanBeReached) {
  const Problem problem = problem_of({0, 0, 0}, {60, 0, 0}, room({60, 0}, 12));
  const auto is_closed_to = [&](const std::vector<LocalPose>& goals) {
    search::Enclosure enclosure(problem.task(), goals);
    while (enclosure.step()) {
    }
    return enclosure.is_proven();
  };
  const LocalPose within = problem.task().goal;
  const LocalPose beside = Local(Pose{60, 4, 1});
  const LocalPose outside = Local(Pose{30, 0, 0});
  EXPECT_TRUE(is_closed_to({}));
  EXPECT_TRUE(is_closed_to({within, beside}));
  EXPECT_FALSE(is_closed_to({within, outside}));
  EXPECT_FALSE(is_closed_to({outside, within}));
}

TEST(Disc, OfAnOutlineItIsTheWidestOneWithinIt) {
  for_each_case(9, 300, [](Rng& rng) {
    const Vehicle vehicle = any_body(rng);
    if (vehicle.outline.empty()) return;
    const search::Disc disc = search::widest_disc(vehicle);
    const auto room = [&, body = OracleBody(vehicle).at({})](double ahead) {
      const Point p{ahead, 0};
      double least = 1e9;
      for (std::size_t i = 0, j = body.size() - 1; i < body.size(); j = i++) {
        const Point q = nearest_on_side(p, body[j], body[i]);
        least = std::min(least, std::hypot(p.x - q.x, p.y - q.y));
      }
      return contains(body, p) ? least : 0.0;
    };
    EXPECT_NEAR(room(disc.ahead), disc.radius, 1e-9);
    const Footprint box = footprint(vehicle);
    for (int i = 0; i <= 50; ++i) {
      const double ahead = -box.rear + i * (box.front + box.rear) / 50;
      EXPECT_LE(room(ahead), disc.radius * (1 + 2e-6)) << ahead;
    }
  });
}

TEST(Enclosure, ProvesThatARoomIsClosed) {
  EXPECT_TRUE(is_closed(problem_of({0, 0, 0}, {60, 3, 1}, room({60, 0}, 15))));
  EXPECT_TRUE(is_closed(problem_of({60, 3, 1}, {0, 0, 0}, room({60, 0}, 15))));
  EXPECT_TRUE(
      is_closed(problem_of({0, 0, 0}, {60, 3, 1}, room({60, 0}, 15), {-1e9, 1e9, -1e9, 1e9})));
}

TEST(Enclosure, IsNotProvenWhereThereIsNoWall) {
  EXPECT_FALSE(is_closed(problem_of({0, 0, 0}, {60, 3, 1}, {})));
  EXPECT_FALSE(is_closed(problem_of({60, 3, 1}, {62, 3, 1}, room({60, 0}, 15))));  // both inside
}

// The truck is 2.55 m wide.
TEST(Enclosure, KnowsWhichGapsAreTooNarrow) {
  const auto gate = [](double width) {
    return std::vector<Polygon>{box(19, -300, 20, -width / 2), box(19, width / 2, 20, 300)};
  };
  EXPECT_TRUE(is_closed(problem_of({0, 0, 0}, {40, 0, 0}, gate(2.4))));
  EXPECT_FALSE(is_closed(problem_of({0, 0, 0}, {40, 0, 0}, gate(2.5502))));
}

/// Two long walls with a gate between, turned around the start.
Problem turned_gate(double width, double turn, double shift) {
  const auto turned = [&](Polygon wall) {
    for (Point& corner : wall) {
      const Pose there = compose({0, 0, turn}, {corner.x, corner.y, 0});
      corner = {there.x, there.y};
    }
    return wall;
  };
  const double low = shift - width / 2;
  return problem_of({0, 0, turn}, compose({0, 0, turn}, {40, 2 * shift, 0}),
                    {turned(box(15, -900, 25, low)), turned(box(15, low + width, 25, 900))});
}

TEST(Enclosure, KnowsGatesInAllDirections) {
  for_each_case(34, 40, [](Rng& rng) {
    const double turn = chance(0.5, rng) ? std::numbers::pi / 4 : uniform(-3, 3, rng);
    const double shift = uniform(-1, 1, rng);
    ASSERT_FALSE(is_closed(turned_gate(2.5501, turn, shift))) << as_code(turn) << as_code(shift);
    ASSERT_TRUE(is_closed(turned_gate(2.4, turn, shift))) << as_code(turn) << as_code(shift);
  });
}

TEST(Enclosure, CountsTheBoundsAsWalls) {
  const std::vector<Polygon> wall = {box(19, -8, 20, 8)};
  EXPECT_TRUE(is_closed(problem_of({0, 0, 0}, {40, 0, 0}, wall, {-10, 50, -9, 9})));
  EXPECT_FALSE(is_closed(problem_of({0, 0, 0}, {40, 0, 0}, wall, {-10, 50, -9, 9.28})));
}

TEST(Enclosure, KnowsVehiclesWhoseRearAxleIsAtTheirEnd) {
  const Bounds bounds = wide_bounds;
  EXPECT_TRUE(
      is_closed(problem_of({0, 0, 0}, {60, 3, 1}, room({60, 0}, 15), bounds, without_rear)));
  EXPECT_FALSE(
      is_closed(problem_of({0, 0, 0}, {60, 3, 1}, room({60, 0}, 15, 2.6), bounds, without_rear)));
}

TEST(Enclosure, KnowsVehiclesThatAreWiderThanLong) {
  const Vehicle wide{.wheelbase = 0.3, .front_overhang = 0.1, .rear_overhang = 0.2, .width = 2};
  const auto closed = [&](double gap) {
    return is_closed(problem_of({0, 0, 0}, {60, 3, 1}, room({60, 0}, 15, gap), wide_bounds, wide));
  };
  EXPECT_TRUE(closed(0.55));
  EXPECT_FALSE(closed(0.65));
}

TEST(Enclosure, KnowsTheMargin) {
  const Problem problem = problem_of({0, 0, 0}, {60, 3, 1}, room({60, 0}, 15, 3.0));
  EXPECT_FALSE(is_closed(task_of(problem, {.margin = 0.2})));
  EXPECT_TRUE(is_closed(task_of(problem, {.margin = 0.4})));
}

TEST(Enclosure, LetsBodiesSwingOverKerbs) {
  EXPECT_FALSE(is_closed(
      problem_in({.bounds = wide_bounds, .kerbs = room({60, 0}, 15)}, {0, 0, 0}, {60, 3, 1})));
}

/// A map, turned, with a wall of one cell across it, but for some cells.
OccupancyGrid walled_map(std::int32_t gap, bool outside_is_free) {
  constexpr std::int32_t columns = 200;
  constexpr std::int32_t rows = 150;
  std::vector<Cell> cells(static_cast<std::size_t>(columns) * rows, Cell::free);
  for (std::int32_t y = 0; y < rows; ++y) {
    if (y >= 70 && y < 70 + gap) continue;
    cells[static_cast<std::size_t>(y * columns + 100)] = Cell::occupied;
  }
  return {.origin = {0, 0, 0.7},
          .resolution = 0.2,
          .columns = columns,
          .rows = rows,
          .cells = std::move(cells),
          .unknown_is_free = outside_is_free};
}

TEST(Enclosure, ProvesOnMapsToo) {
  const auto closed = [](const OccupancyGrid& map, std::vector<Polygon> obstacles) {
    return is_closed(
        problem_in({.bounds = wide_bounds, .obstacles = std::move(obstacles), .map = map},
                   compose(map.origin, {8, 15, 0}), compose(map.origin, {30, 15, 0})));
  };
  EXPECT_TRUE(closed(walled_map(0, false), {}));
  EXPECT_TRUE(closed(walled_map(12, false), {}));
  EXPECT_FALSE(closed(walled_map(14, false), {}));
  EXPECT_FALSE(closed(walled_map(0, true), {}));  // around the map
  const Point gate = {20.1 * std::cos(0.7) - 15.4 * std::sin(0.7),
                      20.1 * std::sin(0.7) + 15.4 * std::cos(0.7)};
  EXPECT_TRUE(closed(walled_map(14, false), room(gate, 0.3)));  // map and polygons together
}

// ---- never where a path is known ----

/// Drives a path at random, then fills the yard with boxes beside it and a wall with a gate on it.
void expect_open_beside_a_drive(Rng& rng) {
  Vehicle vehicle;
  if (chance(0.5, rng)) vehicle.rear_overhang = any_size(1e-3, 2, rng);
  if (chance(0.1, rng)) vehicle.rear_overhang = 0;
  if (chance(0.3, rng)) vehicle.width = any_size(0.1, 3, rng);
  Path path{{0, 0, uniform(-3, 3, rng)}, {}};
  for (int i = 0; i < 6; ++i) {
    path.segments.push_back(
        {any_sign(chance(0.3, rng) ? 0 : 1.0 / 7, rng), any_sign(uniform(1, 12, rng), rng)});
  }
  const Pose end = end_pose(path);
  const double margin = chance(0.3, rng) ? uniform(0, 0.5, rng) : 0;
  std::vector<Polygon> boxes;
  const auto try_box = [&](const Polygon& b) {
    const CollisionChecker checker(vehicle, {.bounds = wide_bounds, .obstacles = {b}},
                                   {.wanted = margin});
    if (!checker.is_free(Local(path.start), path.segments)) return false;
    boxes.push_back(b);
    return true;
  };
  for (int i = 0; i < 150; ++i) {
    const double x = uniform(-25, 25, rng);
    const double y = uniform(-25, 25, rng);
    double size = any_size(0.5, 30, rng);
    while (size > 0.02 && !try_box(box(x, y, x + size, y + any_size(0.1, size, rng)))) size *= 0.8;
  }
  const Problem problem = problem_of(path.start, end, boxes, wide_bounds, vehicle);
  ASSERT_FALSE(is_closed(task_of(problem, {.margin = margin}))) << as_code(path) << as_code(boxes);
}

TEST(Enclosure, IsNeverProvenBesideADrive) { for_each_case(31, 300, expect_open_beside_a_drive); }

std::vector<Polygon> any_yard(Rng& rng) {
  const double gate = uniform(-20, 20, rng);
  const double half = uniform(0.8, 1.8, rng);
  std::vector<Polygon> boxes = {box(12, -30, 13, gate - half), box(12, gate + half, 13, 30)};
  const int count = static_cast<int>(uniform(1, 7, rng));
  for (int i = 0; i < count; ++i) {
    const double x = uniform(-20, 45, rng);
    const double y = uniform(-25, 25, rng);
    const double w = chance(0.5, rng) ? 0.2 : any_size(0.5, 40, rng);
    boxes.push_back(chance(0.5, rng) ? box(x, y, x + w, y + any_size(1, 40, rng))
                                     : box(x, y, x + any_size(1, 40, rng), y + w));
  }
  return boxes;
}

// A wall with a gate goes from bound to bound: every other gate is too narrow.
TEST(Enclosure, IsNeverProvenWhereAPlannerFindsAPath) {
  int closed = 0;
  int open = 0;
  for_each_case(32, 400, [&](Rng& rng) {
    const Problem problem =
        problem_of({0, 0, uniform(-3, 3, rng)}, {30, uniform(-20, 20, rng), uniform(-3, 3, rng)},
                   any_yard(rng), {-15, 45, -25, 25});
    if (!problem.task().checker->is_free(problem.task().start)) return;
    if (!problem.task().checker->is_free(problem.task().goal)) return;
    const bool proven = is_closed(problem);
    (proven ? closed : open) += 1;
    PlanOptions options;
    options.budget.max_iterations = 300;  // the planner itself does not look for walls so early
    for (const char* name : {"anytime", "rrt-bsc-euc"}) {
      const PlanResult result = plan(problem, planner_named(name), options);
      ASSERT_FALSE(result.path && proven) << as_code(obstacles_of(problem));
    }
  });
  if (is_sanitized) return;
  EXPECT_GT(closed, 20);
  EXPECT_GT(open, 20);
}

// ---- always where walls close every way ----

TEST(Enclosure, IsAlwaysProvenWhereTheGoalIsWalledIn) {
  for_each_case(33, 300, [](Rng& rng) {
    const double turn = uniform(-3, 3, rng);
    const double half = any_size(6, 40, rng);
    const Pose middle{uniform(90, 120, rng), uniform(-50, 50, rng), turn};
    std::vector<Polygon> obstacles = room({0, 0}, half);
    for (Polygon& wall : obstacles) {
      for (Point& corner : wall) {
        const Pose there = compose(middle, {corner.x, corner.y, 0});
        corner = {there.x, there.y};
      }
    }
    for (const Polygon& other : any_yard(rng)) obstacles.push_back(other);
    const bool is_goal = chance(0.5, rng);
    const Pose outside{-40, 0, 0};
    const Problem problem =
        problem_of(is_goal ? outside : middle, is_goal ? middle : outside, obstacles);
    ASSERT_TRUE(is_closed(problem)) << as_code(obstacles);
  });
}

// ---- what the planner makes of it ----

TEST(NoPath, IsSaidAtOnce) {
  const Problem problem = problem_of({0, 0, 0}, {60, 3, 1}, room({60, 0}, 15));
  const PlanResult result = plan(problem, {.budget = {.max_iterations = 2000}});
  EXPECT_EQ(result.status, PlanStatus::no_path);
  EXPECT_NE(result.reason.find("proven"), std::string::npos) << result.reason;
  EXPECT_LT(result.iterations, 1000);
  EXPECT_FALSE(result.path);
}

TEST(NoPath, ComesAfterAStartInCollisionAndAGoalThatIsTheStart) {
  const auto walls = room({60, 0}, 15);
  EXPECT_EQ(plan(problem_of({60, 15, 0}, {0, 0, 0}, walls)).status, PlanStatus::start_in_collision);
  EXPECT_EQ(plan(problem_of({60, 3, 1}, {60, 3, 1}, walls)).status, PlanStatus::solved);
}

TEST(NoPath, IsTheSameWithAnyNumberOfThreads) {
  const Problem problem = problem_of({0, 0, 0}, {60, 3, 1}, room({60, 0}, 15));
  PlanOptions options{.budget = {.max_iterations = 5000}};
  const PlanResult one = plan(problem, options);
  options.budget.threads = 3;
  const PlanResult three = plan(problem, options);
  EXPECT_EQ(one.status, three.status);
  EXPECT_EQ(one.iterations, three.iterations);
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/geodesic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "../support/cases.h"
#include "../support/problems.h"
#include "search/geodesic_field.h"
#include "support/numbers.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

constexpr double disc = 1.275;  // [m] half the width of the default truck

double bound_of(const Problem& problem, double longest = infinity) {
  search::Geodesic geodesic(problem.task(), longest);
  while (geodesic.step()) {
  }
  return geodesic.bound();
}

TEST(Geodesic, IsTheDistanceWhereNothingIsInTheWay) {
  EXPECT_DOUBLE_EQ(bound_of(problem_of({0, 0, 0}, {30, 40, 0}, {})), 50.0);
  EXPECT_DOUBLE_EQ(bound_of(problem_of({0, 0, 0}, {30, 0, 0}, {box(10, 3, 20, 5)})), 30.0);
}

// The centre of the disc lies 1.275 m ahead of the rear axle, and may go further than that.
TEST(Geodesic, AllowsForTheWayOfADiscAheadOfTheAxle) {
  Vehicle truck;
  truck.rear_overhang = 0.0;
  const Bounds bounds = wide_bounds;
  EXPECT_NEAR(bound_of(problem_of({0, 0, 0}, {30, 40, 0}, {}, bounds, truck)),
              50 / std::hypot(1, disc / 7), 1e-6);
  EXPECT_NEAR(bound_of(problem_of({0, 0, 0}, {30, 0, std::numbers::pi}, {}, bounds, truck)),
              (30 - 2 * disc) / std::hypot(1, disc / 7), 1e-6);
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

double bound_in(const Zone& zone, search::GearSign only = 0, const Vehicle& vehicle = {}) {
  const Problem problem =
      problem_in({.bounds = wide_bounds, .zones = {zone}}, {0, 0, 0}, {30, 0, 0}, vehicle);
  search::Geodesic geodesic(problem.task(), infinity, only);
  while (geodesic.step()) {
  }
  return geodesic.bound();
}

TEST(Geodesic, GoesAroundClosedZones) {
  const Zone lawn{.area = box(14, -8, 16, 8), .closed = true};
  // The axle goes along the edge, the disc keeps away.
  const double way = 2 * std::hypot(14, 8) + 2;
  EXPECT_LE(bound_in(lawn), way);
  EXPECT_GT(bound_in(lawn), 0.99 * way);
  Zone of_body = lawn;
  of_body.body = true;
  const double around_wall = bound_of(problem_of({0, 0, 0}, {30, 0, 0}, {lawn.area}));
  EXPECT_LE(bound_in(of_body), around_wall);
  EXPECT_GT(bound_in(of_body), 0.995 * around_wall);
  // The centre of the disc may be 1.275 m deep in the zone, so it passes between two such edges.
  Vehicle truck;
  truck.rear_overhang = 0.0;
  Zone strip = lawn;
  strip.area = box(14, -8, 16.5, 8);
  EXPECT_NEAR(bound_in(strip, 0, truck), 30 / std::hypot(1, disc / 7), 1e-6);
  strip.area = box(10, -8, 20, 8);
  EXPECT_GT(bound_in(strip, 0, truck), 32);
}

TEST(Geodesic, GoesAroundZonesOfTheOtherGear) {
  Zone ramp{.area = box(14, -8, 16, 8), .gears = AllowedGears::forward};
  EXPECT_DOUBLE_EQ(bound_in(ramp), 30.0);
  EXPECT_DOUBLE_EQ(bound_in(ramp, 1), 30.0);
  EXPECT_GT(bound_in(ramp, -1), 33);
  ramp.area = box(-1, -1, 1, 1);  // where it starts it may stand
  EXPECT_DOUBLE_EQ(bound_in(ramp, -1), 30.0);
}

// The zone is an open square with an arm that reaches around: its inside is closed, its bay is not.
TEST(Geodesic, GoesIntoTheBayOfAZone) {
  const Zone bay{.area = {{-8, -8}, {8, -8}, {8, 8}, {-8, 8}, {-8, 4}, {4, 4}, {4, -4}, {-8, -4}},
                 .closed = true};
  const double way = std::hypot(8, 4) + 4 + 16 + std::hypot(22, 8);
  EXPECT_LE(bound_in(bay), way);
  EXPECT_GT(bound_in(bay), 0.98 * way);
}

// Two tangents and an arc.
TEST(Geodesic, GoesAroundAPoint) {
  const double slope = std::asin(disc / 15);
  const double way = 2 * (std::sqrt(15 * 15 - disc * disc) + disc * slope);
  const double bound = bound_of(problem_of({0, 0, 0}, {30, 0, 0}, {{{15, 0}, {15, 0}, {15, 0}}}));
  EXPECT_LE(bound, way);
  EXPECT_GT(bound, 30.05);
}

// Obstacles beside the lattice block none of its cells.
TEST(Geodesic, IsTheDistanceAlongTheBounds) {
  for (const double x : {-1.3, 1.3}) {
    const std::vector<Polygon> wall = {box(std::min(x, 3 * x), -10, std::max(x, 3 * x), 40)};
    const Bounds strip{x > 0 ? -20.0 : -0.001, x > 0 ? 0.001 : 20.0, -10, 40};
    EXPECT_DOUBLE_EQ(bound_of(problem_of({0, 0, 1.57}, {0, 30, 1.57}, wall, strip)), 30.0);
  }
}

// ---- Against ways that keep their distance ----

bool crosses(const Point& p, const Point& q, const Polygon& b) {
  double first = 0.0;
  double last = 1.0;
  const auto clip = [&](double from, double way, double low, double high) {
    if (way == 0.0) {
      if (from < low || from > high) last = -1.0;
      return;
    }
    first = std::max(first, std::min((low - from) / way, (high - from) / way));
    last = std::min(last, std::max((low - from) / way, (high - from) / way));
  };
  clip(p.x, q.x - p.x, b[0].x, b[2].x);
  clip(p.y, q.y - p.y, b[0].y, b[2].y);
  return first <= last;
}

/// From a segment to a box along the axes. If they do not cross, an end or a corner is nearest.
double distance_to_box(const Point& p, const Point& q, const Polygon& b) {
  if (crosses(p, q, b)) return 0.0;
  double least = infinity;
  for (const Point& end : {p, q}) {
    const double dx = std::max({b[0].x - end.x, end.x - b[2].x, 0.0});
    const double dy = std::max({b[0].y - end.y, end.y - b[2].y, 0.0});
    least = std::min(least, std::hypot(dx, dy));
  }
  const Point way{q.x - p.x, q.y - p.y};
  const double square = std::max(1e-18, way.x * way.x + way.y * way.y);
  for (const Point& corner : b) {
    const double along = (corner.x - p.x) * way.x + (corner.y - p.y) * way.y;
    const double t = std::clamp(along / square, 0.0, 1.0);
    least = std::min(least, std::hypot(corner.x - p.x - t * way.x, corner.y - p.y - t * way.y));
  }
  return least;
}

const Point far_start{0, 0};
const Point far_goal{31, 0};

/// The shortest way of straight lines for a disc among boxes: by way of corners of an octagon
/// around each corner of a box. It keeps its distance, and is no longer than the shortest way of a
/// disc that holds the octagon.
double way_around(const std::vector<Polygon>& boxes, double radius) {
  std::vector<Point> places = {far_start, far_goal};
  const double octagon = radius / std::cos(std::numbers::pi / 8) + 1e-9;
  for (const Polygon& b : boxes) {
    for (const Point& corner : b) {
      for (int i = 0; i < 8; ++i) {
        const double angle = (i + 0.5) * std::numbers::pi / 4;
        places.push_back(
            {corner.x + octagon * std::cos(angle), corner.y + octagon * std::sin(angle)});
      }
    }
  }
  const auto is_clear = [&](const Point& p, const Point& q) {
    return std::all_of(boxes.begin(), boxes.end(),
                       [&](const Polygon& b) { return distance_to_box(p, q, b) >= radius; });
  };
  std::vector<double> lengths(places.size(), infinity);
  std::vector<bool> is_settled(places.size(), false);
  lengths[0] = 0;
  while (!is_settled[1]) {
    std::size_t nearest = 1;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!is_settled[i] && lengths[i] < lengths[nearest]) nearest = i;
    }
    if (std::isinf(lengths[nearest])) return infinity;
    is_settled[nearest] = true;
    const Point& here = places[nearest];
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double length =
          lengths[nearest] + std::hypot(places[i].x - here.x, places[i].y - here.y);
      if (length < lengths[i] && is_clear(here, places[i])) lengths[i] = length;
    }
  }
  return lengths[1];
}

/// Boxes between start and goal with corners at multiples of the resolution.
std::vector<Polygon> any_boxes(double resolution, Rng& rng) {
  const auto on_lattice = [&](double x) { return std::round(x / resolution) * resolution; };
  std::vector<Polygon> boxes;
  for (int i = 0; i < 5; ++i) {
    const double x = on_lattice(uniform(4, 22, rng));
    const double y = on_lattice(uniform(-12, 12, rng));
    boxes.push_back(
        box(x, y, x + on_lattice(uniform(0.5, 5, rng)), y + on_lattice(uniform(0.5, 12, rng))));
  }
  return boxes;
}

bool is_goal_clear(const std::vector<Polygon>& boxes) {
  return std::all_of(boxes.begin(), boxes.end(), [](const Polygon& b) {
    return distance_to_box(far_goal, far_goal, b) > disc;
  });
}

// Open cells keep 0.95 of the disc's radius at least, on the finest lattice.
void expect_between_ways(double bound, const std::vector<Polygon>& boxes) {
  ASSERT_LE(bound, way_around(boxes, disc) + 1e-9) << as_code(boxes);
  ASSERT_GE(bound, way_around(boxes, 0.95 * std::cos(std::numbers::pi / 8) * disc) - 1e-6)
      << as_code(boxes);
}

constexpr Bounds around{-10, 40, -30, 30};

TEST(Geodesic, IsBetweenTheWaysOfTwoDiscsAmongPolygons) {
  for_each_case(11, 200, [](Rng& rng) {
    const std::vector<Polygon> boxes = any_boxes(0.01, rng);
    if (!is_goal_clear(boxes)) return;
    expect_between_ways(bound_of(problem_of({0, 0, 0}, {31, 0, 0}, boxes, around)), boxes);
  });
}

// The same boxes as cells of a map that is turned against the lattice.
TEST(Geodesic, IsBetweenTheWaysOfTwoDiscsOnAMap) {
  for_each_case(12, 20, [](Rng& rng) {
    constexpr double resolution = 0.5;
    const std::vector<Polygon> boxes = any_boxes(resolution, rng);
    if (!is_goal_clear(boxes)) return;
    std::vector<Cell> cells;
    for (double y = around.y_min + resolution / 2; y < around.y_max; y += resolution) {
      for (double x = around.x_min + resolution / 2; x < around.x_max; x += resolution) {
        const bool is_inside = std::any_of(boxes.begin(), boxes.end(), [&](const Polygon& b) {
          return x > b[0].x && x < b[2].x && y > b[0].y && y < b[2].y;
        });
        cells.push_back(is_inside ? Cell::occupied : Cell::free);
      }
    }
    const Pose origin{0, 0, uniform(-3, 3, rng)};
    const auto turned = [&](const Pose& pose) { return compose(origin, pose); };
    const OccupancyGrid map{.origin = turned({around.x_min, around.y_min, 0}),
                            .resolution = resolution,
                            .columns = 100,
                            .rows = 120,
                            .cells = std::move(cells),
                            .unknown_is_free = true};
    const Problem problem = problem_in({.bounds = {-60, 60, -60, 60}, .map = map},
                                       turned({0, 0, 0}), turned({31, 0, 0}));
    expect_between_ways(bound_of(problem), boxes);
  });
}

TEST(Geodesic, LeavesOutPathsThatAreTooLong) {
  const std::vector<Polygon> wall = {box(14, -100, 16, 100)};
  const Problem problem = problem_of({0, 0, 0}, {30, 0, 0}, wall);
  EXPECT_GT(bound_of(problem), 200.0);
  EXPECT_GT(bound_of(problem, 250.0), 200.0);
  EXPECT_LE(bound_of(problem, 120.0), 120.0);
}

/// Length of the shortest way through open cells, all in cells.
double shortest_way(const search::OpenRows& lattice, const Point& from, const Point& to) {
  search::TautWays ways(lattice, from, to);
  if (ways.start_run() == ways.goal_run()) return std::hypot(to.x - from.x, to.y - from.y);
  while (const auto node = ways.take()) {
    if (node->into == ways.goal_run()) return node->rank;
    if (ways.is_current(*node)) ways.expand(*node);
  }
  return infinity;
}

Point point_in_open_cell(search::OpenRows& lattice, double extent, Rng& rng) {
  for (;;) {
    const Point p{uniform(0, extent, rng), uniform(0, extent, rng)};
    const search::OpenRows::Row& row = lattice.row(static_cast<std::int32_t>(p.y));
    const auto holds = [&](const auto& run) { return p.x > run.begin && p.x < run.end; };
    if (std::any_of(row.begin(), row.end(), holds)) return p;
  }
}

TEST(GeodesicField, TellsTheLengthOfTheShortestWayToEveryPlaceOnShortEnoughOnes) {
  for_each_case(5, 60, [](Rng& rng) {
    std::vector<Polygon> boxes;
    for (int i = 0; i < 8; ++i) {
      const double x = uniform(0, 30, rng);
      const double y = uniform(0, 30, rng);
      boxes.push_back(box(x, y, x + uniform(0.1, 5, rng), y + uniform(0.1, 12, rng)));
    }
    const Problem problem = problem_of({}, {1, 1, 0}, boxes);
    const double side = uniform(0.2, 0.8, rng);
    search::OpenRows lattice(problem.task(), {-5, 35, -5, 35}, side, disc - side);
    const auto open_point = [&] { return point_in_open_cell(lattice, 40 / side, rng); };
    const Point start = open_point();
    const Point goal = open_point();
    const double longest = 1.3 * shortest_way(lattice, start, goal);
    if (longest == infinity) return;
    search::GeodesicField field(lattice, start, goal, longest);
    while (field.go_on(field.work() + 1000)) {
    }
    ASSERT_FALSE(field.is_given_up());
    for (int i = 0; i < 20; ++i) {
      const Point p = open_point();
      const double length = shortest_way(lattice, start, p);
      EXPECT_GE(field.at(p), length - 1e-6);
      if (length + shortest_way(lattice, p, goal) <= longest) {
        EXPECT_NEAR(field.at(p), length, 1e-6) << as_code(boxes);
      }
    }
  });
}

// Each corner of the straight wall sees the ways of all before: once they doubled at each of them.
TEST(GeodesicField, TakesLittleAlongWallsWithManyCornersInARow) {
  const Problem problem = problem_of(
      {0, 10, 0}, {0, -16, 0}, {box(-11, -30, -9, 30), box(9, -30, 11, 30), box(-9, -1, 9, 1)});
  const double side = 0.08;
  const search::OpenRows lattice(problem.task(), {-60, 60, -60, 60}, side, disc - side);
  const Point start = lattice.in_cells({0, 10});
  const Point goal = lattice.in_cells({0, -16});
  search::GeodesicField field(lattice, start, goal, 116 / side);
  while (field.go_on(field.work() + 1000)) {
  }
  EXPECT_FALSE(field.is_given_up());
  EXPECT_LT(field.work(), 300000);
}

}  // namespace
}  // namespace vandplan

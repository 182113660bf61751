// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The checker never accepts an edge that the judge, looking every millimetre, rejects, and rejects
// none that stays more than its tolerance away from everything. Most worlds are made so that the
// edge just touches or just misses an obstacle.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "support/cases.h"
#include "support/collision_oracle.h"
#include "support/draws.h"
#include "support/numbers.h"
#include "support/problems.h"
#include "vandplan/collision.h"
#include "vandplan/judge.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using std::numbers::pi;
constexpr Bounds around{-20, 20, -20, 20};  // edges begin here

struct Case {
  Vehicle vehicle;
  Bounds bounds{-1e4, 1e4, -1e4, 1e4};
  std::vector<Polygon> obstacles;
  Path path;
};

Surroundings yard_of(const Case& c) { return {.bounds = c.bounds, .obstacles = c.obstacles}; }

/// As C++ that can be pasted into a unit test.
std::string described(const Case& c) {
  const Vehicle& v = c.vehicle;
  const auto& [x_min, x_max, y_min, y_max] = c.bounds;
  return "Vehicle" +
         as_code(std::array{v.wheelbase, v.front_overhang, v.rear_overhang, v.width,
                            v.min_turning_radius}) +
         ", outline " + as_code(v.outline) + ", Bounds" +
         as_code(std::array{x_min, x_max, y_min, y_max}) + ", obstacles " + as_code(c.obstacles) +
         ", " + as_code(c.path);
}

/// Around the origin.
Polygon any_polygon(Rng& rng) {
  const double size = chance(0.7, rng) ? any_size(0.3, 10, rng) : any_size(1e-3, 100, rng);
  const double turned = uniform(-pi, pi, rng);
  const auto at = [&](double x, double y) {
    return Point{x * std::cos(turned) - y * std::sin(turned),
                 x * std::sin(turned) + y * std::cos(turned)};
  };
  Polygon polygon;
  const double kind = uniform01(rng);
  if (kind < 0.2) {  // a sliver, 1 cm wide
    polygon = {at(-size, 0), at(size, 0), at(size, 0.01), at(-size, 0.01)};
  } else if (kind < 0.3) {  // a pocket, open to one side
    const double t = size / 5;
    polygon = {at(-size, -size),       at(size, -size),        at(size, t - size),
               at(t - size, t - size), at(t - size, size - t), at(size, size - t),
               at(size, size),         at(-size, size)};
  } else {  // a star, or if its rays are equal convex
    const int corners = 3 + static_cast<int>(uniform(0, kind < 0.6 ? 3 : 10, rng));
    const double least = chance(0.5, rng) ? 1 : 0.3;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * pi * (i + uniform(0, 0.6, rng)) / corners;
      const double ray = size * uniform(least, 1, rng);
      polygon.push_back({ray * std::cos(angle), ray * std::sin(angle)});
    }
  }
  if (chance(0.5, rng)) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

Polygon moved(Polygon polygon, double x, double y) {
  for (Point& p : polygon) p = {p.x + x, p.y + y};
  return polygon;
}

/// A random obstacle near the path; where that is possible, so near that it just touches or just
/// misses what the footprint sweeps.
Polygon any_obstacle(const OracleBody& body, const Path& path, Rng& rng) {
  const Pose near = pose_at(path, uniform(0, length(path.segments), rng));
  const Polygon polygon =
      moved(any_polygon(rng), near.x + uniform(-12, 12, rng), near.y + uniform(-12, 12, rng));
  const Gap gap = least_gap(body, std::span(&polygon, 1), path, 1e-3);
  if (gap.distance == 0 || chance(0.2, rng)) return polygon;
  const double wanted = chance(0.7, rng) ? uniform(-2e-3, 4e-3, rng) : any_size(1e-5, 1, rng);
  const double part = 1 - wanted / gap.distance;
  return moved(polygon, part * (gap.on_body.x - gap.on_obstacle.x),
               part * (gap.on_body.y - gap.on_obstacle.y));
}

Case any_case(Rng& rng) {
  Case c{.vehicle = any_body(rng), .obstacles = {}, .path = any_edge(around, rng)};
  const OracleBody body(c.vehicle);
  const int count = chance(0.8, rng) ? 1 : static_cast<int>(uniform(0, 6, rng));
  for (int i = 0; i < count; ++i) c.obstacles.push_back(any_obstacle(body, c.path, rng));
  return c;
}

TEST(CollisionLaw, WhatIsAcceptedIsValidAndWhatIsClearIsAccepted) {
  constexpr int count = 20000;
  int accepted = 0;
  int barely_accepted = 0;  // within 4 mm of an obstacle
  int rejected = 0;
  int barely_rejected = 0;  // without touching, found in every 16th
  for_each_case(1, count, [&](Rng& rng) {
    const Case c = any_case(rng);
    const OracleBody body(c.vehicle);
    const CollisionChecker checker(c.vehicle, yard_of(c));
    if (checker.is_free(Local(c.path.start), c.path.segments)) {
      const Problem problem = problem_of_path(yard_of(c), c.path, c.vehicle);
      const PathCheck check = check_path(problem, c.path, {});
      EXPECT_TRUE(check.valid) << check.reason << "; " << described(c);
      ++accepted;
      barely_accepted += check.clearance < 4e-3;
    } else {
      EXPECT_TRUE(comes_within(CollisionChecker::tolerance, body, c.obstacles, c.path))
          << described(c);
      barely_rejected += rejected % 16 == 0 && !comes_within(0, body, c.obstacles, c.path);
      ++rejected;
    }
  });
  EXPECT_GT(accepted, cases(count) / 3);
  EXPECT_GT(rejected, cases(count) / 3);
  EXPECT_GT(barely_accepted, accepted / 3);
  // Every 16th is looked for: too few to count where there are few cases.
  EXPECT_GT(barely_rejected * 16, is_sanitized ? -1 : rejected / 8);
}

/// A wedge or a wall that begins near the origin or passes it, with one or two corners far away.
Polygon far_wedge(Rng& rng) {
  const auto any_where = [&](double most) {
    const double angle = uniform(-pi, pi, rng);
    const double distance = any_size(most / 1e3, most, rng);
    return Point{distance * std::cos(angle), distance * std::sin(angle)};
  };
  const Point near = any_where(10);
  const Point far = any_where(3e6);
  if (chance(0.5, rng)) return {near, any_where(10), far};
  const double back = -uniform(0.1, 1, rng);  // the wall's other end, beyond the origin
  const Point aside = any_where(1e3);
  return {far, {near.x + back * far.x, near.y + back * far.y}, {far.x + aside.x, far.y + aside.y}};
}

/// As everything, seen from so near that it is that many times smaller.
Case shrunk(Case c, double by) {
  Vehicle& v = c.vehicle;
  const Polygon outline = v.outline;
  v = {v.wheelbase / by, v.front_overhang / by, v.rear_overhang / by, v.width / by, 1e-3 / by};
  for (const auto& [x, y] : outline) v.outline.push_back({x / by, y / by});
  c.path.start = {c.path.start.x / by, c.path.start.y / by, c.path.start.heading};
  for (Segment& segment : c.path.segments) {
    segment = {segment.curvature * by, segment.length / by, segment.curvature_rate * by * by};
  }
  return c;
}

TEST(CollisionLaw, SidesMayEndFarAway) {
  constexpr int count = 10000;
  int accepted = 0;
  int rejected = 0;
  for_each_case(4, count, [&](Rng& rng) {
    Case c{.vehicle = any_body(rng), .obstacles = {}, .path = any_edge(around, rng)};
    if (chance(0.3, rng)) c = shrunk(c, any_size(1, 100, rng));
    const OracleBody body(c.vehicle);
    const Pose near = pose_at(c.path, uniform(0, length(c.path.segments), rng));
    Polygon wedge;
    Gap gap{.distance = 0.0, .on_body = {}, .on_obstacle = {}};
    for (int i = 0; i < 20 && gap.distance == 0; ++i) {
      wedge = moved(far_wedge(rng), near.x + uniform(-20, 20, rng), near.y + uniform(-20, 20, rng));
      gap = least_gap(body, std::span(&wedge, 1), c.path, 1e-3);
    }
    if (gap.distance > 0) {
      const double part = 1 - uniform(-2e-3, 4e-3, rng) / gap.distance;
      wedge = moved(wedge, part * (gap.on_body.x - gap.on_obstacle.x),
                    part * (gap.on_body.y - gap.on_obstacle.y));
    }
    c.obstacles = {wedge};
    const CollisionChecker checker(c.vehicle, yard_of(c));
    if (checker.is_free(Local(c.path.start), c.path.segments)) {
      EXPECT_FALSE(comes_within(0, body, c.obstacles, c.path)) << described(c);
      ++accepted;
    } else {
      EXPECT_TRUE(comes_within(CollisionChecker::tolerance, body, c.obstacles, c.path))
          << described(c);
      ++rejected;
    }
  });
  EXPECT_GT(accepted, cases(count) / 5);
  EXPECT_GT(rejected, cases(count) / 5);
}

TEST(CollisionLaw, AMarginIsKeptAndNoMoreThanThat) {
  constexpr int count = 4000;
  int accepted = 0;
  int barely_accepted = 0;  // within 4 mm of the margin
  int rejected = 0;
  for_each_case(5, count, [&](Rng& rng) {
    Case c{.vehicle = any_body(rng), .obstacles = {}, .path = any_edge(around, rng)};
    const double margin = any_size(1e-3, 5, rng);
    const OracleBody body(c.vehicle);
    const Pose near = pose_at(c.path, uniform(0, length(c.path.segments), rng));
    Polygon polygon =
        moved(any_polygon(rng), near.x + uniform(-20, 20, rng), near.y + uniform(-20, 20, rng));
    const Gap gap = least_gap(body, std::span(&polygon, 1), c.path, 1e-4);
    if (gap.distance > 0) {
      const double part = 1 - (margin + uniform(-2e-3, 4e-3, rng)) / gap.distance;
      polygon = moved(polygon, part * (gap.on_body.x - gap.on_obstacle.x),
                      part * (gap.on_body.y - gap.on_obstacle.y));
    }
    c.obstacles = {polygon};
    const CollisionChecker checker(
        c.vehicle, Surroundings{.bounds = c.bounds, .obstacles = c.obstacles}, {.wanted = margin});
    if (checker.is_free(Local(c.path.start), c.path.segments)) {
      EXPECT_FALSE(comes_within(margin, body, c.obstacles, c.path))
          << margin << "; " << described(c);
      ++accepted;
      barely_accepted += comes_within(margin + 4e-3, body, c.obstacles, c.path);
    } else {
      EXPECT_TRUE(comes_within(margin + CollisionChecker::tolerance, body, c.obstacles, c.path))
          << margin << "; " << described(c);
      ++rejected;
    }
  });
  EXPECT_GT(accepted, cases(count) / 5);
  EXPECT_GT(rejected, cases(count) / 5);
  EXPECT_GT(barely_accepted, accepted / 4);
}

/// The least clearance beyond what is wanted, at poses that are two centimetres apart [m].
double least_excess(const Margin& margin, const OracleBody& body, const Case& c) {
  double least = infinity;
  const double whole = length(c.path.segments);
  for (int i = 0; i <= 1000; ++i) {
    const Pose pose = pose_at(c.path, whole * i / 1000);
    double wanted = margin.wanted;
    for (const MarginRamp& ramp : margin.ramps) {
      const double part = std::hypot(pose.x - ramp.centre.x, pose.y - ramp.centre.y) / ramp.reach;
      wanted = std::min(wanted, ramp.least + (margin.wanted - ramp.least) * part);
    }
    least = std::min(least, gap_at(body, c.obstacles, pose).distance - wanted);
  }
  return least;
}

TEST(CollisionLaw, ARampOfTheMarginIsKeptAndNoMoreThanThat) {
  constexpr int count = 2500;
  int accepted = 0;
  int accepted_by_ramp = 0;  // and not with the whole margin
  int rejected = 0;
  for_each_case(6, count, [&](Rng& rng) {
    Case c{.vehicle = any_body(rng), .obstacles = {}, .path = any_edge(around, rng)};
    const double whole = length(c.path.segments);
    if (whole > 20) return;
    const OracleBody body(c.vehicle);
    Margin margin{.wanted = any_size(0.05, 2, rng)};
    for (const Pose& end : {c.path.start, end_pose(c.path)}) {
      margin.ramps.push_back(
          {Local(Point{end.x, end.y}), margin.wanted * uniform01(rng), any_size(0.1, 20, rng)});
    }
    const Pose near = pose_at(c.path, uniform(0, whole, rng));
    Polygon polygon =
        moved(any_polygon(rng), near.x + uniform(-15, 15, rng), near.y + uniform(-15, 15, rng));
    const Gap gap = least_gap(body, std::span(&polygon, 1), c.path, 1e-3);
    if (gap.distance > 0) {
      const double part = 1 - margin.wanted * uniform(0, 1.2, rng) / gap.distance;
      polygon = moved(polygon, part * (gap.on_body.x - gap.on_obstacle.x),
                      part * (gap.on_body.y - gap.on_obstacle.y));
    }
    c.obstacles = {polygon};
    const Surroundings yard{.bounds = c.bounds, .obstacles = c.obstacles};
    if (CollisionChecker(c.vehicle, yard, margin).is_free(Local(c.path.start), c.path.segments)) {
      EXPECT_GE(least_excess(margin, body, c), 0) << described(c);
      ++accepted;
      const CollisionChecker strict(c.vehicle, yard, {.wanted = margin.wanted});
      accepted_by_ramp += !strict.is_free(Local(c.path.start), c.path.segments);
    } else {
      double steepest = 0;
      for (const Segment& segment : c.path.segments) {
        steepest = std::max(steepest, std::abs(segment.curvature));
      }
      const double moved_between_looks = 0.02 * (1 + steepest * body.reach());
      EXPECT_LE(least_excess(margin, body, c), CollisionChecker::tolerance + moved_between_looks)
          << described(c);
      ++rejected;
    }
  });
  EXPECT_GT(accepted, cases(count) / 10);
  EXPECT_GT(accepted_by_ramp, cases(count) / 40);
  EXPECT_GT(rejected, cases(count) / 10);
}

TEST(CollisionLaw, TheClearanceIsTheDistanceOfTheOracle) {
  constexpr int count = 10000;
  int apart = 0;
  for_each_case(7, count, [&](Rng& rng) {
    const Case c = any_case(rng);
    const OracleBody body(c.vehicle);
    const CollisionChecker checker(c.vehicle, yard_of(c));
    const double most = any_size(0.01, 100, rng);
    const double gap = gap_at(body, c.obstacles, c.path.start).distance;
    const double expected = std::min(gap, most);
    EXPECT_NEAR(checker.clearance(Local(c.path.start), most), expected, 1e-9)
        << most << described(c);
    if (gap < infinity) {
      EXPECT_NEAR(checker.clearance(Local(c.path.start), infinity), gap, 1e-9) << described(c);
    }
    apart += expected > 0 && expected < most;
  });
  EXPECT_GT(apart, cases(count) / 5);
}

bool judged_within(const Path& path, const Bounds& bounds) {
  const Vehicle vehicle{.min_turning_radius = 1e-3};
  return check_path(problem_of_path({.bounds = bounds}, path, vehicle), path, {}).valid;
}

TEST(CollisionLaw, TheRearAxleIsKeptInTheBoundsToAMicrometre) {
  constexpr int count = 50000;
  int accepted = 0;
  int rejected = 0;
  for_each_case(2, count, [&](Rng& rng) {
    const Path path = any_edge(around, rng);
    std::vector<Point> points;
    for (const PathPoint& p : sampled(path, 1)) points.push_back({p.pose.x, p.pose.y});
    const Bounds box = bounding_box(points);
    // Most of the room beyond the points is for the bulges of arcs between them.
    const auto room = [&] { return chance(0.3, rng) ? 100 : any_size(1e-5, 0.1, rng); };
    const Bounds bounds{box.x_min - room(), box.x_max + room(), box.y_min - room(),
                        box.y_max + room()};
    const CollisionChecker checker(footprint(Vehicle{}), bounds, {});
    const auto inflated = [&](double by) {
      return Bounds{bounds.x_min - by, bounds.x_max + by, bounds.y_min - by, bounds.y_max + by};
    };
    if (checker.is_free(Local(path.start), path.segments)) {
      EXPECT_TRUE(judged_within(path, bounds)) << as_code(path);
      ++accepted;
    } else {
      EXPECT_FALSE(judged_within(path, inflated(-1e-6))) << as_code(path);
      ++rejected;
    }
  });
  EXPECT_GT(accepted, cases(count) / 10);
  EXPECT_GT(rejected, cases(count) / 10);
}

TEST(CollisionLaw, ManyObstaclesAreHitExactlyIfOneOfThemIs) {
  constexpr int count = 300;
  int accepted = 0;
  int rejected = 0;
  for_each_case(3, count, [&](Rng& rng) {
    const Footprint body = footprint(any_vehicle(rng));
    const double extent = any_size(30, 3000, rng);
    const Bounds bounds{-1e4, 1e4, -1e4, 1e4};
    std::vector<Polygon> obstacles;
    const auto obstacle_count = static_cast<int>(any_size(1, 3000, rng));
    for (int i = 0; i < obstacle_count; ++i) {
      obstacles.push_back(
          moved(any_polygon(rng), uniform(-extent, extent, rng), uniform(-extent, extent, rng)));
    }
    const CollisionChecker all(body, bounds, obstacles);
    std::vector<std::unique_ptr<CollisionChecker>> each;
    for (const Polygon& obstacle : obstacles) {
      each.push_back(std::make_unique<CollisionChecker>(body, bounds, std::span(&obstacle, 1)));
    }
    for (int i = 0; i < 30; ++i) {
      Path path = any_edge(around, rng);
      Segment& first = path.segments[0];
      if (first.curvature_rate == 0 && chance(0.05, rng)) first.length *= any_size(1, 100, rng);
      const bool free = all.is_free(Local(path.start), path.segments);
      EXPECT_EQ(free, std::all_of(each.begin(), each.end(),
                                  [&](const auto& checker) {
                                    return checker->is_free(Local(path.start), path.segments);
                                  }))
          << as_code(path);
      ++(free ? accepted : rejected);
    }
  });
  EXPECT_GT(accepted, cases(count) * 3);
  EXPECT_GT(rejected, cases(count) * 3);
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The judge asks a tree for what is near. Whatever it says must be what looking
// at every side everywhere says: among polygons that are nested, touch each
// other, are huge, tiny, thin or far away, with kerbs, on the spot and on
// clothoids.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "judge/ground.h"
#include "support/cases.h"
#include "support/draws.h"
#include "support/judge_oracle.h"
#include "support/numbers.h"
#include "support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using std::numbers::pi;
constexpr double furthest = 3e6;  // coordinate of a corner [m]
constexpr Bounds wide{-1e6, 1e6, -1e6, 1e6};

// ---- What stands around ----

Point towards(const Point& from, double angle, double distance) {
  return {from.x + distance * std::cos(angle), from.y + distance * std::sin(angle)};
}

int any_count(double low, double high, Rng& rng) {
  return static_cast<int>(any_size(low, high, rng));
}

/// With corners in all directions, often concave.
Polygon star(const Point& middle, double size, Rng& rng) {
  const int corners = any_count(3, 40, rng);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * (i + uniform(-0.3, 0.3, rng)) / corners;
    polygon.push_back(towards(middle, angle, size * uniform(0.2, 1, rng)));
  }
  if (chance(0.5, rng)) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

Polygon needle(const Point& tip, Rng& rng) {
  const double angle = uniform(-pi, pi, rng);
  const Point end = towards(tip, angle, any_size(0.1, furthest / 2, rng));
  return {tip, end, towards(end, angle + pi / 2, any_size(1e-6, 1, rng))};
}

/// Many thin teeth side by side.
Polygon comb(const Point& corner, Rng& rng) {
  const double angle = uniform(-pi, pi, rng);
  const double pitch = any_size(1e-3, 1, rng);
  const double tooth = any_size(0.1, 300, rng);
  const int teeth = any_count(3, 60, rng);
  Polygon polygon = {towards(corner, angle + pi / 2, -1)};
  for (int i = 0; i < teeth; ++i) {
    const Point foot = towards(corner, angle, i * pitch);
    polygon.push_back(foot);
    polygon.push_back(towards(towards(foot, angle, pitch / 3), angle + pi / 2, tooth));
  }
  polygon.push_back(towards(towards(corner, angle, teeth * pitch), angle + pi / 2, -1));
  return polygon;
}

/// Around a place, nearly closed.
Polygon ring(const Point& middle, Rng& rng) {
  const double inner = any_size(3, 300, rng);
  const double outer = inner + any_size(0.01, 30, rng);
  const double gap = any_size(1e-3, 1, rng);
  const double first = uniform(-pi, pi, rng);
  const int corners = any_count(4, 80, rng);
  const auto angle = [&](int i) { return first + gap + (2 * pi - 2 * gap) * i / corners; };
  Polygon polygon;
  for (int i = 0; i <= corners; ++i) polygon.push_back(towards(middle, angle(i), inner));
  for (int i = corners; i >= 0; --i) polygon.push_back(towards(middle, angle(i), outer));
  return polygon;
}

/// A corner of the vehicle on its way.
Point grazed_corner(const Vehicle& vehicle, const Path& path, Rng& rng) {
  const auto outline = corners(footprint(vehicle), pose_at(path, uniform(0, length(path), rng)));
  return outline[static_cast<std::size_t>(uniform(0, 4, rng))];
}

/// A side that passes a point at next to no distance, with ends up to
/// `furthest` away.
Polygon huge(const Point& near, Rng& rng) {
  const double angle = uniform(-pi, pi, rng);
  const Point foot = towards(near, angle, any_sign(any_size(1e-9, 1, rng), rng));
  const auto far = [&] { return any_size(1, furthest / 2, rng); };
  return {towards(foot, angle + pi / 2, far()), towards(foot, angle - pi / 2, far()),
          towards(foot, angle, far())};
}

/// The same shape within another one, or beside it at a common corner.
Polygon copy_of(const Polygon& polygon, Rng& rng) {
  const double scale = chance(0.5, rng) ? uniform(0.1, 0.9, rng) : -uniform(0.1, 2, rng);
  const Point& fixed = polygon[0];
  Polygon copy;
  for (const Point& p : polygon) {
    copy.push_back({fixed.x + scale * (p.x - fixed.x), fixed.y + scale * (p.y - fixed.y)});
  }
  return copy;
}

Polygon any_polygon(const Vehicle& vehicle, const Path& path, Rng& rng) {
  const Pose place = uniform_pose({-60, 60, -60, 60}, rng);
  const Point middle =
      chance(0.1, rng) ? grazed_corner(vehicle, path, rng) : Point{place.x, place.y};
  const double kind = uniform01(rng);
  if (kind < 0.1) return needle(middle, rng);
  if (kind < 0.15) return comb(middle, rng);
  if (kind < 0.2) return ring({path.start.x, path.start.y}, rng);
  if (kind < 0.3) return huge(grazed_corner(vehicle, path, rng), rng);
  if (kind < 0.35) return star(towards({}, place.heading, any_size(1e3, 1e6, rng)), 1e6, rng);
  return star(middle, any_size(1e-6, 10, rng), rng);
}

std::vector<Polygon> any_polygons(int count, const Vehicle& vehicle, const Path& path, Rng& rng) {
  std::vector<Polygon> polygons;
  while (polygons.size() < static_cast<std::size_t>(count)) {
    const bool copied = !polygons.empty() && chance(0.2, rng);
    const Polygon polygon =
        copied ? copy_of(polygons.back(), rng) : any_polygon(vehicle, path, rng);
    try {
      const World accepted({.bounds = wide, .obstacles = {polygon}}, {});
      polygons.push_back(accepted.local().obstacles[0]);
    } catch (const InputError&) {  // it crosses itself, once it is rounded
    }
  }
  return polygons;
}

/// Moves everything so that the path just touches or just misses what is
/// nearest.
void graze(std::vector<Polygon>& polygons, const Footprint& body, const Path& path, Rng& rng) {
  const Gap gap = least_gap(body, polygons, path, 1e-3);
  if (gap.distance == 0) return;
  const double part = 1 - uniform(-1e-3, 5e-3, rng) / gap.distance;
  for (Polygon& polygon : polygons) {
    for (Point& p : polygon) {
      p.x += part * (gap.on_body.x - gap.on_obstacle.x);
      p.y += part * (gap.on_body.y - gap.on_obstacle.y);
    }
  }
}

/// On the spot at times, and cut into many segments at times.
Path any_path(Rng& rng) {
  if (chance(0.1, rng))
    return {uniform_pose({-10, 10, -10, 10}, rng), {{100, uniform(0, 0.05, rng)}}};
  Path path = any_edge({-10, 10, -10, 10}, rng);
  if (chance(0.8, rng)) return path;
  Path cut{path.start, {}};
  for (const Segment& segment : path.segments) {
    if (segment.length == 0) continue;
    const double part = std::abs(segment.length) / 16;
    for (int i = 0; i < 16; ++i) cut.segments.push_back(part_of(segment, i * part, (i + 1) * part));
  }
  return cut;
}

// ---- One look ----

judge::Outline rectangle_of(const Footprint& body) {
  return {-body.rear, body.front, -body.half_width, body.half_width};
}

judge::Passage any_passage(Rng& rng) {
  const Pose pose = uniform_pose({-10, 10, -10, 10}, rng);
  judge::Passage passage{{pose.x, pose.y, pose.heading}};
  if (chance(0.5, rng)) return passage;
  passage.half = any_size(1e-4, 20, rng);
  if (chance(0.7, rng)) passage.curvature = any_sign(any_size(1e-6, 100, rng), rng);
  if (chance(0.3, rng)) passage.rate = any_sign(any_size(1e-6, 2, rng) / passage.half, rng);
  return passage;
}

TEST(JudgeCrowdLaw, ATreeOfManyPolygonsIsAsGoodAsEachOnItsOwn) {
  int touched = 0;
  int near = 0;
  for_each_case(1, 3000, [&](Rng& rng) {
    const Vehicle vehicle = any_vehicle(rng);
    const auto polygons = any_polygons(any_count(1, 200, rng), vehicle, any_path(rng), rng);
    const Surroundings all{.obstacles = polygons};
    const judge::Ground ground(all);
    const judge::Outline body = rectangle_of(footprint(vehicle));
    for (int i = 0; i < 5; ++i) {
      const judge::Passage passage = any_passage(rng);
      const double most = chance(0.5, rng) ? infinity : any_size(1e-3, 100, rng);
      judge::Effort effort;
      const double clearance =
          ground.clearance(judge::view_of(passage), {body, body}, most, effort);
      double least = most;
      std::size_t first = polygons.size();
      for (std::size_t k = polygons.size(); k-- > 0;) {
        const Surroundings one{.obstacles = {polygons[k]}};
        const double alone =
            judge::Ground(one).clearance(judge::view_of(passage), {body, body}, infinity, effort);
        if (alone == 0) first = k;
        least = std::min(least, alone);
      }
      if (passage.half == 0) {
        EXPECT_NEAR(clearance, least, 2e-8);
      } else {
        EXPECT_GE(clearance, least - 2e-8);
      }
      near += clearance > 0 && clearance < most;
      if (passage.half > 0 || clearance > 0 || least > 0) continue;
      ++touched;
      EXPECT_EQ(ground.first_within(0, judge::view_of({passage.middle}), {body, body}).name,
                "obstacles[" + std::to_string(first) + "]");
    }
  });
  EXPECT_GT(touched, cases(3000) / 8);
  EXPECT_GT(near, cases(3000) / 2);
}

/// Triangles on some spots, each around the one before it: near by, far away, on top of it.
std::vector<Polygon> many_triangles(Rng& rng) {
  std::vector<Polygon> triangles(static_cast<std::size_t>(any_count(256, 4000, rng)));
  Point spot{};
  double spread = any_size(1e-6, 1e4, rng);
  for (Polygon& triangle : triangles) {
    if (chance(0.002, rng)) {
      spot = towards(spot, uniform(-pi, pi, rng), any_size(1e-3, 1e5, rng));
      spread = chance(0.2, rng) ? 0 : any_size(1e-6, 1e4, rng);
    }
    const Point middle = towards(spot, uniform(-pi, pi, rng), spread * uniform01(rng));
    const double size = any_size(1e-3, chance(0.01, rng) ? 1e3 : 5, rng);
    const double turn = uniform(-pi, pi, rng);
    for (const double angle : {0.0, 2.0, 4.0}) {
      triangle.push_back(towards(middle, turn + angle, size));
    }
  }
  return triangles;
}

// A tree that counts polygons into squares, against trees of so few that none is counted.
TEST(JudgeCrowdLaw, ManyPolygonsAreAsNearAsAFewAtATime) {
  constexpr std::size_t few = 100;
  int touched = 0;
  int near = 0;
  for_each_case(4, 200, [&](Rng& rng) {
    const judge::Outline body = rectangle_of(footprint(any_vehicle(rng)));
    const std::vector<Polygon> polygons = many_triangles(rng);
    const Surroundings all{.obstacles = polygons};
    const judge::Ground ground(all);
    for (int i = 0; i < 5; ++i) {
      const Point& corner = polygons[rng() % polygons.size()][0];
      const double aside = any_size(1e-3, 1e3, rng);
      const judge::Passage passage{{corner.x + aside, corner.y - aside, uniform(-pi, pi, rng)}};
      const judge::View view = judge::view_of(passage);
      judge::Effort effort;
      double least = infinity;
      std::string first;
      for (std::size_t k = 0; k < polygons.size(); k += few) {
        const auto begin = polygons.begin() + static_cast<std::ptrdiff_t>(k);
        const auto count = static_cast<std::ptrdiff_t>(std::min(few, polygons.size() - k));
        const Surroundings some{.obstacles = {begin, begin + count}};
        least =
            std::min(least, judge::Ground(some).clearance(view, {body, body}, infinity, effort));
        if (least > 0 || !first.empty()) continue;
        const std::string name = judge::Ground(some).first_within(0, view, {body, body}).name;
        first = "obstacles[" + std::to_string(k + std::stoul(name.substr(10))) + "]";
      }
      EXPECT_NEAR(ground.clearance(view, {body, body}, infinity, effort), least, 2e-8);
      near += least > 0;
      if (least > 0) continue;
      ++touched;
      EXPECT_EQ(ground.first_within(0, view, {body, body}).name, first);
    }
  });
  EXPECT_GT(touched, cases(200) / 8);
  EXPECT_GT(near, cases(200) / 2);
}

// ---- Whole paths ----

struct Verdicts {
  int valid = 0;
  int grazing = 0;  // by less than 5 mm
  int invalid = 0;
  int kerbs = 0;  // that were hit
};

void expect_verdict(const Vehicle& vehicle, const Surroundings& surroundings, const Path& path,
                    Verdicts& verdicts) {
  const PathCheck check = check_path(problem_of_path(surroundings, path, vehicle), path);
  ASSERT_TRUE(check.clearance) << check.reason;
  const std::vector<Foes> foes = {{footprint(vehicle), surroundings.obstacles},
                                  {wheel_footprint(vehicle), surroundings.kerbs}};
  expect_as_seen(check, foes, path);
  if (testing::Test::HasFatalFailure()) return;
  ++(check.valid ? verdicts.valid : verdicts.invalid);
  verdicts.grazing += check.valid && check.clearance < 5e-3;
  verdicts.kerbs += check.reason.starts_with("the wheels hit kerbs[");
}

TEST(JudgeCrowdLaw, VerdictClearanceAndPlaceAreThoseOfLookingEverywhere) {
  constexpr int count = 1500;
  Verdicts verdicts;
  for_each_case(2, count, [&](Rng& rng) {
    Vehicle vehicle = any_vehicle(rng);
    if (chance(0.3, rng)) vehicle.track_width = vehicle.width * uniform(0.3, 1, rng);
    const Path path = any_path(rng);
    Surroundings surroundings{.bounds = wide};
    surroundings.obstacles = any_polygons(any_count(1, 20, rng), vehicle, path, rng);
    if (chance(0.5, rng)) graze(surroundings.obstacles, footprint(vehicle), path, rng);
    if (chance(0.3, rng)) {
      surroundings.kerbs = any_polygons(any_count(1, 20, rng), vehicle, path, rng);
    }
    SCOPED_TRACE(as_code(path) + " among " + as_code(surroundings.obstacles) + " and kerbs " +
                 as_code(surroundings.kerbs));
    expect_verdict(vehicle, surroundings, path, verdicts);
  });
  EXPECT_GT(verdicts.valid, cases(count) / 8);
  EXPECT_GT(verdicts.grazing, cases(count) / 16);
  EXPECT_GT(verdicts.invalid, cases(count) / 4);
  EXPECT_GT(verdicts.kerbs, cases(count) / 64);
}

// ---- How exactly it sees far corners ----

using Exact = long double;  // 11 bits more than a double

struct ExactPoint {
  Exact x, y;
};

Exact distance_to(const ExactPoint& p, const ExactPoint& a, const ExactPoint& b) {
  const Exact dx = b.x - a.x;
  const Exact dy = b.y - a.y;
  const Exact along = (p.x - a.x) * dx + (p.y - a.y) * dy;
  const Exact part = std::clamp(along / (dx * dx + dy * dy), Exact{0}, Exact{1});
  return std::hypot(p.x - a.x - part * dx, p.y - a.y - part * dy);
}

/// Between the vehicle and a side that does not touch it.
Exact exact_distance(const judge::Outline& body, const judge::Position& p, const Polygon& side) {
  const Exact cos = std::cos(p.heading);
  const Exact sin = std::sin(p.heading);
  std::vector<ExactPoint> corners;
  judge::for_each_corner(body, [&](const Point& c) {
    corners.push_back({p.x + c.x * cos - c.y * sin, p.y + c.x * sin + c.y * cos});
  });
  const ExactPoint a{side[0].x, side[0].y};
  const ExactPoint b{side[1].x, side[1].y};
  Exact least = infinity;
  for (std::size_t i = 0; i < 4; ++i) {
    least = std::min({least, distance_to(corners[i], a, b),
                      distance_to(a, corners[i], corners[(i + 1) % 4]),
                      distance_to(b, corners[i], corners[(i + 1) % 4])});
  }
  return least;
}

// docs/proofs/judge.md derives 1e-8 m for corners 3*10^6 m from the start.
TEST(JudgeCrowdLaw, SidesWithFarEndsAreAsFarAwayAsTheyAre) {
  int far = 0;
  for_each_case(3, 300000, [&](Rng& rng) {
    const double driven = any_size(1, 1e6, rng);
    const Pose pose = uniform_pose({-driven, driven, -driven, driven}, rng);
    const judge::Position position{pose.x + Exact{1e-11}, pose.y, pose.heading};
    const Point near = towards({pose.x, pose.y}, uniform(-pi, pi, rng), any_size(1, 1e3, rng));
    const double angle = uniform(-pi, pi, rng);
    const Point a = towards(near, angle, uniform(1, 4e6, rng));
    const Point b = towards(near, angle + pi, uniform(1, 4e6, rng));
    const Surroundings side{.obstacles = {{a, b, b}}};
    const judge::Outline body = rectangle_of(footprint(Vehicle{}));
    judge::Effort effort;
    const double seen =
        judge::Ground(side).clearance(judge::view_of({position}), {body, body}, infinity, effort);
    const double furthest_end =
        std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    if (seen == 0 || furthest_end > furthest) return;
    EXPECT_LE(std::abs(seen - exact_distance(body, position, side.obstacles[0])), 1e-8L);
    far += furthest_end > furthest / 2;
  });
  EXPECT_GT(far, cases(300000) / 8);
}

}  // namespace
}  // namespace vandplan

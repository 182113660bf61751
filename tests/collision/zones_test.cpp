// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Which segments break the rule of a zone, compared with looking at every millimetre.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/cases.h"
#include "support/collision_oracle.h"
#include "support/draws.h"
#include "support/problems.h"
#include "vandplan/collision.h"
#include "vandplan/path.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using std::numbers::pi;

constexpr Bounds everywhere{-1e3, 1e3, -1e3, 1e3};

/// A triangle, a box or a concave polygon near the origin.
Polygon any_area(Rng& rng) {
  const Point at{uniform(-4, 4, rng), uniform(-4, 4, rng)};
  const double size = any_size(0.02, 5, rng);
  Polygon area;
  const int count = static_cast<int>(uniform(3, 8, rng));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * (i + uniform(-0.3, 0.3, rng)) / count;
    const double radius = size * uniform(0.3, 1, rng);
    area.push_back({at.x + radius * std::cos(angle), at.y + radius * std::sin(angle)});
  }
  if (chance(0.5, rng)) std::reverse(area.begin(), area.end());
  return area;
}

Zone any_zone(Rng& rng) {
  Zone zone{.area = any_area(rng), .body = chance(0.4, rng)};
  const double kind = uniform01(rng);
  if (kind < 0.3) {
    zone.closed = true;
  } else if (kind < 0.6) {
    zone.gears = chance(0.5, rng) ? AllowedGears::forward : AllowedGears::reverse;
  } else {
    const double from = uniform(-4, 4, rng);
    zone.direction = {from, from + uniform(0, 4, rng)};
  }
  return zone;
}

/// How far outside of a range an angle is [rad]; negative inside.
double off_range(double angle, const HeadingRange& range) {
  const double half = width(range) / 2;
  return std::abs(wrap_angle(angle - range.from - half)) - half;
}

/// Least distance from the area where the rule does not hold [m]. `slack`: how far off a direction
/// may be [rad].
double least_distance(const Zone& zone, const Vehicle& vehicle, const Pose& from,
                      const Segment& segment, double slack) {
  const Polygon body = zone.body ? OracleBody(vehicle).corners : Polygon{{0, 0}};
  const bool is_wrong_gear =
      zone.gears == (segment.length < 0 ? AllowedGears::forward : AllowedGears::reverse);
  double least = std::numeric_limits<double>::infinity();
  const double length = std::abs(segment.length);
  const auto count = static_cast<int>(std::ceil(length / 2e-3));
  for (int i = 0; i <= count; ++i) {
    const Pose pose = advance(from, part_of(segment, 0, length * i / count));
    const double travel = pose.heading + (segment.length < 0 ? pi : 0);
    const bool is_astray = zone.direction && off_range(travel, *zone.direction) > slack;
    if (!zone.closed && !is_wrong_gear && !is_astray) continue;
    Polygon there;
    for (const Point& corner : body) {
      const Pose at = compose(pose, {corner.x, corner.y, 0});
      there.push_back({at.x, at.y});
    }
    if (contains(zone.area, {pose.x, pose.y})) return 0;
    least = std::min(least, gap_between(there, zone.area).distance);
  }
  return least;
}

TEST(Zones, BreakWhereAMillimetreByMillimetreLookSaysSo) {
  for_each_case(11, 3000, [](Rng& rng) {
    const Zone zone = any_zone(rng);
    Vehicle vehicle;
    vehicle.min_turning_radius = 1e-3;
    const CollisionChecker checker(vehicle, Surroundings{.bounds = everywhere, .zones = {zone}});
    const Pose from{uniform(-6, 6, rng), uniform(-6, 6, rng), uniform(-pi, pi, rng)};
    Segment segment{uniform(-0.5, 0.5, rng), any_sign(any_size(0.05, 8, rng), rng)};
    if (chance(0.3, rng)) segment.curvature = 0;
    if (chance(0.4, rng)) segment.curvature_rate = uniform(-0.1, 0.1, rng);
    // A search from the goal asks for the same drive from its end.
    const Segment back{curvature_at(segment, std::abs(segment.length)), -segment.length,
                       -segment.curvature_rate};
    const bool is_free =
        chance(0.5, rng) ? checker.is_free(Local(from), segment)
                         : checker.is_free(Local(advance(from, segment)), back, InTime::backward);
    // Between two looks nothing moves further than this.
    const double step = zone.body ? 8e-3 : 2e-3;
    const double surely = least_distance(zone, vehicle, from, segment, 1e-6);
    const double at_most = least_distance(zone, vehicle, from, segment, -0.01);
    if (surely == 0) {
      EXPECT_FALSE(is_free) << as_code(from) << as_code(segment);
    }
    if (at_most > step + CollisionChecker::tolerance) {
      EXPECT_TRUE(is_free) << as_code(from) << as_code(segment);
    }
  });
}

/// A checker of one zone alone.
struct Alone {
  explicit Alone(const Zone& zone, const Vehicle& vehicle = {})
      : checker(vehicle, Surroundings{.bounds = everywhere, .zones = {zone}}) {}

  CollisionChecker checker;
};

TEST(Zones, OfTheAxleDoNotMindTheBody) {
  Zone zone{.area = box(5, -1, 6, 1), .closed = true};
  const LocalPose from(Pose{0, 0, 0});
  EXPECT_TRUE(Alone(zone).checker.is_free(from, Segment{0, 4.998}));
  EXPECT_FALSE(Alone(zone).checker.is_free(from, Segment{0, 5}));
  zone.body = true;
  EXPECT_FALSE(Alone(zone).checker.is_free(from, Segment{0, 4.998}));
  const double front = footprint(Vehicle{}).front;
  EXPECT_TRUE(Alone(Zone{.area = box(front + 2, -1, front + 3, 1), .closed = true, .body = true})
                  .checker.is_free(from, Segment{0, 1.998}));
}

TEST(Zones, StandingBreaksNoGear) {
  const LocalPose there(Pose{5.5, 0, 0});
  const Zone closed{.area = box(5, -1, 6, 1), .closed = true};
  const Zone one_gear{.area = box(5, -1, 6, 1), .gears = AllowedGears::forward};
  EXPECT_FALSE(Alone(closed).checker.is_free(there));
  EXPECT_TRUE(Alone(one_gear).checker.is_free(there));
  EXPECT_TRUE(Alone(one_gear).checker.is_free(there, Segment{0, 3}));
  EXPECT_FALSE(Alone(one_gear).checker.is_free(there, Segment{0, -3}));
  EXPECT_FALSE(Alone(one_gear).checker.is_free(there, Segment{0, 3}, InTime::backward));
}

TEST(Zones, OneWayStreetsAllowBothEndsOfTheirRange) {
  const Zone street{.area = box(-10, -10, 10, 10), .direction = HeadingRange{0, pi / 2}};
  const Alone alone(street);
  const CollisionChecker& checker = alone.checker;
  EXPECT_TRUE(checker.is_free(Local(Pose{0, 0, 0}), Segment{0, 3}));
  EXPECT_TRUE(checker.is_free(Local(Pose{0, 0, pi / 2}), Segment{0, 3}));
  EXPECT_TRUE(checker.is_free(Local(Pose{0, 0, -pi / 2}), Segment{0, -3}));  // in reverse
  EXPECT_FALSE(checker.is_free(Local(Pose{0, 0, pi}), Segment{0, 3}));
  EXPECT_FALSE(checker.is_free(Local(Pose{0, 0, -1e-6}), Segment{0, 3}));
  EXPECT_TRUE(checker.is_free(Local(Pose{-9, -9, 0}), Segment{0.1, 5 * pi}));  // to pi / 2
  EXPECT_FALSE(checker.is_free(Local(Pose{-9, -9, 0}), Segment{0.1, 5 * pi + 0.01}));
}

TEST(Zones, TheTrailerCountsAsBody) {
  Zone zone{.area = box(-9, -1, -8, 1), .closed = true, .body = true};
  const LocalPose from(Pose{0, 0, 0});
  EXPECT_FALSE(Alone(zone, semitrailer()).checker.is_free(from, Segment{0, 1}));
  zone.body = false;
  EXPECT_TRUE(Alone(zone, semitrailer()).checker.is_free(from, Segment{0, 1}));
}

}  // namespace
}  // namespace vandplan

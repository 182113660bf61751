// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/route.h"

#include <gtest/gtest.h>

#include <numbers>
#include <span>
#include <vector>

#include "../support/cases.h"
#include "../support/problems.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using search::are_alike;
using search::Connector;
using search::part_of;
using search::Route;

constexpr Local<Bounds> local_region(Bounds{-30, 30, -30, 30});

Route random_route(Rng& rng) {
  const Problem problem = problem_of({0, 0, 0}, {1, 0, 0}, {});
  Connector connector(problem.task());
  Route route{uniform_pose(local_region, rng), {}, 0.0};
  LocalPose at = route.start;
  for (int leg = 0; leg < 4; ++leg) {
    const LocalPose next = uniform_pose(local_region, rng);
    route.legs.push_back({*connector.steer(at, next), next});
    at = next;
  }
  return route;
}

void expect_near(const Pose& a, const Pose& b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
  EXPECT_NEAR(std::remainder(a.heading - b.heading, 2 * std::numbers::pi), 0.0, 1e-9);
}

TEST(Route, ThreePartsMakeTheWhole) {
  for_each_case(1, 500, [](Rng& rng) {
    const Route route = random_route(rng);
    const Path path = path_of(route);
    const double whole = route.length();
    double a = uniform(0, whole, rng), b = uniform(0, whole, rng);
    if (a > b) std::swap(a, b);
    Pose at = route.start;
    double sum = 0.0;
    for (const Route& part :
         {part_of(route, 0.0, a), part_of(route, a, b), part_of(route, b, whole)}) {
      expect_near(part.start, at);
      at = end_pose(path_of(part));
      expect_near(part.legs.back().end, at);
      sum += part.length();
      expect_near(at, pose_at(path, sum));
    }
    EXPECT_NEAR(sum, whole, 1e-9);
    EXPECT_NEAR(part_of(route, a, b).length(), b - a, 1e-9);
  });
}

TEST(Route, APartOfNoLengthIsEmpty) {
  Rng rng(1);
  const Route route = random_route(rng);
  EXPECT_TRUE(part_of(route, 0.0, 0.0).legs.empty());
  EXPECT_TRUE(part_of(route, route.length(), route.length()).legs.empty());
}

// Two places of a route may be one, and what is cut there has no length.
TEST(Route, APartGoesOnBehindASegmentOfNoLength) {
  Piece piece;
  piece.segments[piece.count++] = {0.1, 0.0};
  piece.segments[piece.count++] = {0.0, 5.0};
  piece.length = 5.0;
  EXPECT_EQ(search::prefix(piece, 3.0).length, 3.0);
  EXPECT_EQ(search::suffix(piece, 3.0).length, 2.0);
  const Route route{{}, {{piece, LocalPose({5, 0, 0})}}, 5.0};
  EXPECT_EQ(part_of(route, 0.0, 3.0).length(), 3.0);
}

// Fewer legs, as many, more, none, and legs at either end.
TEST(Route, LegsTakeThePlaceOfOthers) {
  Rng rng(1);
  const Route old = random_route(rng);
  const Route other = random_route(rng);
  const auto ends_of = [](std::span<const search::Leg> legs) {
    std::vector<double> ends;
    for (const search::Leg& leg : legs) ends.push_back(leg.end.x);
    return ends;
  };
  for (std::size_t first = 0; first <= old.legs.size(); ++first) {
    for (std::size_t last = first; last <= old.legs.size(); ++last) {
      for (std::size_t count = 0; count <= other.legs.size(); ++count) {
        const auto fresh = std::span(other.legs).first(count);
        Route route = old;
        route.replace(first, last, fresh);
        std::vector<double> ends = ends_of(std::span(old.legs).first(first));
        for (const double end : ends_of(fresh)) ends.push_back(end);
        for (const double end : ends_of(std::span(old.legs).subspan(last))) ends.push_back(end);
        EXPECT_EQ(ends_of(route.legs), ends) << first << " " << last << " " << count;
      }
    }
  }
}

TEST(Route, AlikeIsWhatIsNearAndChangesGearAsOften) {
  const auto route_of = [](std::vector<Segment> segments) {
    Route route{{}, {}, 0.0};
    for (const Segment& segment : segments) {
      Piece piece;
      piece.segments[piece.count++] = segment;
      piece.length = std::abs(segment.length);
      route.legs.push_back(
          {piece, advance(route.legs.empty() ? route.start : route.legs.back().end, segment)});
    }
    return route;
  };
  const Route straight = route_of({{0, 30}});
  EXPECT_TRUE(are_alike(straight, straight, 1e-6));
  const Route waving = route_of({{0.1, 2}, {-0.1, 4}, {0.1, 2}, {0, 22}});
  EXPECT_TRUE(are_alike(straight, waving, 2.0));
  EXPECT_FALSE(are_alike(straight, waving, 0.1));
  const Route there_and_back = route_of({{0, 16}, {0, -1}, {0, 15}});
  EXPECT_FALSE(are_alike(straight, there_and_back, 5.0));
}

}  // namespace
}  // namespace vandplan

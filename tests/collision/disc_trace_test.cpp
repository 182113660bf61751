// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Where the trace of discs has no doubt, no cell is touched; where it sees a hit, one is. Cells lie
// near corners of the footprint on its way, where discs that are a little too small or walk a
// little too far would miss them.

#include "collision/disc_trace.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cases.h"
#include "support/collision_oracle.h"
#include "support/draws.h"
#include "support/grids.h"

namespace vandplan {
namespace {

constexpr std::int32_t count = 240;  // of rows and columns

/// A segment and one blocked cell beside it.
struct TraceCase {
  Footprint body;
  Pose from;
  Segment segment;
  OccupancyGrid grid;  // its frame begins at the origin
};

TraceCase any_trace_case(Rng& rng) {
  TraceCase c;
  c.body = footprint(any_vehicle(rng));
  c.segment = any_segment(rng);
  const double side = any_size(0.02, 0.3, rng);
  const double extent = count * side;
  const Pose near{uniform(0.3, 0.7, rng) * extent, uniform(0.3, 0.7, rng) * extent,
                  uniform(-3, 3, rng)};
  const double driven = c.segment.length * uniform01(rng);
  c.from = advance(near, {c.segment.curvature, -driven});
  const Point corner = corners(c.body, near)[static_cast<std::size_t>(4 * uniform01(rng))];
  const double away = any_size(1e-3, 2, rng);
  const double beyond = 1 + away / std::hypot(corner.x - near.x, corner.y - near.y);
  const auto index = [&](double from, double to) {
    const double place = (from + beyond * (to - from)) / side;
    return static_cast<std::size_t>(std::clamp(place, 1.0, count - 1.0));
  };
  std::vector<std::string> rows(count, std::string(count, '.'));
  rows[count - index(near.y, corner.y)][index(near.x, corner.x) - 1] = '#';
  c.grid = grid_of(rows, side, {side, side, 0});
  c.grid.unknown_is_free = true;
  return c;
}

/// Whether the footprint touches an obstacle between two places [m].
bool touches(const TraceCase& c, const std::vector<Polygon>& squares, double begin, double end) {
  const double gear = c.segment.length < 0 ? -1 : 1;
  const Pose from = advance(c.from, {c.segment.curvature, gear * begin});
  return comes_within(0, c.body, squares, from, {c.segment.curvature, gear * (end - begin)});
}

TEST(DiscTrace, WhatIsNotInDoubtIsSo) {
  constexpr int cases_count = 4000;
  int hits = 0;
  int partly = 0;
  for_each_case(1, cases_count, [&](Rng& rng) {
    const TraceCase c = any_trace_case(rng);
    const geometry::DistanceField distances(geometry::BlockedCells(c.grid), 1);
    const collision::PlacedSegment placed(collision::placement_of(c.from), c.segment);
    const collision::DiscTrace trace =
        collision::trace_discs(distances, c.grid.resolution, collision::DiscRows({c.body}), placed);
    const std::vector<Polygon> squares = squares_of(c.grid);
    const double length = std::abs(c.segment.length);
    const auto expect = [&](bool touched, double begin, double end) {
      EXPECT_EQ(touches(c, squares, begin, end), touched)
          << as_code(c.from) << " " << as_code(c.segment) << " from " << begin << " to " << end
          << " among " << as_code(squares);
    };
    if (trace.is_hit) {
      ++hits;
      return expect(true, 0, length);
    }
    double clear_from = 0;
    for (const auto& [begin, end] : trace.in_doubt()) {
      if (begin > clear_from) expect(false, clear_from, begin);
      clear_from = end;
    }
    if (clear_from < length) expect(false, clear_from, length);
    partly += !trace.in_doubt().empty() && clear_from < length;
  });
  EXPECT_GT(hits, cases(cases_count) / 100);
  EXPECT_GT(partly, cases(cases_count) / 50);
}

TEST(DiscTrace, OpenGroundIsClearFurtherThanTheFieldKnowsCells) {
  std::vector<std::string> rows(600, std::string(600, '.'));
  rows.back()[0] = '#';
  OccupancyGrid grid = grid_of(rows, 0.1, {0.1, 0.1, 0});
  grid.unknown_is_free = true;
  const geometry::DistanceField distances(geometry::BlockedCells(grid), 3);
  const collision::DiscRows discs({footprint(Vehicle{})});
  const auto is_clear = [&](const collision::Placement& from) {
    const collision::DiscTrace trace =
        collision::trace_discs(distances, 0.1, discs, {from, {0, 45}});
    return !trace.is_hit && trace.in_doubt().empty();
  };
  EXPECT_TRUE(is_clear({{10, 10}, {1, 0}}));
  EXPECT_FALSE(is_clear({{46, 1}, {-1, 0}}));
}

}  // namespace
}  // namespace vandplan

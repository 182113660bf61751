// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is it true what the judge says of clearance and of the first collision? Compared with looking
// everywhere (slow_judge.h).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/slow_judge.h"
#include "vandplan/judge.h"
#include "vandplan/path.h"

namespace vandplan {

constexpr double look_step = 1e-3;  // of any point of the body between two looks of the judge [m]
constexpr double deepest_dip = look_step / 2;  // into an obstacle, between two of them [m]

/// An outline of the vehicle and what it must not touch.
struct Foes {
  Footprint outline;
  std::vector<Polygon> polygons;
};

inline Footprint shrunk(const Footprint& body, double by) {
  return {body.rear - by, body.front - by, body.half_width - by};
}

/// No more than 1 mm above the truth, no less than it, and nothing is entered unseen.
inline void expect_clearance(double clearance, const std::vector<Foes>& foes, const Path& path) {
  constexpr double moved = 0.05;
  double everywhere = std::numeric_limits<double>::infinity();
  double exact = everywhere;
  for (const auto& [outline, polygons] : foes) {
    if (polygons.empty()) continue;
    everywhere = std::min(everywhere, least_of(look_everywhere(outline, polygons, path, moved)));
    exact = std::min(exact, least_gap(outline, polygons, path, 1e-4).distance);
    EXPECT_FALSE(comes_within(0, shrunk(outline, deepest_dip), polygons, path));
  }
  EXPECT_GT(clearance, 0);
  EXPECT_LE(clearance, everywhere + 1e-3);
  if (std::isinf(everywhere)) return;
  EXPECT_GE(clearance, everywhere - moved / 2);
  EXPECT_LE(clearance, exact + 1e-3);
  EXPECT_GE(clearance, exact - 1e-4);
}

/// Something is touched there, and nothing that goes deep before.
inline void expect_first_touch(const PathPoint& at, const std::vector<Foes>& foes,
                               const Path& path) {
  constexpr double moved = 0.05;
  double there = std::numeric_limits<double>::infinity();
  for (const auto& [outline, polygons] : foes) {
    if (polygons.empty()) continue;
    there = std::min(there, gap_at(outline, polygons, at.pose).distance);
    for (const SlowLook& look :
         look_everywhere(shrunk(outline, deepest_dip), polygons, path, moved)) {
      if (look.s >= at.s - look_step) break;
      EXPECT_GT(look.distance, 0) << look.s << " before " << at.s;
    }
  }
  EXPECT_LE(there, 2e-8);
}

/// The verdict, with its clearance or its place, is that of looking everywhere.
inline void expect_as_seen(const PathCheck& check, const std::vector<Foes>& foes,
                           const Path& path) {
  if (check.valid) {
    expect_clearance(*check.clearance, foes, path);
  } else {
    ASSERT_TRUE(check.at) << check.reason;
    EXPECT_EQ(*check.clearance, 0);
    expect_first_touch(*check.at, foes, path);
  }
}

}  // namespace vandplan

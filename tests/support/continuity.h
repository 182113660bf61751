// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far does a path break the rules of its steering?

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan {

/// The largest jump of the curvature where the wheels cannot be turned at standstill [1/m].
inline double largest_jump(const Path& path, Steering steering, const EndCurvatures& ends) {
  if (path.segments.empty()) return 0.0;
  const auto last = [](const Segment& s) { return curvature_at(s, std::abs(s.length)); };
  double largest = 0.0;
  for (std::size_t i = 1; i < path.segments.size(); ++i) {
    const Segment& before = path.segments[i - 1];
    const Segment& after = path.segments[i];
    const bool stands = before.length * after.length < 0;
    if (stands && steering == Steering::continuous_between_stops) continue;
    largest = std::max(largest, std::abs(after.curvature - last(before)));
  }
  if (steering == Steering::continuous) {
    largest = std::max({largest, std::abs(path.segments.front().curvature - ends.start),
                        std::abs(last(path.segments.back()) - ends.goal)});
  }
  return largest;
}

/// Expects that the wheels of a vehicle can follow the path as it was asked for.
inline void expect_continuous(const Path& path, const Problem& problem, Steering steering) {
  const double radius = problem.vehicle().min_turning_radius;
  EXPECT_LE(largest_jump(path, steering, problem.curvatures()) * radius, 1e-9);
  for (const Segment& segment : path.segments) {
    EXPECT_LE(std::abs(segment.curvature_rate),
              max_curvature_rate(problem.vehicle()) * (1 + 1e-12));
  }
}

}  // namespace vandplan

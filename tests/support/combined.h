// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Plans with every combination of steering, cost, movers and margin.
#include <gtest/gtest.h>

#include <cstdint>
#include <numbers>

#include "support/cases.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan {

/// A car that crosses the x axis at `x`, to the south.
inline MovingObstacle car_across(double x) {
  constexpr double south = -std::numbers::pi / 2;
  return {.outline = {{-2, -1}, {2, -1}, {2, 1}, {-2, 1}},
          .trajectory = {{0, {x, 30, south}}, {12, {x, -30, south}}},
          .after = Afterwards::leaves};
}

/// Options of a combination. `iterations`: most of them, but under sanitizers `few`.
inline PlanOptions combined(Steering steering, CostMeasure measure, double margin,
                            std::int64_t iterations, std::int64_t few) {
  PlanOptions options;
  options.budget = {.max_iterations = is_sanitized ? few : iterations, .seed = 1};
  options.cost.measure = measure;
  options.steering = steering;
  options.clearance = {margin, 0.0};
  return options;
}

/// Whether there is a path to look at. There is one, but for runs of few iterations.
[[nodiscard]] inline bool is_planned(const PlanResult& result) {
  EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
  if (is_sanitized && !result.path) return false;
  EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
  if (!result.path) return false;
  EXPECT_LE(result.lower_bound, result.cost);
  return true;
}

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Scenarios with zones, and options for plans that end after so many iterations.

#include <cstdint>
#include <utility>
#include <vector>

#include "cases.h"
#include "planners/pricing.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan {

/// A drive in open ground with zones.
inline Scenario with_zones(const Pose& start, const Pose& goal, std::vector<Zone> zones) {
  return {.name = "zones",
          .bounds = {-40, 80, -40, 40},
          .start = start,
          .goal = goal,
          .zones = std::move(zones)};
}

/// Options of a run that ends after so many iterations, of fewer under sanitizers.
inline PlanOptions of_iterations(std::int64_t iterations) {
  PlanOptions options;
  options.budget.max_iterations = is_sanitized ? iterations / 20 : iterations;
  return options;
}

/// Cost of a path by the options, as planners compute it.
inline double cost_of(const Problem& problem, const Path& path, const CostOptions& cost = {}) {
  return planning::Pricing(problem.task(), cost)
      .cost(path.segments, search::ClearanceSampling::answer);
}

}  // namespace vandplan

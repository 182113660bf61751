// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// The rapidly-exploring random tree of the thesis, in all its variants.
// Theory and pseudo-code: docs/algorithms/rrt.md.

#include "search/estimates.h"
#include "vandplan/planner.h"

namespace vandplan {

/// Which node becomes the parent of a sample.
enum class Strategy {
  nearest,          ///< BSC: the nearest one by estimate; if that edge is blocked, none
  least_total_cost  ///< OPT: the one through which the sample is reached at the least cost
};

/// Grows a tree from the start until the budget is spent; the best path to the goal counts.
/// Expects start and goal to be free.
[[nodiscard]] PlanResult plan_rrt(const Problem& problem, const PlanOptions& options,
                                  Strategy strategy, Estimate estimate);

}  // namespace vandplan

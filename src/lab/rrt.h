// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// The rapidly-exploring random tree of the thesis, in all its variants.
// Theory and pseudo-code: docs/algorithms/rrt.md.

#include "lab/estimates.h"
#include "vandplan/outcome.h"
#include "vandplan/plan_options.h"

namespace vandplan::rrt {

/// Which node becomes the parent of a sample.
enum class Strategy {
  nearest,          ///< BSC: the nearest one by estimate; if that edge is blocked, none
  least_total_cost  ///< OPT: the one through which the sample is reached at the least cost
};

/// What makes one variant of the tree.
struct Variant {
  Strategy strategy = Strategy::nearest;
  search::Estimate estimate = search::Estimate::euclid;
};

/// The tree's own options; `tries_goal` is the default of one of them.
[[nodiscard]] std::vector<OptionInfo> options(bool tries_goal);

/// Grows a tree from the start until the budget is spent; the best path to the goal counts.
/// Expects start and goal to be free.
[[nodiscard]] PlannerAnswer plan(const Task& task, const PlanOptions& options, Variant variant);

}  // namespace vandplan::rrt

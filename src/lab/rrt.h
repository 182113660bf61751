// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// The rapidly-exploring random tree of the thesis, in all its variants.
// Theory and pseudo-code: docs/algorithms/rrt.md.

#include "lab/estimates.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::rrt {

/// Rule that chooses the parent of a sample.
enum class Strategy {
  nearest,          ///< BSC: nearest node by estimate; none if the edge from it is blocked
  least_total_cost  ///< OPT: node through which the sample has the least cost-to-come
};

/// A variant of the tree: how it chooses parents, and by which estimate.
struct Variant {
  Strategy strategy = Strategy::nearest;
  search::Estimate estimate = search::Estimate::euclid;
};

/// The tree's own options. `tries_goal`: default of "try_goal".
[[nodiscard]] std::vector<OptionInfo> options(bool tries_goal);

/// Grows a tree from the start until the budget is spent or the tree is full. The answer holds the
/// shortest path to the goal that was found. Start and goal must be free.
[[nodiscard]] PlannerAnswer plan(const Task& task, const PlanOptions& options, Variant variant);

}  // namespace vandplan::rrt

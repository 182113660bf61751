// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Hybrid A*: a search over cells of position and heading that keeps one continuous pose in each.
// Theory and pseudo-code: docs/algorithms/hybrid_a_star.md.

#include "vandplan/planner.h"

namespace vandplan::hybrid {

/// The planner "hybrid-a-star".
[[nodiscard]] Planner planner();

/// Searches from the start until the budget is spent, or the cost-to-come + weight * estimate of
/// every waiting node reaches the cost of the best path. Start and goal must be free.
[[nodiscard]] PlannerAnswer plan(const Task& task, const PlanOptions& options);

}  // namespace vandplan::hybrid

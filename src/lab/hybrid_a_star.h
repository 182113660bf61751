// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Hybrid A*: a search over cells of position and heading that keeps one continuous pose in each.
// Theory and pseudo-code: docs/algorithms/hybrid_a_star.md.

#include "vandplan/planner.h"

namespace vandplan::hybrid {

[[nodiscard]] Planner planner();

/// Searches from the start until nothing that is left could lead to a cheaper path, as far as the
/// weighted estimate tells, or the budget is spent. Expects start and goal to be free.
[[nodiscard]] PlannerAnswer plan(const Task& task, const PlanOptions& options);

}  // namespace vandplan::hybrid

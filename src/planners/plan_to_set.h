// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a path to the best goal of a set found?
//
// Method: docs/algorithms/goal_sets.md.

#include "planners/path_search.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// Plans to the cheapest goal of the set of a task. Searches for goals take turns, and promising
/// goals get more work. Then goals between them in continuous regions are tried. Each second costs
/// `time_price` [m] beside the prices of the path; `time_price` is ignored if the cost is the time.
/// Expects the start to be free.
[[nodiscard]] PlannerAnswer plan_to_set(const Task& task, const PlanOptions& options,
                                        double time_price, const SearchTo& search_to);

}  // namespace vandplan::planning

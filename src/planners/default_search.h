// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// The default planner's search: a first path at once, then better ones until the budget is spent.
//
// How it works: docs/algorithms/anytime.md. What was tried: docs/lab/anytime.md.

#include <memory>

#include "planners/anytime/compose.h"
#include "planners/path_search.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// The portfolio of a task, with or without a trailer. Arguments are those of `anytime::compose`.
[[nodiscard]] anytime::Portfolio portfolio_for(const Task& task, const PlanOptions& options,
                                               double time_price, const anytime::Given& given);

/// A search for the cheapest drive: prices of the path plus `time_price` [m] for each second. If
/// the cost is the time, only the seconds count. Expects start and goal to be free. The task and
/// the sources outlive the search.
[[nodiscard]] std::unique_ptr<PathSearch> default_search(const Task& task,
                                                         const PlanOptions& options,
                                                         double time_price,
                                                         const anytime::Given& given);

}  // namespace vandplan::planning

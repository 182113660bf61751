// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// The default planner: a first path at once, then better ones until the budget is spent.
// How it works: docs/algorithms/anytime.md. What was tried: docs/lab/anytime.md.

#include <memory>

#include "planners/anytime/compose.h"
#include "planners/path_search.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::anytime {

/// Searches and shortens until the budget is spent or the path is proven optimal.
/// Expects start and goal to be free.
[[nodiscard]] PlannerAnswer plan_anytime(const Task& task, const PlanOptions& options,
                                         const Given& given = {});

/// A search for the cheapest drive: prices of the path plus `time_price` [m] for each second. If
/// the cost is the time, only the seconds count. Expects start and goal to be free. The task and
/// the sources outlive the search.
[[nodiscard]] std::unique_ptr<planning::PathSearch> drive_search(const Task& task,
                                                                 const PlanOptions& options,
                                                                 double time_price,
                                                                 const Given& given = {});

}  // namespace vandplan::anytime

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// The default planner: a first path at once, then better ones for as long as it may.
// How it works and what was tried: docs/algorithms/anytime.md.

#include <memory>

#include "planners/anytime/compose.h"
#include "planners/path_search.h"
#include "vandplan/outcome.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::anytime {

/// Searches and shortens until the budget is spent or the path is proven optimal.
/// Expects start and goal to be free. With a trailer no notice is taken of what is given.
[[nodiscard]] PlannerAnswer plan_anytime(const Task& task, const PlanOptions& options,
                                         const Given& given = {});

/// A search for the path whose prices and fastest drive cost least together: each second costs
/// `time_price` [m]. Where the cost is the time, the seconds are all that counts. Expects start and
/// goal to be free. The task and the sources outlive the search. With a trailer no notice is taken
/// of what is given.
[[nodiscard]] std::unique_ptr<planning::PathSearch> drive_search(const Task& task,
                                                                 const PlanOptions& options,
                                                                 double time_price,
                                                                 const Given& given = {});

}  // namespace vandplan::anytime

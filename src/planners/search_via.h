// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a path found that passes other places before its goal?
//
// Each leg between two places is a search of its own. Method: docs/algorithms/goal_sets.md.

#include <memory>
#include <span>

#include "planners/path_search.h"
#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// A search for paths that pass the vias of `task`: `search_to` searches for the legs between
/// them. Costs are those of `Pricing` with this `time_price`. The task outlives the search.
/// `known`: path of the task's frame to begin with, or null. `passed`: driven distance to each via
/// on it [m]; if empty, paths past vias begin with none. Legs begin with those of `known`, other
/// legs with a neighbour's. Without vias it is the search of `search_to`.
[[nodiscard]] std::unique_ptr<PathSearch> search_via(const Task& task, const PlanOptions& options,
                                                     double time_price, const Path* known,
                                                     std::span<const double> passed,
                                                     const SearchTo& search_to);

}  // namespace vandplan::planning

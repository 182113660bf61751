// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a path found that passes other places before its goal?
//
// Each leg between two places is a search of its own. Method: docs/algorithms/goal_sets.md.

#include <memory>
#include <vector>

#include "planners/path_search.h"
#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// A path that passes the vias of a task.
struct PathPastVias {
  Path path;                   ///< the path, in the frame of the task
  std::vector<double> passed;  ///< driven distance to each via [m]
};

/// A search for paths that pass the vias of `task` as `along` does at first. Its legs begin with
/// those of `along`, other legs with a neighbour's. Without vias it is the search of `search_to`,
/// which begins with that path. Throughout like the other `search_via`.
[[nodiscard]] std::unique_ptr<PathSearch> search_via(const Task& task, const PlanOptions& options,
                                                     const PathPastVias& along,
                                                     const SearchTo& search_to);

/// A search for paths that pass the vias of `task`: `search_to` searches for the legs between
/// them. Costs are those of `Pricing` with this `time_price`. The task outlives the search. Without
/// vias it is the search of `search_to`, which may begin with the path `known`, or null.
[[nodiscard]] std::unique_ptr<PathSearch> search_via(const Task& task, const PlanOptions& options,
                                                     double time_price, const Path* known,
                                                     const SearchTo& search_to);

}  // namespace vandplan::planning

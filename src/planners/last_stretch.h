// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a path end with a straight line?
//
// The line begins at one state. So a search for paths to that state is enough, in whose end the
// wheels are straight. Method: docs/algorithms/goal_sets.md.

#include <memory>

#include "planners/path_search.h"
#include "planners/search_via.h"
#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// The straight line with which paths of a task end.
[[nodiscard]] inline Segment line_of(const Task& task) { return {0.0, task.last_stretch}; }

/// Whether a task needs no path: the goal is the start, with wheels and trailer as they are.
[[nodiscard]] bool is_there(const Task& task);

/// The task with its one goal as a set if it has vias: what passes them is planned to sets.
[[nodiscard]] Task to_set_behind_vias(Task task);

/// The task of driving to where the straight line of `task` begins. The task itself without one.
[[nodiscard]] Task before_line(const Task& task);

/// A search for paths that pass the vias of `task` and end with its straight line: `search_to`
/// searches for what is between them, and `known` is a path to the goal or null. Costs are those of
/// `Pricing` with this `time_price`. The task outlives the search. Without vias and line it is the
/// search of `search_to`.
[[nodiscard]] std::unique_ptr<PathSearch> search_with_line(const Task& task,
                                                           const PlanOptions& options,
                                                           double time_price, const Path* known,
                                                           const SearchTo& search_to);

/// A search for paths that pass the vias of `task` as `along` does at first, and end with its
/// straight line. Throughout like the other `search_with_line`.
[[nodiscard]] std::unique_ptr<PathSearch> search_with_line(const Task& task,
                                                           const PlanOptions& options,
                                                           const PathPastVias& along,
                                                           const SearchTo& search_to);

}  // namespace vandplan::planning

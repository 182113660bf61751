// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a path end with a straight line?
//
// The line begins at one state. So a search for paths to that state is enough, in whose end the
// wheels are straight. Method: docs/algorithms/goal_sets.md.

#include <memory>
#include <span>

#include "planners/path_search.h"
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

/// A search for paths that pass the vias of `task` and end with its straight line. All else is as
/// for `search_via`.
[[nodiscard]] std::unique_ptr<PathSearch> search_with_line(const Task& task,
                                                           const PlanOptions& options,
                                                           double time_price, const Path* known,
                                                           std::span<const double> passed,
                                                           const SearchTo& search_to);

}  // namespace vandplan::planning

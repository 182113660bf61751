// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which workers does a task need?
//
// This is the only place that asks what kind of task, cost and budget there is.

#include <span>

#include "planners/anytime/portfolio.h"
#include "vandplan/path.h"
#include "vandplan/path_source.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::anytime {

/// What the caller knows of a task.
struct Given {
  /// A path in the frame of the task that was good for a like one; null if there is none. If a
  /// route along it is free, that is the first one, and bettered before others are looked for.
  const Path* known = nullptr;
  std::span<const NamedSource> sources = {};  ///< of paths, beside the planner's own workers
};

/// The cheapest words on open ground, by length and by the prices of a rule, if nothing is in their
/// way. The task has no trailer.
[[nodiscard]] std::vector<search::Route> open_ways(const Task& task, const search::CostRule& rule);

/// The portfolio of a task without a trailer. Each second costs `time_price` [m] beside the prices
/// of the path; without effect where the cost is the time. The task and the sources outlive the
/// portfolio.
[[nodiscard]] Portfolio compose(const Task& task, const PlanOptions& options, double time_price,
                                const Given& given);

}  // namespace vandplan::anytime

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which workers does a task need?
//
// This is the only place that decides by the kind of task, cost and budget who takes part and how
// much. Workers see prices, steering and whether the task goes over a whole site. The run sees its
// limits.

#include <span>

#include "planners/anytime/portfolio.h"
#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan {
class SiteTable;
}

namespace vandplan::anytime {

/// What the caller knows of a task.
struct Given {
  /// A known path in the frame of the task, such as the answer to a similar task; null: none. If a
  /// route along it is free, that is the first route, and it is improved before others are
  /// searched.
  const Path* known = nullptr;
  /// A table that serves the task; null: none. Without a known path its way is the known path.
  const SiteTable* site = nullptr;
  std::span<const NamedSource> sources = {};  ///< sources of paths beside the planner's own workers
};

/// The portfolio of a task without a trailer. Each second costs `time_price` [m] beside the prices
/// of the path; `time_price` is ignored if the cost is the time. The task and the sources outlive
/// the portfolio.
[[nodiscard]] Portfolio compose(const Task& task, const PlanOptions& options, double time_price,
                                const Given& given);

}  // namespace vandplan::anytime

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which workers does a task need?
//
// This is the only place that asks what kind of task, cost and budget there is.

#include "planners/anytime/portfolio.h"
#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

/// The portfolio of a task without a trailer. Each second costs `time_price` [m] beside the prices
/// of the path; without effect where the cost is the time. A route along `known`, in the frame of
/// the task, is taken over if it is free. The task outlives the portfolio.
[[nodiscard]] Portfolio compose(const Task& task, const PlanOptions& options, double time_price,
                                const Path* known, const search::Budget& budget);

}  // namespace vandplan::anytime

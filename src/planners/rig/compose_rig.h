// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which workers does the task of a rig need?

#include "planners/anytime/compose.h"

namespace vandplan::rig {

/// The portfolio of a task with a trailer, as `anytime::compose` makes that of others. Its workers
/// find drives, not routes.
[[nodiscard]] anytime::Portfolio compose(const Task& task, const PlanOptions& options,
                                         double time_price, const anytime::Given& given);

}  // namespace vandplan::rig

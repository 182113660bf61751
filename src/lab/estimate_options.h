// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which estimate guides a planner of the laboratory, and which options does it have?

#include <string_view>
#include <vector>

#include "planners/registered.h"
#include "vandplan/graphs.h"
#include "vandplan/plan_options.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// Value of the option "max_with" without a second estimate.
inline constexpr std::string_view no_estimate = "none";

/// Sampling region that complete options name.
[[nodiscard]] Region region_of(const PlanOptions& options);

/// Options "estimate" and "max_with": the estimate that guides a search, and a second one; the
/// larger value counts.
[[nodiscard]] std::vector<OptionInfo> estimate_options(std::string_view default_value,
                                                       std::string_view max_with = no_estimate);

/// Sets the properties of a planner that takes an estimate: `search`, its own name; `estimate`, the
/// one that guides it by default; `Capability::site`.
void name_estimate(Planner& planner);

/// Estimate of a name under complete options. The task outlives it. Throws InputError naming "site"
/// if it looks up a table that does not serve the task.
[[nodiscard]] search::GoalEstimate estimate_named(std::string_view name, const PlanOptions& options,
                                                  const Task& task);

/// Estimate that complete options name. The task outlives it.
[[nodiscard]] search::GoalEstimate estimate_of(const PlanOptions& options, const Task& task);

}  // namespace vandplan::planning

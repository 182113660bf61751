// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which options do several planners have?

#include <optional>
#include <string_view>
#include <vector>

#include "vandplan/graphs.h"
#include "vandplan/plan_options.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// Names of the options of a search that is guided by an estimate of the cost-to-go.
inline constexpr std::string_view estimate_key = "estimate";
inline constexpr std::string_view max_with_key = "max_with";
/// Names of `PlanOptions::table` and `PlanOptions::site`, the tables of such an estimate.
inline constexpr std::string_view table_key = "table";
inline constexpr std::string_view site_key = "site";

/// Option "region": sampling region.
[[nodiscard]] OptionInfo region_option();

/// Sampling region that complete options name.
[[nodiscard]] Region region_of(const PlanOptions& options);

/// Options "estimate" and "max_with": the estimate that guides a search, and a second one; the
/// larger value counts.
[[nodiscard]] std::vector<OptionInfo> estimate_options(std::string_view default_value,
                                                       std::string_view max_with = "none");

/// Sets the properties of a planner that takes an estimate: `search`, its own name; `estimate`, the
/// one that guides it by default; `Capability::site`.
void name_estimate(Planner& planner);

/// Estimate of a name under complete options. The task outlives it. Throws InputError naming "site"
/// if it looks up a table that does not serve the task.
[[nodiscard]] search::GoalEstimate estimate_named(std::string_view name, const PlanOptions& options,
                                                  const Task& task);

/// Estimate that complete options name. The task outlives it.
[[nodiscard]] search::GoalEstimate estimate_of(const PlanOptions& options, const Task& task);

/// A planner with an estimate by name, or with the larger of two: "hlut-4", "max-hlut-4-bound".
/// None if the name is unknown or the planner takes no estimate.
[[nodiscard]] std::optional<Planner> with_estimate(Planner planner, std::string_view estimate);

}  // namespace vandplan::planning

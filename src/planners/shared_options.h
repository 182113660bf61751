// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which options do several planners have?

#include <optional>
#include <string_view>
#include <vector>

#include "vandplan/goal_estimate.h"
#include "vandplan/plan_options.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// Options of a search that an estimate guides.
inline constexpr std::string_view estimate_key = "estimate";
inline constexpr std::string_view max_with_key = "max_with";
/// `PlanOptions::table`, which comes along with them.
inline constexpr std::string_view table_key = "table";

/// "region": where samples are drawn.
[[nodiscard]] OptionInfo region_option();

/// The region that complete options name.
[[nodiscard]] Region region_of(const PlanOptions& options);

/// "estimate" and "max_with": what guides a search to the goal, and what it is raised to.
[[nodiscard]] std::vector<OptionInfo> estimate_options(std::string_view standard,
                                                       std::string_view max_with = "none");

/// Says in the properties of a planner that takes an estimate which search it is, and which
/// estimate guides it if nobody asks for another one.
void name_estimate(Planner& planner);

/// The estimate that complete options name. The task outlives it.
[[nodiscard]] search::GoalEstimate estimate_of(const PlanOptions& options, const Task& task);

/// A planner with one estimate by name or the larger of two: "hlut-4", "max-hlut-4-bound". None if
/// there is none of that name, or the planner takes none.
[[nodiscard]] std::optional<Planner> with_estimate(Planner planner, std::string_view estimate);

}  // namespace vandplan::planning

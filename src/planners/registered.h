// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which planners does the library bring?

#include <optional>
#include <string_view>
#include <vector>

#include "vandplan/planner.h"

namespace vandplan::planning {

/// All planners of the library, the default one first, in the order of the documentation.
[[nodiscard]] std::vector<Planner> registered_planners();

/// The planners of the folder `lab`, to compare the default one with: the thesis' trees and others'
/// methods. Nothing else of the library uses that folder.
[[nodiscard]] std::vector<Planner> laboratory();

/// Trees of the thesis that rank nodes by the estimate "site". They are not among `planners()`,
/// since they cannot plan without a table of the site.
[[nodiscard]] std::vector<Planner> laboratory_of_sites();

/// Names of the options of a search that is guided by an estimate of the cost-to-go.
inline constexpr std::string_view estimate_key = "estimate";
inline constexpr std::string_view max_with_key = "max_with";
/// Names of `PlanOptions::table` and `PlanOptions::site`, the tables of such an estimate.
inline constexpr std::string_view table_key = "table";
inline constexpr std::string_view site_key = "site";

/// Gives a planner of the laboratory an estimate by name, or the larger of two: "hlut-4",
/// "max-hlut-4-bound". None if the name is unknown or the planner takes no estimate.
[[nodiscard]] std::optional<Planner> with_estimate(Planner planner, std::string_view estimate);

/// Option "region": sampling region.
[[nodiscard]] OptionInfo region_option();

}  // namespace vandplan::planning

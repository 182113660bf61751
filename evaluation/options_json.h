// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are options written down, so that they read back as they were?

#include <string>
#include <utility>
#include <vector>

#include "vandplan/plan_options.h"

namespace vandplan::evaluation {

/// Every option but the seed with its value as JSON: those of budget and cost, then the planner's
/// own by name. Numbers that are not whole keep a point, so that their type is seen.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> option_values(
    const PlanOptions& options);

/// Name and value beside the options of a run whose times are processor time.
inline const std::pair<std::string, std::string> processor_clock = {"clock", "\"processor\""};

/// The options but for the seed as a JSON object, and back with their types. Reading throws
/// InputError for text that is no JSON object of options.
[[nodiscard]] std::string options_to_json(const PlanOptions& options);
[[nodiscard]] PlanOptions options_from_json(const std::string& json);

}  // namespace vandplan::evaluation

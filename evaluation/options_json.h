// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are options written so that they read back unchanged?

#include <string>
#include <utility>
#include <vector>

#include "vandplan/plan_options.h"

namespace vandplan::evaluation {

/// Names and JSON values of all options without the seed: budget and cost first, then those of the
/// planner by name. Whole numbers of type double keep a point, so that their type is seen.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> option_values(
    const PlanOptions& options);

/// Additional entry (name, JSON value) in the options of runs whose times are processor time.
inline const std::pair<std::string, std::string> processor_clock = {"clock", "\"processor\""};

/// JSON object of all options without the seed, and the options of such an object. Reading throws
/// InputError for text that is no JSON object of options.
[[nodiscard]] std::string options_to_json(const PlanOptions& options);
[[nodiscard]] PlanOptions options_from_json(const std::string& json);

}  // namespace vandplan::evaluation

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) What do the parts of a comparison look like in JSON?

#include <nlohmann/json.hpp>

#include "evaluation/report.h"

namespace vandplan {

using OrderedJson = nlohmann::ordered_json;

[[nodiscard]] OrderedJson environment_json(const Environment& environment);

/// JSON knows no infinity: null.
[[nodiscard]] OrderedJson finite_json(double value);

[[nodiscard]] OrderedJson json_of(const MedianEstimate& estimate);

/// One planner on a scenario; with the furthest distance of a row of goals.
[[nodiscard]] OrderedJson json_of(const MethodSummary& method, bool row);

/// One planner against its Euclid twin on a scenario.
[[nodiscard]] OrderedJson json_of(const TwinComparison& twins);

/// What planning, judging and storing took, all sessions together [s]; `rest` is what the workers
/// waited or did something else. Storing goes on beside them.
[[nodiscard]] OrderedJson harness_json(const std::vector<Session>& sessions);

/// Every planner against its Euclid twin, over all scenarios of a region together.
[[nodiscard]] OrderedJson pooled_json(const Summary& summary);

[[nodiscard]] OrderedJson claims_json(const std::vector<Finding>& findings);

/// By region.
[[nodiscard]] OrderedJson headlines_json(const Summary& summary);

[[nodiscard]] const char* name_of(Region region) noexcept;

}  // namespace vandplan

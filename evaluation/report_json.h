// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) What do the parts of a comparison look like in JSON?

#include <nlohmann/json.hpp>

#include "evaluation/report.h"

namespace vandplan::evaluation {

using OrderedJson = nlohmann::ordered_json;

/// "better", "worse", "no difference" or "nothing searched".
[[nodiscard]] const char* verdict_name(PairedComparison::Verdict verdict);

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
[[nodiscard]] OrderedJson headlines_json(const Report& report);

/// Sentences that say which claims hold where.
[[nodiscard]] OrderedJson verdicts_json(const std::vector<Finding>& findings);

/// What the judge rejected: for each planner how many paths, and why the first of them.
[[nodiscard]] OrderedJson rejected_json(const std::vector<RunRecord>& runs);

/// What is the same for all planners, by name.
[[nodiscard]] OrderedJson shared_options_json(const ReportOptions& options);
/// What differs: name, value and the planners that have it.
[[nodiscard]] OrderedJson differing_options_json(const ReportOptions& options);

/// Every search with every estimate, by region.
[[nodiscard]] OrderedJson search_matrix_json(const Report& report);

/// What the literature says of two planners, and what pairs of runs say.
[[nodiscard]] OrderedJson literature_json(const Report& report);

/// What tells planners apart.
[[nodiscard]] OrderedJson planners_json(const std::vector<Planner>& planners);

}  // namespace vandplan::evaluation

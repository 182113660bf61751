// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) How do the parts of a comparison look in JSON?

#include <nlohmann/json.hpp>

#include "evaluation/report.h"

namespace vandplan::evaluation {

using OrderedJson = nlohmann::ordered_json;

/// Name of a verdict: "better", "worse", "no difference" or "nothing searched".
[[nodiscard]] const char* verdict_name(PairedComparison::Verdict verdict);

[[nodiscard]] OrderedJson environment_json(const Environment& environment);

/// The number, or null if it is infinite, which JSON cannot express.
[[nodiscard]] OrderedJson finite_json(double value);

[[nodiscard]] OrderedJson json_of(const MedianEstimate& estimate);

/// One planner on a scenario; with `row` also the furthest distance of its row of goals.
[[nodiscard]] OrderedJson json_of(const MethodSummary& method, bool row);

/// One planner against its Euclid twin on a scenario.
[[nodiscard]] OrderedJson json_of(const TwinComparison& twins);

/// Times of planning, judging and storing, summed over all sessions [s]. `rest` is the other time
/// of the workers, such as waiting. Storing runs beside the workers.
[[nodiscard]] OrderedJson harness_json(const std::vector<Session>& sessions);

/// Every planner against its Euclid twin, over all scenarios of a region together.
[[nodiscard]] OrderedJson pooled_json(const Summary& summary);

[[nodiscard]] OrderedJson claims_json(const std::vector<Finding>& findings);

/// Headlines by region.
[[nodiscard]] OrderedJson headlines_json(const Report& report);

/// Sentences on where each claim holds.
[[nodiscard]] OrderedJson verdicts_json(const std::vector<Finding>& findings);

/// Rejected paths: for each planner their number and the reason of the first.
[[nodiscard]] OrderedJson rejected_json(const std::vector<RunRecord>& runs);

/// Options that are equal for all planners, by name.
[[nodiscard]] OrderedJson shared_options_json(const ReportOptions& options);
/// Options that differ: name, value, and the planners with that value.
[[nodiscard]] OrderedJson differing_options_json(const ReportOptions& options);

/// Every search with every estimate, by region.
[[nodiscard]] OrderedJson search_matrix_json(const Report& report);

/// Claims of the literature about two planners, and the results of pairs of runs.
[[nodiscard]] OrderedJson literature_json(const Report& report);

/// Names, summaries and properties of planners.
[[nodiscard]] OrderedJson planners_json(const std::vector<Planner>& planners);

}  // namespace vandplan::evaluation

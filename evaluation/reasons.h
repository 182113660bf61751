// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) Which runs explain the effects of the thesis' tables?

#include <string>
#include <vector>

#include "evaluation/findings.h"

namespace vandplan::evaluation {

/// Text: how many runs end better, worse and equal to Euclid, and for which share of pairs of
/// samples a table has an entry.
[[nodiscard]] std::string reason_for_paths(const Summary& summary,
                                           const std::vector<ScenarioFile>& scenarios,
                                           const Circumstances& where);

/// Text: time of an iteration, the share of ranking in it, and how many exact lengths a table
/// saves.
[[nodiscard]] std::string reason_for_times(const Summary& summary, const Circumstances& where);

/// Text: how many runs are solved with a table and with Euclid. No gain can be larger.
[[nodiscard]] std::string reason_for_gains(const Summary& summary, const Circumstances& where);

/// Share of pairs of uniform samples for which a table of the thesis (`number` in 1..4) has an
/// entry: pairs that are nearer than its extent in x and in y.
[[nodiscard]] double table_coverage(const Problem& problem, Region region, int number);

}  // namespace vandplan::evaluation

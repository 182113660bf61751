// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) Why do the thesis' tables change what they change, as far as the runs tell?

#include <string>
#include <vector>

#include "evaluation/findings.h"

namespace vandplan::evaluation {

/// How many runs end better or worse than with Euclid, how many with exactly the same cost, and for
/// which share of pairs of samples a table has an answer of its own.
[[nodiscard]] std::string reason_for_paths(const Summary& summary,
                                           const std::vector<ScenarioFile>& scenarios,
                                           const Circumstances& where);

/// What an iteration takes, and what of it is ranking; how many exact lengths a table saves.
[[nodiscard]] std::string reason_for_times(const Summary& summary, const Circumstances& where);

/// How many runs are solved with a table and with Euclid: no gain is larger.
[[nodiscard]] std::string reason_for_gains(const Summary& summary, const Circumstances& where);

/// The share of pairs of uniform samples for which a table of the thesis (`number` in 1..4) has an
/// entry: those that are nearer than its extent in x and in y.
[[nodiscard]] double table_coverage(const Problem& problem, Region region, int number);

}  // namespace vandplan::evaluation

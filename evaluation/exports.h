// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do other programs read the runs of a store?

#include <string>

#include "evaluation/store.h"

namespace vandplan::evaluation {

/// CSV with one line for each run, below a header with names and units. Missing values are empty.
[[nodiscard]] std::string runs_to_csv(Store& store);

/// JSON of all environments and scenarios, and of all runs with options, cost over time and path.
[[nodiscard]] std::string runs_to_json(Store& store);

/// Writes an OMPL benchmark database, which Planner Arena displays. Each scenario, region and goal
/// is an experiment, with region and distance as parameters. Replaces the file. Profiled runs are
/// left out.
void write_ompl_database(Store& store, const std::string& file);

}  // namespace vandplan::evaluation

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do other programs read the runs of a store?

#include <string>

#include "evaluation/store.h"

namespace vandplan::evaluation {

/// One line for each run, a head with names and units above; what there is not is empty.
[[nodiscard]] std::string runs_to_csv(Store& store);

/// Everything: environments, scenarios, runs with options, cost over time and path.
[[nodiscard]] std::string runs_to_json(Store& store);

/// Writes a benchmark database of OMPL, which Planner Arena shows. Each scenario, region and goal
/// is an experiment; region and distance are its parameters. Replaces the file.
void write_ompl_database(Store& store, const std::string& file);

}  // namespace vandplan::evaluation

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a store keep of a scenario? All of it with its map, so a report needs no other file.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/sqlite.h"
#include "vandplan/files.h"

namespace vandplan::evaluation {

/// Scenario in a store. Scenarios are equal if their text and their map are.
struct StoredScenario {
  std::string name;
  std::string file;                       ///< file from which the scenario was read
  std::string yaml;                       ///< the scenario without its map, as YAML
  std::optional<OccupancyGrid> map = {};  ///< map that the scenario names
};

[[nodiscard]] StoredScenario stored(const ScenarioFile& scenario, const std::string& file);

/// The scenario of a stored one, without reading any file.
[[nodiscard]] ScenarioFile scenario_of(const StoredScenario& stored);

/// (internal to the store) SQL of the tables of scenarios and maps.
extern const char* const tables_of_scenarios;

/// (internal to the store) Index of the scenario in an open store; it is added if it is missing.
[[nodiscard]] std::size_t index_of(Database& database, const StoredScenario& scenario);

/// (internal to the store) All scenarios; scenarios with equal maps share the cells.
[[nodiscard]] std::vector<StoredScenario> stored_scenarios(Database& database);

}  // namespace vandplan::evaluation

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a store keep of a scenario? All of it, its map too: a report needs no other file.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/sqlite.h"
#include "vandplan/scenario_file.h"

namespace vandplan::evaluation {

/// A scenario as a store keeps it. Two are the same when their text and their map are.
struct StoredScenario {
  std::string name;
  std::string file;                       ///< where it was read from
  std::string yaml;                       ///< all of it but the map
  std::optional<OccupancyGrid> map = {};  ///< what the file says that it names
};

[[nodiscard]] StoredScenario stored(const ScenarioFile& scenario, const std::string& file);

/// The scenario as it was, without a look at any file.
[[nodiscard]] ScenarioFile scenario_of(const StoredScenario& stored);

/// (internal to the store) Its tables of scenarios and maps, in SQL.
extern const char* const tables_of_scenarios;

/// (internal to the store) The index of the scenario in an open store, added if it is not there.
[[nodiscard]] std::size_t index_of(Database& database, const StoredScenario& scenario);

/// (internal to the store) All of them; those of equal maps share the cells.
[[nodiscard]] std::vector<StoredScenario> stored_scenarios(Database& database);

}  // namespace vandplan::evaluation

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/stored_scenario.h"

#include <fmt/format.h>

#include <cstring>
#include <map>
#include <span>
#include <string_view>

#include "base/hash.h"
#include "vandplan/input_error.h"

namespace vandplan::evaluation {
namespace {

std::string hex(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

// Hash of a map's geometry and cells; empty without a map.
std::string fingerprint(const std::optional<OccupancyGrid>& map) {
  if (!map) return "";
  const std::string head =
      fmt::format("{} {} {} {} {} {}", map->columns, map->rows, map->resolution, map->origin.x,
                  map->origin.y, map->origin.heading);
  const auto* const cells = reinterpret_cast<const char*>(map->cells->data());
  return hex(base::hash_of(head)) + hex(base::hash_of(std::string_view(cells, map->cells->size())));
}

void keep(Database& database, const OccupancyGrid& map, const std::string& fingerprint) {
  Statement(database, "INSERT OR IGNORE INTO maps VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
      .run(fingerprint, map.columns, map.rows, map.resolution, map.origin.x, map.origin.y,
           map.origin.heading, std::as_bytes(std::span(*map.cells)));
}

std::map<std::string, OccupancyGrid> stored_maps(Database& database) {
  std::map<std::string, OccupancyGrid> maps;
  Statement rows(database, "SELECT * FROM maps");
  while (rows.step()) {
    const std::span<const std::byte> bytes = rows.bytes(7);
    std::vector<Cell> cells(bytes.size());
    if (!bytes.empty()) std::memcpy(cells.data(), bytes.data(), bytes.size());
    maps[rows.text(0)] = {.origin = {rows.real(4), rows.real(5), rows.real(6)},
                          .resolution = rows.real(3),
                          .columns = static_cast<std::int32_t>(rows.integer(1)),
                          .rows = static_cast<std::int32_t>(rows.integer(2)),
                          .cells = std::move(cells)};
  }
  return maps;
}

}  // namespace

const char* const tables_of_scenarios = R"(
CREATE TABLE maps(
  fingerprint TEXT PRIMARY KEY, columns INTEGER NOT NULL, rows INTEGER NOT NULL,
  resolution REAL NOT NULL, x REAL NOT NULL, y REAL NOT NULL, heading REAL NOT NULL,
  cells BLOB NOT NULL) STRICT;
CREATE TABLE scenarios(
  id INTEGER PRIMARY KEY, name TEXT NOT NULL, file TEXT NOT NULL, hash TEXT NOT NULL,
  yaml TEXT NOT NULL, map TEXT REFERENCES maps(fingerprint)) STRICT;
CREATE UNIQUE INDEX scenario_and_map ON scenarios(yaml, ifnull(map, ''));
)";

StoredScenario stored(const ScenarioFile& scenario, const std::string& file) {
  return {scenario.scenario.name, file, to_yaml(scenario), scenario.scenario.map};
}

ScenarioFile scenario_of(const StoredScenario& stored) {
  return scenario_from_yaml(stored.yaml, stored.file, stored.map);
}

std::size_t index_of(Database& database, const StoredScenario& scenario) {
  const std::string map = fingerprint(scenario.map);
  if (scenario.map) keep(database, *scenario.map, map);
  Statement(database, "INSERT OR IGNORE INTO scenarios VALUES (NULL, ?, ?, ?, ?, nullif(?, ''))")
      .run(scenario.name, scenario.file, hex(base::hash_of(scenario.yaml)), scenario.yaml, map);
  Statement find(database, "SELECT id FROM scenarios WHERE yaml = ? AND ifnull(map, '') = ?");
  find.bind(scenario.yaml, map).step();
  return static_cast<std::size_t>(find.integer(0)) - 1;
}

std::vector<StoredScenario> stored_scenarios(Database& database) {
  const std::map<std::string, OccupancyGrid> maps = stored_maps(database);
  Statement rows(database, "SELECT name, file, yaml, map FROM scenarios ORDER BY id");
  std::vector<StoredScenario> found;
  while (rows.step()) {
    StoredScenario& scenario =
        found.emplace_back(StoredScenario{rows.text(0), rows.text(1), rows.text(2)});
    if (rows.is_null(3)) continue;
    const auto map = maps.find(rows.text(3));
    if (map == maps.end()) throw InputError(database.file(), "is damaged: a map is missing");
    scenario.map = map->second;
  }
  return found;
}

}  // namespace vandplan::evaluation

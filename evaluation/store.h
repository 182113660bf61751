// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do finished runs live?
//
// In one SQLite file, one transaction per run: killing the program at any moment loses the runs
// in flight and nothing else. Its tables: docs/evaluation.md.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/run_record.h"
#include "evaluation/shards.h"
#include "evaluation/sqlite.h"
#include "evaluation/stored_scenario.h"

namespace vandplan::evaluation {

/// An open result store. One thread at a time. Environments and scenarios are named by their
/// index.
class Store {
 public:
  /// Raised when the tables change.
  static constexpr int format = 4;

  /// Opens a store. Throws InputError when it is missing, damaged, of another format, or no store.
  [[nodiscard]] static Store open(const std::string& file);
  /// Makes an empty store. Throws InputError if the file exists, or is a link to nothing.
  [[nodiscard]] static Store create(const std::string& file);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// The index of what is equal, added if there is none.
  std::size_t index_of(const Environment& environment);
  std::size_t index_of(const StoredScenario& scenario);

  /// Whether a run of the same environment, scenario, goal, planner, region and options is there.
  [[nodiscard]] bool contains(const RunRecord& run);
  /// Keeps a run unless `contains` it; true if it was new. Atomic and durable.
  bool add(const RunRecord& run);
  void add(const Session& session);
  /// Adds what `other` has and this has not; says how many runs. All of it or nothing.
  int merge(Store& other);

  /// Which shard of a campaign this store holds; none: it holds whatever was put in.
  [[nodiscard]] std::optional<StoredShard> shard();
  /// From now on this store holds that shard and nothing else; of an empty store.
  void set(const StoredShard& shard);
  [[nodiscard]] int count_runs();

  [[nodiscard]] std::vector<Environment> environments();
  [[nodiscard]] std::vector<StoredScenario> scenarios();
  [[nodiscard]] std::vector<Session> sessions();
  /// In the order in which they were added.
  [[nodiscard]] std::vector<RunRecord> runs();
  /// The same, each path with its start alone: a fifth of the memory and time.
  [[nodiscard]] std::vector<RunRecord> runs_without_segments();
  /// Adds what `runs_without_segments` has left out of a run of this store.
  void read_segments(RunRecord& run);

 private:
  struct Statements;
  enum class Paths : std::uint8_t { whole, start_only };

  explicit Store(const std::string& file);
  // 0 if it is not there.
  std::int64_t configuration_of(const RunRecord& run);
  // 0 if it is not there.
  std::int64_t id_of(const RunRecord& run, std::int64_t configuration);
  bool insert(const RunRecord& run);
  std::vector<RunRecord> read_runs(Paths paths);

  Database database_;
  std::unique_ptr<Statements> statements_;
};

}  // namespace vandplan::evaluation

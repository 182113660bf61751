// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where are finished runs stored?
//
// A store is one SQLite file, with one transaction per run. If the program is killed, only the runs
// in flight are lost. Tables: docs/evaluation.md.

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

/// An open result store, for one thread at a time. Environments and scenarios are referred to by
/// index.
class Store {
 public:
  /// Version of the tables; it is raised when they change.
  static constexpr int format = 4;

  /// Opens a store. Throws InputError if the file is missing, damaged, of another format, or no
  /// store.
  [[nodiscard]] static Store open(const std::string& file);
  /// Makes an empty store. Throws InputError if the file exists, or is a link to nothing.
  [[nodiscard]] static Store create(const std::string& file);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Index of an equal environment or scenario; it is added if there is none.
  std::size_t index_of(const Environment& environment);
  std::size_t index_of(const StoredScenario& scenario);

  /// Whether the store has a run with the same environment, scenario, goal, planner, region,
  /// options and seed.
  [[nodiscard]] bool contains(const RunRecord& run);
  /// Stores a run unless the store contains it; true if it was new. Atomic and durable.
  bool add(const RunRecord& run);
  void add(const Session& session);
  /// Adds the runs and sessions of `other` that this store lacks, all of them or none. Returns the
  /// number of new runs.
  int merge(Store& other);

  /// The shard of a campaign that this store holds; none if the store is not limited to a shard.
  [[nodiscard]] std::optional<StoredShard> shard();
  /// Limits an empty store to a shard.
  void set(const StoredShard& shard);
  [[nodiscard]] int count_runs();

  [[nodiscard]] std::vector<Environment> environments();
  [[nodiscard]] std::vector<StoredScenario> scenarios();
  [[nodiscard]] std::vector<Session> sessions();
  /// All runs, in the order in which they were added.
  [[nodiscard]] std::vector<RunRecord> runs();
  /// All runs in that order, with paths that have a start but no segments: a fifth of the memory
  /// and time.
  [[nodiscard]] std::vector<RunRecord> runs_without_segments();
  /// Reads the segments of a run that `runs_without_segments` returned.
  void read_segments(RunRecord& run);

 private:
  struct Statements;
  enum class Paths : std::uint8_t { whole, start_only };

  explicit Store(const std::string& file);
  // Id of the configuration of a run; 0 if it is not there.
  std::int64_t configuration_of(const RunRecord& run);
  // Id of a run with a configuration; 0 if it is not there.
  std::int64_t id_of(const RunRecord& run, std::int64_t configuration);
  bool insert(const RunRecord& run);
  std::vector<RunRecord> read_runs(Paths paths);

  Database database_;
  std::unique_ptr<Statements> statements_;
};

}  // namespace vandplan::evaluation

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do I write and read results?
//
// Format: docs/formats.md. Everything is in the scenario's frame.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/files.h"
#include "vandplan/planner.h"

namespace vandplan {

/// The furthest goal of a row that a file states as reached.
struct StatedFurthest {
  std::optional<double> distance;  ///< distance of the goal [m]; none: no goal was reached
};

/// One planning run, with what is needed to write, judge and draw it.
struct ResultRecord {
  std::string scenario = {};            ///< name of the scenario
  std::string planner = {};             ///< name of the planner
  PlanOptions options = {};             ///< options that were in force
  std::optional<double> distance = {};  ///< distance of the goal in a row of goals [m]
  PlanResult result = {};               ///< result of the run
  PathClaims claims = {};               ///< claims of a file that was read about its path
  /// Options that a file which was read states for its run; those without a value are left out.
  std::optional<std::vector<Setting>> stated = {};
  /// Furthest goal that a file which was read states for the row of this record.
  std::optional<StatedFurthest> furthest = {};
};

/// The options of the run, as far as they are known: those that a file states, or those that were
/// in force.
[[nodiscard]] std::vector<Setting> stored_options(const ResultRecord& record);

/// The largest distance among the goals of a row that have a path [m]; none if no goal has a path.
[[nodiscard]] std::optional<double> furthest_reached(const std::vector<ResultRecord>& records);

/// Largest number of poses in a result file, all its paths together, which takes some 200 km. If
/// there would be more, the file holds no poses.
inline constexpr std::size_t most_written_poses = 2'000'000;
/// Largest number of nodes of search trees in a result file, all together. If there would be more,
/// the file holds no trees.
inline constexpr std::size_t most_written_nodes = 10'000'000;

/// Receives a text piece by piece.
using TextSink = std::function<void(std::string_view piece)>;

/// A result file as JSON text: one record for `goal:`, a row of records for `goals:`. Throws
/// InputError naming "records" if there is none.
[[nodiscard]] std::string results_to_json(const ScenarioFile& file,
                                          const std::vector<ResultRecord>& records);
/// Passes the text of `results_to_json` to `sink` while it is made, so that a long text is never
/// held as a whole.
void write_results(const ScenarioFile& file, const std::vector<ResultRecord>& records,
                   const TextSink& sink);
/// Whether the name of a result file asks for the binary form: it ends in ".vpr".
[[nodiscard]] bool is_binary_result(std::string_view file);

/// Throws InputError naming the file if its name ends in ".geojson", but the scenario file has no
/// `origin` or the library was built without GeographicLib.
void expect_format(const std::string& output, const ScenarioFile& scenario);

/// Writes a result file, whole or not at all, piece by piece: JSON, binary if its name ends in
/// ".vpr", or for maps if its name ends in ".geojson". "-" is standard output. Throws InputError
/// naming the file if it cannot be written, or as `expect_format` does.
void write_results(const std::string& output, const ScenarioFile& file,
                   const std::vector<ResultRecord>& records);

/// The result for the pair of poses with the number `pair`, as one line of JSON.
[[nodiscard]] std::string result_to_json_line(std::size_t pair, const Problem& problem,
                                              const ResultRecord& record);
/// Passes the text of `result_to_json_line` to `sink` while it is made.
void write_result_line(std::size_t pair, const Problem& problem, const ResultRecord& record,
                       const TextSink& sink);

/// Writes the results of many pairs as they come, whole or not at all: JSON Lines, or binary if the
/// name of the file asks for that. "-" is standard output. All functions throw InputError naming
/// the file if it cannot be written.
class PairWriter {
 public:
  /// Begins the file. `pattern` holds what all results share: scenario, planner and options.
  PairWriter(const std::string& file, const ResultRecord& pattern);
  ~PairWriter();
  PairWriter(const PairWriter&) = delete;
  PairWriter& operator=(const PairWriter&) = delete;

  /// Writes the result for the pair with that number.
  void write(std::size_t pair, const Problem& problem, const ResultRecord& record);
  /// Ends the file and puts it in its place; without it the old file stays.
  void commit();

 private:
  struct Output;
  std::unique_ptr<Output> output_;
};

/// Reads a result file, JSON or binary, of ours or of other programs. It has as many records as the
/// scenario has goals. Throws InputError "file:line: what is wrong".
[[nodiscard]] std::vector<ResultRecord> read_results(const std::string& file,
                                                     const ScenarioFile& scenario);

/// The result for one pair of poses among many.
struct PairRecord {
  std::size_t pair = 0;  ///< number of the pair, counted from 1
  PosePair poses;        ///< start and goal of the pair
  ResultRecord record;
};

/// Reads a result file of any kind: one result, many results on one line each (JSON Lines), or
/// binary. Many results are read one after the other. "-" is standard input. All functions throw
/// InputError "file:line: what is wrong".
class ResultReader {
 public:
  /// Opens the file. `scenario` must outlive the reader.
  ResultReader(const std::string& file, const ScenarioFile& scenario);
  ~ResultReader();
  ResultReader(const ResultReader&) = delete;
  ResultReader& operator=(const ResultReader&) = delete;

  /// Whether the file has results of pairs: its first line is an object with "pair", or its bytes
  /// say so.
  [[nodiscard]] bool has_pairs() const noexcept;
  /// The next pair; none at the end. Only for a file with pairs.
  [[nodiscard]] std::optional<PairRecord> next();
  /// All records of a file without pairs, as `read_results` returns them.
  [[nodiscard]] std::vector<ResultRecord> all();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vandplan

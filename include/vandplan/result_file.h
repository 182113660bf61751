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

#include "vandplan/planner.h"
#include "vandplan/scenario_file.h"

namespace vandplan {

/// The furthest goal of a row that somebody says was reached.
struct StatedFurthest {
  std::optional<double> distance;  ///< [m]; none: no goal was
};

/// One planning run with what is needed to write, judge and draw it.
struct ResultRecord {
  std::string scenario = {};  ///< name of the scenario
  std::string planner = {};
  PlanOptions options = {};             ///< that were in force
  std::optional<double> distance = {};  ///< of the goal in a row of goals [m]
  PlanResult result = {};
  PathClaims claims = {};  ///< what a file that was read says about its path
  /// Options that a file states for its run, if the record was read; those without a value are left
  /// out.
  std::optional<std::vector<Setting>> stated = {};
  /// What that file says about the row that the record belongs to.
  std::optional<StatedFurthest> furthest = {};
};

/// The options of the run, as far as they are known: those that a file states, or those that were
/// in force.
[[nodiscard]] std::vector<Setting> stored_options(const ResultRecord& record);

/// The largest distance among the goals of a row that have a path [m].
[[nodiscard]] std::optional<double> furthest_reached(const std::vector<ResultRecord>& records);

/// The most poses that a result file states, all its paths together: it goes without any if they
/// would be more, which takes some 200 km.
inline constexpr std::size_t most_written_poses = 2'000'000;
/// The most nodes of search trees in a result file, all together: it goes without any if they would
/// be more.
inline constexpr std::size_t most_written_nodes = 10'000'000;

/// Takes a text in, piece by piece.
using TextSink = std::function<void(std::string_view piece)>;

/// Result file as JSON text: one record for `goal:`, a row of records for `goals:`.
[[nodiscard]] std::string results_to_json(const ScenarioFile& file,
                                          const std::vector<ResultRecord>& records);
/// Hands out the text of `results_to_json` while it is made: a long one is never held as a whole.
void write_results(const ScenarioFile& file, const std::vector<ResultRecord>& records,
                   const TextSink& sink);
/// Whether the name of a result file asks for the binary form: it ends in ".vpr".
[[nodiscard]] bool is_binary_result(std::string_view file);

/// Writes a result file, whole or not at all, piece by piece: JSON, or binary if its name asks for
/// that; "-" is standard output. Throws InputError naming the file when it cannot be written.
void write_results(const std::string& output, const ScenarioFile& file,
                   const std::vector<ResultRecord>& records);

/// One of many results, for the pair of poses with that number, as one line of JSON.
[[nodiscard]] std::string result_to_json_line(std::size_t pair, const Problem& problem,
                                              const ResultRecord& record);
/// Hands out the text of `result_to_json_line` while it is made.
void write_result_line(std::size_t pair, const Problem& problem, const ResultRecord& record,
                       const TextSink& sink);

/// Writes results of many pairs as they come, whole or not at all: JSON Lines, or binary if the
/// name of the file asks for that; "-" is standard output. All throw InputError if it cannot be
/// written.
class PairWriter {
 public:
  /// `pattern` holds what all results share: scenario, planner and options.
  PairWriter(const std::string& file, const ResultRecord& pattern);
  ~PairWriter();
  PairWriter(const PairWriter&) = delete;
  PairWriter& operator=(const PairWriter&) = delete;

  void write(std::size_t pair, const Problem& problem, const ResultRecord& record);
  void commit();

 private:
  struct Output;
  std::unique_ptr<Output> output_;
};

/// Reads a result file, JSON or binary, written by us or by others. As many records as the scenario
/// has goals. Throws InputError "file:line: what is wrong".
[[nodiscard]] std::vector<ResultRecord> read_results(const std::string& file,
                                                     const ScenarioFile& scenario);

/// A result for one pair of poses among many.
struct PairRecord {
  std::size_t pair = 0;  ///< its number; counted from 1
  PosePair poses;
  ResultRecord record;
};

/// Reads a result file that may be of any kind: one result, or many, one on each line (JSON Lines)
/// or binary, which are read one after the other. "-" is standard input. All throw InputError
/// "file:line: what is wrong".
class ResultReader {
 public:
  /// `scenario` must outlive the reader.
  ResultReader(const std::string& file, const ScenarioFile& scenario);
  ~ResultReader();
  ResultReader(const ResultReader&) = delete;
  ResultReader& operator=(const ResultReader&) = delete;

  /// Whether it has results of pairs: the first line is an object with "pair", or bytes say so.
  [[nodiscard]] bool has_pairs() const noexcept;
  /// The next pair; none at the end. Only where there are pairs.
  [[nodiscard]] std::optional<PairRecord> next();
  /// All of a file without pairs, as `read_results` does.
  [[nodiscard]] std::vector<ResultRecord> all();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vandplan

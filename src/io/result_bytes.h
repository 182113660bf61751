// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the bytes of a binary result file laid out?
//
// A header with the keys that all results share, a record for each result, and an end mark with a
// checksum. All numbers are little-endian. Layout: docs/formats.md.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/input_file.h"
#include "vandplan/problem.h"
#include "vandplan/result_file.h"

namespace vandplan::io {

/// Problems that the results of a file belong to.
enum class ResultsOf : std::uint32_t { goals, pairs };

/// Header of a file.
struct ResultHead {
  ResultsOf kind = ResultsOf::goals;
  std::string text;  ///< JSON with the keys that all results share.
};

/// JSON of the header for results with the scenario, planner and options of `pattern`.
[[nodiscard]] std::string head_text(const ResultRecord& pattern);

/// One result of a file.
struct ResultBytes {
  std::uint64_t number = 0;  ///< Number of the pair or goal, from 1.
  PosePair poses;
  double hitch_angle = 0.0;  ///< Hitch angle at the start [rad]; 0 without a trailer.
  PlanResult result = {};
};

/// Writes a file result by result.
class ResultBytesWriter {
 public:
  ResultBytesWriter(const ResultHead& head, TextSink sink);

  /// Adds the result of the pair or goal `number`. `hitch_angle`: at the start [rad].
  void add(std::uint64_t number, const PosePair& poses, double hitch_angle,
           const PlanResult& result);
  /// Writes the end mark. Must follow the last result.
  void end();

 private:
  void hand_out(std::string_view bytes);

  TextSink sink_;
  std::uint64_t checksum_;
};

/// Reads a binary result file, one result at a time. All functions throw InputError naming the file
/// and the wrong result.
class ResultBytesReader {
 public:
  /// Whether a file begins like a binary result file.
  [[nodiscard]] static bool begins(FileReader& file);

  /// `file` must outlive the reader.
  explicit ResultBytesReader(FileReader& file);

  [[nodiscard]] const ResultHead& head() const noexcept { return head_; }
  /// Next result; empty after the last one, if the checksum is right.
  [[nodiscard]] std::optional<ResultBytes> next();

  /// Throws InputError about the result that was read last.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  /// Next bytes, valid until the next call.
  [[nodiscard]] std::string_view take(std::size_t size);
  void read_head();
  void read_end();

  FileReader& file_;
  ResultHead head_;
  std::uint64_t checksum_;
  std::uint64_t read_ = 0;  // Number of results read.
  bool has_ended_ = false;
};

}  // namespace vandplan::io

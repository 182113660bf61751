// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the bytes of a binary result file laid out?
//
// A head with what all results share, a record for each of them, and a mark with a check sum;
// everything little-endian. Layout: docs/formats.md.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/input_file.h"
#include "vandplan/problem.h"
#include "vandplan/result_file.h"

namespace vandplan::io {

/// What the results of a file are for.
enum class ResultsOf : std::uint32_t { goals, pairs };

/// What stands at the beginning of a file.
struct ResultHead {
  ResultsOf kind = ResultsOf::goals;
  std::string text;  ///< JSON: the keys that all results share
};

/// What the head says of results with the scenario, planner and options of this one.
[[nodiscard]] std::string head_text(const ResultRecord& pattern);

/// What a file says of one result.
struct ResultBytes {
  std::uint64_t number = 0;  ///< of the pair or the goal, from 1
  PosePair poses;
  double hitch_angle = 0.0;  ///< at the start [rad]; 0 without a trailer
  PlanResult result = {};
};

/// Hands out the bytes of a file as its results come.
class ResultBytesWriter {
 public:
  ResultBytesWriter(const ResultHead& head, TextSink sink);

  /// For the pair or goal of that number, with the angle of the trailer at the start [rad].
  void add(std::uint64_t number, const PosePair& poses, double hitch_angle,
           const PlanResult& result);
  /// Behind the last one.
  void end();

 private:
  void hand_out(std::string_view bytes);

  TextSink sink_;
  std::uint64_t checksum_;
};

/// Reads such a file; holds one result at a time. All throw InputError naming the file, and the
/// result that is wrong.
class ResultBytesReader {
 public:
  /// Whether a file begins like one.
  [[nodiscard]] static bool begins(FileReader& file);

  /// `file` must outlive the reader.
  explicit ResultBytesReader(FileReader& file);

  [[nodiscard]] const ResultHead& head() const noexcept { return head_; }
  /// The next result; none behind the last one, once the check sum has turned out right.
  [[nodiscard]] std::optional<ResultBytes> next();

  /// Says what is wrong with the result that was read last.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  /// The next bytes, valid until the next call.
  [[nodiscard]] std::string_view take(std::size_t size);
  void read_head();
  void read_end();

  FileReader& file_;
  ResultHead head_;
  std::uint64_t checksum_;
  std::uint64_t read_ = 0;  // results
  bool has_ended_ = false;
};

}  // namespace vandplan::io

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Which format does a result file have, and what is its next result?

#include <fmt/format.h>

#include <utility>

#include "io/document.h"
#include "io/input_file.h"
#include "io/result_bytes.h"
#include "io/result_lists.h"
#include "io/result_reader.h"
#include "vandplan/input_error.h"
#include "vandplan/result_file.h"

namespace vandplan {
namespace {

using namespace io;

// Limits for a result [bytes]; `plan` writes less.
constexpr std::size_t largest_result = std::size_t{2} << 30;
constexpr std::size_t largest_result_line = std::size_t{512} << 20;

/// A line with the result of a pair.
struct PairLine {
  Document document;
  ListTaker lists;
};

PairLine pair_line_from(const std::string& line, const std::string& name, int number) {
  ListTaker lists(name);
  Document document = parse_json(line, name, number, [&](const auto& open, Node& element) {
    return lists.take(open, element);
  });
  return {std::move(document), std::move(lists)};
}

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

/// Result of a pair in a line; empty if the line is no object with "pair".
std::optional<PairLine> first_pair_from(const std::string& line, const std::string& name,
                                        int number) {
  try {
    PairLine pair = pair_line_from(line, name, number);
    const Document& document = pair.document;
    if (document.find(document.root(), "pair") != nullptr) return pair;
  } catch (const InputError&) {  // It is the first line of a longer text.
  }
  return std::nullopt;
}

/// Results of a binary file.
class BinaryResults {
 public:
  BinaryResults(FileReader& file, const ScenarioFile& scenario)
      : bytes_(file),
        scenario_(scenario),
        pattern_(pattern_from(parse_json(bytes_.head().text, file.name(), 1, {}))) {}

  [[nodiscard]] bool has_pairs() const { return bytes_.head().kind == ResultsOf::pairs; }

  [[nodiscard]] std::optional<PairRecord> next() {
    std::optional<ResultBytes> bytes = bytes_.next();
    if (!bytes) return std::nullopt;
    try {
      check_poses(bytes->poses.start, bytes->poses.goal);
    } catch (const InputError& error) {
      bytes_.fail(fmt::format("has a {} that {}", error.where(), error.problem()));
    }
    PairRecord record{bytes->number, bytes->poses, pattern_};
    record.record.result = std::move(bytes->result);
    const PlanResult& result = record.record.result;
    PathClaims& claims = record.record.claims;
    if (!result.path) {
      claims = {};
      return record;
    }
    claims.cost->cost = result.cost;
    claims.cost->lower_bound = result.lower_bound;
    if (scenario_.scenario.vehicle.trailer) claims.start_hitch_angle = bytes->hitch_angle;
    return record;
  }

  /// All results, one for each goal.
  [[nodiscard]] std::vector<ResultRecord> all() {
    std::vector<ResultRecord> records;
    while (std::optional<PairRecord> record = next()) {
      if (records.size() == scenario_.size()) {
        bytes_.fail(
            fmt::format("is one too many, expected the scenario's {} goals", scenario_.size()));
      }
      if (scenario_.is_row()) record->record.distance = scenario_.row[records.size()].distance;
      records.push_back(std::move(record->record));
    }
    if (records.size() < scenario_.size()) {
      bytes_.fail(
          fmt::format("is the last one, expected the scenario's {} goals", scenario_.size()));
    }
    return records;
  }

 private:
  ResultBytesReader bytes_;
  const ScenarioFile& scenario_;
  ResultRecord pattern_;
};

}  // namespace

struct ResultReader::State {
  State(const std::string& file, const ScenarioFile& of) : lines(file), scenario(of) {
    if (ResultBytesReader::begins(lines)) binary.emplace(lines, scenario);
  }

  FileReader lines;
  const ScenarioFile& scenario;
  std::string head = {};  ///< First line that is not blank, of a file without pairs.
  int first_line = 1;     ///< Number of the first line that is not blank.
  bool has_pairs = false;
  std::optional<PairLine> first = {};  ///< First pair, until it is returned.
  std::optional<BinaryResults> binary = {};
};

ResultReader::ResultReader(const std::string& file, const ScenarioFile& scenario)
    : state_(std::make_unique<State>(file, scenario)) {
  State& state = *state_;
  if (state.binary) {
    state.has_pairs = state.binary->has_pairs();
    return;
  }
  while (std::optional<std::string> line = state.lines.next(largest_result_line)) {
    if (is_blank(*line)) continue;
    state.first = first_pair_from(*line, state.lines.name(), state.lines.number());
    state.has_pairs = state.first.has_value();
    if (!state.has_pairs) state.head = *std::move(line) + '\n';
    state.first_line = state.lines.number();
    break;
  }
}

ResultReader::~ResultReader() = default;

bool ResultReader::has_pairs() const noexcept { return state_->has_pairs; }

std::optional<PairRecord> ResultReader::next() {
  if (state_->binary) return state_->binary->next();
  FileReader& lines = state_->lines;
  const auto record_from = [&](PairLine pair) {
    const double radius = state_->scenario.scenario.vehicle.min_turning_radius;
    return pair_record_from(pair.document, radius, pair.lists);
  };
  if (state_->first) return record_from(*std::exchange(state_->first, std::nullopt));
  while (const std::optional<std::string> line = lines.next(largest_result_line)) {
    if (!is_blank(*line)) return record_from(pair_line_from(*line, lines.name(), lines.number()));
  }
  return std::nullopt;
}

std::vector<ResultRecord> ResultReader::all() {
  if (state_->binary) return state_->binary->all();
  FileReader& lines = state_->lines;
  ListTaker lists(lines.name());
  bool is_begun = false;
  const auto next = [&]() -> std::string_view {
    if (!std::exchange(is_begun, true) && !state_->head.empty()) return state_->head;
    state_->head.clear();
    return lines.next_piece(largest_result);
  };
  const auto take = [&](const auto& open, Node& element) { return lists.take(open, element); };
  const Document document = parse_json(next, lines.name(), state_->first_line, take);
  return records_from(document, state_->scenario, lists);
}

std::vector<ResultRecord> read_results(const std::string& file, const ScenarioFile& scenario) {
  ResultReader reader(file, scenario);
  if (!reader.has_pairs()) return reader.all();
  throw InputError(file == "-" ? "standard input" : file,
                   "holds results of many pairs, expected one result");
}

}  // namespace vandplan

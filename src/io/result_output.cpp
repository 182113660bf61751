// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Which format does a result file get, and how is it written?

#include <algorithm>
#include <memory>
#include <optional>

#include "io/result_bytes.h"
#include "io/result_geojson.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/path.h"
#include "vandplan/result_file.h"

namespace vandplan {
namespace {

using namespace io;

/// Goal that the path reaches; without a path, some goal of the scenario.
Pose goal_of(const Scenario& scenario, const PlanResult& result) {
  if (scenario.goal_set.empty()) return scenario.goal;
  const bool is_known = result.check && result.check->goal;
  return is_known ? result.check->goal->pose : some_pose(scenario.goal_set.front());
}

void write_bytes(const ScenarioFile& file, const std::vector<ResultRecord>& records,
                 const TextSink& sink) {
  ResultBytesWriter writer({ResultsOf::goals, head_text(records.front())}, sink);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Scenario scenario = scenario_at(file, i);
    const PlanResult& result = records[i].result;
    writer.add(i + 1, {scenario.start, goal_of(scenario, result)}, scenario.hitch_angles.start,
               result);
  }
  writer.end();
}

/// Whether a name has the ending, which is in small letters.
bool ends_in(std::string_view file, std::string_view ending) {
  if (file.size() < ending.size()) return false;
  return std::ranges::equal(file.substr(file.size() - ending.size()), ending, {}, [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
}

bool is_geojson_result(std::string_view file) { return ends_in(file, ".geojson"); }

}  // namespace

bool is_binary_result(std::string_view file) { return ends_in(file, ".vpr"); }

void expect_format(const std::string& output, const ScenarioFile& scenario) {
  if (!is_geojson_result(output)) return;
  if (!reads_longitudes()) {
    throw InputError(output, "would be GeoJSON, which this build lacks GeographicLib for");
  }
  if (scenario.origin) return;
  throw InputError(output,
                   "would be GeoJSON, but the scenario has no place on Earth, expected its key "
                   "origin, which `vandplan convert geojson` writes");
}

void write_results(const std::string& output, const ScenarioFile& file,
                   const std::vector<ResultRecord>& records) {
  expect_format(output, file);
  FileWriter writer(output);
  const TextSink sink = [&](std::string_view piece) { writer.write(piece); };
  if (is_binary_result(output)) {
    write_bytes(file, records, sink);
  } else if (is_geojson_result(output)) {
    sink(geojson_of(file, records));
  } else {
    write_results(file, records, sink);
  }
  writer.commit();
}

struct PairWriter::Output {
  explicit Output(const std::string& name) : file(name) {}

  FileWriter file;
  TextSink sink = [this](std::string_view piece) { file.write(piece); };
  std::optional<ResultBytesWriter> bytes = {};
};

PairWriter::PairWriter(const std::string& file, const ResultRecord& pattern)
    : output_(std::make_unique<Output>(file)) {
  if (!is_binary_result(file)) return;
  output_->bytes.emplace(ResultHead{ResultsOf::pairs, head_text(pattern)}, output_->sink);
}

PairWriter::~PairWriter() = default;

void PairWriter::write(std::size_t pair, const Problem& problem, const ResultRecord& record) {
  if (output_->bytes) {
    output_->bytes->add(pair, {problem.start(), problem.goal()}, problem.hitch_angles().start,
                        record.result);
  } else {
    write_result_line(pair, problem, record, output_->sink);
  }
}

void PairWriter::commit() {
  if (output_->bytes) output_->bytes->end();
  output_->file.commit();
}

}  // namespace vandplan

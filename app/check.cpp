// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan check: does the judge accept the paths of a result file?
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "commands.h"
#include "evaluation/metrics.h"
#include "vandplan/judge.h"
#include "vandplan/result_file.h"
#include "wording.h"

namespace vandplan::app {
namespace {

using evaluation::DrivingStyle;
using evaluation::metrics_of;
using evaluation::PathMetrics;

struct CheckArguments {
  std::string scenario;
  std::string result;
  bool json = false;
  bool metrics = false;
  DrivingStyle style;
};

/// Verdict of the judge on a path. With `drive` it includes the drive along the path over time.
struct Judged : PathCheck {
  std::optional<DriveCheck> drive = {};
};

/// The verdict on one goal; none without a path.
using Verdict = std::optional<Judged>;

/// Speeds of a result; if it has none, those of the fastest drive along its path.
SpeedProfile speeds_of(const Problem& problem, const PlanResult& result) {
  if (result.speeds) return *result.speeds;
  return speed_profile(*result.path, problem.vehicle(), speed_options(problem, *result.path));
}

Verdict judge(const Problem& problem, const ResultRecord& record) {
  const PlanResult& result = record.result;
  if (!result.path) return std::nullopt;
  Judged judged{check_path(problem, *result.path, record.claims)};
  const bool has_times = result.speeds || !problem.task().moving.empty();
  if (!judged.valid || !has_times) return judged;
  judged.drive = check_drive(problem, {*result.path, speeds_of(problem, result)},
                             {.margin = record.claims.clearance.margin});
  judged.valid = judged.drive->valid;
  judged.reason = judged.drive->reason;
  judged.at = judged.drive->at;
  return judged;
}

nlohmann::ordered_json verdict_json(const ResultRecord& record, const Verdict& verdict) {
  nlohmann::ordered_json json;
  if (record.distance) json["distance"] = *record.distance;
  json["status"] = name_of(record.result.status);
  json["valid"] = verdict && verdict->valid;
  if (!verdict && !record.result.reason.empty()) json["reason"] = record.result.reason;
  if (!verdict) return json;
  json["length"] = verdict->length;
  json["gear_changes"] = verdict->gear_changes;
  json["reverse_length"] = verdict->reverse_length;
  // JSON has no infinity: without obstacles there is no clearance.
  if (verdict->clearance && std::isfinite(*verdict->clearance)) {
    json["clearance"] = *verdict->clearance;
  }
  if (!verdict->valid) json["reason"] = verdict->reason;
  if (verdict->drive) {
    json["duration"] = verdict->drive->duration;
    const std::optional<double>& near = verdict->drive->clearance;
    if (near && std::isfinite(*near)) json["moving_clearance"] = *near;
    if (verdict->drive->t) json["t"] = *verdict->drive->t;
  }
  if (verdict->at) {
    const auto& [s, pose, curvature, gear] = *verdict->at;
    json["at"] = {{"s", s}, {"x", pose.x}, {"y", pose.y}, {"heading", pose.heading}};
  }
  return json;
}

std::string verdict_text(const ResultRecord& record, const Verdict& verdict) {
  if (!verdict) return no_path_text(record.result);
  const std::optional<DriveCheck>& drive = verdict->drive;
  if (verdict->valid) return "valid: " + path_text(*verdict) + drive_text(drive);
  if (!verdict->at) return fmt::format("invalid: {}", verdict->reason);
  const auto& [s, pose, curvature, gear] = *verdict->at;
  const std::string when = drive && drive->t ? fmt::format(" at t = {:.3f} s,", *drive->t) : "";
  return fmt::format("invalid: {}{} at s = {:.4f} m, where x = {} m, y = {} m, heading = {} rad",
                     verdict->reason, when, s, pose.x, pose.y, pose.heading);
}

nlohmann::ordered_json metrics_json(const PathMetrics& metrics, const DrivingStyle& style) {
  return {{"length", metrics.length},
          {"gear_changes", metrics.gear_changes},
          {"reverse_share", metrics.reverse_share},
          {"turning", metrics.turning},
          {"curvature_changes", metrics.curvature_changes},
          {"driving_time", metrics.driving_time},
          {"speed", style.speed},
          {"pause", style.pause}};
}

std::string metrics_text(const PathMetrics& metrics, const DrivingStyle& style) {
  return fmt::format(
      "in reverse {:.1f} %, turning {:.3f} rad, curvature changes {}, "
      "driven in {:.1f} s (at {} m/s, {} s for each gear change)",
      100.0 * metrics.reverse_share, metrics.turning, metrics.curvature_changes,
      metrics.driving_time, style.speed, style.pause);
}

std::string distance_text(const std::optional<double>& distance) {
  return distance ? fmt::format("{} m", *distance) : "none";
}

/// Fault of the furthest goal that a result file states for a row; empty if there is none.
std::string false_furthest(const std::vector<ResultRecord>& records) {
  const std::optional<StatedFurthest>& stated = records.front().furthest;
  if (!stated) return "";
  const std::optional<double> reached = furthest_reached(records);
  if (stated->distance == reached) return "";
  return fmt::format("the stated furthest is {}, the furthest goal reached is {}",
                     distance_text(stated->distance), distance_text(reached));
}

/// Numbers of results with a valid path, with an invalid path, and without a path.
struct Tally {
  int valid = 0;
  int invalid = 0;
  int without_path = 0;

  void add(const Verdict& verdict) {
    ++(!verdict ? without_path : verdict->valid ? valid : invalid);
  }
  [[nodiscard]] bool passed() const { return valid > 0 && invalid == 0; }
};

/// Output for one result, as text and as JSON.
struct Statement {
  std::string text;
  nlohmann::ordered_json json;
};

Statement statement_on(const ResultRecord& record, const Verdict& verdict,
                       const CheckArguments& arguments) {
  Statement statement{verdict_text(record, verdict), verdict_json(record, verdict)};
  if (!arguments.metrics || !record.result.path) return statement;
  const PathMetrics metrics = metrics_of(*record.result.path, arguments.style);
  statement.json["metrics"] = metrics_json(metrics, arguments.style);
  statement.text += "\n  " + metrics_text(metrics, arguments.style);
  return statement;
}

/// Judges each pair of start and goal in the world of the scenario. Returns the exit status.
int check_pairs(const ScenarioProblems& read, ResultReader& reader,
                const CheckArguments& arguments) {
  const Problem& pattern = read.problems.front();
  Tally tally;
  while (const std::optional<PairRecord> pair = reader.next()) {
    const Problem problem = with_poses(pattern, pair->poses.start, pair->poses.goal);
    const Verdict verdict = judge(problem, pair->record);
    tally.add(verdict);
    const Statement statement = statement_on(pair->record, verdict, arguments);
    if (arguments.json) {
      nlohmann::ordered_json line = {{"pair", pair->pair}};
      line.update(statement.json);
      print_line(line);
    } else {
      fmt::print("{}: {}\n", pair->pair, statement.text);
    }
  }
  if (!arguments.json) {
    fmt::print("{}: {} valid, {} invalid, {} without a path\n", printable(read.file.scenario.name),
               tally.valid, tally.invalid, tally.without_path);
  }
  return tally.passed() ? exit_status::done : exit_status::failed;
}

int check_goals(const ScenarioProblems& read, const std::vector<ResultRecord>& records,
                const CheckArguments& arguments) {
  const bool is_row = read.file.is_row();
  nlohmann::ordered_json goals = nlohmann::ordered_json::array();
  Tally tally;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Verdict verdict = judge(read.problems[i], records[i]);
    tally.add(verdict);
    const Statement statement = statement_on(records[i], verdict, arguments);
    goals.push_back(statement.json);
    if (arguments.json) continue;
    if (is_row) fmt::print("goals[{}]: ", i);
    fmt::print("{}\n", statement.text);
  }
  const std::string reason = is_row ? false_furthest(records) : "";
  if (!reason.empty() && !arguments.json) fmt::print("invalid: {}\n", reason);
  // A row passes even if some of its goals were not reached.
  const bool passed = tally.passed() && reason.empty();
  if (arguments.json && is_row) {
    nlohmann::ordered_json row = {{"valid", passed}};
    if (!reason.empty()) row["reason"] = reason;
    row["goals"] = goals;
    print(row);
  } else if (arguments.json) {
    print(goals.front());
  }
  return passed ? exit_status::done : exit_status::failed;
}

int run(const CheckArguments& arguments) {
  validate(arguments.style);
  const ScenarioProblems read = read_problems(arguments.scenario);
  warn(read.file.warnings);
  ResultReader reader(arguments.result, read.file);
  if (reader.has_pairs()) return check_pairs(read, reader, arguments);
  return check_goals(read, reader.all(), arguments);
}

}  // namespace

void add_check(CLI::App& vandplan, int& status) {
  CLI::App* const command =
      vandplan.add_subcommand("check", "Check the paths of a result with the independent judge.");
  command->footer(
      "Exit status: 0 valid (many paths: at least one valid, none invalid), 1 invalid or no path,\n"
      "2 bad input.");
  const auto arguments = std::make_shared<CheckArguments>();
  add_scenario_and_result(*command, arguments->scenario, arguments->result);
  CLI::Option* const metrics =
      command->add_flag("--metrics", arguments->metrics,
                        "Measure the path: share in reverse, turning, curvature changes, time");
  command->add_option("--speed", arguments->style.speed, "Speed for that time [m/s]; > 0")
      ->type_name("M/S")
      ->needs(metrics)
      ->capture_default_str();
  command->add_option("--pause", arguments->style.pause, "Time per gear change [s]; >= 0")
      ->type_name("S")
      ->needs(metrics)
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace vandplan::app

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan check: does the judge accept the paths of a result file?
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "commands.h"
#include "evaluation/metrics.h"
#include "vandplan/io.h"
#include "vandplan/path_check.h"

namespace vandplan {
namespace {

struct CheckArguments {
  std::string scenario;
  std::string result;
  bool json = false;
  bool metrics = false;
  DrivingStyle style;
};

/// The verdict on one goal; none without a path. The place is in the scenario's frame.
using Verdict = std::optional<PathCheck>;

Verdict judge(const Problem& problem, const ResultRecord& record) {
  if (!record.result.path) return std::nullopt;
  Path path = *record.result.path;
  path.start = to_local(*problem.world, path.start);
  PathClaims claims = record.claims;
  for (StatedPose& stated : claims.poses) stated.pose = to_local(*problem.world, stated.pose);
  PathCheck check = check_path(problem, path, claims);
  if (check.at) check.at->pose = to_scenario(*problem.world, check.at->pose);
  return check;
}

nlohmann::ordered_json json_of(const ResultRecord& record, const Verdict& verdict) {
  nlohmann::ordered_json json;
  if (record.distance) json["distance"] = *record.distance;
  json["status"] = name_of(record.result.status);
  json["valid"] = verdict && verdict->valid;
  if (!verdict) return json;
  json["length"] = verdict->length;
  json["gear_changes"] = verdict->gear_changes;
  // JSON has no infinity: without obstacles there is no clearance.
  if (verdict->clearance && std::isfinite(*verdict->clearance)) {
    json["clearance"] = *verdict->clearance;
  }
  if (!verdict->valid) json["reason"] = verdict->reason;
  if (verdict->at) {
    const auto& [s, pose, curvature, direction] = *verdict->at;
    json["at"] = {{"s", s}, {"x", pose.x}, {"y", pose.y}, {"heading", pose.heading}};
  }
  return json;
}

std::string text_of(const ResultRecord& record, const Verdict& verdict) {
  if (!verdict) return fmt::format("no path: {}", name_of(record.result.status));
  if (verdict->valid) {
    const std::string clearance = std::isfinite(*verdict->clearance)
                                      ? fmt::format("clearance {:.3f} m", *verdict->clearance)
                                      : "no obstacles";
    return fmt::format("valid: length {:.3f} m, gear changes {}, {}", verdict->length,
                       verdict->gear_changes, clearance);
  }
  if (!verdict->at) return fmt::format("invalid: {}", verdict->reason);
  const auto& [s, pose, curvature, direction] = *verdict->at;
  return fmt::format("invalid: {} at s = {:.4f} m, where x = {} m, y = {} m, heading = {} rad",
                     verdict->reason, s, pose.x, pose.y, pose.heading);
}

nlohmann::ordered_json json_of(const PathMetrics& metrics, const DrivingStyle& style) {
  return {{"length", metrics.length},
          {"gear_changes", metrics.gear_changes},
          {"reverse_share", metrics.reverse_share},
          {"turning", metrics.turning},
          {"curvature_changes", metrics.curvature_changes},
          {"driving_time", metrics.driving_time},
          {"speed", style.speed},
          {"pause", style.pause}};
}

std::string text_of(const PathMetrics& metrics, const DrivingStyle& style) {
  return fmt::format(
      "in reverse {:.1f} %, turning {:.3f} rad, curvature changes {}, "
      "driven in {:.1f} s (at {} m/s, {} s for each gear change)",
      100.0 * metrics.reverse_share, metrics.turning, metrics.curvature_changes,
      metrics.driving_time, style.speed, style.pause);
}

std::string text_of(const std::optional<double>& distance) {
  return distance ? fmt::format("{} m", *distance) : "none";
}

/// What is wrong about the furthest goal that a file states for a row; empty if nothing is.
std::string false_furthest(const std::vector<ResultRecord>& records) {
  const std::optional<StatedFurthest>& stated = records.front().furthest;
  if (!stated) return "";
  const std::optional<double> reached = furthest_reached(records);
  if (stated->distance == reached) return "";
  return fmt::format("the stated furthest is {}, the furthest goal reached is {}",
                     text_of(stated->distance), text_of(reached));
}

int run(const CheckArguments& arguments) {
  validate(arguments.style);
  const Scenario scenario = read_scenario(arguments.scenario);
  const std::vector<ResultRecord> records = read_results(arguments.result, scenario);
  const std::vector<Problem> problems = make_problems(scenario);
  nlohmann::ordered_json goals = nlohmann::ordered_json::array();
  int valid = 0;
  int invalid = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Verdict verdict = judge(problems[i], records[i]);
    if (verdict) ++(verdict->valid ? valid : invalid);
    goals.push_back(json_of(records[i], verdict));
    std::string text = text_of(records[i], verdict);
    if (arguments.metrics && records[i].result.path) {
      const PathMetrics metrics = metrics_of(*records[i].result.path, arguments.style);
      goals.back()["metrics"] = json_of(metrics, arguments.style);
      text += "\n  " + text_of(metrics, arguments.style);
    }
    if (arguments.json) continue;
    if (scenario.goals_are_a_row) fmt::print("goals[{}]: ", i);
    fmt::print("{}\n", text);
  }
  const std::string reason = scenario.goals_are_a_row ? false_furthest(records) : "";
  if (!reason.empty() && !arguments.json) fmt::print("invalid: {}\n", reason);
  // A row of goals may hold some that were not reached.
  const bool passed = valid > 0 && invalid == 0 && reason.empty();
  if (arguments.json && scenario.goals_are_a_row) {
    nlohmann::ordered_json row = {{"valid", passed}};
    if (!reason.empty()) row["reason"] = reason;
    row["goals"] = goals;
    print(row);
  } else if (arguments.json) {
    print(goals.front());
  }
  return passed ? exit_status::done : exit_status::failed;
}

}  // namespace

void add_check(CLI::App& vandplan, int& status) {
  CLI::App* const command = vandplan.add_subcommand(
      "check",
      "Let the independent judge look at a result: start, goal, curvature, bounds,\n"
      "collisions, and whatever the file states: length, gear changes, cost, gap, poses,\n"
      "furthest goal.");
  const auto arguments = std::make_shared<CheckArguments>();
  command->add_option("SCENARIO", arguments->scenario, "Scenario file (YAML), - is standard input")
      ->required();
  command->add_option("RESULT", arguments->result, "Result file (JSON)")->required();
  CLI::Option* const metrics = command->add_flag(
      "--metrics", arguments->metrics,
      "Also what the path is like to drive: share in reverse, turning, curvature changes, time");
  command->add_option("--speed", arguments->style.speed, "It is driven at [m/s]; > 0")
      ->type_name("M/S")
      ->needs(metrics)
      ->capture_default_str();
  command->add_option("--pause", arguments->style.pause, "Each gear change takes [s]; >= 0")
      ->type_name("S")
      ->needs(metrics)
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Print one JSON object instead of a summary");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a result written? (docs/formats.md)

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "vandplan/result_file.h"
#include "vandplan/version.h"

namespace vandplan {
namespace {

using Json = nlohmann::ordered_json;

constexpr double pose_distance = 0.1;  // at most between neighbouring poses of a file [m]

Json json_of(const Pose& pose) { return {{"x", pose.x}, {"y", pose.y}, {"heading", pose.heading}}; }

Json json_of(const Segment& segment, double radius) {
  Json json;
  if (segment.curvature_rate != 0.0) {
    json["curvature"] = segment.curvature;
    json["curvature_rate"] = segment.curvature_rate;
  } else if (segment.curvature == 0.0) {
    json["turn"] = "straight";
  } else if (std::abs(segment.curvature) == 1.0 / radius) {
    json["turn"] = segment.curvature > 0.0 ? "left" : "right";
  } else {
    json["curvature"] = segment.curvature;
  }
  json["length"] = segment.length;
  return json;
}

Json json_of(const PathPoint& point) {
  Json json;
  json["s"] = point.s;
  json["x"] = point.pose.x;
  json["y"] = point.pose.y;
  json["heading"] = point.pose.heading;
  json["curvature"] = point.curvature;
  json["direction"] = point.direction;
  return json;
}

Json poses_of(const Path& path) {
  Json json = Json::array();
  for (const PathPoint& point : sampled(path, pose_distance)) json.push_back(json_of(point));
  return json;
}

Json json_of(const Path& path, double radius) {
  Json segments = Json::array();
  for (const Segment& segment : path.segments) segments.push_back(json_of(segment, radius));
  Json json = {{"start", json_of(path.start)}, {"segments", segments}};
  json["poses"] = poses_of(path);  // by far the most of a file: not to be copied
  return json;
}

Json json_of(const TreeSnapshot& tree) {
  Json poses = Json::array();
  for (const Pose& pose : tree.poses) poses.push_back({pose.x, pose.y, pose.heading});
  return {{"poses", poses}, {"parents", tree.parents}};
}

Json time_of(const PlanResult& result) {
  Json time = {{"total", result.time_total}};
  if (!result.anytime.empty()) time["first_solution"] = result.anytime.front().time;
  return time;
}

Json anytime_of(const PlanResult& result) {
  Json json = Json::array();
  for (const CostSample& sample : result.anytime) {
    json.push_back({{"time", sample.time}, {"iteration", sample.iteration}, {"cost", sample.cost}});
  }
  return json;
}

Json options_of(const PlanOptions& options) {
  Json json = Json::object();
  for (const CommonOption& option : common_options()) {
    json[std::string(option.name)] = Json::parse(option.get(options));
  }
  for (const auto& [name, value] : options.planner.values())
    json[name] = Json::parse(vandplan::json_of(value));
  return json;
}

Json counters_of(const PlanResult& result) {
  Json json = Json::object();
  for (const Counter& counter : result.counters) json[counter.name] = counter.value;
  return json;
}

Json build_of(const BuildInfo& build) {
  return {
      {"version", build.version}, {"compiler", build.compiler}, {"build_type", build.build_type}};
}

Json heading_of(const ResultRecord& record) {
  return {{"format", "vandplan-result/1"},
          {"scenario", record.scenario},
          {"planner", record.planner},
          {"seed", record.options.budget.seed}};
}

Json json_of(const Vehicle& vehicle, const ResultRecord& record) {
  const PlanResult& result = record.result;
  Json json = heading_of(record);
  if (record.distance) json["distance"] = *record.distance;
  json["status"] = name_of(result.status);
  if (!result.reason.empty()) json["reason"] = result.reason;
  if (result.path) {
    json["length"] = length(result.path->segments);
    json["cost"] = result.cost;
    if (result.lower_bound > 0.0) {
      json["bound"] = result.lower_bound;
      json["gap"] = result.cost / result.lower_bound - 1.0;
    }
    json["gear_changes"] = gear_changes(result.path->segments);
    if (result.check) {
      json["reverse_length"] = result.check->reverse_length;
      // JSON has no infinity: without obstacles there is no clearance.
      const std::optional<double>& clearance = result.check->clearance;
      if (clearance && std::isfinite(*clearance)) json["clearance"] = *clearance;
    }
  }
  json["time"] = time_of(result);
  json["iterations"] = result.iterations;
  json["nodes"] = counter(result, "nodes");
  json["counters"] = counters_of(result);
  json["anytime"] = anytime_of(result);
  if (result.path) json["path"] = json_of(*result.path, vehicle.min_turning_radius);
  if (result.tree) json["tree"] = json_of(*result.tree);
  json["options"] = options_of(record.options);
  json["build"] = build_of(build_info());
  return json;
}

/// Whether it goes on one line: nothing in it holds anything.
bool is_flat(const Json& json) {
  return std::none_of(json.begin(), json.end(),
                      [](const Json& item) { return item.is_structured() && !item.empty(); });
}

/// One line for whatever is flat, else one line per element.
void write(const Json& json, const std::string& indent, std::string& text) {
  if (!json.is_structured() || json.empty()) {
    text += json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return;
  }
  const bool flat = is_flat(json);
  const std::string inner = indent + "  ";
  text += json.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& item : json.items()) {
    if (!first) text += flat ? ", " : ",";
    if (!flat) text += '\n' + inner;
    if (json.is_object()) {
      text += Json(item.key()).dump(-1, ' ', false, Json::error_handler_t::replace) + ": ";
    }
    write(item.value(), inner, text);
    first = false;
  }
  if (!flat) text += '\n' + indent;
  text += json.is_object() ? '}' : ']';
}

}  // namespace

std::optional<double> furthest_reached(const std::vector<ResultRecord>& records) {
  std::optional<double> furthest;
  for (const ResultRecord& record : records) {
    if (record.result.path) furthest = std::max(furthest, record.distance);
  }
  return furthest;
}

std::string results_to_json(const ScenarioFile& file, const std::vector<ResultRecord>& records) {
  assert(!records.empty());
  const Vehicle& vehicle = file.scenario.vehicle;
  Json json;
  if (file.is_row()) {
    json = heading_of(records.front());
    json["goals"] = Json::array();
    for (const ResultRecord& record : records) json["goals"].push_back(json_of(vehicle, record));
    const std::optional<double> furthest = furthest_reached(records);
    json["furthest"] = furthest ? Json(*furthest) : Json();
  } else {
    json = json_of(vehicle, records.front());
  }
  std::string text;
  write(json, "", text);
  return text + '\n';
}

std::string result_to_json_line(std::size_t pair, const Problem& problem,
                                const ResultRecord& record) {
  Json json = {{"pair", pair}};
  json["start"] = json_of(problem.start());
  json["goal"] = json_of(problem.goal());
  Json result = json_of(problem.vehicle(), record);
  for (auto& [key, value] : result.get_ref<Json::object_t&>()) json[key] = std::move(value);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/result_geojson.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/local_plane.h"

namespace vandplan::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr double place_distance = 0.5;  // Largest distance of neighbouring places of a line [m].
constexpr double most_places = 1e6;     // Largest number of places of a line, about.

Json feature_of(Json geometry, Json properties) {
  return {{"type", "Feature"},
          {"properties", std::move(properties)},
          {"geometry", std::move(geometry)}};
}

Json properties_of_path(const ResultRecord& record) {
  const PlanResult& result = record.result;
  Json properties = {{"what", "path"},
                     {"scenario", record.scenario},
                     {"planner", record.planner},
                     {"status", name_of(result.status)}};
  if (record.distance) properties["distance"] = *record.distance;
  if (!result.reason.empty()) properties["reason"] = result.reason;
  if (!result.path) return properties;
  properties["length"] = length(*result.path);
  properties["gear_changes"] = gear_changes(*result.path);
  properties["cost"] = result.cost;
  if (result.speeds) properties["duration"] = result.speeds->duration;
  return properties;
}

/// The line of a path, and points at its start, gear changes and end.
void add_path(Json& features, const ResultRecord& record, const FromPlane& place_at) {
  const Path& path = *record.result.path;
  const auto position = [&](const Pose& pose) {
    const GeoPlace place = place_at({pose.x, pose.y});
    return Json::array({place.longitude, place.latitude});
  };
  Json line = Json::array();
  Json points = Json::array();
  const auto add_point = [&](const char* what, const PathPoint& point) {
    points.push_back(feature_of({{"type", "Point"}, {"coordinates", position(point.pose)}},
                                {{"what", what},
                                 {"s", point.s},
                                 {"heading", point.pose.heading},
                                 {"direction", direction_of(point.gear)}}));
  };
  const auto all = sampled(path, std::max(place_distance, length(path) / most_places));
  for (std::size_t i = 0; i < all.size(); ++i) {
    line.push_back(position(all[i].pose));
    if (i == 0) add_point("start", all[i]);
    if (i > 0 && all[i].gear != all[i - 1].gear) add_point("gear change", all[i]);
    if (i + 1 == all.size()) add_point("end", all[i]);
  }
  if (line.size() == 1) line.push_back(line.front());  // A line has two positions at least.
  features.push_back(feature_of({{"type", "LineString"}, {"coordinates", std::move(line)}},
                                properties_of_path(record)));
  for (Json& point : points) features.push_back(std::move(point));
}

}  // namespace

std::string geojson_of(const ScenarioFile& file, const std::vector<ResultRecord>& records) {
  const FromPlane place_at = places_around(file.origin.value());
  Json features = Json::array();
  for (const ResultRecord& record : records) {
    if (record.result.path) {
      add_path(features, record, place_at);
    } else {
      features.push_back(feature_of(nullptr, properties_of_path(record)));
    }
  }
  std::string text = R"({"type": "FeatureCollection", "name": )" +
                     Json(file.scenario.name).dump(-1, ' ', false, Json::error_handler_t::replace) +
                     ", \"features\": [";
  const char* separator = "\n";
  for (const Json& feature : features) {
    text += separator + feature.dump(-1, ' ', false, Json::error_handler_t::replace);
    separator = ",\n";
  }
  return text + "\n]}\n";
}

}  // namespace vandplan::io

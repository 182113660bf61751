// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/geojson_zone.h"

#include <cmath>
#include <numbers>
#include <string>

#include "io/goal_file.h"
#include "io/site_shapes.h"
#include "vandplan/input_error.h"
#include "vandplan/plan_options.h"

namespace vandplan::io {
namespace {

constexpr double quarter = std::numbers::pi / 2;

HeadingRange around(double heading) { return {heading - quarter, heading + quarter}; }

}  // namespace

Zone rules_of(const Document& file, const Feature& feature) {
  const auto find = [&](const char* name) { return property(file, *feature.node, name); };
  Zone zone;
  if (const Node* const name = find("name")) zone.name = file.text(*name);
  if (const Node* const closed = find("closed")) zone.closed = file.truth(*closed);
  if (const Node* const body = find("body")) zone.body = file.truth(*body);
  if (const Node* const cost = find("cost")) zone.cost = file.number(*cost);
  if (const Node* const speed = find("max_speed")) zone.max_speed = file.number(*speed);
  if (const Node* const direction = find("direction")) {
    zone.direction = directions_from(file, *direction);
  }
  if (feature.heading) zone.direction = around(*feature.heading);
  if (const Node* const gears = find("gears")) {
    try {
      zone.gears = gears_named(file.text(*gears));
    } catch (const InputError& error) {
      file.fail(*gears, error.problem());
    }
  }
  const bool is_line = feature.type.ends_with("LineString");
  if (feature.kind == FeatureKind::one_way && !zone.direction && !is_line) {
    file.fail(*feature.node, "is one-way without direction, heading or heading_deg");
  }
  if (feature.kind == FeatureKind::speed && !zone.max_speed) {
    file.fail(*feature.node, "key \"max_speed\" is missing, expected a speed in m/s");
  }
  return zone;
}

std::vector<Zone> street_along(const std::vector<Point>& line, double width, const Zone& rules) {
  std::vector<Zone> zones;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point& from = line[i - 1];
    const Point& to = line[i];
    if (from == to) continue;
    Zone zone = rules;
    zone.direction = around(std::atan2(to.y - from.y, to.x - from.x));
    zone.area = walls_along(std::vector<Point>{from, to}, width).front();
    zones.push_back(std::move(zone));
  }
  return zones;
}

}  // namespace vandplan::io

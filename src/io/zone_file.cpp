// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/zone_file.h"

#include <fmt/format.h>

#include "io/goal_file.h"
#include "io/map_file.h"
#include "io/polygons.h"
#include "vandplan/input_error.h"
#include "vandplan/plan_options.h"

namespace vandplan::io {
namespace {

AllowedGears gears_from(const Document& file, const Node& node) {
  try {
    return gears_named(file.text(node));
  } catch (const InputError& error) {
    file.fail(node, error.problem());
  }
}

Zone zone_from(const Document& file, const Node& node) {
  file.allow_only(node,
                  {"name", "area", "closed", "gears", "direction", "cost", "max_speed", "body"});
  Zone zone{.area = polygon_from(file, file.at(node, "area"))};
  if (const Node* const name = file.find(node, "name")) zone.name = file.text(*name);
  if (const Node* const closed = file.find(node, "closed")) zone.closed = file.truth(*closed);
  if (const Node* const gears = file.find(node, "gears")) zone.gears = gears_from(file, *gears);
  if (const Node* const direction = file.find(node, "direction")) {
    zone.direction = headings_from(file, *direction);
  }
  if (const Node* const cost = file.find(node, "cost")) zone.cost = file.number(*cost);
  if (const Node* const speed = file.find(node, "max_speed")) zone.max_speed = file.number(*speed);
  if (const Node* const body = file.find(node, "body")) zone.body = file.truth(*body);
  return zone;
}

}  // namespace

std::vector<Zone> zones_from(const Document& file, const Node& node) {
  std::vector<Zone> zones;
  for (const Node& item : file.list(node, "a list of zones")) {
    zones.push_back(zone_from(file, item));
  }
  return zones;
}

std::string zones_to_yaml(const std::vector<Zone>& zones) {
  std::string text = zones.empty() ? "" : "zones:\n";
  for (const Zone& zone : zones) {
    std::string rules = zone.name.empty() ? "" : fmt::format("name: {}, ", yaml_scalar(zone.name));
    rules += fmt::format("area: {}", yaml_of(zone.area));
    if (zone.closed) rules += ", closed: true";
    if (zone.gears != AllowedGears::both) rules += fmt::format(", gears: {}", name_of(zone.gears));
    if (zone.direction) rules += fmt::format(", direction: {}", yaml_of(*zone.direction));
    if (zone.cost != 1.0) rules += fmt::format(", cost: {}", zone.cost);
    if (zone.max_speed) rules += fmt::format(", max_speed: {}", *zone.max_speed);
    if (zone.body) rules += ", body: true";
    text += fmt::format("  - {{{}}}\n", rules);
  }
  return text;
}

std::vector<Mask> masks_from(const Document& file, const Node& node, const std::string& where,
                             std::vector<std::string>& warnings) {
  std::vector<Mask> masks;
  for (const Node& item : file.list(node, "a list of masks")) {
    file.allow_only(item, {"map", "as"});
    const Node& as = file.at(item, "as");
    if (file.text(as) != "obstacles") {
      file.fail(as, "is \"" + file.text(as).substr(0, 40) + "\", expected obstacles");
    }
    const Node& map = file.at(item, "map");
    masks.push_back({file.text(map), map_named(file, map, where, warnings)});
  }
  return masks;
}

std::string masks_to_yaml(const std::vector<Mask>& masks) {
  std::string text = masks.empty() ? "" : "masks:\n";
  for (const Mask& mask : masks) {
    text += fmt::format("  - {{map: {}, as: obstacles}}\n", yaml_scalar(mask.map_file));
  }
  return text;
}

}  // namespace vandplan::io

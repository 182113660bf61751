// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/zone_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <utility>

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
    zone.direction = directions_from(file, *direction);
  }
  if (const Node* const cost = file.find(node, "cost")) zone.cost = file.number(*cost);
  if (const Node* const speed = file.find(node, "max_speed")) zone.max_speed = file.number(*speed);
  if (const Node* const body = file.find(node, "body")) zone.body = file.truth(*body);
  return zone;
}

/// A mask with the keys `as` and `of`.
Mask mask_named(const Document& file, const Node& item) {
  for (const char* const key : {"base", "multiplier"}) {
    if (const Node* const node = file.find(item, key)) {
      file.fail(*node, "is given without type, expected type 0, 1 or 2 beside it");
    }
  }
  const Node& as = file.at(item, "as");
  const Node* const of = file.find(item, "of");
  const std::string& use = file.text(as);
  if (use == name_of(MaskUse::obstacles)) {
    if (of != nullptr) file.fail(*of, "is given for obstacles, expected max_speed or cost");
    return {};
  }
  if (use != name_of(MaskUse::max_speed) && use != name_of(MaskUse::cost)) {
    file.fail(as, "is \"" + use.substr(0, 40) + "\", expected obstacles, max_speed or cost");
  }
  const double most = file.number(file.at(item, "of"));
  return use == name_of(MaskUse::cost) ? cost_mask({}, most) : speed_mask({}, most);
}

/// A mask with the keys of Nav2's costmap filters: 0 is keepout, 1 a speed in percent, 2 one in
/// m/s.
Mask mask_of_nav2(const Document& file, const Node& item, double fastest) {
  for (const char* const key : {"as", "of"}) {
    if (const Node* const node = file.find(item, key)) {
      file.fail(*node, "is given beside type, expected one of them");
    }
  }
  const Node& type = file.at(item, "type");
  const double kind = file.number(type);
  if (kind != 0 && kind != 1 && kind != 2) {
    file.fail(type, fmt::format("is {}, expected 0 (keepout), 1 (speed in %) or 2 (in m/s)", kind));
  }
  const auto number = [&](const char* key, double otherwise) {
    const Node* const node = file.find(item, key);
    return node == nullptr ? otherwise : file.number(*node);
  };
  const double base = number("base", 0.0), multiplier = number("multiplier", 1.0);
  if (kind == 0) return {};
  const double unit = kind == 1 ? fastest / 100 : 1.0;
  return {.use = MaskUse::max_speed, .base = unit * base, .multiplier = unit * multiplier};
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
    if (zone.direction) {
      rules += fmt::format(", direction: [{}, {}]", zone.direction->from, zone.direction->to);
    }
    if (zone.cost != 1.0) rules += fmt::format(", cost: {}", zone.cost);
    if (zone.max_speed) rules += fmt::format(", max_speed: {}", *zone.max_speed);
    if (zone.body) rules += ", body: true";
    text += fmt::format("  - {{{}}}\n", rules);
  }
  return text;
}

std::vector<Mask> masks_from(const Document& file, const Node& node, const std::string& where,
                             double fastest, std::vector<std::string>& warnings) {
  std::vector<Mask> masks;
  for (const Node& item : file.list(node, "a list of masks")) {
    file.allow_only(item, {"map", "as", "of", "type", "base", "multiplier"});
    const bool is_of_nav2 = file.find(item, "type") != nullptr;
    Mask mask = is_of_nav2 ? mask_of_nav2(file, item, fastest) : mask_named(file, item);
    const Node& map = file.at(item, "map");
    mask.map_file = file.text(map);
    std::vector<std::uint8_t> percents;
    mask.map = map_named(file, map, where, warnings, &percents);
    if (mask.use != MaskUse::obstacles) {
      mask.percents = std::make_shared<const std::vector<std::uint8_t>>(std::move(percents));
    }
    masks.push_back(std::move(mask));
  }
  return masks;
}

std::string masks_to_yaml(const std::vector<Mask>& masks) {
  std::string text = masks.empty() ? "" : "masks:\n";
  for (const Mask& mask : masks) {
    std::string rule = fmt::format("as: {}", name_of(mask.use));
    if (mask.use == MaskUse::cost) {
      rule += fmt::format(", of: {}", 100 * mask.multiplier);
    } else if (mask.use == MaskUse::max_speed && mask.multiplier == -mask.base / 100) {
      rule += fmt::format(", of: {}", mask.base);
    } else if (mask.use == MaskUse::max_speed) {
      rule = fmt::format("type: 2, base: {}, multiplier: {}", mask.base, mask.multiplier);
    }
    text += fmt::format("  - {{map: {}, {}}}\n", yaml_scalar(mask.map_file), rule);
  }
  return text;
}

}  // namespace vandplan::io

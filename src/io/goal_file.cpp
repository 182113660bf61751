// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/goal_file.h"

#include <fmt/format.h>

#include "io/polygons.h"
#include "vandplan/files.h"
#include "vandplan/vehicle.h"

namespace vandplan::io {
namespace {

Pose lone_pose(const Document& file, const Node& node) {
  file.allow_only(node, {"x", "y", "heading", "curvature", "hitch_angles"});
  return {file.number(file.at(node, "x")), file.number(file.at(node, "y")),
          file.number(file.at(node, "heading"))};
}

double curvature_from(const Document& file, const Node& pose) {
  const Node* const curvature = file.find(pose, "curvature");
  return curvature == nullptr ? 0.0 : file.number(*curvature);
}

void expect_trailer(const Document& file, const Node& node, const Vehicle& vehicle,
                    const char* verb) {
  if (vehicle.trailer) return;
  file.fail(node,
            fmt::format("{} given without a trailer, expected trailers of the vehicle", verb));
}

/// The only element of a list of hitch angles.
const Node& angle_node(const Document& file, const Node& angles) {
  const std::vector<Node>& items = file.list(angles, "a list with one angle");
  if (items.size() != 1) {
    file.fail(angles, fmt::format("has {} angles, expected 1, one for each trailer", items.size()));
  }
  return items[0];
}

double hitch_angle_from(const Document& file, const Node& pose, const Vehicle& vehicle) {
  const Node* const angles = file.find(pose, "hitch_angles");
  if (angles == nullptr) return 0.0;
  expect_trailer(file, *angles, vehicle, "are");
  return file.number(angle_node(file, *angles));
}

bool is_any(const Node& node) { return node.kind == Node::Kind::scalar && node.text == "any"; }

/// Interval from a number, or from [least, most].
Interval interval_from(const Document& file, const Node& node) {
  if (node.kind != Node::Kind::list) return {file.number(node), file.number(node)};
  const Point ends = pair_from(file, node, "[smallest, largest]");
  return {ends.x, ends.y};
}

Interval hitch_angles_from(const Document& file, const Node& node, const Vehicle& vehicle) {
  expect_trailer(file, node, vehicle, "are");
  if (is_any(node)) return {-vehicle.max_hitch_angle, vehicle.max_hitch_angle};
  return interval_from(file, angle_node(file, node));
}

/// Reads place and heading of the axle that a goal refers to.
void read_axle(const Document& file, const Node& node, GoalRegion& region) {
  if (const Node* const area = file.find(node, "area")) {
    for (const char* const key : {"x", "y"}) {
      if (file.find(node, key) == nullptr) continue;
      file.fail(*area, fmt::format("is given beside {}, expected one of the two", key));
    }
    region.area = polygon_from(file, *area);
    if (region.area.empty()) file.fail(*area, "has 0 corners, expected at least 3");
  } else {
    region.x = interval_from(file, file.at(node, "x"));
    region.y = interval_from(file, file.at(node, "y"));
  }
  region.heading = headings_from(file, file.at(node, "heading"));
  const Node* const either_way = file.find(node, "either_way");
  if (either_way != nullptr) region.either_way = file.truth(*either_way);
}

/// Reads a region; `stop` of a via may stand beside its keys.
GoalRegion region_from(const Document& file, const Node& node, const Vehicle& vehicle) {
  GoalRegion region;
  if (const Node* const trailer = file.find(node, "trailer")) {
    file.allow_only(node, {"trailer", "curvature", "hitch_angles", "straight", "stop"});
    expect_trailer(file, *trailer, vehicle, "is");
    file.allow_only(*trailer, {"x", "y", "area", "heading", "either_way"});
    region.is_of_trailer = true;
    read_axle(file, *trailer, region);
  } else {
    file.allow_only(node, {"x", "y", "area", "heading", "either_way", "trailer", "any_of",
                           "curvature", "hitch_angles", "straight", "stop"});
    read_axle(file, node, region);
  }
  region.curvature = curvature_from(file, node);
  if (const Node* const straight = file.find(node, "straight")) {
    region.straight = file.number(*straight);
  }
  if (const Node* const angles = file.find(node, "hitch_angles")) {
    region.hitch_angle = hitch_angles_from(file, *angles, vehicle);
  }
  return region;
}

/// The goals under `any_of`, or the goal itself.
std::vector<const Node*> entries_of(const Document& file, const Node& node) {
  const Node* const any_of = file.find(node, "any_of");
  if (any_of == nullptr) return {&node};
  file.allow_only(node, {"any_of", "stop"});
  std::vector<const Node*> entries;
  for (const Node& item : file.list(*any_of, "a list of goals")) entries.push_back(&item);
  if (entries.empty()) file.fail(*any_of, "is empty, expected at least one goal");
  return entries;
}

void expect_no_stop(const Document& file, const Node& node) {
  if (const Node* const stop = file.find(node, "stop")) {
    file.fail(*stop, "is given, expected it for entries of via alone");
  }
}

std::vector<GoalRegion> regions_from(const Document& file, const Node& node,
                                     const Vehicle& vehicle) {
  std::vector<GoalRegion> set;
  for (const Node* const entry : entries_of(file, node)) {
    if (entry != &node) {
      expect_no_stop(file, *entry);
      const Node* const inner = file.find(*entry, "any_of");
      if (inner != nullptr) file.fail(*inner, "is given within any_of, expected one region");
    }
    set.push_back(region_from(file, *entry, vehicle));
  }
  return set;
}

std::string yaml_of(const Interval& interval) {
  if (interval.least == interval.most) return fmt::format("{}", interval.least);
  return fmt::format("[{}, {}]", interval.least, interval.most);
}

std::string yaml_of(const GoalRegion& region) {
  std::string axle = region.area.empty()
                         ? fmt::format("x: {}, y: {}", yaml_of(region.x), yaml_of(region.y))
                         : fmt::format("area: {}", io::yaml_of(region.area));
  axle += fmt::format(", heading: {}", io::yaml_of(region.heading));
  if (region.either_way) axle += ", either_way: true";
  if (region.is_of_trailer) axle = fmt::format("trailer: {{{}}}", axle);
  if (region.curvature != 0.0) axle += fmt::format(", curvature: {}", region.curvature);
  if (region.hitch_angle != Interval{}) {
    axle += fmt::format(", hitch_angles: [{}]", yaml_of(region.hitch_angle));
  }
  if (region.straight != 0.0) axle += fmt::format(", straight: {}", region.straight);
  return fmt::format("{{{}}}", axle);
}

}  // namespace

HeadingRange headings_from(const Document& file, const Node& node) {
  if (is_any(node)) return any_heading;
  if (node.kind != Node::Kind::list) return {file.number(node), file.number(node)};
  return directions_from(file, node);
}

HeadingRange directions_from(const Document& file, const Node& node) {
  const Point ends = pair_from(file, node, "[first, last], counter-clockwise");
  return {ends.x, ends.y};
}

End end_from(const Document& file, const Node& node, const Vehicle& vehicle) {
  return {lone_pose(file, node), curvature_from(file, node), hitch_angle_from(file, node, vehicle)};
}

End goal_from(const Document& file, const Node& node, const Vehicle& vehicle) {
  const Node* const trailer = file.find(node, "trailer");
  if (trailer == nullptr) return end_from(file, node, vehicle);
  file.allow_only(node, {"trailer", "curvature", "hitch_angles"});
  expect_trailer(file, *trailer, vehicle, "is");
  file.allow_only(*trailer, {"x", "y", "heading"});
  End end{lone_pose(file, *trailer), curvature_from(file, node),
          hitch_angle_from(file, node, vehicle)};
  end.pose = tractor_pose(vehicle, end.pose, end.hitch_angle);
  return end;
}

bool is_goal_set(const Document& file, const Node& node) {
  if (file.find(node, "straight") != nullptr) return true;
  const Node* const trailer = file.find(node, "trailer");
  const Node& axle = trailer == nullptr ? node : *trailer;
  for (const char* const key : {"any_of", "area", "either_way"}) {
    if (file.find(axle, key) != nullptr) return true;
  }
  for (const char* const key : {"x", "y", "heading"}) {
    const Node* const value = file.find(axle, key);
    if (value == nullptr) continue;
    if (value->kind == Node::Kind::list || is_any(*value)) return true;
  }
  const Node* const angles = file.find(node, "hitch_angles");
  if (angles == nullptr) return false;
  return is_any(*angles) || (angles->kind == Node::Kind::list && angles->items.size() == 1 &&
                             angles->items[0].kind == Node::Kind::list);
}

std::vector<GoalRegion> goal_set_from(const Document& file, const Node& node,
                                      const Vehicle& vehicle) {
  expect_no_stop(file, node);
  return regions_from(file, node, vehicle);
}

std::vector<Via> via_from(const Document& file, const Node& node, const Vehicle& vehicle) {
  std::vector<Via> all;
  for (const Node& item : file.list(node, "a list of what the path passes")) {
    const Node* const stop = file.find(item, "stop");
    all.push_back({.any_of = regions_from(file, item, vehicle),
                   .stop = stop != nullptr && file.truth(*stop)});
  }
  return all;
}

void warn_of_degrees(const Document& file, const Node& node, std::vector<std::string>& warnings) {
  for (const Node* const entry : entries_of(file, node)) {
    const Node* const trailer = file.find(*entry, "trailer");
    const Node& heading = file.at(trailer == nullptr ? *entry : *trailer, "heading");
    if (is_any(heading)) continue;
    const bool is_range = heading.kind == Node::Kind::list;
    for (const Node& value : is_range ? heading.items : std::vector<Node>{heading}) {
      const std::string doubt = heading_doubt(file.number(value));
      if (doubt.empty()) continue;
      warnings.push_back(file.place_of(heading) + ": " + doubt);
      break;
    }
  }
}

std::string yaml_of(const HeadingRange& range) {
  if (range == any_heading) return "any";
  if (range.from == range.to) return fmt::format("{}", range.from);
  return fmt::format("[{}, {}]", range.from, range.to);
}

std::string yaml_of(const End& end) {
  std::string more = end.curvature == 0.0 ? "" : fmt::format(", curvature: {}", end.curvature);
  if (end.hitch_angle != 0.0) more += fmt::format(", hitch_angles: [{}]", end.hitch_angle);
  return fmt::format("{{x: {}, y: {}, heading: {}{}}}", end.pose.x, end.pose.y, end.pose.heading,
                     more);
}

std::string yaml_of(const std::vector<GoalRegion>& set) {
  const bool is_alone =
      set.size() == 1 && (set[0].either_way || is_continuous(set[0]) || set[0].straight != 0.0);
  if (is_alone) return " " + yaml_of(set.front()) + "\n";
  std::string text = "\n  any_of:\n";
  for (const GoalRegion& region : set) text += fmt::format("    - {}\n", yaml_of(region));
  return text;
}

std::string yaml_of(const std::vector<Via>& via) {
  std::string text = via.empty() ? "" : "via:\n";
  for (const auto& [any_of, stop] : via) {
    std::string entries;
    for (const GoalRegion& region : any_of) {
      entries += (entries.empty() ? "" : ", ") + yaml_of(region);
    }
    std::string entry = any_of.size() == 1 ? entries : fmt::format("{{any_of: [{}]}}", entries);
    if (stop) entry.insert(entry.size() - 1, ", stop: true");
    text += fmt::format("  - {}\n", entry);
  }
  return text;
}

}  // namespace vandplan::io

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a scenario read and written? (docs/formats.md)

#include <fmt/format.h>

#include <filesystem>

#include "io/document.h"
#include "io/vehicle_file.h"
#include "vandplan/input_error.h"
#include "vandplan/io.h"

namespace vandplan {
namespace {

/// A list of exactly two numbers.
Point pair_from(const Document& file, const Node& node, const std::string& expected) {
  const std::vector<Node>& items = file.list(node, expected);
  if (items.size() != 2) {
    file.fail(node, fmt::format("has {} element{}, expected {}", items.size(),
                                items.size() == 1 ? "" : "s", expected));
  }
  return {file.number(items[0]), file.number(items[1])};
}

Bounds bounds_from(const Document& file, const Node& node) {
  file.allow_only(node, {"x", "y"});
  const Point x = pair_from(file, file.at(node, "x"), "[smallest, largest]");
  const Point y = pair_from(file, file.at(node, "y"), "[smallest, largest]");
  return {x.x, x.y, y.x, y.y};
}

Pose pose_from(const Document& file, const Node& node) {
  file.allow_only(node, {"x", "y", "heading"});
  return {file.number(file.at(node, "x")), file.number(file.at(node, "y")),
          file.number(file.at(node, "heading"))};
}

std::vector<Polygon> polygons_from(const Document& file, const Node& node) {
  std::vector<Polygon> polygons;
  for (const Node& item : file.list(node, "a list of polygons")) {
    Polygon& polygon = polygons.emplace_back();
    polygon.reserve(item.items.size());
    for (const Node& corner : file.list(item, "a polygon [[x, y], ...]")) {
      polygon.push_back(pair_from(file, corner, "a corner [x, y]"));
    }
  }
  return polygons;
}

std::vector<Goal> goals_from(const Document& file, const Node& node) {
  std::vector<Goal> goals;
  for (const Node& item : file.list(node, "a list of goals")) {
    file.allow_only(item, {"distance", "goal", "obstacles"});
    Goal& goal = goals.emplace_back();
    goal.distance = file.number(file.at(item, "distance"));
    goal.pose = pose_from(file, file.at(item, "goal"));
    if (const Node* const obstacles = file.find(item, "obstacles")) {
      goal.obstacles = polygons_from(file, *obstacles);
    }
  }
  return goals;
}

/// Whether unknown ground is free.
bool unknown_from(const Document& file, const Node& node) {
  const std::string& text = file.text(node);
  if (text != "free" && text != "obstacle") {
    file.fail(node, "is \"" + text.substr(0, 40) + "\", expected free or obstacle");
  }
  return text == "free";
}

using Map = std::optional<OccupancyGrid>;

/// The map that a scenario names, relative to itself.
OccupancyGrid map_from(const Document& file, const Node& node, const std::string& where) {
  const auto path = std::filesystem::path(where).parent_path() / file.text(node);
  try {
    return read_map(path.string());
  } catch (const InputError& error) {
    if (error.where() != path.string()) throw;  // in the map and not the file as such
    file.fail(node, error.what());
  }
}

/// Map, bounds, obstacles and kerbs; with a map the others may be left out.
void read_ground(const Document& file, const std::string& where, const Map& known,
                 Scenario& scenario) {
  const Node& root = file.root();
  const Node* const map = file.find(root, "map");
  const Node* const unknown = file.find(root, "unknown");
  if (map != nullptr) {
    scenario.map_file = file.text(*map);
    scenario.map = known ? *known : map_from(file, *map, where);
    scenario.map->unknown_is_free = unknown != nullptr && unknown_from(file, *unknown);
  } else if (unknown != nullptr) {
    file.fail(*unknown, "is given without a map, expected map beside it");
  }
  const Node* const bounds = file.find(root, "bounds");
  if (map != nullptr && bounds == nullptr) {
    scenario.bounds = bounding_box(outline(*scenario.map));
  } else {
    scenario.bounds = bounds_from(file, file.at(root, "bounds"));
  }
  if (const Node* const kerbs = file.find(root, "kerbs")) {
    scenario.kerbs = polygons_from(file, *kerbs);
  }
  const Node* const obstacles = file.find(root, "obstacles");
  if (map != nullptr && obstacles == nullptr) return;
  scenario.obstacles = polygons_from(file, file.at(root, "obstacles"));
}

Scenario scenario_from(const Document& file, const std::string& where, const Map& map) {
  const Node& root = file.root();
  if (const Node* const image = file.find(root, "image")) {
    file.fail(*image, "belongs into a map, expected a scenario that names this file as its map");
  }
  file.allow_only(root, {"name", "description", "vehicle", "bounds", "start", "goal", "goals",
                         "obstacles", "kerbs", "map", "unknown"});
  const Node* const goals = file.find(root, "goals");
  const Node* const goal = file.find(root, "goal");
  if (goals != nullptr && goal != nullptr) {
    file.fail(*goals, "is given beside goal, expected one of the two");
  }
  if (goals == nullptr && goal == nullptr) {
    file.fail(root, "key \"goal\" is missing, expected either goal or goals");
  }
  Scenario scenario;
  scenario.name = file.text(file.at(root, "name"));
  if (const Node* const description = file.find(root, "description")) {
    scenario.description = file.text(*description);
  }
  scenario.vehicle = vehicle_from(file, file.at(root, "vehicle"));
  scenario.start = pose_from(file, file.at(root, "start"));
  scenario.goals_are_a_row = goals != nullptr;
  scenario.goals =
      goals != nullptr
          ? goals_from(file, *goals)
          : std::vector<Goal>{{.distance = {}, .pose = pose_from(file, *goal), .obstacles = {}}};
  read_ground(file, where, map, scenario);
  return scenario;
}

/// A double-quoted YAML scalar.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if ((c >= 0 && c < ' ') || c == 127) {
      result += fmt::format("\\x{:02x}", static_cast<int>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string yaml_of(const Pose& pose) {
  return fmt::format("{{x: {}, y: {}, heading: {}}}", pose.x, pose.y, pose.heading);
}

/// The value of an `obstacles` key and the end of its line.
std::string yaml_of(const std::vector<Polygon>& polygons, const std::string& indent) {
  if (polygons.empty()) return " []\n";
  std::string text = "\n";
  for (const Polygon& polygon : polygons) {
    std::string corners;
    for (const Point& corner : polygon) {
      corners += fmt::format("{}[{}, {}]", corners.empty() ? "" : ", ", corner.x, corner.y);
    }
    text += fmt::format("{}- [{}]\n", indent, corners);
  }
  return text;
}

}  // namespace

Scenario scenario_from_yaml(const std::string& text, const std::string& where, const Map& map) {
  const Document file = parse_yaml(text, where);
  Scenario scenario = scenario_from(file, where, map);
  try {
    check_scenario(scenario);
  } catch (const InputError& error) {
    file.fail(error.where(), error.problem());
  }
  return scenario;
}

Scenario read_scenario(const std::string& file) {
  return scenario_from_yaml(read_file(file, largest_text), file == "-" ? "standard input" : file);
}

std::string scenario_to_yaml(const Scenario& scenario) {
  const Vehicle& v = scenario.vehicle;
  const Bounds& b = scenario.bounds;
  std::string text = fmt::format("name: {}\n", quoted(scenario.name));
  if (!scenario.description.empty()) {
    text += fmt::format("description: {}\n", quoted(scenario.description));
  }
  text += fmt::format(
      "vehicle: {{wheelbase: {}, front_overhang: {}, rear_overhang: {}, width: {}, "
      "min_turning_radius: {}{}}}\n",
      v.wheelbase, v.front_overhang, v.rear_overhang, v.width, v.min_turning_radius,
      v.track_width ? fmt::format(", track_width: {}", *v.track_width) : "");
  text += fmt::format("bounds: {{x: [{}, {}], y: [{}, {}]}}\n", b.x_min, b.x_max, b.y_min, b.y_max);
  text += fmt::format("start: {}\n", yaml_of(scenario.start));
  if (scenario.goals_are_a_row) {
    text += "goals:\n";
    for (const Goal& goal : scenario.goals) {
      text += fmt::format("  - distance: {}\n    goal: {}\n    obstacles:{}",
                          goal.distance.value_or(0.0), yaml_of(goal.pose),
                          yaml_of(goal.obstacles, "      "));
    }
  } else {
    text += fmt::format("goal: {}\n", yaml_of(scenario.goals.at(0).pose));
  }
  std::vector<Polygon> obstacles = scenario.obstacles;
  if (!scenario.goals_are_a_row) {  // a single goal's own have no key of their own
    const std::vector<Polygon>& own = scenario.goals.at(0).obstacles;
    obstacles.insert(obstacles.end(), own.begin(), own.end());
  }
  if (!scenario.kerbs.empty()) text += "kerbs:" + yaml_of(scenario.kerbs, "  ");
  if (scenario.map) {
    text += fmt::format("map: {}\n", quoted(scenario.map_file));
    if (scenario.map->unknown_is_free) text += "unknown: free\n";
  }
  return text + "obstacles:" + yaml_of(obstacles, "  ");
}

}  // namespace vandplan

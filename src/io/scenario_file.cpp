// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a scenario read and written? (docs/formats.md)

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/document.h"
#include "io/goal_file.h"
#include "io/map_file.h"
#include "io/moving_file.h"
#include "io/polygons.h"
#include "io/vehicle_file.h"
#include "io/zone_file.h"
#include "problem/checks.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace io;

Bounds bounds_from(const Document& file, const Node& node) {
  file.allow_only(node, {"x", "y"});
  const Point x = pair_from(file, file.at(node, "x"), "[smallest, largest]");
  const Point y = pair_from(file, file.at(node, "y"), "[smallest, largest]");
  return {x.x, x.y, y.x, y.y};
}

std::vector<Polygon> polygons_from(const Document& file, const Node& node) {
  std::vector<Polygon> polygons;
  for (const Node& item : file.list(node, "a list of polygons")) {
    polygons.push_back(polygon_from(file, item));
  }
  return polygons;
}

std::vector<RowGoal> row_from(const Document& file, const Node& node, const Vehicle& vehicle) {
  std::vector<RowGoal> row;
  for (const Node& item : file.list(node, "a list of goals")) {
    file.allow_only(item, {"distance", "goal", "obstacles"});
    RowGoal& goal = row.emplace_back();
    goal.distance = file.number(file.at(item, "distance"));
    const End end = goal_from(file, file.at(item, "goal"), vehicle);
    goal.goal = end.pose;
    goal.curvature = end.curvature;
    goal.hitch_angle = end.hitch_angle;
    if (const Node* const obstacles = file.find(item, "obstacles")) {
      goal.obstacles = polygons_from(file, *obstacles);
    }
  }
  if (row.empty()) file.fail(node, "is empty, expected at least one goal");
  return row;
}

/// Whether unknown ground is free.
bool unknown_from(const Document& file, const Node& node) {
  const std::string& text = file.text(node);
  if (text != "free" && text != "obstacle") {
    file.fail(node, "is \"" + text.substr(0, 40) + "\", expected free or obstacle");
  }
  return text == "free";
}

/// An option that some planner accepts, with a valid value.
Setting setting_from(const Document& file, const Node& map, std::size_t i) {
  const Node& value = map.items[i];
  Setting setting{map.keys[i].text, file.text(value)};
  const auto honouring = std::ranges::find_if(
      planners(), [&](const Planner& planner) { return honours(planner, setting.name); });
  try {
    PlanOptions options;
    const Planner& planner = honouring == planners().end() ? default_planner() : *honouring;
    set_option(options, planner, setting.name, setting.value);
    if (options.budget == BudgetOptions{}) return setting;
  } catch (const InputError& error) {
    file.fail(value, error.problem());
  }
  file.fail(value, "is an option of the budget, expected one of what is planned: --set " +
                       setting.name + "=" + setting.value);
}

/// Options that some planner accepts, without a contradiction.
std::vector<Setting> settings_from(const Document& file, const Node& node, const Vehicle& vehicle) {
  if (node.kind != Node::Kind::map) file.fail(node, "is no map, expected options by their names");
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    settings.push_back(setting_from(file, node, i));
  }
  try {
    PlanOptions options;
    set_honoured(options, default_planner(), settings);
    (void)complete(default_planner(), options, vehicle);
  } catch (const InputError& error) {
    file.fail("options." + error.where(), error.problem());
  }
  return settings;
}

GeoPlace origin_from(const Document& file, const Node& node) {
  file.allow_only(node, {"longitude", "latitude"});
  const Node& longitude = file.at(node, "longitude");
  const Node& latitude = file.at(node, "latitude");
  const GeoPlace origin{file.number(longitude), file.number(latitude)};
  const auto expect_within = [&](const Node& angle, double value, double most) {
    if (std::abs(value) <= most) return;
    file.fail(angle, fmt::format("is {}, expected -{} to {} degrees", value, most, most));
  };
  expect_within(longitude, origin.longitude, 180);
  expect_within(latitude, origin.latitude, 90);
  return origin;
}

using Map = std::optional<OccupancyGrid>;

/// Whether the map has a cell where the vehicle may be.
bool has_free_cell(const OccupancyGrid& map) {
  return map.unknown_is_free || std::ranges::find(*map.cells, Cell::free) != map.cells->end();
}

/// Reads map, bounds, obstacles and kerbs. With a map the others may be missing.
void read_ground(const Document& file, const std::string& where, const Map& known,
                 ScenarioFile& result) {
  Scenario& scenario = result.scenario;
  const Node& root = file.root();
  const Node* const map = file.find(root, "map");
  const Node* const unknown = file.find(root, "unknown");
  if (map != nullptr) {
    scenario.map_file = file.text(*map);
    scenario.map = known ? *known : map_named(file, *map, where, result.warnings);
    scenario.map->unknown_is_free = unknown != nullptr && unknown_from(file, *unknown);
    if (!has_free_cell(*scenario.map)) {
      result.warnings.push_back(file.place_of(*map) +
                                ": has no free cell; look at mode, negate, free_thresh and "
                                "occupied_thresh of the map");
    }
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
  if (const Node* const inside = file.find(root, "inside")) {
    scenario.inside = polygons_from(file, *inside);
    if (scenario.inside.empty()) file.fail(*inside, "is empty, expected one area at least");
  }
  if (const Node* const zones = file.find(root, "zones")) scenario.zones = zones_from(file, *zones);
  if (const Node* const masks = file.find(root, "masks")) {
    const double fastest = scenario.vehicle.limits.max_speed.forward;
    scenario.masks = masks_from(file, *masks, where, fastest, result.warnings);
  }
  const Node* const obstacles = file.find(root, "obstacles");
  if (map != nullptr && obstacles == nullptr) return;
  scenario.obstacles = polygons_from(file, file.at(root, "obstacles"));
}

void read_via(const Document& file, bool is_row, ScenarioFile& result) {
  const Node* const via = file.find(file.root(), "via");
  if (via == nullptr) return;
  if (is_row) file.fail(*via, "is given beside goals, expected it beside goal");
  result.scenario.via = via_from(file, *via, result.scenario.vehicle);
  for (const Node& item : via->items) warn_of_degrees(file, item, result.warnings);
}

ScenarioFile scenario_from(const Document& file, const std::string& where, const Map& map) {
  const Node& root = file.root();
  if (const Node* const image = file.find(root, "image")) {
    file.fail(*image, "belongs into a map, expected a scenario that names this file as its map");
  }
  file.allow_only(root, {"name", "description", "vehicle", "bounds", "start", "goal", "goals",
                         "via", "obstacles", "kerbs", "inside", "zones", "map", "unknown", "masks",
                         "moving", "options", "origin"});
  const Node* const goals = file.find(root, "goals");
  const Node* const goal = file.find(root, "goal");
  if (goals != nullptr && goal != nullptr) {
    file.fail(*goals, "is given beside goal, expected one of the two");
  }
  if (goals == nullptr && goal == nullptr) {
    file.fail(root, "key \"goal\" is missing, expected either goal or goals");
  }
  ScenarioFile result;
  Scenario& scenario = result.scenario;
  scenario.name = file.text(file.at(root, "name"));
  if (const Node* const description = file.find(root, "description")) {
    scenario.description = file.text(*description);
  }
  scenario.vehicle = vehicle_from(file, file.at(root, "vehicle"), where);
  const End start = end_from(file, file.at(root, "start"), scenario.vehicle);
  End end;
  if (goals != nullptr) {
    result.row = row_from(file, *goals, scenario.vehicle);
    const RowGoal& first = result.row.front();
    end = {first.goal, first.curvature, first.hitch_angle};
  } else {
    // Where a key is unknown, a goal of one pose names those of sets, too.
    const std::vector<GoalRegion> set = goal_set_from(file, *goal, scenario.vehicle);
    const bool is_set = is_goal_set(file, *goal);
    if (is_set) scenario.goal_set = set;
    if (!is_set) end = goal_from(file, *goal, scenario.vehicle);
  }
  read_via(file, goals != nullptr, result);
  scenario.start = start.pose;
  scenario.goal = end.pose;
  scenario.curvatures = {start.curvature, end.curvature};
  scenario.hitch_angles = {start.hitch_angle, end.hitch_angle};
  read_ground(file, where, map, result);
  if (const Node* const moving = file.find(root, "moving")) {
    scenario.moving = moving_from(file, *moving);
  }
  if (const Node* const options = file.find(root, "options")) {
    result.options = settings_from(file, *options, scenario.vehicle);
    for (const Node& item : options->items) result.option_places.push_back(file.place_of(item));
  }
  if (const Node* const origin = file.find(root, "origin")) {
    result.origin = origin_from(file, *origin);
  }
  warn_of_degrees(file, file.at(root, "start"), result.warnings);
  if (goal != nullptr) warn_of_degrees(file, *goal, result.warnings);
  if (goals != nullptr) {
    for (const Node& item : goals->items) {
      warn_of_degrees(file, file.at(item, "goal"), result.warnings);
    }
  }
  return result;
}

/// Key in the file for a key in the problem of goal `i`, such as "goal" or "obstacles[5]".
std::string key_in_row(const ScenarioFile& file, std::size_t i, const std::string& key) {
  const std::string goal = "goals[" + std::to_string(i) + "]";
  if (key.starts_with("goal")) return goal + "." + key;
  const std::string list = "obstacles[";
  if (!key.starts_with(list)) return key;
  const auto index = static_cast<std::size_t>(std::stoull(key.substr(list.size())));
  const std::size_t shared = file.scenario.obstacles.size();
  return index < shared ? key : goal + "." + list + std::to_string(index - shared) + "]";
}

Problem problem_of_row(const ScenarioFile& file, std::size_t i,
                       std::shared_ptr<const World>& shared) {
  const RowGoal& goal = file.row[i];
  problem::check_row_distance(goal.distance, "goals[" + std::to_string(i) + "].distance");
  try {
    if (!goal.obstacles.empty()) return make_problem(scenario_at(file, i));
    if (shared != nullptr) {
      return with_moving(make_problem(shared, file.scenario.vehicle, file.scenario.start, goal.goal,
                                      {file.scenario.curvatures.start, goal.curvature},
                                      {file.scenario.hitch_angles.start, goal.hitch_angle}),
                         file.scenario.moving);
    }
    Problem made = make_problem(scenario_at(file, i));
    shared = made.world();
    return made;
  } catch (const InputError& error) {
    throw InputError(key_in_row(file, i, error.where()), error.problem());
  }
}

/// Throws InputError naming the key that is wrong.
void check(const ScenarioFile& file) {
  check_scenario(file.scenario);
  const Pose& start = file.scenario.start;
  for (std::size_t i = 0; i < file.row.size(); ++i) {
    const std::string key = "goals[" + std::to_string(i) + "]";
    problem::check_row_distance(file.row[i].distance, key + ".distance");
    problem::check_pose(file.row[i].goal, key + ".goal");
    problem::check_curvature(file.row[i].curvature, file.scenario.vehicle, key + ".goal.curvature");
    problem::check_hitch_angle(file.row[i].hitch_angle, file.scenario.vehicle,
                               key + ".goal.hitch_angles");
    problem::check_distance(start, file.row[i].goal, key + ".goal");
    (void)problem::local_polygons(file.row[i].obstacles, problem::local_origin({start.x, start.y}),
                                  key + ".obstacles");
  }
}

std::string name_of_file(const std::string& file) { return file == "-" ? "standard input" : file; }

/// Value of an `obstacles` key, up to the end of its lines.
std::string yaml_of(const std::vector<Polygon>& polygons, const std::string& indent) {
  if (polygons.empty()) return " []\n";
  std::string text = "\n";
  for (const Polygon& polygon : polygons) {
    text += fmt::format("{}- {}\n", indent, io::yaml_of(polygon));
  }
  return text;
}

}  // namespace

Scenario scenario_at(const ScenarioFile& file, std::size_t i) {
  Scenario scenario = file.scenario;
  if (!file.is_row()) return scenario;
  if (i >= file.row.size()) {
    throw InputError("goals",
                     fmt::format("are {}, there is none of number {}", file.row.size(), i));
  }
  const RowGoal& goal = file.row[i];
  scenario.goal = goal.goal;
  scenario.curvatures.goal = goal.curvature;
  scenario.hitch_angles.goal = goal.hitch_angle;
  scenario.obstacles.insert(scenario.obstacles.end(), goal.obstacles.begin(), goal.obstacles.end());
  return scenario;
}

std::vector<Problem> make_problems(const ScenarioFile& file) {
  if (!file.is_row()) return {make_problem(file.scenario)};
  std::shared_ptr<const World> shared;
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < file.row.size(); ++i) {
    problems.push_back(problem_of_row(file, i, shared));
  }
  return problems;
}

ScenarioFile scenario_from_yaml(const std::string& text, const std::string& where, const Map& map) {
  const Document file = parse_yaml(text, where);
  ScenarioFile scenario = scenario_from(file, where, map);
  try {
    check(scenario);
  } catch (const InputError& error) {
    file.fail(error.where(), error.problem());
  }
  return scenario;
}

ScenarioFile read_scenario_file(const std::string& file) {
  return scenario_from_yaml(read_file(file, largest_text), name_of_file(file));
}

Scenario read_scenario(const std::string& file) {
  ScenarioFile scenario = read_scenario_file(file);
  if (scenario.is_row()) {
    throw InputError(name_of_file(file), "has a row of goals, expected one goal");
  }
  return std::move(scenario.scenario);
}

ScenarioProblems read_problems(const std::string& file) {
  const std::string where = name_of_file(file);
  const Document document = parse_yaml(read_file(file, largest_text), where);
  ScenarioProblems read{scenario_from(document, where, {}), {}};
  try {
    read.problems = make_problems(read.file);
  } catch (const InputError& error) {
    document.fail(error.where(), error.problem());
  }
  return read;
}

std::string to_yaml(const ScenarioFile& file) {
  const Scenario& scenario = file.scenario;
  const Bounds& b = scenario.bounds;
  std::string text = fmt::format("name: {}\n", yaml_scalar(scenario.name));
  if (!scenario.description.empty()) {
    text += fmt::format("description: {}\n", yaml_scalar(scenario.description));
  }
  text += fmt::format("vehicle: {}\n", yaml_of(scenario.vehicle));
  text += fmt::format("bounds: {{x: [{}, {}], y: [{}, {}]}}\n", b.x_min, b.x_max, b.y_min, b.y_max);
  const auto& [start_curvature, goal_curvature] = scenario.curvatures;
  const auto& [start_angle, goal_angle] = scenario.hitch_angles;
  text += fmt::format("start: {}\n", yaml_of(End{scenario.start, start_curvature, start_angle}));
  if (file.is_row()) {
    text += "goals:\n";
  } else if (!scenario.goal_set.empty()) {
    text += "goal:" + yaml_of(scenario.goal_set);
  } else {
    text += fmt::format("goal: {}\n", yaml_of(End{scenario.goal, goal_curvature, goal_angle}));
  }
  text += yaml_of(scenario.via);
  for (const RowGoal& goal : file.row) {
    text += fmt::format("  - distance: {}\n    goal: {}\n    obstacles:{}", goal.distance,
                        yaml_of(End{goal.goal, goal.curvature, goal.hitch_angle}),
                        yaml_of(goal.obstacles, "      "));
  }
  if (!scenario.kerbs.empty()) text += "kerbs:" + yaml_of(scenario.kerbs, "  ");
  if (!scenario.inside.empty()) text += "inside:" + yaml_of(scenario.inside, "  ");
  text += zones_to_yaml(scenario.zones);
  if (scenario.map) {
    text += fmt::format("map: {}\n", yaml_scalar(scenario.map_file));
    if (scenario.map->unknown_is_free) text += "unknown: free\n";
  }
  text += masks_to_yaml(scenario.masks);
  if (file.origin) {
    text += fmt::format("origin: {{longitude: {}, latitude: {}}}\n", file.origin->longitude,
                        file.origin->latitude);
  }
  text += moving_to_yaml(scenario.moving);
  if (!file.options.empty()) text += "options:\n";
  for (const Setting& setting : file.options) {
    text += fmt::format("  {}: {}\n", setting.name, setting.value);
  }
  return text + "obstacles:" + yaml_of(scenario.obstacles, "  ");
}

std::string to_yaml(const Scenario& scenario) { return to_yaml(ScenarioFile{scenario}); }

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a problem of dynobench (Ortiz-Haro, Hönig and Toussaint 2023) read?
//
// YAML: `environment` with `min`, `max` and `obstacles` (boxes along the axes: `center`, `size`),
// and `robots` with `start` and `goal`, [x, y, heading] or [x, y, heading, heading of the trailer].

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "io/document.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace io;

std::vector<double> numbers_from(const Document& file, const Node& node, std::size_t count,
                                 const char* expected) {
  std::vector<double> numbers;
  for (const Node& item : file.list(node, expected)) numbers.push_back(file.number(item));
  if (numbers.size() != count) {
    file.fail(node, fmt::format("has {} elements, expected {}", numbers.size(), expected));
  }
  return numbers;
}

/// State of a car, with the hitch angle of a trailer if any [rad].
struct ListedState {
  Pose pose;
  std::optional<double> hitch_angle;
};

ListedState listed_state(const Document& file, const Node& node) {
  const bool is_towing = node.kind == Node::Kind::list && node.items.size() == 4;
  const std::vector<double> state =
      numbers_from(file, node, is_towing ? 4 : 3, "[x, y, heading] or [x, y, heading, trailer]");
  const Pose pose{state[0], state[1], state[2]};
  if (!is_towing) return {pose, {}};
  return {pose, wrap_angle(pose.heading - state[3])};
}

/// `car1_v0` of dynobench's models: 60 degrees at the front wheels, 45 degrees between the bodies.
Vehicle car_with_trailer() {
  constexpr double pi = std::numbers::pi;
  Vehicle car{0.25, 0.0, 0.25, 0.25, 0.25 / std::sqrt(3.0)};
  car.max_hitch_angle = pi / 4;
  car.trailer = Trailer{0.5, -0.35, 0.15, 0.25};
  return car;
}

Polygon box_from(const Document& file, const Node& node) {
  file.allow_only(node, {"type", "center", "size"});
  const Node& type = file.at(node, "type");
  if (file.text(type) != "box") {
    file.fail(type,
              "is \"" + file.text(type).substr(0, 40) + "\", expected box, all that is covered");
  }
  const std::vector<double> center = numbers_from(file, file.at(node, "center"), 2, "[x, y]");
  const std::vector<double> size = numbers_from(file, file.at(node, "size"), 2, "[width, height]");
  for (const double side : size) {
    if (side > 0) continue;
    file.fail(file.at(node, "size"), fmt::format("has a side of {}, expected more than 0 m", side));
  }
  const double x = size[0] / 2;
  const double y = size[1] / 2;
  return {{center[0] - x, center[1] - y},
          {center[0] + x, center[1] - y},
          {center[0] + x, center[1] + y},
          {center[0] - x, center[1] + y}};
}

/// The only robot of a file, which must be a car.
const Node& robot_in(const Document& file) {
  const Node& robots = file.at(file.root(), "robots");
  const std::vector<Node>& list = file.list(robots, "a list with one robot");
  if (list.size() != 1) {
    file.fail(robots,
              fmt::format("has {} robots, expected one: fleets are not covered", list.size()));
  }
  file.allow_only(list[0], {"type", "start", "goal"});
  const Node& type = file.at(list[0], "type");
  if (!file.text(type).starts_with("car")) {
    file.fail(type, "is \"" + file.text(type).substr(0, 40) +
                        "\", expected a car: other robots are not covered");
  }
  return list[0];
}

/// Path in the file of the value that a scenario calls `key`.
std::string path_of(std::string_view key) {
  if (key.starts_with("obstacles")) return "environment." + std::string(key);
  if (key.starts_with("bounds")) return "environment.max";
  return "robots[0]." + std::string(key.substr(0, key.find('.')));
}

}  // namespace

Scenario read_dynobench(const std::string& name, const std::string& vehicle) {
  const Document file = parse_yaml(read_file(name, largest_text), name);
  const Node& root = file.root();
  file.allow_only(root, {"name", "environment", "robots"});
  const Node& ground = file.at(root, "environment");
  file.allow_only(ground, {"min", "max", "obstacles"});
  const Node& robot = robot_in(file);
  Scenario scenario;
  scenario.name = file.text(file.at(root, "name"));
  scenario.description = "dynobench";
  scenario.vehicle = vehicle_named(vehicle);
  const std::vector<double> low = numbers_from(file, file.at(ground, "min"), 2, "[x, y]");
  const std::vector<double> high = numbers_from(file, file.at(ground, "max"), 2, "[x, y]");
  scenario.bounds = {low[0], high[0], low[1], high[1]};
  const ListedState start = listed_state(file, file.at(robot, "start"));
  const ListedState goal = listed_state(file, file.at(robot, "goal"));
  if (start.hitch_angle.has_value() != goal.hitch_angle.has_value()) {
    file.fail(file.at(robot, "goal"), "expected as many elements as start has");
  }
  scenario.start = start.pose;
  scenario.goal = goal.pose;
  if (start.hitch_angle) {
    if (!scenario.vehicle.trailer) scenario.vehicle = car_with_trailer();
    scenario.hitch_angles = {*start.hitch_angle, *goal.hitch_angle};
  }
  for (const Node& item : file.list(file.at(ground, "obstacles"), "a list of boxes")) {
    scenario.obstacles.push_back(box_from(file, item));
  }
  try {
    check_scenario(scenario);
  } catch (const InputError& error) {
    file.fail(path_of(error.where()), error.problem());
  }
  return scenario;
}

}  // namespace vandplan

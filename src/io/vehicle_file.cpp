// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/vehicle_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "base/text.h"
#include "base/trigonometry.h"
#include "embedded_vehicles.h"
#include "vandplan/input_error.h"
#include "vandplan/scenario_file.h"

namespace vandplan::io {
namespace {

/// Full steering of the bicycle's front wheel makes the turning radius of the rear axle.
double radius_from(const Document& file, const Node& node, double wheelbase) {
  const double angle = file.number(node);
  if (!(angle > 0 && angle < std::numbers::pi / 2)) {
    file.fail(node, fmt::format("is {}, expected more than 0 and less than 1.5707 rad", angle));
  }
  const auto [sin, cos] = base::sin_cos(angle);
  return wheelbase * cos / sin;
}

double turning_radius_from(const Document& file, const Node& node, double wheelbase) {
  const Node* const radius = file.find(node, "min_turning_radius");
  const Node* const angle = file.find(node, "max_steering_angle");
  if (radius != nullptr && angle != nullptr) {
    file.fail(*angle, "is given beside min_turning_radius, expected one of the two");
  }
  if (angle != nullptr) return radius_from(file, *angle, wheelbase);
  if (radius != nullptr) return file.number(*radius);
  file.fail(node,
            "key \"min_turning_radius\" is missing, expected either it or max_steering_angle");
}

Vehicle lengths_from(const Document& file, const Node& node) {
  file.allow_only(node, {"wheelbase", "front_overhang", "rear_overhang", "width",
                         "min_turning_radius", "max_steering_angle", "track_width"});
  Vehicle vehicle{.wheelbase = file.number(file.at(node, "wheelbase")),
                  .front_overhang = file.number(file.at(node, "front_overhang")),
                  .rear_overhang = file.number(file.at(node, "rear_overhang")),
                  .width = file.number(file.at(node, "width")),
                  .min_turning_radius = 0.0};
  vehicle.min_turning_radius = turning_radius_from(file, node, vehicle.wheelbase);
  if (const Node* const track = file.find(node, "track_width")) {
    vehicle.track_width = file.number(*track);
  }
  return vehicle;
}

const EmbeddedVehicle* find_vehicle(std::string_view name) {
  const auto found = std::find_if(std::begin(embedded_vehicles), std::end(embedded_vehicles),
                                  [&](const EmbeddedVehicle& v) { return v.name == name; });
  return found == std::end(embedded_vehicles) ? nullptr : found;
}

Vehicle read(const EmbeddedVehicle& vehicle) {
  const Document file = parse_yaml(std::string(vehicle.text), std::string(vehicle.name) + ".yaml");
  return lengths_from(file, file.root());
}

std::string no_such_vehicle(std::string_view name) {
  return fmt::format("is \"{}\", expected one of {}", name.substr(0, 40),
                     base::joined(embedded_vehicles, &EmbeddedVehicle::name));
}

}  // namespace

Vehicle vehicle_from(const Document& file, const Node& node) {
  if (node.kind != Node::Kind::scalar) return lengths_from(file, node);
  const EmbeddedVehicle* const found = find_vehicle(node.text);
  if (found == nullptr) file.fail(node, no_such_vehicle(node.text) + ", or a map of lengths");
  return read(*found);
}

}  // namespace vandplan::io

namespace vandplan {

Vehicle vehicle_named(std::string_view name) {
  const io::EmbeddedVehicle* const found = io::find_vehicle(name);
  if (found == nullptr) throw InputError("vehicle", io::no_such_vehicle(name));
  return io::read(*found);
}

std::vector<std::string> vehicle_names() {
  std::vector<std::string> names;
  for (const io::EmbeddedVehicle& v : io::embedded_vehicles) names.emplace_back(v.name);
  return names;
}

}  // namespace vandplan

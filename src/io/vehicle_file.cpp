// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/vehicle_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <optional>
#include <vector>

#include "base/nearest_word.h"
#include "base/trigonometry.h"
#include "embedded_vehicles.h"
#include "io/polygons.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

double radius_from(const Document& file, const Node& node, double wheelbase) {
  try {
    return turning_radius(wheelbase, file.number(node));
  } catch (const InputError& error) {
    file.fail(error.where() == "wheelbase" ? file.at(node, "wheelbase") : node, error.problem());
  }
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

/// Reads lengths and outline of the body of a vehicle or trailer. Without an overhang its front is
/// `wheelbase` ahead of the axle. With an outline the lengths may be missing; they are then those
/// of the box around it.
void read_body(const Document& file, const Node& node, auto& body) {
  body.wheelbase = file.number(file.at(node, "wheelbase"));
  const Node* const outline = file.find(node, "outline");
  if (outline != nullptr) {
    body.outline = polygon_from(file, *outline);
    if (body.outline.empty()) file.fail(*outline, "has 0 corners, expected at least 3");
    const Footprint box = footprint(body);
    body.front_overhang = box.front - body.wheelbase;
    body.rear_overhang = box.rear;
    body.width = 2 * box.half_width;
  }
  const auto read = [&](std::string_view key, double& length) {
    if (outline == nullptr || file.find(node, key) != nullptr) {
      length = file.number(file.at(node, key));
    }
  };
  read("front_overhang", body.front_overhang);
  read("rear_overhang", body.rear_overhang);
  read("width", body.width);
}

Trailer trailer_from(const Document& file, const Node& node) {
  file.allow_only(node, {"wheelbase", "front_overhang", "rear_overhang", "width", "outline"});
  Trailer trailer;
  read_body(file, node, trailer);
  return trailer;
}

/// Reads the trailer and its hitch.
void read_trailer(const Document& file, const Node& node, Vehicle& vehicle) {
  const Node* const trailers = file.find(node, "trailers");
  if (trailers == nullptr) {
    for (const std::string_view key : {"hitch", "max_hitch_angle"}) {
      if (const Node* const found = file.find(node, key)) {
        file.fail(*found, "is given without a trailer, expected trailers beside it");
      }
    }
    return;
  }
  const std::vector<Node>& items = file.list(*trailers, "a list with one trailer");
  if (items.size() != 1) {
    file.fail(*trailers,
              fmt::format("has {} trailers, expected one: more are not covered", items.size()));
  }
  vehicle.trailer = trailer_from(file, items[0]);
  if (const Node* const hitch = file.find(node, "hitch")) vehicle.hitch = file.number(*hitch);
  if (const Node* const angle = file.find(node, "max_hitch_angle")) {
    vehicle.max_hitch_angle = file.number(*angle);
  }
}

Vehicle lengths_from(const Document& file, const Node& node) {
  file.allow_only(
      node, {"wheelbase", "front_overhang", "rear_overhang", "width", "min_turning_radius",
             "max_steering_angle", "track_width", "max_steering_rate", "max_curvature_rate",
             "max_speed", "max_acceleration", "max_braking", "max_lateral_acceleration", "max_jerk",
             "hitch", "max_hitch_angle", "trailers", "outline"});
  Vehicle vehicle;
  read_body(file, node, vehicle);
  vehicle.min_turning_radius = turning_radius_from(file, node, vehicle.wheelbase);
  if (const Node* const track = file.find(node, "track_width")) {
    vehicle.track_width = file.number(*track);
  }
  read_trailer(file, node, vehicle);
  return vehicle;
}

/// Reads a limit if the key is there.
void read_limit(const Document& file, const Node& node, std::string_view key, double& limit) {
  if (const Node* const found = file.find(node, key)) limit = file.number(*found);
}

/// Reads a limit that may be `none`.
void read_limit(const Document& file, const Node& node, std::string_view key,
                std::optional<double>& limit) {
  const Node* const found = file.find(node, key);
  if (found == nullptr) return;
  const bool is_none = found->kind == Node::Kind::scalar && found->text == "none";
  limit = is_none ? std::nullopt : std::optional(file.number(*found));
}

/// Reads the limits that are given.
void read_limits(const Document& file, const Node& node, DrivingLimits& limits) {
  read_limit(file, node, "max_steering_rate", limits.max_steering_rate);
  read_limit(file, node, "max_curvature_rate", limits.max_curvature_rate);
  if (const Node* const speed = file.find(node, "max_speed")) {
    file.allow_only(*speed, {"forward", "reverse"});
    read_limit(file, *speed, "forward", limits.max_speed.forward);
    read_limit(file, *speed, "reverse", limits.max_speed.reverse);
  }
  read_limit(file, node, "max_acceleration", limits.max_acceleration);
  read_limit(file, node, "max_braking", limits.max_braking);
  read_limit(file, node, "max_lateral_acceleration", limits.max_lateral_acceleration);
  read_limit(file, node, "max_jerk", limits.max_jerk);
}

const EmbeddedVehicle* find_vehicle(std::string_view name) {
  const auto found = std::find_if(std::begin(embedded_vehicles), std::end(embedded_vehicles),
                                  [&](const EmbeddedVehicle& v) { return v.name == name; });
  return found == std::end(embedded_vehicles) ? nullptr : found;
}

Vehicle read(const EmbeddedVehicle& vehicle) {
  const Document file = parse_yaml(std::string(vehicle.text), std::string(vehicle.name) + ".yaml");
  Vehicle read = lengths_from(file, file.root());
  read_limits(file, file.root(), read.limits);
  return read;
}

/// Limits that a vehicle with these lengths has if a file does not state them.
DrivingLimits usual_limits(const Vehicle& vehicle) {
  static const auto catalogue = [] {
    std::vector<Vehicle> vehicles;
    for (const EmbeddedVehicle& known : embedded_vehicles) vehicles.push_back(read(known));
    return vehicles;
  }();
  for (const Vehicle& known : catalogue) {
    if (same_lengths(known, vehicle)) return known.limits;
  }
  return {};
}

/// Appends ", key: value" if the value is not the usual one.
void add_limit(std::string& text, std::string_view key, const std::optional<double>& value,
               const std::optional<double>& usual) {
  if (value == usual) return;
  text += fmt::format(", {}: {}", key, value ? fmt::format("{}", *value) : "none");
}

/// Limits that differ from `usual_limits`, as YAML.
std::string yaml_of_limits(const Vehicle& vehicle) {
  const DrivingLimits& limits = vehicle.limits;
  const DrivingLimits usual = usual_limits(vehicle);
  std::string text;
  add_limit(text, "max_steering_rate", limits.max_steering_rate, usual.max_steering_rate);
  add_limit(text, "max_curvature_rate", limits.max_curvature_rate, usual.max_curvature_rate);
  if (limits.max_speed != usual.max_speed) {
    text += fmt::format(", max_speed: {{forward: {}, reverse: {}}}", limits.max_speed.forward,
                        limits.max_speed.reverse);
  }
  add_limit(text, "max_acceleration", limits.max_acceleration, usual.max_acceleration);
  add_limit(text, "max_braking", limits.max_braking, usual.max_braking);
  add_limit(text, "max_lateral_acceleration", limits.max_lateral_acceleration,
            usual.max_lateral_acceleration);
  add_limit(text, "max_jerk", limits.max_jerk, usual.max_jerk);
  return text;
}

/// Appends an outline as ", outline: [[x, y], ...]"; empty if there is none.
std::string yaml_of_outline(const Polygon& outline) {
  return outline.empty() ? "" : ", outline: " + yaml_of(outline);
}

/// Hitch and trailer as YAML; empty without a trailer.
std::string yaml_of_trailer(const Vehicle& vehicle) {
  if (!vehicle.trailer) return "";
  const Trailer& trailer = *vehicle.trailer;
  return fmt::format(
      ", hitch: {}, max_hitch_angle: {}, trailers: [{{wheelbase: {}, front_overhang: {}, "
      "rear_overhang: {}, width: {}{}}}]",
      vehicle.hitch, vehicle.max_hitch_angle, trailer.wheelbase, trailer.front_overhang,
      trailer.rear_overhang, trailer.width, yaml_of_outline(trailer.outline));
}

std::string no_such_vehicle(std::string_view name) {
  return fmt::format("is \"{}\", {}", name.substr(0, 40),
                     base::expected_one_of(name, embedded_vehicles, &EmbeddedVehicle::name));
}

}  // namespace

Vehicle vehicle_from(const Document& file, const Node& node, const std::string& where) {
  if (node.kind != Node::Kind::scalar) {
    Vehicle vehicle = lengths_from(file, node);
    vehicle.limits = usual_limits(vehicle);
    read_limits(file, node, vehicle.limits);
    return vehicle;
  }
  if (node.text.ends_with(".yaml") || node.text.ends_with(".yml")) {
    return read_vehicle((std::filesystem::path(where).parent_path() / node.text).string());
  }
  const EmbeddedVehicle* const found = find_vehicle(node.text);
  if (found == nullptr) {
    file.fail(node, no_such_vehicle(node.text) + ", a map of lengths, or a file (.yaml)");
  }
  return read(*found);
}

std::string yaml_of(const Vehicle& vehicle) {
  const std::string track =
      vehicle.track_width ? fmt::format(", track_width: {}", *vehicle.track_width) : "";
  return fmt::format(
      "{{wheelbase: {}, front_overhang: {}, rear_overhang: {}, width: {}, min_turning_radius: "
      "{}{}{}{}{}}}",
      vehicle.wheelbase, vehicle.front_overhang, vehicle.rear_overhang, vehicle.width,
      vehicle.min_turning_radius, track, yaml_of_outline(vehicle.outline), yaml_of_limits(vehicle),
      yaml_of_trailer(vehicle));
}

}  // namespace vandplan::io

namespace vandplan {

Vehicle vehicle_named(std::string_view name) {
  const io::EmbeddedVehicle* const found = io::find_vehicle(name);
  if (found == nullptr) throw InputError("vehicle", io::no_such_vehicle(name));
  return io::read(*found);
}

Vehicle read_vehicle(const std::string& name) {
  const io::Document file =
      io::parse_yaml(read_file(name, io::largest_text), name == "-" ? "standard input" : name);
  if (file.root().kind != io::Node::Kind::map) {
    file.fail(file.root(), "is no vehicle, expected a map of lengths");
  }
  Vehicle vehicle = io::vehicle_from(file, file.root(), name);
  try {
    check_vehicle(vehicle);
  } catch (const InputError& error) {
    const std::string& key = error.where();
    file.fail(std::string_view(key).substr(key.find('.') + 1), error.problem());
  }
  return vehicle;
}

std::string to_yaml(const Vehicle& vehicle) { return io::yaml_of(vehicle) + "\n"; }

std::vector<std::string> vehicle_names() {
  std::vector<std::string> names;
  for (const io::EmbeddedVehicle& v : io::embedded_vehicles) names.emplace_back(v.name);
  return names;
}

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does the footprint of a Nav2 robot become a vehicle?
//
// Nav2 writes it as a text, footprint: "[[0.3, 0.2], [0.3, -0.2], ...]", somewhere in a tree of
// parameters.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/document.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace io;

/// Finds the values of all keys named footprint. Empty values are skipped: they mean no footprint.
void find_footprints(const Node& node, std::vector<const Node*>& found) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Node& item = node.items[i];
    const bool is_one = node.kind == Node::Kind::map && node.keys[i].text == "footprint";
    const bool is_empty = item.kind == Node::Kind::scalar ? item.text.empty() || item.text == "[]"
                                                          : item.items.empty();
    if (is_one && is_empty) continue;
    if (is_one && item.kind != Node::Kind::map) {
      found.push_back(&item);
    } else {
      find_footprints(item, found);
    }
  }
}

Polygon corners_in(const Document& file, const Node& node) {
  Polygon corners;
  for (const Node& item : file.list(node, "a footprint [[x, y], ...]")) {
    const std::vector<Node>& corner = file.list(item, "a corner [x, y]");
    if (corner.size() != 2) {
      file.fail(item, fmt::format("has {} elements, expected a corner [x, y]", corner.size()));
    }
    corners.push_back({file.number(corner[0]), file.number(corner[1])});
  }
  if (corners.size() < 3) {
    file.fail(node, fmt::format("has {} corners, expected at least 3", corners.size()));
  }
  return corners;
}

/// Corners of a list, or of a list in quotes.
Polygon footprint_from(const Document& file, const Node& node) {
  if (node.kind != Node::Kind::scalar) return corners_in(file, node);
  try {
    const Document text = parse_yaml(file.text(node), "footprint");
    return corners_in(text, text.root());
  } catch (const InputError& error) {
    file.fail(node, error.problem());
  }
}

/// The only footprint of a file.
Polygon footprint_in(const Document& file) {
  const Node& root = file.root();
  if (root.kind != Node::Kind::map) return footprint_from(file, root);
  std::vector<const Node*> found;
  find_footprints(root, found);
  if (found.empty()) file.fail(root, "has no footprint, expected a key of that name with corners");
  Polygon first = footprint_from(file, *found.front());
  for (const Node* const other : found) {
    if (footprint_from(file, *other) == first) continue;
    file.fail(*other, fmt::format("is another footprint than that on line {}, expected one; put it "
                                  "into a file of its own",
                                  found.front()->line));
  }
  return first;
}

double area_of(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return std::abs(twice) / 2;
}

/// Length of a vehicle, rounded to remove the noise of a subtraction [m].
double length_of(double metres) { return std::round(metres * 1e9) / 1e9; }

}  // namespace

FootprintVehicle read_footprint(const FootprintFile& footprint) {
  const std::string name = footprint.file == "-" ? "standard input" : footprint.file;
  const Document file = parse_yaml(read_file(footprint.file, largest_text), name);
  const Polygon corners = footprint_in(file);
  const Bounds box = bounding_box(corners);
  FootprintVehicle result;
  Vehicle& vehicle = result.vehicle;
  vehicle.wheelbase = footprint.wheelbase;
  vehicle.min_turning_radius = footprint.min_turning_radius;
  vehicle.rear_overhang = length_of(footprint.rear_axle - box.x_min);
  vehicle.front_overhang = length_of(box.x_max - footprint.rear_axle - footprint.wheelbase);
  vehicle.width = length_of(2 * std::max(std::abs(box.y_min), std::abs(box.y_max)));
  if (vehicle.rear_overhang < 0 || vehicle.front_overhang < 0) {
    throw InputError(name,
                     fmt::format("has a footprint with x from {} to {} m, but axles at {} and "
                                 "{} m, expected them within it",
                                 box.x_min, box.x_max, footprint.rear_axle,
                                 footprint.rear_axle + footprint.wheelbase));
  }
  result.footprint_area = area_of(corners);
  const double added_area = (box.x_max - box.x_min) * vehicle.width - result.footprint_area;
  const bool is_rectangle = added_area <= 1e-9 * result.footprint_area;
  if (!footprint.rectangle && !is_rectangle && is_convex(corners)) {
    for (const auto& [x, y] : corners) {
      vehicle.outline.push_back({length_of(x - footprint.rear_axle), y});
    }
  } else {
    result.added_area = added_area;
    result.added_width = length_of(vehicle.width - (box.y_max - box.y_min));
  }
  try {
    check_vehicle(vehicle);
  } catch (const InputError& error) {
    throw InputError(name, error.what());
  }
  return result;
}

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/geojson_feature.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

namespace vandplan::io {
namespace {

constexpr double largest_width = 1000.0;  // Largest width of lines and points [m].

/// OpenStreetMap tags of features on the ground that block nobody.
constexpr std::string_view tags_of_ground[] = {"highway", "area:highway", "landuse",
                                               "amenity", "leisure",      "boundary",
                                               "place",   "parking",      "surface"};

struct NamedKind {
  std::string_view name;
  FeatureKind kind;
};
constexpr NamedKind feature_kinds[] = {
    {"obstacle", FeatureKind::obstacle}, {"kerb", FeatureKind::kerb},
    {"bounds", FeatureKind::bounds},     {"zone", FeatureKind::zone},
    {"one-way", FeatureKind::one_way},   {"speed", FeatureKind::speed},
    {"start", FeatureKind::start},       {"goal", FeatureKind::goal},
    {"ground", FeatureKind::ground}};

/// A number of metres. OpenStreetMap writes it in quotes, sometimes with a unit.
double metres_from(const Document& file, const Node& node) {
  if (!node.is_quoted) return file.number(node);
  std::string_view text = file.text(node);
  if (text.ends_with(" m")) text.remove_suffix(2);
  double value = 0.0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error == std::errc() && end == last && std::isfinite(value)) return value;
  file.fail(node, "is \"" + file.text(node).substr(0, 40) + "\", expected a number of metres");
}

std::optional<double> width_of(const Document& file, const Node& feature) {
  const Node* const node = property(file, feature, "width");
  if (node == nullptr) return {};
  const double width = metres_from(file, *node);
  if (width >= 0.001 && width <= largest_width) return width;
  file.fail(*node, fmt::format("is {} m, expected 0.001 to {} m", width, largest_width));
}

bool is_area(const Feature& feature) { return feature.type.ends_with("Polygon"); }
bool is_line(const Feature& feature) { return feature.type.ends_with("LineString"); }
bool is_point(const Feature& feature) { return feature.type.ends_with("Point"); }

void make_ground(Feature& feature, std::string_view why) {
  feature.kind = FeatureKind::ground;
  feature.ground = why;
}

FeatureKind named_kind(const Document& file, const Node& node) {
  const std::string& name = file.text(node);
  const auto found = std::ranges::find(feature_kinds, name, &NamedKind::name);
  if (found != std::end(feature_kinds)) return found->kind;
  file.fail(node,
            "is \"" + name.substr(0, 40) +
                "\", expected obstacle, kerb, bounds, zone, one-way, speed, start, goal or ground");
}

/// Sorts a barrier of OpenStreetMap. Most barriers on points, such as gates, can be passed.
void sort_barrier(Feature& feature, const std::string& barrier) {
  const bool stands_alone = barrier == "bollard" || barrier == "block";
  if (barrier == "no" || (is_point(feature) && !stands_alone)) {
    make_ground(feature, "barrier=" + barrier.substr(0, 40));
  } else {
    feature.kind = barrier == "kerb" ? FeatureKind::kerb : FeatureKind::obstacle;
  }
}

/// Finds the kind of a feature: from its property `kind`, otherwise its tags, otherwise its shape.
void sort(const Document& file, Feature& feature) {
  const Node& node = *feature.node;
  if (feature.geometry == nullptr) return make_ground(feature, "without geometry");
  if (const Node* const kind = property(file, node, "kind")) {
    feature.kind = named_kind(file, *kind);
    feature.ground = "kind=ground";
    return;
  }
  if (const Node* const barrier = property(file, node, "barrier")) {
    return sort_barrier(feature, file.text(*barrier));
  }
  const Node* const building = property(file, node, "building");
  if (building != nullptr && file.text(*building) != "no") {
    if (is_point(feature)) return make_ground(feature, "building on a point");
    feature.kind = FeatureKind::obstacle;
    return;
  }
  for (const std::string_view tag : tags_of_ground) {
    if (property(file, node, tag) != nullptr) return make_ground(feature, tag);
  }
  if (is_point(feature)) return make_ground(feature, "point without kind");
  if (is_line(feature) && !feature.width) return make_ground(feature, "line without kind or width");
  feature.kind = FeatureKind::obstacle;
}

void read_heading(const Document& file, Feature& feature) {
  const Node* const radians = property(file, *feature.node, "heading");
  const Node* const degrees = property(file, *feature.node, "heading_deg");
  if (radians != nullptr && degrees != nullptr) {
    file.fail(*degrees, "is given beside heading, expected one of the two");
  }
  if (radians == nullptr && degrees == nullptr) {
    if (feature.kind == FeatureKind::one_way) return;
    file.fail(*feature.node, "key \"heading\" is missing, expected either it or heading_deg");
  }
  feature.heading =
      radians != nullptr ? file.number(*radians) : file.number(*degrees) / 180.0 * std::numbers::pi;
  feature.heading_node = radians;
}

Feature feature_from(const Document& file, const Node& node) {
  const Node& type = file.at(node, "type");
  if (file.text(type) != "Feature") {
    file.fail(type, "is \"" + file.text(type).substr(0, 40) + "\", expected Feature");
  }
  Feature feature{.node = &node};
  const Node& geometry = file.at(node, "geometry");
  if (geometry.kind != Node::Kind::nothing) {
    feature.geometry = &geometry;
    feature.type = file.text(file.at(geometry, "type"));
    if (!is_point(feature)) feature.width = is_area(feature) ? std::nullopt : width_of(file, node);
  }
  sort(file, feature);
  const bool has_thickness =
      feature.kind == FeatureKind::obstacle || feature.kind == FeatureKind::kerb;
  if (is_point(feature) && has_thickness) feature.width = width_of(file, node);
  if (feature.kind == FeatureKind::one_way) read_heading(file, feature);
  if (feature.kind != FeatureKind::start && feature.kind != FeatureKind::goal) return feature;
  if (feature.type != "Point") {
    file.fail(geometry,
              "is a " + feature.type.substr(0, 40) + ", expected a Point for start and goal");
  }
  read_heading(file, feature);
  return feature;
}

/// Number of a coordinate system in the EPSG register; 0 for other systems.
int epsg_number(std::string_view name) {
  const std::size_t at = name.rfind(':');
  if (name.find("EPSG") == std::string_view::npos || at == std::string_view::npos) return 0;
  const std::string_view digits = name.substr(at + 1);
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return error == std::errc() && end == digits.data() + digits.size() ? number : 0;
}

/// Whether coordinates are eastings and northings in metres: UTM on WGS84 (north, south) and on
/// ETRS89, SWEREF 99 TM and its zones.
bool is_metric(int epsg) {
  const auto within = [epsg](int first, int last) { return first <= epsg && epsg <= last; };
  return within(32601, 32660) || within(32701, 32760) || within(25828, 25838) || within(3006, 3018);
}

}  // namespace

const Node* property(const Document& file, const Node& feature, std::string_view name) {
  const Node* const properties = file.find(feature, "properties");
  if (properties == nullptr || properties->kind == Node::Kind::nothing) return nullptr;
  const Node* const found = file.find(*properties, name);
  if (found == nullptr || found->kind == Node::Kind::nothing) return nullptr;
  return found->kind == Node::Kind::scalar && found->text.empty() ? nullptr : found;
}

std::vector<Feature> features_from(const Document& file) {
  const Node& type = file.at(file.root(), "type");
  if (file.text(type) != "FeatureCollection") {
    file.fail(type, "is \"" + file.text(type).substr(0, 40) + "\", expected FeatureCollection");
  }
  std::vector<Feature> features;
  for (const Node& node : file.list(file.at(file.root(), "features"), "a list of features")) {
    features.push_back(feature_from(file, node));
  }
  return features;
}

bool has_longitudes(const Document& file) {
  const Node* const crs = file.find(file.root(), "crs");
  if (crs == nullptr) return true;
  const Node& name = file.at(file.at(*crs, "properties"), "name");
  const std::string& text = file.text(name);
  const int epsg = epsg_number(text);
  if (text.ends_with(":CRS84") || epsg == 4326 || epsg == 4258) return true;
  if (is_metric(epsg)) return false;
  file.fail(name, "is \"" + text.substr(0, 60) +
                      "\", expected longitude and latitude (CRS84, EPSG:4326) or a known plane in "
                      "metres (UTM, SWEREF 99); --metres takes the coordinates as metres");
}

}  // namespace vandplan::io

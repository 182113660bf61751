// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does a site in GeoJSON (RFC 7946) become a scenario?
#include "vandplan/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "io/document.h"
#include "io/geojson_feature.h"
#include "io/geojson_zone.h"
#include "io/local_plane.h"
#include "io/site_shapes.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace io;

constexpr double room = 20.0;       // Distance between the contents of the file and the bounds [m].
constexpr double hairline = 0.001;  // Width of the walls along the rings of an area with holes [m].

/// Start or goal, with x and y in the units of the file.
struct SiteEnd {
  Pose pose;
  const Node* node = nullptr;  // Null if it is not in the file.
};

/// Position [x, y], perhaps with a height, in the units of the file.
Point raw_position(const Document& file, const Node& node) {
  const std::vector<Node>& items = file.list(node, "a position [x, y]");
  if (items.size() < 2) {
    file.fail(node, fmt::format("has {} elements, expected a position [x, y]", items.size()));
  }
  return {file.number(items[0]), file.number(items[1])};
}

/// Converts positions of a file to the plane of the scenario.
class Plane {
 public:
  Plane(const Document& file, bool has_longitudes, const Point& start) : file_(file) {
    if (!has_longitudes) return;
    const auto rounded = [](double degrees) { return std::round(degrees * 1e5) / 1e5; };
    origin_ = GeoPlace{rounded(start.x), rounded(start.y)};
    to_plane_ = plane_around(*origin_);
  }

  [[nodiscard]] const std::optional<GeoPlace>& origin() const { return origin_; }
  [[nodiscard]] Point point_at(const Node& node) const {
    return in_plane(raw_position(file_, node), &node);
  }
  [[nodiscard]] Pose pose_of(const SiteEnd& end) const {
    const Point point = in_plane({end.pose.x, end.pose.y}, end.node);
    return {point.x, point.y, end.pose.heading};
  }

 private:
  [[nodiscard]] Point in_plane(const Point& raw, const Node* node) const {
    if (!origin_) return raw;
    if (!(std::abs(raw.x) <= 360 && std::abs(raw.y) <= 90)) {
      fail(node, fmt::format("is [{}, {}], expected longitude and latitude in degrees, at most 90 "
                             "of latitude; --metres takes the coordinates as metres",
                             raw.x, raw.y));
    }
    const auto point = to_plane_({raw.x, raw.y});
    if (point) return *point;
    fail(node, fmt::format("is [{}, {}], expected a place within {} km of the start", raw.x, raw.y,
                           largest_plane / 1000));
  }
  [[noreturn]] void fail(const Node* node, const std::string& problem) const {
    if (node == nullptr) throw InputError("start or goal", problem);
    file_.fail(*node, problem);
  }

  const Document& file_;
  std::optional<GeoPlace> origin_;
  ToPlane to_plane_;
};

/// Polygons, and the feature that each comes from.
struct Shapes {
  std::vector<Polygon> polygons;
  std::vector<const Node*> sources;
};

/// Scenario under construction.
struct Draft {
  const Document& file;
  const GeoJsonSite& site;
  const Plane& plane;
  Pose start;
  Pose goal;
  Shapes obstacles = {};
  Shapes kerbs = {};
  std::vector<Zone> zones = {};
  std::vector<const Node*> sources_of_zones = {};
  const Node* bounds = nullptr;  // Feature of the bounds.
  Polygon bounds_ring = {};      // Outer ring of the bounds.
  std::map<std::string, int> left_out = {};
  int filled_holes = 0;
  std::vector<std::string> notes = {};
  std::vector<std::string> warnings = {};
};

std::vector<Point> line_from(const Draft& draft, const Node& node) {
  std::vector<Point> points;
  for (const Node& item : draft.file.list(node, "a list of positions")) {
    points.push_back(draft.plane.point_at(item));
  }
  return points;
}

/// Corners of a closed ring, without the last one, which repeats the first.
Polygon ring_from(const Draft& draft, const Node& node) {
  Polygon ring = line_from(draft, node);
  if (ring.size() < 4) {
    draft.file.fail(node,
                    fmt::format("has {} positions, expected a ring of at least 4", ring.size()));
  }
  if (!(ring.front() == ring.back())) {
    draft.file.fail(node, "ends elsewhere than it begins, expected a closed ring");
  }
  ring.pop_back();
  return ring;
}

void add(Shapes& shapes, const Node& source, std::vector<Polygon> polygons) {
  for (Polygon& polygon : polygons) {
    shapes.polygons.push_back(std::move(polygon));
    shapes.sources.push_back(&source);
  }
}

/// Adds a warning if start or goal lies in an area that becomes an obstacle.
void warn_of_ends_within(Draft& draft, const Node& source, const Polygon& ring) {
  const bool has_start = contains(ring, {draft.start.x, draft.start.y});
  const bool has_goal = contains(ring, {draft.goal.x, draft.goal.y});
  if (!has_start && !has_goal) return;
  const char* const ends = !has_goal ? "the start" : !has_start ? "the goal" : "start and goal";
  draft.warnings.push_back(
      fmt::format("{}: is an obstacle with {} in it; a boundary is a LineString along its ring, or "
                  "has kind \"bounds\"",
                  draft.file.place_of(source), ends));
}

/// Adds an area with holes. If neither start nor goal lies in a hole, the holes are filled.
/// Otherwise the rings become walls.
void add_area(Draft& draft, Shapes& shapes, const Node& source, const Node& node) {
  std::vector<Polygon> rings;
  for (const Node& item : draft.file.list(node, "a list of rings")) {
    rings.push_back(ring_from(draft, item));
  }
  if (rings.empty()) draft.file.fail(node, "is empty, expected a ring");
  const bool keeps_holes = std::any_of(rings.begin() + 1, rings.end(), [&](const Polygon& hole) {
    return contains(hole, {draft.start.x, draft.start.y}) ||
           contains(hole, {draft.goal.x, draft.goal.y});
  });
  if (!keeps_holes) {
    warn_of_ends_within(draft, source, rings.front());
    draft.filled_holes += static_cast<int>(rings.size()) - 1;
    return add(shapes, source, {std::move(rings.front())});
  }
  for (Polygon& ring : rings) {
    ring.push_back(ring.front());
    add(shapes, source, walls_along(ring, hairline));
  }
  draft.notes.push_back(draft.file.place_of(source) +
                        ": start or goal lies in a hole, so its rings are walls");
}

/// Calls `use` with the coordinates of each part of a geometry.
template <typename Use>
void for_each_part(const Document& file, const Feature& feature, Use use) {
  const Node& coordinates = file.at(*feature.geometry, "coordinates");
  if (!feature.type.starts_with("Multi")) return use(coordinates);
  for (const Node& part : file.list(coordinates, "a list of parts")) use(part);
}

void add_shapes(Draft& draft, const Feature& feature) {
  const Document& file = draft.file;
  Shapes& shapes = feature.kind == FeatureKind::kerb ? draft.kerbs : draft.obstacles;
  const double width = feature.width.value_or(draft.site.default_width);
  const std::string_view type = feature.type;
  const std::string_view part_type = type.starts_with("Multi") ? type.substr(5) : type;
  for_each_part(file, feature, [&](const Node& part) {
    if (part_type == "Polygon") {
      add_area(draft, shapes, *feature.node, part);
    } else if (part_type == "LineString") {
      std::vector<Polygon> walls = walls_along(line_from(draft, part), width);
      if (walls.empty()) file.fail(part, "has no length, expected a line of two places");
      add(shapes, *feature.node, std::move(walls));
    } else if (part_type == "Point") {
      add(shapes, *feature.node, {square_around(draft.plane.point_at(part), width)});
    } else {
      file.fail(file.at(*feature.geometry, "type"),
                "is \"" + feature.type.substr(0, 40) +
                    "\", expected Polygon, LineString, Point, or a Multi of these");
    }
  });
}

void add_zones(Draft& draft, const Feature& feature) {
  const Document& file = draft.file;
  const Zone rules = rules_of(file, feature);
  for_each_part(file, feature, [&](const Node& part) {
    if (feature.type.ends_with("Polygon")) {
      const std::vector<Node>& rings = file.list(part, "a list of rings");
      if (rings.empty()) file.fail(part, "is empty, expected a ring");
      draft.filled_holes += static_cast<int>(rings.size()) - 1;
      draft.zones.push_back(rules);
      draft.zones.back().area = ring_from(draft, rings.front());
    } else if (feature.type.ends_with("LineString") && feature.kind == FeatureKind::one_way) {
      const double width = feature.width.value_or(draft.site.default_width);
      for (Zone& zone : street_along(line_from(draft, part), width, rules)) {
        draft.zones.push_back(std::move(zone));
      }
    } else {
      file.fail(*feature.geometry, "is a " + feature.type.substr(0, 40) +
                                       ", expected a Polygon, or a LineString that is one-way");
    }
    draft.sources_of_zones.resize(draft.zones.size(), feature.node);
  });
}

void read_bounds(Draft& draft, const Feature& feature) {
  if (draft.bounds != nullptr) {
    draft.file.fail(*feature.node, "are bounds once more, expected one feature of that kind");
  }
  if (feature.type != "Polygon") {
    draft.file.fail(*feature.geometry,
                    "is a " + feature.type.substr(0, 40) + ", expected a Polygon for bounds");
  }
  draft.bounds = feature.node;
  const Node& rings = draft.file.at(*feature.geometry, "coordinates");
  for (const Node& ring : draft.file.list(rings, "a list of rings")) {
    const Polygon corners = ring_from(draft, ring);
    if (draft.bounds_ring.empty()) draft.bounds_ring = corners;
  }
  if (draft.bounds_ring.empty()) draft.file.fail(rings, "is empty, expected a ring");
}

void add_feature(Draft& draft, const Feature& feature) {
  switch (feature.kind) {
    case FeatureKind::obstacle:
    case FeatureKind::kerb:
      return add_shapes(draft, feature);
    case FeatureKind::bounds:
      return read_bounds(draft, feature);
    case FeatureKind::zone:
    case FeatureKind::one_way:
    case FeatureKind::speed:
      return add_zones(draft, feature);
    case FeatureKind::ground:
      ++draft.left_out[feature.ground];
      return;
    case FeatureKind::start:
    case FeatureKind::goal:
      return;
  }
}

/// Start or goal: the value given by the caller, otherwise the only feature of that kind.
SiteEnd end_from(const Document& file, const std::vector<Feature>& features, FeatureKind kind,
                 const std::optional<Pose>& given) {
  const std::string name = kind == FeatureKind::start ? "start" : "goal";
  const Feature* found = nullptr;
  for (const Feature& feature : features) {
    if (feature.kind != kind) continue;
    if (found != nullptr) {
      file.fail(*feature.node, "is a " + name + " once more, expected one");
    }
    found = &feature;
  }
  if (given) return {*given, nullptr};
  if (found == nullptr) {
    file.fail(file.root(), "has no " + name + ", expected a Point with kind \"" + name +
                               "\" and a heading, or --" + name + " X,Y,HEADING");
  }
  const Node& position = file.at(*found->geometry, "coordinates");
  const Point point = raw_position(file, position);
  return {{point.x, point.y, *found->heading}, &position};
}

/// Bounding box of the ring of the bounds, or of everything plus `room`; rounded to millimetres.
Bounds bounds_of(const Draft& draft) {
  std::vector<Point> points = draft.bounds_ring;
  const double around = draft.bounds != nullptr ? 0.0 : room;
  if (draft.bounds == nullptr) {
    points = {{draft.start.x, draft.start.y}, {draft.goal.x, draft.goal.y}};
    for (const auto* polygons : {&draft.obstacles.polygons, &draft.kerbs.polygons}) {
      for (const Polygon& polygon : *polygons) {
        points.insert(points.end(), polygon.begin(), polygon.end());
      }
    }
    for (const Zone& zone : draft.zones) {
      points.insert(points.end(), zone.area.begin(), zone.area.end());
    }
  }
  const Bounds box = bounding_box(points);
  const auto rounded = [](double metres) { return std::round(metres * 1000) / 1000; };
  return {rounded(box.x_min - around), rounded(box.x_max + around), rounded(box.y_min - around),
          rounded(box.y_max + around)};
}

/// Rethrows an error of `check_scenario`, naming the feature that caused it.
[[noreturn]] void blame(const Draft& draft, const Node* start, const Node* goal,
                        const InputError& error) {
  const std::string& key = error.where();
  const auto source_in = [&](const std::vector<const Node*>& sources) -> const Node* {
    const std::size_t at = key.find('[');
    if (at == std::string::npos) return nullptr;
    const auto index = static_cast<std::size_t>(std::stoull(key.substr(at + 1)));
    return index < sources.size() ? sources[index] : nullptr;
  };
  const Node* node = nullptr;
  if (key.starts_with("obstacles")) node = source_in(draft.obstacles.sources);
  if (key.starts_with("kerbs")) node = source_in(draft.kerbs.sources);
  if (key.starts_with("zones")) node = source_in(draft.sources_of_zones);
  if (key.starts_with("bounds") || key.starts_with("inside")) node = draft.bounds;
  if (key.starts_with("start")) node = start;
  if (key.starts_with("goal")) node = goal;
  if (node == nullptr) throw error;
  draft.file.fail(*node, error.problem());
}

void tell(const Draft& draft, GeoJsonScenario& result) {
  std::string text;
  for (const auto& [why, count] : draft.left_out) {
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", why, count);
  }
  if (!text.empty()) result.notes.push_back("left out: " + text);
  if (draft.filled_holes > 0) {
    result.notes.push_back(fmt::format("holes filled: {}", draft.filled_holes));
  }
  result.notes.insert(result.notes.end(), draft.notes.begin(), draft.notes.end());
}

void warn_of_degrees(const Document& file, const std::vector<Feature>& features,
                     std::vector<std::string>& warnings) {
  for (const Feature& feature : features) {
    if (feature.heading_node == nullptr) continue;
    if (const std::string doubt = heading_doubt(*feature.heading); !doubt.empty()) {
      warnings.push_back(file.place_of(*feature.heading_node) + ": " + doubt);
    }
  }
}

std::string name_of(const Document& file, const std::string& path) {
  const Node* const name = file.find(file.root(), "name");
  if (name != nullptr && name->kind == Node::Kind::scalar && !name->text.empty()) return name->text;
  return path == "-" ? "site" : std::filesystem::path(path).stem().string();
}

}  // namespace

GeoJsonScenario read_geojson(const GeoJsonSite& site) {
  if (!(site.default_width >= 0.001 && site.default_width <= 1000)) {
    throw InputError("width", fmt::format("is {}, expected 0.001 to 1000 m", site.default_width));
  }
  const Document file =
      parse_json(read_file(site.file, largest_text),
                 site.file == "-" ? "standard input" : site.file, 1, {}, "GeoJSON");
  const std::vector<Feature> features = features_from(file);
  const SiteEnd start = end_from(file, features, FeatureKind::start, site.start);
  const SiteEnd goal = end_from(file, features, FeatureKind::goal, site.goal);
  const bool is_on_earth = !site.is_in_metres && has_longitudes(file);
  const Plane plane(file, is_on_earth, {start.pose.x, start.pose.y});
  Draft draft{file, site, plane, plane.pose_of(start), plane.pose_of(goal)};
  for (const Feature& feature : features) add_feature(draft, feature);
  GeoJsonScenario result{.origin = plane.origin()};
  Scenario& scenario = result.scenario;
  scenario.name = name_of(file, site.file);
  scenario.vehicle = site.vehicle;
  scenario.start = draft.start;
  scenario.goal = draft.goal;
  scenario.bounds = bounds_of(draft);
  scenario.obstacles = draft.obstacles.polygons;
  scenario.kerbs = draft.kerbs.polygons;
  const bool is_drawn = draft.bounds != nullptr && !is_box(draft.bounds_ring);
  if (is_drawn) scenario.inside = {draft.bounds_ring};
  scenario.zones = draft.zones;
  try {
    check_scenario(scenario);
  } catch (const InputError& error) {
    blame(draft, start.node, goal.node, error);
  }
  tell(draft, result);
  result.warnings = draft.warnings;
  warn_of_degrees(file, features, result.warnings);
  return result;
}

}  // namespace vandplan

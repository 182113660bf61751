// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does a map of Lanelet2 (Poggenhans et al. 2018) become a scenario?
//
// OSM XML: nodes, ways of nodes, and relations of ways. A lanelet is a relation with a left and a
// right way, an area one with outer and inner ways. Tags say the rest.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "io/ground.h"
#include "io/levels.h"
#include "io/local_plane.h"
#include "io/roads.h"
#include "io/site_shapes.h"
#include "io/xml.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace io;

constexpr double wall_width = 0.001;  // Width of walls, fences and curbs, which no map says [m].

/// Elements of a map by their ids, and the plane that its places are in.
class OsmMap {
 public:
  OsmMap(const XmlFile& file, const RoadMap& map) : file_(file) {
    for (const XmlNode node : file.root().children("node")) {
      nodes_[file.text(node, "id")] = node;
      has_metres_ = has_metres_ || !tag(node, "local_x").empty();
      has_heights_ = has_heights_ && !tag(node, "ele").empty();
    }
    for (const XmlNode way : file.root().children("way")) ways_[file.text(way, "id")] = way;
    for (const XmlNode relation : file.root().children("relation")) {
      for (const XmlNode member : relation.children("member")) {
        members_.insert(member.attribute("ref").value());
      }
    }
    if (has_metres_) return;
    const auto short_angle = [](double degrees) { return std::round(degrees * 1e5) / 1e5; };
    origin_ = GeoPlace{short_angle(map.start.x), short_angle(map.start.y)};
    to_plane_ = plane_around(*origin_);
  }

  /// Place of the origin of the plane; none if the map is in metres.
  [[nodiscard]] const std::optional<GeoPlace>& origin() const { return origin_; }

  /// Start or goal, given in coordinates of the map. `flag` names it in errors.
  [[nodiscard]] Pose pose_of(const Pose& given, const char* flag) const {
    if (has_metres_) return given;
    const std::optional<Point> point = point_of({given.x, given.y});
    if (point) return {point->x, point->y, given.heading};
    throw InputError(flag, fmt::format("is {},{}, expected longitude and latitude in degrees of a "
                                       "place within {} km of the start",
                                       given.x, given.y, largest_plane / 1000));
  }

  /// Whether a way or node is a member of a relation.
  [[nodiscard]] bool is_member(const XmlNode& node) const {
    return members_.contains(node.attribute("id").value());
  }

  /// Whether all nodes have a height. Otherwise all heights are 0.
  [[nodiscard]] bool has_heights() const { return has_heights_; }

  /// Heights of the points of a way.
  [[nodiscard]] std::vector<double> heights_of(const XmlNode& way) const {
    std::vector<double> heights;
    for (const XmlNode part : way.children("nd")) {
      const XmlNode node = nodes_.at(file_.text(part, "ref"));
      const std::string_view height = has_heights_ ? tag(node, "ele") : "0";
      heights.push_back(file_.number_from(node, "has ele ", height));
    }
    return heights;
  }

  /// Points of a way.
  [[nodiscard]] std::vector<Point> line_of(const XmlNode& way) {
    std::vector<Point> line;
    for (const XmlNode part : way.children("nd")) {
      const std::string id = file_.text(part, "ref");
      const auto node = nodes_.find(id);
      if (node == nodes_.end()) file_.fail(part, "is node " + id + ", expected one of the file");
      line.push_back(point_at(id, node->second));
    }
    if (line.size() < 2) {
      file_.fail(way, fmt::format("has {} nodes, expected at least 2", line.size()));
    }
    return line;
  }

  /// Ways that are members of a relation in that role.
  [[nodiscard]] std::vector<XmlNode> ways_of(const XmlNode& relation, std::string_view role) const {
    std::vector<XmlNode> ways;
    for (const XmlNode member : relation.children("member")) {
      const std::string_view type = member.attribute("type").value();
      if (type != "way" || member.attribute("role").value() != role) continue;
      const std::string id = file_.text(member, "ref");
      const auto way = ways_.find(id);
      if (way == ways_.end()) file_.fail(member, "is way " + id + ", expected one of the file");
      ways.push_back(way->second);
    }
    return ways;
  }

 private:
  [[nodiscard]] std::optional<Point> point_of(const GeoPlace& place) const {
    if (!(std::abs(place.longitude) <= 360 && std::abs(place.latitude) <= 90)) return {};
    return to_plane_(place);
  }

  Point point_at(const std::string& id, const XmlNode& node) {
    const auto [found, is_new] = points_.try_emplace(id);
    if (is_new) found->second = has_metres_ ? metres_at(node) : plane_at(node);
    return found->second;
  }

  [[nodiscard]] Point metres_at(const XmlNode& node) const {
    Point point;
    for (const XmlNode child : node.children("tag")) {
      const std::string_view key = child.attribute("k").value();
      if (key == "local_x") point.x = file_.number(child, "v");
      if (key == "local_y") point.y = file_.number(child, "v");
    }
    if (tag(node, "local_x").empty() || tag(node, "local_y").empty()) {
      file_.fail(node, "has no local_x and local_y, expected both, as other nodes have them");
    }
    return point;
  }

  [[nodiscard]] Point plane_at(const XmlNode& node) const {
    const GeoPlace place{file_.number(node, "lon"), file_.number(node, "lat")};
    if (const std::optional<Point> point = point_of(place)) return *point;
    file_.fail(node, fmt::format("is at longitude {} and latitude {}, expected a place within {} "
                                 "km of the start",
                                 place.longitude, place.latitude, largest_plane / 1000));
  }

  const XmlFile& file_;
  std::unordered_map<std::string, XmlNode> nodes_;
  std::unordered_map<std::string, XmlNode> ways_;
  std::unordered_map<std::string, Point> points_;
  std::unordered_set<std::string> members_;  // Ids of all members of relations.
  bool has_metres_ = false;
  bool has_heights_ = true;
  std::optional<GeoPlace> origin_;
  ToPlane to_plane_;
};

double squared(const Point& a, const Point& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// Whether vehicles may drive there, by a tag of the participants, or else by the subtype.
bool is_for_vehicles(const XmlNode& relation, bool by_subtype) {
  bool is_named = false;
  for (const XmlNode child : relation.children("tag")) {
    const std::string_view key = child.attribute("k").value();
    if (!key.starts_with("participant:")) continue;
    const std::string_view value = child.attribute("v").value();
    if (key.starts_with("participant:vehicle") && value == "yes") return true;
    is_named = true;
  }
  return !is_named && by_subtype;
}

/// Speed limit of a lanelet [m/s]: a number of km/h, or with its unit.
std::optional<double> lanelet_limit(const XmlFile& file, const XmlNode& relation) {
  for (const XmlNode child : relation.children("tag")) {
    if (child.attribute("k").value() != std::string_view("speed_limit")) continue;
    const std::string_view text = without_blanks(child.attribute("v").value());
    const std::size_t end = std::min(text.find_first_not_of("0123456789.+-"), text.size());
    const double number = file.number_from(child, "has v ", text.substr(0, end));
    const std::string_view unit = without_blanks(text.substr(end));
    const std::optional<double> speed = speed_from(number, unit.empty() ? "km/h" : unit);
    if (speed) return speed;
    file.fail(child, fmt::format("has v \"{}\", expected a positive number of km/h, mph or m/s",
                                 text.substr(0, 40)));
  }
  return {};
}

Lane lane_from(const XmlFile& file, OsmMap& map, const XmlNode& relation) {
  Lane lane{.name = "lanelet " + file.text(relation, "id")};
  for (const bool is_left : {true, false}) {
    const char* const role = is_left ? "left" : "right";
    const std::vector<XmlNode> ways = map.ways_of(relation, role);
    if (ways.size() != 1) {
      file.fail(relation, fmt::format("has {} {} ways, expected one", ways.size(), role));
    }
    (is_left ? lane.left : lane.right) = map.line_of(ways.front());
    (is_left ? lane.left_heights : lane.right_heights) = map.heights_of(ways.front());
  }
  // Ways have any direction: both edges get one direction, and then that of travel.
  const double as_they_are =
      squared(lane.left.front(), lane.right.front()) + squared(lane.left.back(), lane.right.back());
  const double turned =
      squared(lane.left.front(), lane.right.back()) + squared(lane.left.back(), lane.right.front());
  const auto turn_left = [&] {
    std::ranges::reverse(lane.left);
    std::ranges::reverse(lane.left_heights);
  };
  const auto turn_right = [&] {
    std::ranges::reverse(lane.right);
    std::ranges::reverse(lane.right_heights);
  };
  if (turned < as_they_are) turn_right();
  if (twice_area(outline(lane)) > 0.0) {
    turn_left();
    turn_right();
  }
  lane.is_one_way = !is_any_of(tag(relation, "one_way"), {"no", "false"});
  lane.max_speed = lanelet_limit(file, relation);
  return lane;
}

/// Joins lines to a ring at their ends, in any direction. The lines that are joined are taken.
Polygon ring_from(const XmlFile& file, const XmlNode& relation,
                  std::vector<std::vector<Point>>& lines) {
  Polygon ring = std::move(lines.back());
  lines.pop_back();
  while (!(ring.front() == ring.back())) {
    const auto next = std::ranges::find_if(lines, [&](const std::vector<Point>& line) {
      return line.front() == ring.back() || line.back() == ring.back();
    });
    if (next == lines.end()) file.fail(relation, "has an open ring, expected ways that close it");
    if (!(next->front() == ring.back())) std::reverse(next->begin(), next->end());
    ring.insert(ring.end(), next->begin() + 1, next->end());
    lines.erase(next);
  }
  ring.pop_back();
  if (ring.size() < 3) {
    file.fail(relation, fmt::format("has a ring of {} places, expected at least 3", ring.size()));
  }
  return ring;
}

std::vector<Polygon> rings_of(const XmlFile& file, OsmMap& map, const XmlNode& relation,
                              const char* role) {
  std::vector<std::vector<Point>> lines;
  for (const XmlNode& way : map.ways_of(relation, role)) lines.push_back(map.line_of(way));
  std::vector<Polygon> rings;
  while (!lines.empty()) rings.push_back(ring_from(file, relation, lines));
  return rings;
}

/// Lowest and highest point of ways. Ways say where something stands, not how high it is.
Interval heights_of(const OsmMap& map, const std::vector<XmlNode>& ways) {
  std::vector<double> heights;
  for (const XmlNode& way : ways) {
    const std::vector<double> more = map.heights_of(way);
    heights.insert(heights.end(), more.begin(), more.end());
  }
  if (heights.empty()) return {};
  const auto [least, most] = std::ranges::minmax(heights);
  return {least, most};
}

void add_areas(const OsmMap& map, const std::vector<XmlNode>& ways,
               const std::vector<Polygon>& rings, Roads& roads) {
  const Interval heights = heights_of(map, ways);
  for (const Polygon& ring : rings) {
    roads.areas.push_back({ring, (heights.least + heights.most) / 2});
  }
}

/// Adds obstacles that stand on ways, as high as a vehicle.
void add_obstacles(const XmlFile& file, const OsmMap& map, const XmlNode& node,
                   const std::vector<XmlNode>& ways, const std::vector<Polygon>& outlines,
                   Roads& roads) {
  const Interval heights = heights_of(map, ways);
  for (const Polygon& one : outlines) {
    roads.obstacles.push_back(
        {one, file.place_of(node), {heights.least, heights.most + clear_height}});
  }
}

void add_relation(const XmlFile& file, OsmMap& map, const XmlNode& relation, Roads& roads) {
  const std::string_view type = tag(relation, "type");
  const std::string subtype(tag(relation, "subtype"));
  if (type == "lanelet") {
    const bool is_road = is_any_of(subtype, {"", "road", "highway", "play_street", "bus_lane",
                                             "emergency_lane", "exit", "road_shoulder"});
    if (is_for_vehicles(relation, is_road)) {
      roads.lanes.push_back(lane_from(file, map, relation));
    } else {
      ++roads.left_out["lanelet " + subtype];
    }
  } else if (type == "multipolygon") {
    if (is_for_vehicles(relation, is_any_of(subtype, {"parking", "freespace", "exit"}))) {
      add_areas(map, map.ways_of(relation, "outer"), rings_of(file, map, relation, "outer"), roads);
      add_obstacles(file, map, relation, map.ways_of(relation, "inner"),
                    rings_of(file, map, relation, "inner"), roads);
    } else if (is_any_of(subtype, {"building", "keepout", "traffic_island", "vegetation"})) {
      add_obstacles(file, map, relation, map.ways_of(relation, "outer"),
                    rings_of(file, map, relation, "outer"), roads);
    } else {
      ++roads.left_out["area " + subtype];
    }
  } else if (type == "regulatory_element") {
    ++roads.left_out["regulatory_element " + subtype];
  }
}

/// Ways that are more than an edge: car parks and parking spaces as Autoware has them, walls,
/// fences and high curbs.
void add_way(const XmlFile& file, OsmMap& map, const XmlNode& way, Roads& roads) {
  const std::string_view type = tag(way, "type");
  if (type == "parking_lot") {
    Polygon ring = map.line_of(way);
    if (ring.front() == ring.back()) ring.pop_back();
    add_areas(map, {way}, {ring}, roads);
  } else if (type == "parking_space") {
    double width = 0.0;
    for (const XmlNode child : way.children("tag")) {
      if (child.attribute("k").value() == std::string_view("width"))
        width = file.number(child, "v");
    }
    if (!(width > 0.0 && width <= 1000)) {
      file.fail(way, fmt::format("has width {}, expected more than 0 m", width));
    }
    const std::vector<Point> line = map.line_of(way);
    const Point ends[] = {line.front(), line.back()};
    add_areas(map, {way}, walls_along(ends, width), roads);
  } else if (is_any_of(type, {"wall", "fence", "guard_rail"})) {
    add_obstacles(file, map, way, {way}, walls_along(map.line_of(way), wall_width), roads);
  } else if (type == "curbstone" && tag(way, "subtype") == "high") {
    const std::vector<Polygon> kerbs = walls_along(map.line_of(way), wall_width);
    roads.kerbs.insert(roads.kerbs.end(), kerbs.begin(), kerbs.end());
  } else if (!type.empty() && !map.is_member(way)) {
    ++roads.left_out[fmt::format("way {}", type)];
  }
}

/// Counts posts, which are left out, and heights, if only some nodes have one.
void count_nodes(const XmlFile& file, const OsmMap& map, Roads& roads) {
  for (const XmlNode node : file.root().children("node")) {
    if (is_any_of(tag(node, "type"), {"pole", "post", "bollard"})) {
      ++roads.left_out[fmt::format("node {}", tag(node, "type"))];
    }
    if (!map.has_heights() && !tag(node, "ele").empty()) ++roads.left_out["node ele"];
  }
}

}  // namespace

RoadScenario read_lanelet2(const RoadMap& given) {
  const XmlFile file(given.file, "osm", "a map of Lanelet2");
  OsmMap map(file, given);
  const Pose start = map.pose_of(given.start, "--start");
  const Pose goal = map.pose_of(given.goal, "--goal");
  Roads roads;
  for (const XmlNode relation : file.root().children("relation")) {
    add_relation(file, map, relation, roads);
  }
  for (const XmlNode way : file.root().children("way")) add_way(file, map, way, roads);
  count_nodes(file, map, roads);
  if (roads.lanes.empty() && roads.areas.empty()) {
    file.fail(file.root(), "has no lanelet or area for vehicles, expected one at least");
  }
  RoadScenario result{.file = {.origin = map.origin()}};
  Scenario& scenario = result.file.scenario;
  scenario.name = file.stem();
  scenario.description = "Lanelet2";
  scenario.vehicle = given.vehicle;
  scenario.start = start;
  scenario.goal = goal;
  add_roads(roads, given, file.place_of(file.root()), result);
  return result;
}

}  // namespace vandplan

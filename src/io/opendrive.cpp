// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does a map of OpenDRIVE (ASAM, 1.4 to 1.8) become a scenario?
//
// A road has a reference line. Lanes lie side by side, to the left and to the right of it; their
// widths are cubics of the distance along the road. Edges of lanes become lines of many corners.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/ground.h"
#include "io/road_line.h"
#include "io/road_objects.h"
#include "io/roads.h"
#include "io/xml.h"
#include "vandplan/files.h"

namespace vandplan {
namespace {

using namespace io;

constexpr double tolerance = 0.005;  // Largest distance of an edge from its corners' lines [m].
constexpr double height_tolerance = 0.5;  // And of its height [m] ...
constexpr double least_slope = 2.0;       // ... between corners that are so far apart [m].
constexpr double least_step = 0.01;       // Least distance between corners, along the road [m].
constexpr double narrow = 0.001;          // Width below which there is no lane [m].
constexpr std::size_t most_corners = 1'000'000;  // Corners of all edges of a map.

/// A lane of a lane section, on one side of the reference line.
struct SectionLane {
  XmlNode node;
  int id = 0;
  CubicLine width;
  CubicLine border;
  SpeedLimits speeds;

  [[nodiscard]] bool is_ground() const {
    return is_any_of(
        node.attribute("type").value(),
        {"driving", "parking", "bidirectional", "entry", "exit", "onRamp", "offRamp",
         "connectingRamp", "slipLane", "stop", "bus", "taxi", "HOV", "mwyEntry", "mwyExit"});
  }
};

/// A road and what holds along all of it.
struct Road {
  const XmlFile& file;
  XmlNode node;
  RoadLine line;
  CubicLine offset;
  CubicLine elevation;
  SpeedLimits speeds;
};

/// Adds the lanes of a section on one side, from the reference line outwards.
void add_side(const Road& road, const XmlNode& section, bool is_left, double s,
              std::vector<SectionLane>& all) {
  const XmlFile& file = road.file;
  std::vector<SectionLane> lanes;
  for (const XmlNode node : section.child(is_left ? "left" : "right").children("lane")) {
    const double id = file.number(node, "id");
    if (!(is_left ? id > 0 : id < 0) || std::abs(id) > 1000 || id != std::round(id)) {
      file.fail(node, fmt::format("has id {}, expected a {} number", id,
                                  is_left ? "positive" : "negative"));
    }
    lanes.push_back({node, static_cast<int>(id), CubicLine(file, node, "width", "sOffset", s),
                     CubicLine(file, node, "border", "sOffset", s),
                     SpeedLimits(file, node, s, road.speeds)});
  }
  std::ranges::sort(lanes, [](const SectionLane& a, const SectionLane& b) {
    return std::abs(a.id) < std::abs(b.id);
  });
  all.insert(all.end(), lanes.begin(), lanes.end());
}

/// Edges of all lanes of a section at one distance along the road.
struct Station {
  double s = 0.0;
  double height = 0.0;            // Height of the reference line [m].
  std::vector<double> t = {};     // Two for each lane: its inner and its outer edge [m].
  std::vector<Point> edges = {};  // Their points [m].
};

/// A lane section. All lanes have corners at the same stations, so that neighbours share them.
class Section {
 public:
  /// The section from the distance `begin` along its road to the distance `end`.
  Section(const Road& road, const XmlNode& node, double begin, double end)
      : road_(road), node_(node) {
    for (const bool is_left : {true, false}) add_side(road, node, is_left, begin, lanes_);
    std::vector<double> distances = {begin, end};
    road.line.add_begins(distances);
    road.offset.add_begins(distances);
    road.elevation.add_begins(distances);
    for (const SectionLane& lane : lanes_) {
      lane.width.add_begins(distances);
      lane.border.add_begins(distances);
      lane.speeds.add_begins(distances);
    }
    std::erase_if(distances, [&](double s) { return !(s >= begin && s <= end); });
    std::sort(distances.begin(), distances.end());
    stations_.push_back(at(begin));
    for (const double s : distances) {
      const double before = stations_.back().s;
      if (s - before >= narrow || (s == end && before < end)) add_up_to(at(s));
    }
  }

  [[nodiscard]] const std::vector<SectionLane>& lanes() const { return lanes_; }
  /// Stations between which the edges are straight but for `tolerance`.
  [[nodiscard]] const std::vector<Station>& stations() const { return stations_; }

 private:
  [[nodiscard]] Station at(double s) const {
    Station station{.s = s, .height = road_.elevation.at(s)};
    const Pose on_line = road_.line.at(s);
    const double offset = road_.offset.at(s);
    double t = offset;
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      const SectionLane& lane = lanes_[i];
      const bool is_innermost = i == 0 || (lane.id < 0 && lanes_[i - 1].id > 0);
      if (is_innermost) t = offset;
      station.t.push_back(t);
      const double width = std::max(0.0, lane.width.at(s));
      if (!lane.width.is_empty()) {
        t += lane.id > 0 ? width : -width;
      } else if (!lane.border.is_empty()) {
        t = offset + lane.border.at(s);
      }
      station.t.push_back(t);
    }
    for (const double edge : station.t) station.edges.push_back(beside(on_line, edge));
    return station;
  }

  /// Adds stations up to `last`, which is one of them.
  void add_up_to(const Station& last) {
    const Station first = stations_.back();
    if (last.s - first.s > 2 * least_step) {
      for (const double share : {0.25, 0.5, 0.75}) {
        if (is_near(at(first.s + share * (last.s - first.s)), first, last, share)) continue;
        add_up_to(at((first.s + last.s) / 2));
        return add_up_to(last);
      }
    }
    stations_.push_back(last);
    if (stations_.size() * stations_.back().t.size() > most_corners) {
      road_.file.fail(node_,
                      fmt::format("is too winding, expected at most {} corners", most_corners));
    }
  }

  /// Whether the edges of a station are near the lines between those of two others.
  static bool is_near(const Station& station, const Station& first, const Station& last,
                      double share) {
    const double height = first.height + (last.height - first.height) * share;
    const bool is_long = last.s - first.s > least_slope;
    if (is_long && std::abs(station.height - height) > height_tolerance) return false;
    for (std::size_t i = 0; i < station.edges.size(); ++i) {
      const Point& a = first.edges[i];
      const Point& b = last.edges[i];
      const Point& p = station.edges[i];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const Point on_line = {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
      const double off =
          length < narrow
              ? std::hypot(p.x - on_line.x, p.y - on_line.y)
              : std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
      if (off > tolerance) return false;
    }
    return true;
  }

  const Road& road_;
  XmlNode node_;
  std::vector<SectionLane> lanes_;
  std::vector<Station> stations_;
};

/// How a lane is driven, with the reference line (1), against it (-1), or both ways (0).
int direction_of(const XmlNode& road, const SectionLane& lane) {
  const std::string_view type = lane.node.attribute("type").value();
  const std::string_view direction = lane.node.attribute("direction").value();
  if (type == "parking" || type == "bidirectional" || direction == "both") return 0;
  const bool on_left = road.attribute("rule").value() == std::string_view("LHT");
  const int usual = (lane.id > 0) == on_left ? 1 : -1;
  return direction == "reversed" ? -usual : usual;
}

/// Adds the lane of a section with that index, divided where it has no width or another speed
/// limit.
void add_lane(const XmlNode& road, const Section& section, std::size_t index, Roads& roads) {
  const SectionLane& lane = section.lanes()[index];
  const std::vector<Station>& stations = section.stations();
  const std::size_t inner = 2 * index;
  const std::size_t outer = inner + 1;
  const int direction = direction_of(road, lane);
  const auto width = [&](const Station& station) {
    return std::abs(station.t[outer] - station.t[inner]);
  };
  Lane made{.name = fmt::format("road {} lane {}", road.attribute("id").value(), lane.id),
            .is_one_way = direction != 0};
  const auto close = [&] {
    if (made.left.size() > 1) {
      Lane done = made;
      // So far the edges run along the reference line, the outer one on the left for positive ids.
      if (direction < 0) {
        std::swap(done.left, done.right);
        std::reverse(done.left.begin(), done.left.end());
        std::reverse(done.right.begin(), done.right.end());
        std::reverse(done.left_heights.begin(), done.left_heights.end());
      }
      done.right_heights = done.left_heights;
      roads.lanes.push_back(std::move(done));
    }
    made.left.clear();
    made.right.clear();
    made.left_heights.clear();
  };
  for (std::size_t i = 0; i < stations.size(); ++i) {
    // A station stands for all distances that are less than `narrow` ahead.
    const std::optional<double> limit = lane.speeds.at(stations[i].s + narrow);
    const bool is_narrow = width(stations[i]) < narrow;
    const bool goes_on = i + 1 < stations.size() && width(stations[i + 1]) >= narrow;
    if (is_narrow && made.left.empty() && !goes_on) continue;
    made.left.push_back(stations[i].edges[lane.id > 0 ? outer : inner]);
    made.right.push_back(stations[i].edges[lane.id > 0 ? inner : outer]);
    made.left_heights.push_back(stations[i].height);
    if (made.left.size() == 1) made.max_speed = limit;
    const bool changes = i + 1 < stations.size() && limit != made.max_speed;
    if (made.left.size() == 1 || !(is_narrow || changes)) continue;
    close();
    if (goes_on || changes) --i;  // The next part begins at the same station.
  }
  close();
}

void add_section(const Road& road, const XmlNode& section, double end, Roads& roads) {
  const double begin = road.file.number(section, "s");
  if (!(begin >= 0.0 && begin < end)) {
    road.file.fail(section,
                   fmt::format("begins at s = {}, expected 0 to less than {}, where the next "
                               "one or the end of the road is",
                               begin, end));
  }
  const Section lanes(road, section, begin, end);
  for (std::size_t i = 0; i < lanes.lanes().size(); ++i) {
    const SectionLane& lane = lanes.lanes()[i];
    if (lane.is_ground()) {
      add_lane(road.node, lanes, i, roads);
      if (lane.node.child("access")) ++roads.left_out["lane access"];
    } else {
      ++roads.left_out[fmt::format("lane {}", lane.node.attribute("type").value())];
    }
  }
}

/// Counts what a road has beside its lanes and objects, which is left out.
void count_rest(const XmlNode& road, Roads& roads) {
  const auto is_level = [](const XmlNode& node) {
    return std::ranges::all_of(
        std::initializer_list<const char*>{"a", "b", "c", "d"},
        [&](const char* name) { return node.attribute(name).as_double() == 0; });
  };
  for (const XmlNode node : road.child("lateralProfile").children()) {
    if (!is_level(node)) ++roads.left_out[node.name()];
  }
  for (const XmlNode node : road.child("signals").children()) ++roads.left_out[node.name()];
}

void add_road(const XmlFile& file, const XmlNode& node, Roads& roads) {
  const XmlNode lanes = file.child(node, "lanes");
  const Road road{file,
                  node,
                  RoadLine(file, node),
                  CubicLine(file, lanes, "laneOffset", "s", 0.0),
                  CubicLine(file, node.child("elevationProfile"), "elevation", "s", 0.0),
                  SpeedLimits(file, node)};
  for (XmlNode section = lanes.child("laneSection"); section;) {
    const XmlNode next = section.next_sibling("laneSection");
    add_section(road, section, next ? file.number(next, "s") : road.line.length(), roads);
    section = next;
  }
  add_objects(file, node, road.line, road.elevation, roads);
  count_rest(node, roads);
  std::size_t corners = 0;
  for (const Lane& lane : roads.lanes) corners += lane.left.size() + lane.right.size();
  if (corners > most_corners) {
    file.fail(node, fmt::format("is one too many, expected at most {} corners of lanes in a map",
                                most_corners));
  }
}

}  // namespace

RoadScenario read_opendrive(const RoadMap& map) {
  const XmlFile file(map.file, "OpenDRIVE", "a map of OpenDRIVE");
  Roads roads;
  for (const XmlNode road : file.root().children("road")) add_road(file, road, roads);
  if (roads.lanes.empty() && roads.areas.empty()) {
    file.fail(file.root(), "has no lane or parking space, expected one at least");
  }
  RoadScenario result;
  Scenario& scenario = result.file.scenario;
  scenario.name = file.stem();
  scenario.description = "OpenDRIVE";
  scenario.vehicle = map.vehicle;
  scenario.start = map.start;
  scenario.goal = map.goal;
  add_roads(roads, map, file.place_of(file.root()), result);
  return result;
}

}  // namespace vandplan

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
#include "io/roads.h"
#include "io/xml.h"
#include "vandplan/files.h"

namespace vandplan {
namespace {

using namespace io;

constexpr double tolerance = 0.005;  // Largest distance of an edge from its corners' lines [m].
constexpr double least_step = 0.01;  // Least distance between corners, along the road [m].
constexpr double narrow = 0.001;     // Width below which there is no lane [m].
constexpr std::size_t most_corners = 1'000'000;  // Corners of all edges of a map.

bool is_listed(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

/// Point beside the reference line [m]; `t` counts to the left.
Point beside(const Pose& on_line, double t) {
  return rounded(
      {on_line.x - t * std::sin(on_line.heading), on_line.y + t * std::cos(on_line.heading)});
}

/// A lane of a lane section, on one side of the reference line.
struct SectionLane {
  XmlNode node;
  int id = 0;
  CubicLine width;
  CubicLine border;

  [[nodiscard]] bool is_ground() const {
    return is_listed(
        node.attribute("type").value(),
        {"driving", "parking", "bidirectional", "entry", "exit", "onRamp", "offRamp",
         "connectingRamp", "slipLane", "stop", "bus", "taxi", "HOV", "mwyEntry", "mwyExit"});
  }
};

/// Adds the lanes of a section on one side, from the reference line outwards.
void add_side(const XmlFile& file, const XmlNode& section, bool is_left, double s,
              std::vector<SectionLane>& all) {
  std::vector<SectionLane> lanes;
  for (const XmlNode node : section.child(is_left ? "left" : "right").children("lane")) {
    const double id = file.number(node, "id");
    if (!(is_left ? id > 0 : id < 0) || std::abs(id) > 1000 || id != std::round(id)) {
      file.fail(node, fmt::format("has id {}, expected a {} number", id,
                                  is_left ? "positive" : "negative"));
    }
    lanes.push_back({node, static_cast<int>(id), CubicLine(file, node, "width", "sOffset", s),
                     CubicLine(file, node, "border", "sOffset", s)});
  }
  std::ranges::sort(lanes, [](const SectionLane& a, const SectionLane& b) {
    return std::abs(a.id) < std::abs(b.id);
  });
  all.insert(all.end(), lanes.begin(), lanes.end());
}

/// Edges of all lanes of a section at one distance along the road.
struct Station {
  double s = 0.0;
  std::vector<double> t = {};     // Two for each lane: its inner and its outer edge [m].
  std::vector<Point> edges = {};  // Their points [m].
};

/// A lane section. All lanes have corners at the same stations, so that neighbours share them.
class Section {
 public:
  /// The section from the distance `begin` along its road to the distance `end`.
  Section(const XmlFile& file, const RoadLine& line, const CubicLine& offset, const XmlNode& node,
          double begin, double end)
      : file_(file), line_(line), offset_(offset), node_(node) {
    for (const bool is_left : {true, false}) add_side(file, node, is_left, begin, lanes_);
    std::vector<double> distances = {begin, end};
    line_.add_begins(distances);
    offset_.add_begins(distances);
    for (const SectionLane& lane : lanes_) {
      lane.width.add_begins(distances);
      lane.border.add_begins(distances);
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
    Station station{.s = s};
    const Pose on_line = line_.at(s);
    const double offset = offset_.at(s);
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
      file_.fail(node_, fmt::format("is too winding, expected at most {} corners", most_corners));
    }
  }

  /// Whether the edges of a station are near the lines between those of two others.
  static bool is_near(const Station& station, const Station& first, const Station& last,
                      double share) {
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

  const XmlFile& file_;
  const RoadLine& line_;
  const CubicLine& offset_;
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

/// Adds the lane of a section with that index, divided where it has no width.
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
      }
      roads.lanes.push_back(std::move(done));
    }
    made.left.clear();
    made.right.clear();
  };
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const bool is_narrow = width(stations[i]) < narrow;
    const bool goes_on = i + 1 < stations.size() && width(stations[i + 1]) >= narrow;
    if (is_narrow && made.left.empty() && !goes_on) continue;
    made.left.push_back(stations[i].edges[lane.id > 0 ? outer : inner]);
    made.right.push_back(stations[i].edges[lane.id > 0 ? inner : outer]);
    if (!is_narrow || made.left.size() == 1) continue;
    close();
    if (goes_on) --i;  // The next part begins at the same station.
  }
  close();
}

void add_section(const XmlFile& file, const XmlNode& road, const RoadLine& line,
                 const CubicLine& offset, const XmlNode& section, double end, Roads& roads) {
  const double begin = file.number(section, "s");
  if (!(begin >= 0.0 && begin < end)) {
    file.fail(section, fmt::format("begins at s = {}, expected 0 to less than {}, where the next "
                                   "one or the end of the road is",
                                   begin, end));
  }
  const Section lanes(file, line, offset, section, begin, end);
  for (std::size_t i = 0; i < lanes.lanes().size(); ++i) {
    const SectionLane& lane = lanes.lanes()[i];
    if (lane.is_ground()) {
      add_lane(road, lanes, i, roads);
    } else {
      ++roads.left_out[fmt::format("lane {}", lane.node.attribute("type").value())];
    }
  }
}

/// Area of a parking space: its first outline, else a rectangle.
Polygon area_of(const XmlFile& file, const XmlNode& object, const RoadLine& line) {
  const Pose on_line = line.at(file.number(object, "s"));
  const Point middle = beside(on_line, file.number(object, "t"));
  const Pose pose = {middle.x, middle.y, on_line.heading + file.number_or(object, "hdg", 0.0)};
  const auto point = [&](double u, double v) {
    const Pose at = compose(pose, {u, v, 0.0});
    return rounded({at.x, at.y});
  };
  const XmlNode outlines = object.child("outlines");
  const XmlNode outline = (outlines ? outlines : object).child("outline");
  Polygon corners;
  for (const XmlNode corner : outline.children("cornerLocal")) {
    corners.push_back(point(file.number(corner, "u"), file.number(corner, "v")));
  }
  for (const XmlNode corner : outline.children("cornerRoad")) {
    corners.push_back(beside(line.at(file.number(corner, "s")), file.number(corner, "t")));
  }
  if (outline && corners.size() < 3) {
    file.fail(outline, fmt::format("has {} corners, expected at least 3", corners.size()));
  }
  if (outline) return corners;
  const double u = file.number(object, "length") / 2;
  const double v = file.number(object, "width") / 2;
  return {point(-u, -v), point(u, -v), point(u, v), point(-u, v)};
}

void add_road(const XmlFile& file, const XmlNode& road, Roads& roads) {
  const RoadLine line(file, road);
  const XmlNode lanes = file.child(road, "lanes");
  const CubicLine offset(file, lanes, "laneOffset", "s", 0.0);
  for (XmlNode section = lanes.child("laneSection"); section;) {
    const XmlNode next = section.next_sibling("laneSection");
    add_section(file, road, line, offset, section, next ? file.number(next, "s") : line.length(),
                roads);
    section = next;
  }
  for (const XmlNode object : road.child("objects").children("object")) {
    const std::string type = object.attribute("type").value();
    if (type == "parkingSpace") {
      roads.areas.push_back(area_of(file, object, line));
    } else {
      ++roads.left_out["object " + type];
    }
  }
  std::size_t corners = 0;
  for (const Lane& lane : roads.lanes) corners += lane.left.size() + lane.right.size();
  if (corners > most_corners) {
    file.fail(road, fmt::format("is one too many, expected at most {} corners of lanes in a map",
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

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/road_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "io/ground.h"
#include "io/levels.h"
#include "io/site_shapes.h"

namespace vandplan::io {
namespace {

constexpr double most_copies = 10'000;  // Copies of one object, or parts of a continuous one.
constexpr double tolerance = 0.005;  // Largest distance of a continuous object from its parts [m].
constexpr double least_part = 0.01;  // Least length of a part along the road [m].
constexpr double least_width = 0.001;  // Width of a continuous object that has none [m].

/// Where an object stands along, beside and above its road, and how large it is [m].
struct ObjectPlace {
  double s = 0.0;
  double t = 0.0;
  double radius = 0.0;
  double length = 0.0;
  double width = 0.0;
  double above = 0.0;
  double height = 0.0;  // 0: it is not said.
};

/// An object's outline, and its height above the road and above all.
struct Shape {
  Polygon outline;
  Interval above;
  Interval heights;
};

/// Reads one object.
class ObjectReader {
 public:
  ObjectReader(const XmlFile& file, const RoadLine& line, const CubicLine& elevation,
               const XmlNode& object)
      : file_(file),
        line_(line),
        elevation_(elevation),
        object_(object),
        place_{file.number(object, "s"),
               file.number(object, "t"),
               file.number_or(object, "radius", 0.0),
               file.number_or(object, "length", 0.0),
               file.number_or(object, "width", 0.0),
               file.number_or(object, "zOffset", 0.0),
               file.number_or(object, "height", 0.0)},
        turn_(file.number_or(object, "hdg", 0.0)) {}

  /// Shapes of the object, of its copies, or of its parts if it is continuous. Empty if it has no
  /// size.
  [[nodiscard]] std::vector<Shape> shapes() const {
    std::vector<Shape> shapes;
    for (const XmlNode repeat : object_.children("repeat")) add_copies(repeat, shapes);
    if (!object_.child("repeat")) add_at(place_, shapes);
    return shapes;
  }

 private:
  /// Adds copies from the begin of a repetition to its end, both included.
  void add_copies(const XmlNode& repeat, std::vector<Shape>& shapes) const {
    const double step = file_.number(repeat, "distance");
    const double length = file_.number(repeat, "length");
    if (!(step >= 0.0 && length >= 0.0)) return;
    if (step == 0.0) return add_parts(repeat, length, shapes);
    const double last = std::floor(length / step + 1e-9);
    if (!(last < most_copies)) {
      file_.fail(repeat, fmt::format("has {} copies, expected at most {}", last + 1, most_copies));
    }
    for (double i = 0.0; i <= last; i += 1.0) {
      add_at(place_in(repeat, i * step, length), shapes);
    }
  }

  /// Place and size at a distance from the begin of a repetition that is so long.
  [[nodiscard]] ObjectPlace place_in(const XmlNode& repeat, double distance, double length) const {
    const double share = length > 0.0 ? distance / length : 0.0;
    const auto at = [&](const std::string& name, double otherwise) {
      const double from = file_.number_or(repeat, (name + "Start").c_str(), otherwise);
      return from + share * (file_.number_or(repeat, (name + "End").c_str(), from) - from);
    };
    return {file_.number(repeat, "s") + distance,
            at("t", place_.t),
            at("radius", place_.radius),
            at("length", place_.length),
            at("width", place_.width),
            at("zOffset", place_.above),
            at("height", place_.height)};
  }

  /// Adds the parts of an object that goes on along the road.
  void add_parts(const XmlNode& repeat, double length, std::vector<Shape>& shapes) const {
    const double begin = file_.number(repeat, "s");
    std::vector<double> ends = {begin, begin + length};
    line_.add_begins(ends);
    elevation_.add_begins(ends);
    std::erase_if(ends, [&](double s) { return s < begin || s > begin + length; });
    std::ranges::sort(ends);
    std::vector<ObjectPlace> places = {place_in(repeat, 0.0, length)};
    for (const double end : ends) add_up_to(repeat, end - begin, length, places);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      add_part(places[i], places[i + 1], shapes);
    }
  }

  /// Adds places up to a distance from the begin of a repetition. The object is straight between
  /// them.
  void add_up_to(const XmlNode& repeat, double end, double length,
                 std::vector<ObjectPlace>& places) const {
    const double first = places.back().s - file_.number(repeat, "s");
    if (end - first < least_part && end < length) return;
    const ObjectPlace last = place_in(repeat, end, length);
    const double middle = (first + end) / 2;
    if (end - first > 2 * least_part &&
        std::ranges::any_of(std::initializer_list<double>{0.25, 0.5, 0.75}, [&](double share) {
          const ObjectPlace at = place_in(repeat, first + share * (end - first), length);
          return distance(middle_of(at),
                          between(middle_of(places.back()), middle_of(last), share)) > tolerance;
        })) {
      add_up_to(repeat, middle, length, places);
      return add_up_to(repeat, end, length, places);
    }
    places.push_back(last);
    if (static_cast<double>(places.size()) > most_copies) {
      file_.fail(repeat, fmt::format("is too winding, expected at most {} parts", most_copies));
    }
  }

  [[nodiscard]] Point middle_of(const ObjectPlace& place) const {
    return beside(line_.at(place.s), place.t);
  }

  /// Adds the part of a continuous object between two places.
  void add_part(const ObjectPlace& from, const ObjectPlace& to, std::vector<Shape>& shapes) const {
    const auto edge = [&](const ObjectPlace& place, double side) {
      const double width = std::max({place.width, 2 * place.radius, least_width});
      return beside(line_.at(place.s), place.t + side * width / 2);
    };
    const Point middles[] = {middle_of(from), middle_of(to)};
    Polygon outline = {edge(from, -1), edge(to, -1), edge(to, 1), edge(from, 1)};
    if (!geometry::flaw_of(geometry::cleaned(outline), {}).empty()) {  // In a sharp bend.
      const double width = std::max({from.width, to.width, least_width});
      const std::vector<Polygon> straight = walls_along(middles, width);
      if (straight.empty()) return;
      outline = straight.front();
    }
    const Shape one = shape_of(from, {});
    const Shape other = shape_of(to, {});
    const auto around = [](const Interval& a, const Interval& b) {
      return Interval{std::min(a.least, b.least), std::max(a.most, b.most)};
    };
    shapes.push_back(
        {std::move(outline), around(one.above, other.above), around(one.heights, other.heights)});
  }

  /// A shape with an outline at a place.
  [[nodiscard]] Shape shape_of(const ObjectPlace& place, Polygon outline) const {
    const double ground = elevation_.at(place.s);
    const double top =
        place.height > 0.0 ? place.above + place.height : std::numeric_limits<double>::infinity();
    return {std::move(outline), {place.above, top}, {ground + place.above, ground + top}};
  }

  /// Adds the outer outlines of the object, or else a circle or rectangle.
  void add_at(const ObjectPlace& place, std::vector<Shape>& shapes) const {
    const Pose on_line = line_.at(place.s);
    const Point middle = beside(on_line, place.t);
    const Pose pose = {middle.x, middle.y, on_line.heading + turn_};
    const XmlNode outlines = object_.child("outlines");
    const XmlNode parent = outlines ? outlines : object_;
    for (const XmlNode outline : parent.children("outline")) {
      if (outline.attribute("outer").value() == std::string_view("false")) continue;
      shapes.push_back(shape_of(place, outline_at(place, pose, outline)));
    }
    if (parent.child("outline")) return;
    if (place.radius > 0.0) {
      shapes.push_back(shape_of(place, circle_shape(middle, place.radius, true)));
    } else if (place.length > 0.0 && place.width > 0.0) {
      const double u = place.length / 2;
      const double v = place.width / 2;
      shapes.push_back(shape_of(
          place, {moved(pose, -u, -v), moved(pose, u, -v), moved(pose, u, v), moved(pose, -u, v)}));
    }
  }

  [[nodiscard]] Polygon outline_at(const ObjectPlace& place, const Pose& pose,
                                   const XmlNode& outline) const {
    Polygon corners;
    for (const XmlNode corner : outline.children("cornerLocal")) {
      corners.push_back(moved(pose, file_.number(corner, "u"), file_.number(corner, "v")));
    }
    for (const XmlNode corner : outline.children("cornerRoad")) {
      corners.push_back(beside(line_.at(file_.number(corner, "s") + place.s - place_.s),
                               file_.number(corner, "t") + place.t - place_.t));
    }
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < 3) {
      file_.fail(outline, fmt::format("has {} corners, expected at least 3", corners.size()));
    }
    return corners;
  }

  static Point moved(const Pose& pose, double u, double v) {
    const Pose at = compose(pose, {u, v, 0.0});
    return rounded({at.x, at.y});
  }

  const XmlFile& file_;
  const RoadLine& line_;
  const CubicLine& elevation_;
  XmlNode object_;
  ObjectPlace place_;
  double turn_;  // Heading of the object less that of the road [rad].
};

/// Whether an object with that type stands in the way of vehicles.
bool is_in_the_way(std::string_view type) {
  return is_any_of(type, {"obstacle", "barrier", "building", "pole", "streetLamp", "tree",
                          "vegetation", "trafficIsland", "railing", "soundBarrier", "car", "van",
                          "bus", "trailer", "bike", "motorbike"});
}

}  // namespace

void add_objects(const XmlFile& file, const XmlNode& road, const RoadLine& line,
                 const CubicLine& elevation, Roads& roads) {
  for (const XmlNode object : road.child("objects").children("object")) {
    const std::string type = object.attribute("type").value();
    const bool is_ground = type == "parkingSpace";
    if (!is_ground && !is_in_the_way(type)) {
      ++roads.left_out["object " + type];
      continue;
    }
    const std::vector<Shape> shapes = ObjectReader(file, line, elevation, object).shapes();
    if (shapes.empty()) ++roads.left_out["object " + type + " without a size"];
    for (const auto& [outline, above, heights] : shapes) {
      if (is_ground) {
        roads.areas.push_back({outline, heights.least});
      } else if (above.least >= clear_height || above.most <= 0.0) {
        ++roads.left_out["object " + type + " above or below the road"];
      } else {
        roads.obstacles.push_back({outline, file.place_of(object), heights});
      }
    }
  }
}

}  // namespace vandplan::io

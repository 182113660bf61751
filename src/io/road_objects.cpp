// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/road_objects.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/ground.h"
#include "io/site_shapes.h"

namespace vandplan::io {
namespace {

constexpr double most_copies = 10'000;  // Copies of one object.

/// Where an object stands along and beside its road, and how large it is [m].
struct ObjectPlace {
  double s = 0.0;
  double t = 0.0;
  double radius = 0.0;
  double length = 0.0;
  double width = 0.0;
};

/// Reads one object.
class ObjectReader {
 public:
  ObjectReader(const XmlFile& file, const RoadLine& line, const XmlNode& object)
      : file_(file),
        line_(line),
        object_(object),
        place_{file.number(object, "s"), file.number(object, "t"),
               file.number_or(object, "radius", 0.0), file.number_or(object, "length", 0.0),
               file.number_or(object, "width", 0.0)},
        turn_(file.number_or(object, "hdg", 0.0)) {}

  /// Polygons of the object and its copies. Empty if it has no size, or if it is continuous.
  [[nodiscard]] std::vector<Polygon> shapes() const {
    std::vector<Polygon> shapes;
    for (const XmlNode repeat : object_.children("repeat")) add_copies(repeat, shapes);
    if (!object_.child("repeat")) add_at(place_, shapes);
    return shapes;
  }

 private:
  /// Adds copies from the begin of a repetition to its end, both included.
  void add_copies(const XmlNode& repeat, std::vector<Polygon>& shapes) const {
    const double step = file_.number(repeat, "distance");
    const double length = file_.number(repeat, "length");
    if (!(step > 0.0 && length >= 0.0)) return;
    const double last = std::floor(length / step + 1e-9);
    if (!(last < most_copies)) {
      file_.fail(repeat, fmt::format("has {} copies, expected at most {}", last + 1, most_copies));
    }
    const double begin = file_.number(repeat, "s");
    for (double i = 0.0; i <= last; i += 1.0) {
      const double share = length > 0.0 ? i * step / length : 0.0;
      const auto at = [&](const std::string& name, double otherwise) {
        const double from = file_.number_or(repeat, (name + "Start").c_str(), otherwise);
        return from + share * (file_.number_or(repeat, (name + "End").c_str(), from) - from);
      };
      add_at({begin + i * step, at("t", place_.t), at("radius", place_.radius),
              at("length", place_.length), at("width", place_.width)},
             shapes);
    }
  }

  /// Adds the outer outlines of the object, or else a circle or rectangle.
  void add_at(const ObjectPlace& place, std::vector<Polygon>& shapes) const {
    const Pose on_line = line_.at(place.s);
    const Point middle = beside(on_line, place.t);
    const Pose pose = {middle.x, middle.y, on_line.heading + turn_};
    const XmlNode outlines = object_.child("outlines");
    const XmlNode parent = outlines ? outlines : object_;
    for (const XmlNode outline : parent.children("outline")) {
      if (outline.attribute("outer").value() == std::string_view("false")) continue;
      shapes.push_back(outline_at(place, pose, outline));
    }
    if (parent.child("outline")) return;
    if (place.radius > 0.0) {
      shapes.push_back(circle_shape(middle, place.radius, true));
    } else if (place.length > 0.0 && place.width > 0.0) {
      const double u = place.length / 2;
      const double v = place.width / 2;
      shapes.push_back(
          {moved(pose, -u, -v), moved(pose, u, -v), moved(pose, u, v), moved(pose, -u, v)});
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

void add_objects(const XmlFile& file, const XmlNode& road, const RoadLine& line, Roads& roads) {
  for (const XmlNode object : road.child("objects").children("object")) {
    const std::string type = object.attribute("type").value();
    const bool is_ground = type == "parkingSpace";
    if (!is_ground && !is_in_the_way(type)) {
      ++roads.left_out["object " + type];
      continue;
    }
    const std::vector<Polygon> shapes = ObjectReader(file, line, object).shapes();
    if (shapes.empty()) ++roads.left_out["object " + type + " without a size"];
    for (const Polygon& shape : shapes) {
      if (is_ground) {
        roads.areas.push_back(shape);
      } else {
        roads.obstacles.push_back({shape, file.place_of(object)});
      }
    }
  }
}

}  // namespace vandplan::io

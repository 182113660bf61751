// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "bindings/web/core/values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "bindings/web/core/zones.h"
#include "vandplan/input_error.h"
#include "vandplan/plan_options.h"
#include "vandplan/vehicle.h"

namespace vandplan::web {
namespace {

bool is_object(const val& given) {
  return given.typeOf().as<std::string>() == "object" && !given.isNull();
}

std::vector<Polygon> polygons_at(const val& object, const char* key) {
  std::vector<Polygon> polygons;
  if (!has(object, key)) return polygons;
  const val list = object[key];
  polygons.resize(size_of(list, key));
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    polygons[i] = polygon_from(list[i], std::string(key) + "[" + std::to_string(i) + "]");
  }
  return polygons;
}

template <typename Number>
val copy_of(std::span<const Number> numbers, const char* type) {
  const val view{emscripten::typed_memory_view(numbers.size(), numbers.data())};
  return val::global(type).new_(view);
}

void add_limits(const val& given, DrivingLimits& limits) {
  limits.max_steering_rate =
      number_at(given, "max_steering_rate", "vehicle", limits.max_steering_rate);
  if (has(given, "max_curvature_rate")) {
    limits.max_curvature_rate = number_at(given, "max_curvature_rate", "vehicle");
  }
  if (has(given, "max_speed")) {
    const val speed = given["max_speed"];
    allow_only(speed, {"forward", "reverse"}, "vehicle.max_speed");
    limits.max_speed = {number_at(speed, "forward", "vehicle.max_speed", limits.max_speed.forward),
                        number_at(speed, "reverse", "vehicle.max_speed", limits.max_speed.reverse)};
  }
  limits.max_acceleration =
      number_at(given, "max_acceleration", "vehicle", limits.max_acceleration);
  if (has(given, "max_braking")) limits.max_braking = number_at(given, "max_braking", "vehicle");
  limits.max_lateral_acceleration =
      number_at(given, "max_lateral_acceleration", "vehicle", limits.max_lateral_acceleration);
  if (has(given, "max_jerk")) limits.max_jerk = number_at(given, "max_jerk", "vehicle");
}

/// Reads lengths and outline of the body of a vehicle or trailer. With an outline the lengths may
/// be missing; they are then those of the box around it.
void read_body(const val& given, const std::string& where, auto& body) {
  body.wheelbase = number_at(given, "wheelbase", where);
  const bool has_outline = has(given, "outline");
  if (has_outline) {
    body.outline = polygon_from(given["outline"], where + ".outline");
    if (body.outline.empty()) throw InputError(where + ".outline", "has 0 corners");
    const Footprint box = footprint(body);
    body.front_overhang = box.front - body.wheelbase;
    body.rear_overhang = box.rear;
    body.width = 2 * box.half_width;
  }
  const auto read = [&](const char* key, double& length) {
    if (!has_outline || has(given, key)) length = number_at(given, key, where);
  };
  read("front_overhang", body.front_overhang);
  read("rear_overhang", body.rear_overhang);
  read("width", body.width);
}

/// Turning radius, given as such or by `max_steering_angle`.
double radius_at(const val& given, double wheelbase) {
  if (!has(given, "max_steering_angle")) return number_at(given, "min_turning_radius", "vehicle");
  if (has(given, "min_turning_radius")) {
    throw InputError("vehicle.max_steering_angle", "is given beside min_turning_radius");
  }
  return turning_radius(wheelbase, number_at(given, "max_steering_angle", "vehicle"));
}

Trailer trailer_from(const val& given) {
  const std::string where = "vehicle.trailers[0]";
  allow_only(given, {"wheelbase", "front_overhang", "rear_overhang", "width", "outline"}, where);
  Trailer trailer;
  read_body(given, where, trailer);
  return trailer;
}

void add_trailer(const val& given, Vehicle& vehicle) {
  if (!has(given, "trailers")) return;
  if (size_of(given["trailers"], "vehicle.trailers") != 1) {
    throw InputError("vehicle.trailers", "expected a list with one trailer");
  }
  vehicle.trailer = trailer_from(given["trailers"][0]);
  vehicle.hitch = number_at(given, "hitch", "vehicle", vehicle.hitch);
  vehicle.max_hitch_angle = number_at(given, "max_hitch_angle", "vehicle", vehicle.max_hitch_angle);
}

double hitch_angle_at(const val& given, const std::string& where, const Vehicle& vehicle) {
  if (!has(given, "hitch_angles")) return 0.0;
  const std::string key = where + ".hitch_angles";
  const std::size_t trailers = vehicle.trailer ? 1 : 0;
  if (size_of(given["hitch_angles"], key) != trailers) {
    throw InputError(key, "expected one angle for each trailer");
  }
  return trailers == 0 ? 0.0 : number_from(given["hitch_angles"][0], key);
}

MovingObstacle mover_from(const val& given, const std::string& where) {
  allow_only(given, {"outline", "trajectory", "after", "inflate"}, where);
  MovingObstacle mover{.outline = polygon_from(given["outline"], where + ".outline"),
                       .inflate = number_at(given, "inflate", where, 0.0)};
  const val rows = given["trajectory"];
  mover.trajectory.resize(size_of(rows, where + ".trajectory"));
  for (std::size_t i = 0; i < mover.trajectory.size(); ++i) {
    const std::string row = where + ".trajectory[" + std::to_string(i) + "]";
    if (size_of(rows[i], row) != 4) throw InputError(row, "expected [t, x, y, heading]");
    const auto number = [&](int k) { return number_from(rows[i][k], row); };
    mover.trajectory[i] = {number(0), {number(1), number(2), number(3)}};
  }
  if (has(given, "after")) {
    const auto after = given["after"].as<std::string>();
    if (after == name_of(Afterwards::leaves)) {
      mover.after = Afterwards::leaves;
    } else if (after != name_of(Afterwards::stays)) {
      throw InputError(where + ".after", "expected stays or leaves");
    }
  }
  return mover;
}

std::vector<MovingObstacle> moving_at(const val& object) {
  std::vector<MovingObstacle> moving;
  if (!has(object, "moving")) return moving;
  const val list = object["moving"];
  const std::size_t count = size_of(list, "moving");
  for (std::size_t i = 0; i < count; ++i) {
    moving.push_back(mover_from(list[i], "moving[" + std::to_string(i) + "]"));
  }
  return moving;
}

}  // namespace

std::string key_of(const std::string& where, const std::string& key) {
  return where.empty() ? key : where + "." + key;
}

std::size_t size_of(const val& list, const std::string& where) {
  if (!list.isArray()) throw InputError(where, "expected a list");
  return list["length"].as<std::size_t>();
}

Point point_from(const val& given, const std::string& where) {
  if (size_of(given, where) != 2) throw InputError(where, "expected [x, y]");
  return {number_from(given[0], where), number_from(given[1], where)};
}

Polygon polygon_from(const val& corners, const std::string& where) {
  Polygon polygon(size_of(corners, where));
  for (std::size_t i = 0; i < polygon.size(); ++i) polygon[i] = point_from(corners[i], where);
  return polygon;
}

double number_from(const val& given, const std::string& where) {
  if (!given.isNumber()) throw InputError(where, "expected a number");
  return given.as<double>();
}

bool has(const val& object, const char* key) {
  const val value = object[key];
  return !value.isUndefined() && !value.isNull();
}

double number_at(const val& object, const char* key, const std::string& where) {
  if (!has(object, key)) throw InputError(key_of(where, key), "is missing");
  return number_from(object[key], key_of(where, key));
}

double number_at(const val& object, const char* key, const std::string& where, double standard) {
  return has(object, key) ? number_at(object, key, where) : standard;
}

void allow_only(const val& object, std::initializer_list<std::string_view> keys,
                const std::string& where) {
  const std::string name = where.empty() ? "the scenario" : where;
  if (!is_object(object)) throw InputError(name, "expected an object");
  const val given = val::global("Object").call<val>("keys", object);
  const auto count = given["length"].as<std::size_t>();
  for (std::size_t i = 0; i < count; ++i) {
    const auto key = given[i].as<std::string>();
    if (std::ranges::find(keys, key) == keys.end()) {
      throw InputError(key_of(where, key.substr(0, 40)), "is not known");
    }
  }
}

Pose pose_from(const val& given, const std::string& where) {
  allow_only(given, {"x", "y", "heading", "curvature", "hitch_angles"}, where);
  return {number_at(given, "x", where), number_at(given, "y", where),
          number_at(given, "heading", where)};
}

End end_from(const val& given, const std::string& where, const Vehicle& vehicle) {
  if (!is_object(given)) throw InputError(where, "expected an object");
  End end{.curvature = number_at(given, "curvature", where, 0.0),
          .hitch_angle = hitch_angle_at(given, where, vehicle)};
  if (!has(given, "trailer")) {
    end.pose = pose_from(given, where);
    return end;
  }
  allow_only(given, {"trailer", "curvature", "hitch_angles"}, where);
  if (!vehicle.trailer) throw InputError(where + ".trailer", "is given without a trailer");
  const Pose trailer = pose_from(given["trailer"], where + ".trailer");
  end.pose = tractor_pose(vehicle, trailer, end.hitch_angle);
  return end;
}

Vehicle vehicle_from(const val& given) {
  allow_only(given,
             {"wheelbase", "front_overhang", "rear_overhang", "width", "min_turning_radius",
              "max_steering_angle", "track_width", "max_steering_rate", "max_curvature_rate",
              "max_speed", "max_acceleration", "max_braking", "max_lateral_acceleration",
              "max_jerk", "hitch", "max_hitch_angle", "trailers", "outline"},
             "vehicle");
  Vehicle vehicle;
  read_body(given, "vehicle", vehicle);
  vehicle.min_turning_radius = radius_at(given, vehicle.wheelbase);
  if (has(given, "track_width")) vehicle.track_width = number_at(given, "track_width", "vehicle");
  add_limits(given, vehicle.limits);
  add_trailer(given, vehicle);
  check_vehicle(vehicle);
  return vehicle;
}

Scenario scenario_from(const val& given) {
  allow_only(given,
             {"name", "description", "vehicle", "bounds", "start", "goal", "via", "obstacles",
              "kerbs", "inside", "zones", "map", "masks", "moving"},
             "");
  Scenario scenario;
  if (has(given, "vehicle")) scenario.vehicle = vehicle_from(given["vehicle"]);
  if (has(given, "map")) scenario.map = map_from(given["map"], "map");
  if (has(given, "bounds")) {
    const val bounds = given["bounds"];
    allow_only(bounds, {"x", "y"}, "bounds");
    const Point x = point_from(bounds["x"], "bounds.x");
    const Point y = point_from(bounds["y"], "bounds.y");
    scenario.bounds = {x.x, x.y, y.x, y.y};
  } else if (scenario.map) {
    scenario.bounds = bounding_box(outline(*scenario.map));
  } else {
    throw InputError("bounds", "is missing");
  }
  const End start = end_from(given["start"], "start", scenario.vehicle);
  Goal goal = goal_from(given["goal"], scenario.vehicle);
  scenario.start = start.pose;
  scenario.goal = goal.end.pose;
  scenario.goal_set = std::move(goal.set);
  scenario.via = via_at(given, scenario.vehicle);
  scenario.curvatures = {start.curvature, goal.end.curvature};
  scenario.hitch_angles = {start.hitch_angle, goal.end.hitch_angle};
  scenario.obstacles = polygons_at(given, "obstacles");
  scenario.kerbs = polygons_at(given, "kerbs");
  scenario.inside = polygons_at(given, "inside");
  scenario.zones = zones_at(given);
  scenario.masks = masks_at(given, scenario.vehicle.limits.max_speed.forward);
  scenario.moving = moving_at(given);
  return scenario;
}

Path path_from(const val& given) {
  allow_only(given, {"start", "segments"}, "path");
  Path path{pose_from(given["start"], "path.start"), {}};
  const val segments = given["segments"];
  path.segments.resize(size_of(segments, "path.segments"));
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const val segment = segments[i];
    const std::string where = "path.segments[" + std::to_string(i) + "]";
    allow_only(segment, {"curvature", "length", "curvature_rate"}, where);
    path.segments[i] = {number_at(segment, "curvature", where), number_at(segment, "length", where),
                        number_at(segment, "curvature_rate", where, 0.0)};
  }
  return path;
}

val array_of(std::span<const double> numbers) { return copy_of(numbers, "Float64Array"); }
val array_of(std::span<const float> numbers) { return copy_of(numbers, "Float32Array"); }
val array_of(std::span<const std::int32_t> numbers) { return copy_of(numbers, "Int32Array"); }

val object_of(const Pose& pose) {
  val object = val::object();
  object.set("x", pose.x);
  object.set("y", pose.y);
  object.set("heading", pose.heading);
  return object;
}

val list_of(std::span<const Segment> segments) {
  val list = val::array();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    val segment = val::object();
    segment.set("curvature", segments[i].curvature);
    segment.set("length", segments[i].length);
    segment.set("curvature_rate", segments[i].curvature_rate);
    list.set(i, segment);
  }
  return list;
}

val object_of(const Path& path) {
  val object = val::object();
  object.set("start", object_of(path.start));
  object.set("segments", list_of(path.segments));
  return object;
}

}  // namespace vandplan::web

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Vehicles, from keywords with the names of scenario files.

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <array>
#include <string_view>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/scenario.h"
#include "vandplan/input_error.h"
#include "vandplan/vehicle.h"

namespace vandplan::python {
namespace {

namespace py = pybind11;

/// Number of a vehicle, with its name in files.
struct Field {
  const char* name;
  void (*set)(Vehicle&, double);
  std::optional<double> (*get)(const Vehicle&);
  const char* about;
};

constexpr std::array fields = {
    Field{"wheelbase", [](Vehicle& v, double x) { v.wheelbase = x; },
          [](const Vehicle& v) { return std::optional(v.wheelbase); },
          "Distance from rear axle to front axle [m]."},
    Field{"front_overhang", [](Vehicle& v, double x) { v.front_overhang = x; },
          [](const Vehicle& v) { return std::optional(v.front_overhang); },
          "Distance from front axle to front bumper [m]."},
    Field{"rear_overhang", [](Vehicle& v, double x) { v.rear_overhang = x; },
          [](const Vehicle& v) { return std::optional(v.rear_overhang); },
          "Distance from rear axle to rear bumper [m]."},
    Field{"width", [](Vehicle& v, double x) { v.width = x; },
          [](const Vehicle& v) { return std::optional(v.width); }, "Width of the body [m]."},
    Field{"min_turning_radius", [](Vehicle& v, double x) { v.min_turning_radius = x; },
          [](const Vehicle& v) { return std::optional(v.min_turning_radius); },
          "Turning radius of the midpoint of the rear axle at full steering [m]."},
    Field{"track_width", [](Vehicle& v, double x) { v.track_width = x; },
          [](const Vehicle& v) { return v.track_width; },
          "Width over the wheels of an axle [m]; None: as wide as the body."},
    Field{"max_steering_rate", [](Vehicle& v, double x) { v.limits.max_steering_rate = x; },
          [](const Vehicle& v) { return std::optional(v.limits.max_steering_rate); },
          "Largest rate of the front wheel's angle in a bicycle model [rad/s]."},
    Field{
        "max_curvature_rate", [](Vehicle& v, double x) { v.limits.max_curvature_rate = x; },
        [](const Vehicle& v) { return v.limits.max_curvature_rate; },
        "Largest change of curvature per metre driven [1/m^2]; None: as the steering rate allows."},
    Field{"max_acceleration", [](Vehicle& v, double x) { v.limits.max_acceleration = x; },
          [](const Vehicle& v) { return std::optional(v.limits.max_acceleration); },
          "Largest acceleration along the path [m/s^2]."},
    Field{"max_braking", [](Vehicle& v, double x) { v.limits.max_braking = x; },
          [](const Vehicle& v) { return v.limits.max_braking; },
          "Largest braking along the path [m/s^2]; None: as `max_acceleration`."},
    Field{"max_lateral_acceleration",
          [](Vehicle& v, double x) { v.limits.max_lateral_acceleration = x; },
          [](const Vehicle& v) { return std::optional(v.limits.max_lateral_acceleration); },
          "Largest lateral acceleration, speed^2 * |curvature| [m/s^2]."},
    Field{"max_jerk", [](Vehicle& v, double x) { v.limits.max_jerk = x; },
          [](const Vehicle& v) { return v.limits.max_jerk; },
          "Largest change of the acceleration [m/s^3]; None: unlimited."},
};

constexpr const char* steering_key = "max_steering_angle";
constexpr std::array others = {steering_key,      "max_speed", "hitch",
                               "max_hitch_angle", "outline",   "trailers"};

double number_of(const std::string& name, const py::handle& value) {
  try {
    return value.cast<double>();
  } catch (const py::cast_error&) {
    throw InputError("vehicle." + name, "is no number");
  }
}

GearSpeeds speeds_from(const py::handle& value) {
  if (py::isinstance<py::dict>(value)) {
    const auto speeds = py::reinterpret_borrow<py::dict>(value);
    if (speeds.size() == 2 && speeds.contains("forward") && speeds.contains("reverse")) {
      return {number_of("max_speed.forward", speeds["forward"]),
              number_of("max_speed.reverse", speeds["reverse"])};
    }
  } else if (py::isinstance<py::sequence>(value) && py::len(value) == 2) {
    return {number_of("max_speed.forward", value[py::int_(0)]),
            number_of("max_speed.reverse", value[py::int_(1)])};
  }
  throw InputError("vehicle.max_speed", "expected two numbers, forward and reverse");
}

Polygon outline_from(const py::handle& value, const std::string& where) {
  return value.is_none() ? Polygon{} : polygon_from(value, where);
}

Trailer trailer_from(const py::handle& value) {
  const std::string where = "vehicle.trailers[0]";
  if (!py::isinstance<py::dict>(value)) throw InputError(where, "expected a dict of its lengths");
  Trailer trailer;
  for (const auto& [key, given] : py::reinterpret_borrow<py::dict>(value)) {
    const std::string name = py::str(key);
    const auto number = [&, &item = given] { return number_of("trailers[0]." + name, item); };
    if (name == "wheelbase") {
      trailer.wheelbase = number();
    } else if (name == "front_overhang") {
      trailer.front_overhang = number();
    } else if (name == "rear_overhang") {
      trailer.rear_overhang = number();
    } else if (name == "width") {
      trailer.width = number();
    } else if (name == "outline") {
      trailer.outline = outline_from(given, where + ".outline");
    } else {
      throw InputError(where + "." + name,
                       "unknown key, expected one of wheelbase, front_overhang, rear_overhang, "
                       "width, outline");
    }
  }
  return trailer;
}

std::optional<Trailer> trailers_from(const py::handle& value) {
  const auto list = py::reinterpret_borrow<py::sequence>(value);
  if (py::isinstance<py::str>(value) || !py::isinstance<py::sequence>(value) || list.size() > 1) {
    throw InputError("vehicle.trailers", "expected a list with one trailer, or an empty one");
  }
  return list.size() == 0 ? std::nullopt : std::optional(trailer_from(list[0]));
}

/// Sets a value that is no number, or belongs to a trailer; false if the name is unknown.
bool set_other(Vehicle& vehicle, const std::string& name, const py::handle& value) {
  if (name == "max_speed") {
    vehicle.limits.max_speed = speeds_from(value);
  } else if (name == "hitch") {
    vehicle.hitch = number_of(name, value);
  } else if (name == "max_hitch_angle") {
    vehicle.max_hitch_angle = number_of(name, value);
  } else if (name == "outline") {
    vehicle.outline = outline_from(value, "vehicle.outline");
  } else if (name == "trailers") {
    vehicle.trailer = trailers_from(value);
  } else {
    return false;
  }
  return true;
}

void set_field(Vehicle& vehicle, const std::string& name, const py::handle& value) {
  if (set_other(vehicle, name, value)) return;
  std::string names;
  for (const Field& field : fields) {
    if (name != field.name) {
      names += std::string(field.name) + ", ";
      continue;
    }
    const bool is_standard = value.is_none() && !field.get(Vehicle{});
    if (!is_standard) field.set(vehicle, number_of(name, value));
    return;
  }
  throw InputError("vehicle." + name, fmt::format("unknown key, expected one of {}{}", names,
                                                  fmt::join(others, ", ")));
}

Vehicle vehicle_of(const py::dict& values) {
  Vehicle vehicle;
  std::optional<double> angle;
  for (const auto& [name, value] : values) {
    const std::string key = py::str(name);
    if (key == steering_key) {
      angle = number_of(key, value);
    } else {
      set_field(vehicle, key, value);
    }
  }
  if (angle && values.contains("min_turning_radius")) {
    throw InputError("vehicle.max_steering_angle",
                     "is given beside min_turning_radius, expected one of the two");
  }
  if (angle) vehicle.min_turning_radius = turning_radius(vehicle.wheelbase, *angle);
  check_vehicle(vehicle);
  return vehicle;
}

/// Corners as a list of pairs; None if there are none.
py::object list_of(const Polygon& outline) {
  if (outline.empty()) return py::none();
  py::list corners;
  for (const auto& [x, y] : outline) corners.append(py::make_tuple(x, y));
  return corners;
}

py::list trailers_of(const Vehicle& vehicle) {
  py::list trailers;
  if (!vehicle.trailer) return trailers;
  const Trailer& trailer = *vehicle.trailer;
  py::dict values;
  values["wheelbase"] = trailer.wheelbase;
  values["front_overhang"] = trailer.front_overhang;
  values["rear_overhang"] = trailer.rear_overhang;
  values["width"] = trailer.width;
  values["outline"] = list_of(trailer.outline);
  trailers.append(values);
  return trailers;
}

py::dict dict_of_vehicle(const Vehicle& vehicle) {
  py::dict values;
  for (const Field& field : fields) values[field.name] = field.get(vehicle);
  const GearSpeeds& speeds = vehicle.limits.max_speed;
  values["max_speed"] = py::make_tuple(speeds.forward, speeds.reverse);
  values["hitch"] = vehicle.hitch;
  values["max_hitch_angle"] = vehicle.max_hitch_angle;
  values["outline"] = list_of(vehicle.outline);
  values["trailers"] = trailers_of(vehicle);
  return values;
}

std::string vehicle_text(const Vehicle& vehicle) {
  return fmt::format("<vandplan.Vehicle: {} m by {} m, turning radius {} m{}>",
                     vehicle.rear_overhang + vehicle.wheelbase + vehicle.front_overhang,
                     vehicle.width, vehicle.min_turning_radius,
                     vehicle.trailer ? ", with a trailer" : "");
}

}  // namespace

Vehicle vehicle_from(const py::handle& given) {
  if (given.is_none()) return {};
  if (py::isinstance<py::str>(given)) return vehicle_named(given.cast<std::string>());
  if (py::isinstance<py::dict>(given)) return vehicle_of(py::reinterpret_borrow<py::dict>(given));
  if (py::isinstance<Vehicle>(given)) return given.cast<Vehicle>();
  throw InputError("vehicle", "expected a Vehicle, the name of one, or a dict of its lengths");
}

void bind_vehicle(py::module_& module) {
  py::class_<Vehicle> vehicle(module, "Vehicle", R"(Vehicle(**lengths_and_limits)

Rigid vehicle with front steering: its lengths and its limits of motion.

Keywords are those of scenario files. Missing ones have the values of a truck.

- wheelbase, front_overhang, rear_overhang, width, track_width [m]
- min_turning_radius [m], or in its place max_steering_angle [rad]
- max_steering_rate [rad/s], max_curvature_rate [1/m^2]
- max_speed: (forward, reverse) [m/s]
- max_acceleration, max_braking, max_lateral_acceleration [m/s^2], max_jerk [m/s^3]
- outline: corners of a convex body in the vehicle frame [m], shape (N, 2), in place of the
  rectangle
- trailers: a list with one dict of wheelbase (hitch to axle), front_overhang, rear_overhang, width
  and perhaps outline
- hitch: x of the hitch in the vehicle frame [m]; max_hitch_angle [rad]

Raises InputError naming the keyword that is wrong.)");
  vehicle.def(py::init([](const py::kwargs& values) { return vehicle_of(values); }))
      .def_static("named", &vehicle_named, py::arg("name"),
                  "named(name) -> Vehicle\n\nVehicle of the catalogue, such as \"city-bus\".")
      .def_static("names", &vehicle_names,
                  "names() -> list of str\n\nNames of the catalogue's vehicles.")
      .def("as_dict", &dict_of_vehicle, R"(as_dict() -> dict

All values by keyword. `Vehicle(**{**vehicle.as_dict(), "width": 2.4})` is a narrower vehicle.)")
      .def("__eq__", [](const Vehicle& self, const Vehicle& other) { return self == other; })
      .def("__eq__", [](const Vehicle&, const py::object&) { return false; })
      .def("__repr__", &vehicle_text)
      .def(py::pickle([](const Vehicle& self) { return dict_of_vehicle(self); },
                      [](const py::dict& values) { return vehicle_of(values); }));
  for (const Field& field : fields) {
    vehicle.def_property_readonly(field.name, field.get, field.about);
  }
  vehicle.def_property_readonly(
      steering_key,
      [](const Vehicle& self) { return steering_angle(self, 1.0 / self.min_turning_radius); },
      "Angle of the front wheel in a bicycle model at full steering [rad].");
  vehicle.def_property_readonly(
      "max_speed",
      [](const Vehicle& self) {
        return py::make_tuple(self.limits.max_speed.forward, self.limits.max_speed.reverse);
      },
      "Largest speeds (forward, reverse) [m/s].");
  vehicle.def_readonly("hitch", &Vehicle::hitch,
                       "x of the hitch in the vehicle frame [m]; negative behind the rear axle.");
  vehicle.def_readonly("max_hitch_angle", &Vehicle::max_hitch_angle,
                       "Largest absolute hitch angle [rad].");
  vehicle.def_property_readonly(
      "outline",
      [](const Vehicle& self) { return array_of(std::span<const Point>(body_outline(self))); },
      "Corners of the body in the vehicle frame [m], counter-clockwise; shape (N, 2).");
  vehicle.def_property_readonly("trailers", &trailers_of,
                                "List with a dict of the trailer; empty without a trailer.");
  vehicle.attr("__hash__") = py::none();
}

}  // namespace vandplan::python

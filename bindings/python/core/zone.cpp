// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Zones of a scenario.

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

using Direction = std::optional<std::pair<double, double>>;

Zone made_zone(const py::object& area, const std::string& name, bool closed,
               const std::string& gears, const Direction& direction, double cost,
               std::optional<double> max_speed, bool body) {
  Zone zone{.name = name,
            .area = polygon_from(area, "area"),
            .closed = closed,
            .gears = gears_named(gears),
            .cost = cost,
            .max_speed = max_speed,
            .body = body};
  if (direction) zone.direction = HeadingRange{direction->first, direction->second};
  return zone;
}

py::object corners_of(const Zone& self) { return array_of(std::span<const Point>(self.area)); }

Direction direction_of_zone(const Zone& self) {
  if (!self.direction) return std::nullopt;
  return std::pair{self.direction->from, self.direction->to};
}

py::tuple state_of_zone(const Zone& self) {
  return py::make_tuple(corners_of(self), self.name, self.closed, std::string(name_of(self.gears)),
                        direction_of_zone(self), self.cost, self.body);
}

Zone zone_from_state(const py::tuple& state) {
  return made_zone(state[0], state[1].cast<std::string>(), state[2].cast<bool>(),
                   state[3].cast<std::string>(), state[4].cast<Direction>(),
                   state[5].cast<double>(), state[6].cast<std::optional<double>>(),
                   state[7].cast<bool>());
}

}  // namespace

void bind_zone(py::module_& module) {
  py::class_<Zone>(module, "Zone", R"(Zone(area, *, name="", closed=False, gears="both",
    direction=None, cost=1, max_speed=None, body=False)

Ground with rules of its own. They hold while the midpoint of the rear axle is in the area.

- `area`: simple polygon [m], shape (N, 2); its edge belongs to it.
- `name`: name for messages.
- `closed`: whether the vehicle may not be there at all.
- `gears`: gears that may be driven there: "both", "forward" or "reverse".
- `direction`: first and last allowed direction of travel, counter-clockwise [rad]. That is the
  heading, in reverse turned by half a turn.
- `cost`: how many times as much a metre costs there; 1 to 1000.
- `max_speed`: largest speed there, in either gear [m/s].
- `body`: whether the rules hold while any part of the vehicle or its trailer is in the area.

Raises InputError for gears of another name; `Scenario` checks the rest.)")
      .def(py::init(&made_zone), "area"_a, py::kw_only(), "name"_a = "", "closed"_a = false,
           "gears"_a = "both", "direction"_a = py::none(), "cost"_a = 1.0,
           "max_speed"_a = py::none(), "body"_a = false)
      .def_property_readonly("area", &corners_of, "Corners of the area [m], shape (N, 2).")
      .def_readonly("name", &Zone::name, "Name for messages.")
      .def_readonly("closed", &Zone::closed, "Whether the vehicle may not be there at all.")
      .def_property_readonly(
          "gears", [](const Zone& self) { return std::string(name_of(self.gears)); },
          "Gears that may be driven there: \"both\", \"forward\" or \"reverse\".")
      .def_property_readonly("direction", &direction_of_zone,
                             "First and last direction of travel [rad]; or None.")
      .def_readonly("cost", &Zone::cost, "How many times as much a metre costs there.")
      .def_readonly("max_speed", &Zone::max_speed, "Largest speed there [m/s]; or None.")
      .def_readonly("body", &Zone::body, "Whether any part of the vehicle counts.")
      .def("__eq__", [](const Zone& self, const Zone& other) { return self == other; })
      .def("__eq__", [](const Zone&, const py::object&) { return false; })
      .def("__repr__",
           [](const Zone& self) {
             return fmt::format("<vandplan.Zone {}: {} corners>", self.name, self.area.size());
           })
      .def(py::pickle(&state_of_zone, &zone_from_state))
      .attr("__hash__") = py::none();
}

}  // namespace vandplan::python

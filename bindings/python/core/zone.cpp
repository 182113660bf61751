// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Zones and masks of a scenario.

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <utility>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/scenario.h"
#include "vandplan/input_error.h"
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
                        direction_of_zone(self), self.cost, self.max_speed, self.body);
}

Zone zone_from_state(const py::tuple& state) {
  return made_zone(state[0], state[1].cast<std::string>(), state[2].cast<bool>(),
                   state[3].cast<std::string>(), state[4].cast<Direction>(),
                   state[5].cast<double>(), state[6].cast<std::optional<double>>(),
                   state[7].cast<bool>());
}

using Percents = py::array_t<int, py::array::c_style | py::array::forcecast>;

Mask made_mask(const OccupancyGrid& map, std::optional<double> max_speed,
               std::optional<double> cost, const std::optional<Percents>& percents) {
  if (max_speed && cost)
    throw InputError("cost", "is given beside max_speed, expected one of them");
  Mask mask = max_speed ? speed_mask(map, *max_speed)
              : cost    ? cost_mask(map, *cost)
                        : Mask{"", map};
  if (!percents) return mask;
  if (percents->ndim() != 2 || percents->shape(0) != map.rows ||
      percents->shape(1) != map.columns) {
    throw InputError("percents", fmt::format("expected an array of {} rows and {} columns",
                                             map.rows, map.columns));
  }
  std::vector<std::uint8_t> values;
  for (py::ssize_t i = 0; i < percents->size(); ++i) {
    const int value = percents->data()[i];
    if (value > 100)
      throw InputError("percents", fmt::format("has {}, expected 100 or less", value));
    values.push_back(value < 0 ? Mask::unknown : static_cast<std::uint8_t>(value));
  }
  mask.percents = std::make_shared<const std::vector<std::uint8_t>>(std::move(values));
  return mask;
}

std::optional<double> max_speed_of(const Mask& self) {
  return self.use == MaskUse::max_speed ? std::optional(self.base) : std::nullopt;
}

std::optional<double> cost_of(const Mask& self) {
  return self.use == MaskUse::cost ? std::optional(100 * self.multiplier) : std::nullopt;
}

py::object percents_of(const Mask& self) {
  if (!self.percents) return py::none();
  py::array_t<std::int8_t> array({self.map.rows, self.map.columns});
  std::int8_t* out = array.mutable_data();
  for (const std::uint8_t percent : *self.percents) {
    *out++ = percent == Mask::unknown ? std::int8_t{-1} : static_cast<std::int8_t>(percent);
  }
  return array;
}

}  // namespace

py::tuple state_of_mask(const Mask& self) {
  return py::make_tuple(self.map_file, self.map, static_cast<int>(self.use), self.base,
                        self.multiplier, percents_of(self));
}

Mask mask_from_state(const py::tuple& state) {
  Mask mask = made_mask(state[1].cast<OccupancyGrid>(), std::nullopt, std::nullopt,
                        state[5].cast<std::optional<Percents>>());
  mask.map_file = state[0].cast<std::string>();
  mask.use = static_cast<MaskUse>(state[2].cast<int>());
  mask.base = state[3].cast<double>();
  mask.multiplier = state[4].cast<double>();
  return mask;
}

void bind_mask(py::module_& module) {
  py::class_<Mask>(module, "Mask", R"(Mask(map, *, max_speed=None, cost=None, percents=None)

A further map, such as Nav2's costmap filters have. Unknown cells and the ground outside say
nothing. Occupied cells are obstacles, unless a speed or cost is given; these hold while the
midpoint of the rear axle is in the cell.

- `map`: an `OccupancyGrid`.
- `max_speed`: in a cell that is occupied by p percent the largest speed is (1 - p / 100) times
  this [m/s]. 0 percent is no limit; 100 percent is refused.
- `cost`: a metre costs 1 + p / 100 times this in a cell that is occupied by p percent.
- `percents`: occupancy of all cells, whole numbers of shape (rows, columns), from 0 to 100;
  negative ones are unknown. By default occupied cells have 100 and free ones 0.

Raises InputError naming the argument that is wrong; `Scenario` checks the values.)")
      .def(py::init(&made_mask), "map"_a, py::kw_only(), "max_speed"_a = py::none(),
           "cost"_a = py::none(), "percents"_a = py::none())
      .def_readonly("map", &Mask::map, "The map, an `OccupancyGrid`.")
      .def_property_readonly("max_speed", &max_speed_of,
                             "Largest speed where nothing is occupied [m/s]; or None.")
      .def_property_readonly("cost", &cost_of, "What an occupied cell adds to the cost; or None.")
      .def_property_readonly("percents", &percents_of,
                             "Occupancy of all cells as a new array of int8, -1 unknown; or None.")
      .def("__repr__",
           [](const Mask& self) {
             return fmt::format("<vandplan.Mask of {}: {} x {} cells>", name_of(self.use),
                                self.map.rows, self.map.columns);
           })
      .def(py::pickle(&state_of_mask, &mask_from_state));
  py::implicitly_convertible<OccupancyGrid, Mask>();
}

void bind_zone(py::module_& module) {
  py::class_<Zone>(module, "Zone", R"(Zone(area, *, name="", closed=False, gears="both",
    direction=None, cost=1, max_speed=None, body=False)

An area with rules for driving in it. The rules hold while the midpoint of the rear axle is in the area.

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

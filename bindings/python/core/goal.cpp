// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Goals with more than one pose.

#include "bindings/python/core/goal.h"
#include "bindings/python/core/renamed.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/value.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

/// Interval from a number or a pair of numbers.
Interval interval_from(const py::object& given, const char* where) {
  const Numbers numbers = numbers_from(given, where);
  if (numbers.ndim() == 0) return {*numbers.data(), *numbers.data()};
  if (numbers.size() == 2) return {numbers.data()[0], numbers.data()[1]};
  throw InputError(where, "expected a number or a pair of them");
}

HeadingRange headings_from(const py::object& given) {
  if (py::isinstance<py::str>(given)) {
    const auto word = given.cast<std::string>();
    if (word == "any") return any_heading;
    throw InputError("heading", "is \"" + word + "\", expected any, a number or a pair of them");
  }
  const auto [from, to] = interval_from(given, "heading");
  return {from, to};
}

GoalRegion made_region(const py::object& x, const py::object& y, const py::object& heading,
                       const py::object& area, bool either_way, double curvature,
                       const py::object& hitch_angle, std::optional<bool> is_of_trailer,
                       double straight, std::optional<bool> of_trailer) {
  const auto trailer = renamed("is_of_trailer", is_of_trailer, "of_trailer", of_trailer);
  GoalRegion region{.heading = headings_from(heading),
                    .either_way = either_way,
                    .curvature = curvature,
                    .hitch_angle = interval_from(hitch_angle, "hitch_angle"),
                    .is_of_trailer = trailer.value_or(false),
                    .straight = straight};
  const bool has_area = !area.is_none();
  if (has_area != (x.is_none() && y.is_none()) || x.is_none() != y.is_none()) {
    throw InputError("area", "expected either x and y or an area");
  }
  if (has_area) {
    region.area = polygon_from(area, "area");
    if (region.area.empty()) throw InputError("area", "has 0 corners, expected at least 3");
  } else {
    region.x = interval_from(x, "x");
    region.y = interval_from(y, "y");
  }
  return region;
}

py::object number_or_pair(double least, double most) {
  if (least == most) return py::float_(least);
  return py::make_tuple(least, most);
}

py::object heading_of(const GoalRegion& region) {
  if (region.heading == any_heading) return py::str("any");
  return number_or_pair(region.heading.from, region.heading.to);
}

py::object area_of(const GoalRegion& region) {
  if (region.area.empty()) return py::none();
  return array_of(std::span<const Point>(region.area));
}

py::object place_of(const GoalRegion& region, const Interval& interval) {
  if (!region.area.empty()) return py::none();
  return number_or_pair(interval.least, interval.most);
}

py::tuple state_of_region(const GoalRegion& self) {
  return py::make_tuple(place_of(self, self.x), place_of(self, self.y), heading_of(self),
                        area_of(self), self.either_way, self.curvature,
                        number_or_pair(self.hitch_angle.least, self.hitch_angle.most),
                        self.is_of_trailer, self.straight);
}

GoalRegion region_from_state(const py::tuple& state) {
  return made_region(state[0], state[1], state[2], state[3], state[4].cast<bool>(),
                     state[5].cast<double>(), state[6], state[7].cast<bool>(),
                     state[8].cast<double>(), {});
}

std::string text_of_region(const GoalRegion& self) {
  const py::object place =
      self.area.empty() ? py::object(py::make_tuple(place_of(self, self.x), place_of(self, self.y)))
                        : py::object(py::str("an area"));
  return fmt::format("<vandplan.GoalRegion: {}, heading {}{}>", std::string(py::str(place)),
                     std::string(py::str(heading_of(self))),
                     self.either_way ? " or turned round" : "");
}

void bind_region(py::module_& module) {
  py::class_<GoalRegion> region(module, "GoalRegion",
                                R"(GoalRegion(x=None, y=None, heading="any", *,
    area=None, either_way=False, curvature=0, hitch_angle=0, is_of_trailer=False,
    straight=0)

Set of poses where a path may end: every place with every heading of the region.

Numbers may be pairs (first, second), which stand for all values between them.

- `x`, `y`: place of the midpoint of the rear axle [m].
- `area`: simple polygon in place of `x` and `y` [m], shape (N, 2).
- `heading`: heading [rad]; a pair runs counter-clockwise; "any": all headings.
- `either_way`: whether headings turned by half a turn are goals too.
- `curvature`: curvature that the wheels are turned to [1/m].
- `hitch_angle`: heading of the vehicle less that of its trailer [rad].
- `is_of_trailer`: whether place and heading are those of the trailer's axle.
- `straight`: length of the straight line with which a path ends, in either gear [m].

Raises InputError unless either `x` and `y` or `area` are given.)");
  region
      .def(py::init(&made_region), "x"_a = py::none(), "y"_a = py::none(), "heading"_a = "any",
           py::kw_only(), "area"_a = py::none(), "either_way"_a = false, "curvature"_a = 0.0,
           "hitch_angle"_a = 0.0, "is_of_trailer"_a = py::none(), "straight"_a = 0.0,
           "of_trailer"_a = py::none())
      .def_property_readonly(
          "x", [](const GoalRegion& self) { return place_of(self, self.x); },
          "x of the axle, a number or a pair [m]; None with an area.")
      .def_property_readonly(
          "y", [](const GoalRegion& self) { return place_of(self, self.y); },
          "y of the axle, a number or a pair [m]; None with an area.")
      .def_property_readonly("heading", &heading_of, "Heading, a number, a pair or \"any\" [rad].")
      .def_property_readonly("area", &area_of, "Corners of the area [m], shape (N, 2); or None.")
      .def_readonly("either_way", &GoalRegion::either_way,
                    "Whether headings turned by half a turn are goals too.")
      .def_readonly("curvature", &GoalRegion::curvature,
                    "Curvature that the wheels are turned to [1/m].")
      .def_property_readonly(
          "hitch_angle",
          [](const GoalRegion& self) {
            return number_or_pair(self.hitch_angle.least, self.hitch_angle.most);
          },
          "Heading of the vehicle less that of its trailer: a number or a pair [rad].")
      .def_readonly("is_of_trailer", &GoalRegion::is_of_trailer,
                    "Whether place and heading are those of the trailer's axle.")
      .def_readonly("straight", &GoalRegion::straight,
                    "Length of the straight line with which a path ends [m].")
      .def("__eq__", [](const GoalRegion& self, const GoalRegion& other) { return self == other; })
      .def("__eq__", [](const GoalRegion&, const py::object&) { return false; })
      .def("__repr__", &text_of_region)
      .def(py::pickle(&state_of_region, &region_from_state))
      .attr("__hash__") = py::none();
  add_old_property(region, "of_trailer", "is_of_trailer",
                   [](const GoalRegion& self) { return self.is_of_trailer; });
}

}  // namespace

std::vector<GoalRegion> goal_set_from(const py::handle& given) {
  if (py::isinstance<GoalRegion>(given)) return {given.cast<GoalRegion>()};
  std::vector<GoalRegion> set;
  if (!py::isinstance<py::sequence>(given) || py::isinstance<py::str>(given)) return set;
  const auto all = py::reinterpret_borrow<py::sequence>(given);
  for (const py::handle item : all) {
    if (!py::isinstance<GoalRegion>(item)) {
      if (set.empty()) return set;
      throw InputError("goal", "expected a pose, or GoalRegion objects only");
    }
    set.push_back(item.cast<GoalRegion>());
  }
  return set;
}

namespace {

/// Regions of a via: a pose, a `GoalRegion`, or a sequence of these.
std::vector<GoalRegion> regions_of_via(const py::object& given) {
  std::vector<GoalRegion> regions = goal_set_from(given);
  if (regions.empty()) regions.push_back(region_of_pose(pose_from(given, "via")));
  return regions;
}

void bind_via(py::module_& module) {
  py::class_<Via> via(module, "Via", R"(Via(any_of, *, stop=False)

What a path passes on its way to the goal.

- `any_of`: a pose [x, y, heading], a `GoalRegion`, or a sequence of `GoalRegion` objects.
- `stop`: whether the vehicle stands there, so that its gear may change and its wheels may turn.)");
  via.def(py::init([](const py::object& any_of, bool stop) {
            return Via{regions_of_via(any_of), stop};
          }),
          "any_of"_a, py::kw_only(), "stop"_a = false)
      .def_readonly("any_of", &Via::any_of, "Regions, of which the path passes one.")
      .def_readonly("stop", &Via::stop, "Whether the vehicle stands there.")
      .def("__eq__", [](const Via& self, const Via& other) { return self == other; })
      .def("__eq__", [](const Via&, const py::object&) { return false; })
      .def("__repr__",
           [](const Via& self) {
             return fmt::format("<vandplan.Via: {} region{}{}>", self.any_of.size(),
                                self.any_of.size() == 1 ? "" : "s", self.stop ? ", stop" : "");
           })
      .def(py::pickle([](const Via& self) { return py::make_tuple(self.any_of, self.stop); },
                      [](const py::tuple& state) {
                        return Via{state[0].cast<std::vector<GoalRegion>>(), state[1].cast<bool>()};
                      }))
      .attr("__hash__") = py::none();
  ValueClass<PassedVia> passed(module, "PassedVia", R"(Place where a path passes a via.)");
  passed.field("s", &PassedVia::s, "Driven distance since the start [m].")
      .field("pose", &PassedVia::pose, "Pose [x, y, heading] of the vehicle.");
  passed.pickled()
      .def("__eq__", [](const PassedVia& self, const PassedVia& other) { return self == other; })
      .def("__eq__", [](const PassedVia&, const py::object&) { return false; })
      .def("__repr__",
           [](const PassedVia& self) {
             return fmt::format("<vandplan.PassedVia: {:.3f} m, ({:.3f}, {:.3f}, {:.4f})>", self.s,
                                self.pose.x, self.pose.y, self.pose.heading);
           })
      .attr("__hash__") = py::none();
}

}  // namespace

std::vector<Via> via_from(const py::handle& given) {
  std::vector<Via> all;
  for (const py::handle item : py::reinterpret_borrow<py::iterable>(given)) {
    all.push_back(py::isinstance<Via>(item)
                      ? item.cast<Via>()
                      : Via{regions_of_via(py::reinterpret_borrow<py::object>(item)), false});
  }
  return all;
}

void bind_goal(py::module_& module) {
  bind_region(module);
  bind_via(module);
  ValueClass<ReachedGoal> reached(module, "ReachedGoal", R"(Goal of a set that a path ends at.)");
  reached.field("index", &ReachedGoal::index, "Index of the region in its set.")
      .field("pose", &ReachedGoal::pose, "Pose [x, y, heading] of the vehicle.");
  reached.pickled()
      .def("__eq__",
           [](const ReachedGoal& self, const ReachedGoal& other) { return self == other; })
      .def("__eq__", [](const ReachedGoal&, const py::object&) { return false; })
      .def("__repr__",
           [](const ReachedGoal& self) {
             return fmt::format("<vandplan.ReachedGoal: {}, ({:.3f}, {:.3f}, {:.4f})>", self.index,
                                self.pose.x, self.pose.y, self.pose.heading);
           })
      .attr("__hash__") = py::none();
}

}  // namespace vandplan::python

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Speeds along a path.

#include "vandplan/speed.h"

#include <fmt/format.h>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/result.h"
#include "vandplan/input_error.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

/// A drive: speeds with the path and the vehicle that they belong to.
struct PathDrive {
  Path path;
  Vehicle vehicle;
  SpeedProfile profile;
};

py::dict columns_of(const std::vector<Motion>& motions) {
  py::dict columns;
  const auto add = [&](const char* name, auto value_of) {
    py::array_t<decltype(value_of(motions[0]))> array(static_cast<py::ssize_t>(motions.size()));
    auto* out = array.mutable_data();
    for (const Motion& motion : motions) *out++ = value_of(motion);
    columns[name] = array;
  };
  add("t", [](const Motion& m) { return m.t; });
  add("s", [](const Motion& m) { return m.s; });
  add("x", [](const Motion& m) { return m.pose.x; });
  add("y", [](const Motion& m) { return m.pose.y; });
  add("heading", [](const Motion& m) { return m.pose.heading; });
  add("curvature", [](const Motion& m) { return m.curvature; });
  add("steering_angle", [](const Motion& m) { return m.steering_angle; });
  add("direction", [](const Motion& m) { return m.direction; });
  add("v", [](const Motion& m) { return m.v; });
  add("a", [](const Motion& m) { return m.a; });
  return columns;
}

py::dict motions_of(const PathDrive& self, double step) {
  expect_positive(step, "step");
  if (!(self.profile.duration / step < 1e8)) {
    throw InputError("step", "is too small: there would be more than 1e8 rows");
  }
  return columns_of(sampled(self.path, self.vehicle, self.profile, step));
}

py::dict motions_at(const PathDrive& self, const py::object& t) {
  const Numbers times = numbers_from(t, "t");
  std::vector<Motion> motions;
  for (py::ssize_t i = 0; i < times.size(); ++i) {
    motions.push_back(motion_at(self.path, self.vehicle, self.profile, times.data()[i]));
  }
  return columns_of(motions);
}

PathDrive drive_of(const py::object& path, const py::object& vehicle, double start_curvature) {
  if (!py::isinstance<RunResult>(path) && vehicle.is_none()) {
    throw InputError("vehicle", "is missing: a path does not say who drives it");
  }
  PathDrive drive{path_from(path), {}, {}};
  if (vehicle.is_none()) {
    const Scenario& scenario = path.cast<const RunResult&>().scenario.scenario();
    drive.vehicle = scenario.vehicle;
    start_curvature = scenario.curvatures.start;
  } else {
    drive.vehicle = vehicle_from(vehicle);
  }
  drive.profile = speed_profile(drive.path, drive.vehicle, {start_curvature});
  return drive;
}

}  // namespace

void bind_speed(py::module_& module) {
  py::class_<PathDrive>(module, "SpeedProfile", R"(The fastest drive along a path.)")
      .def_property_readonly(
          "duration", [](const PathDrive& self) { return self.profile.duration; },
          "Of the whole drive [s].")
      .def_property_readonly(
          "standing", [](const PathDrive& self) { return self.profile.standing; },
          "Time in which it stands and turns its wheels [s].")
      .def_property_readonly(
          "stops",
          [](const PathDrive& self) {
            py::list stops;
            for (const Stop& stop : self.profile.stops) {
              stops.append(py::dict("t"_a = stop.t, "s"_a = stop.s, "pause"_a = stop.pause));
            }
            return stops;
          },
          "Where it stands on its way: dicts of t [s], s [m] and pause [s].")
      .def("motions", &motions_of, "step"_a = 0.05, R"(motions(step=0.05) -> dict of arrays

Columns t [s], s [m], x, y, heading, curvature [1/m], steering_angle [rad], direction, v [m/s] and a
[m/s^2] at all multiples of `step` [s]; v is negative in reverse.)")
      .def("at", &motions_at, "t"_a, "at(t) -> dict of arrays\n\nThe same columns at these times.")
      .def("__repr__", [](const PathDrive& self) {
        return fmt::format("<vandplan.SpeedProfile: {:.2f} m in {:.2f} s, {} stops>",
                           length(self.path), self.profile.duration, self.profile.stops.size());
      });
  module.def("speed_profile", &drive_of, "path"_a, "vehicle"_a = py::none(),
             "start_curvature"_a = 0.0,
             R"(speed_profile(path, vehicle=None, start_curvature=0) -> SpeedProfile

The fastest drive along a `Path` of a vehicle, or along the path of a `Result`, within the limits of
the vehicle. It stands wherever the gear changes or the curvature jumps until the wheels are turned;
before the start they are turned to `start_curvature` [1/m].)");
}

}  // namespace vandplan::python

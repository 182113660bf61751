// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Simulated drives along a path, with controller or without feedback.

#include "bindings/python/core/driving.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/result.h"
#include "bindings/python/core/value.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

constexpr std::array moment_numbers = {
    std::pair{"t", &DriveMoment::t},
    std::pair{"s", &DriveMoment::s},
    std::pair{"v", &DriveMoment::v},
    std::pair{"steering_angle", &DriveMoment::steering_angle},
    std::pair{"wanted_steering", &DriveMoment::wanted_steering},
    std::pair{"wanted_acceleration", &DriveMoment::wanted_acceleration},
    std::pair{"lateral_error", &DriveMoment::lateral_error},
    std::pair{"heading_error", &DriveMoment::heading_error},
};

template <typename ValueOf>
py::array column_of(const std::vector<DriveMoment>& log, ValueOf value_of) {
  py::array_t<decltype(value_of(log[0]))> column(static_cast<py::ssize_t>(log.size()));
  auto* out = column.mutable_data();
  for (const DriveMoment& moment : log) *out++ = value_of(moment);
  return column;
}

DriveResult driven(const CheckedScenario& scenario, const py::object& given,
                   const py::kwargs& keywords) {
  DriveOptions options;
  py::dict rest(keywords);
  take_drive_options(rest, options);
  expect_nothing_left(rest);
  const Path path = path_from(given);
  const Problem& problem = scenario.problem();
  const py::gil_scoped_release release;
  return drive(problem, path, options);
}

ExecutableCheck execution_of(const CheckedScenario& scenario, const py::object& given) {
  const Path path = path_from(given);
  const Problem& problem = scenario.problem();
  const py::gil_scoped_release release;
  return executable(problem, path);
}

py::list controllers_list() {
  py::list all;
  for (const ControllerInfo& info : controllers()) {
    all.append(py::dict("name"_a = info.name, "summary"_a = info.summary,
                        "drives_reverse"_a = info.drives_reverse,
                        "steers_trailer"_a = info.steers_trailer));
  }
  return all;
}

void bind_parts(py::module_& module) {
  ValueClass<Contact> contact(
      module, "Contact",
      R"(First moment when a driven vehicle touches an obstacle or its rig folds up.)");
  contact.field("t", &Contact::t, "Time since the start [s].")
      .field("s", &Contact::s, "Distance along the planned path [m].")
      .field("pose", &Contact::pose, "Pose [x, y, heading] of the vehicle.")
      .field("what", &Contact::what, "What happens: \"the footprint hits obstacles[3]\".");
  contact.pickled().def("__repr__", [](const Contact& self) {
    return fmt::format("<vandplan.Contact: {} at t = {:.2f} s>", self.what, self.t);
  });
  ValueClass<TrailerDeviation> trailer(
      module, "TrailerDeviation",
      R"(Deviation of a trailer from its place behind a tractor that is exactly on the path.)");
  trailer
      .field("largest_lateral", &TrailerDeviation::largest_lateral,
             "Largest sideways distance of the midpoint of the trailer's axle [m].")
      .field("rms_lateral", &TrailerDeviation::rms_lateral,
             "Root mean square of the sideways distance of the trailer's axle [m].")
      .field("end_distance", &TrailerDeviation::end_distance,
             "Distance of the midpoint of the trailer's axle from its planned end [m].")
      .field("end_heading", &TrailerDeviation::end_heading,
             "Absolute difference of the trailer's heading at the end [rad].")
      .field("hitch_deviation", &TrailerDeviation::hitch_deviation,
             "How much larger the hitch angle became than on the path [rad].");
  trailer.pickled();
}

void bind_drive_result(py::module_& module) {
  ValueClass<DriveResult> drive(
      module, "DriveResult",
      R"(Result of a simulated drive; true if the vehicle arrived without contact.)");
  drive
      .field("has_arrived", &DriveResult::has_arrived, "Whether it stopped at the end of the path.")
      .field("duration", &DriveResult::duration, "Duration of the drive [s].")
      .field("planned_duration", &DriveResult::planned_duration,
             "Duration of the fastest drive with limits less the reserve [s].")
      .field("largest_lateral", &DriveResult::largest_lateral,
             "Largest distance of the rear axle from the path [m].")
      .field("rms_lateral", &DriveResult::rms_lateral,
             "Root mean square of the distance of the rear axle from the path [m].")
      .field("largest_heading", &DriveResult::largest_heading,
             "Largest difference from the heading of the path [rad].")
      .field("rms_heading", &DriveResult::rms_heading,
             "Root mean square of the difference from the heading of the path [rad].")
      .field("end_distance", &DriveResult::end_distance,
             "Distance of the rear axle from the end of the path [m].")
      .field("end_heading", &DriveResult::end_heading,
             "Absolute difference of the heading at the end of the path [rad].")
      .field("trailer", &DriveResult::trailer,
             "Deviation of the trailer, a `TrailerDeviation`; None without a trailer.")
      .field("outline_deviation", &DriveResult::outline_deviation,
             R"(Largest distance of the outline beyond its place on the path [m].

A path with a margin of at least that is driven without contact.)")
      .field("out_of_bounds", &DriveResult::out_of_bounds,
             "Largest distance of the rear axle outside the bounds [m].")
      .field(
          "clearance", &DriveResult::clearance,
          "Least distance from an obstacle [m]; infinite without obstacles within 1 km, 0 after a "
          "contact.")
      .field("contact", &DriveResult::contact, "The first `Contact`, or None.")
      .part([](const DriveResult& self) { return log_table(self.log); },
            [](DriveResult& self, const py::handle& table) { self.log = log_from(table); });
  drive.pickled()
      .def_property_readonly(
          "log", [](const DriveResult& self) { return log_columns(self.log); },
          R"(Motion every 0.02 s as a dict of arrays; the arrays are empty without keep_log=True.

Keys: t [s], s [m], x, y, heading, direction, v [m/s], steering_angle and wanted_steering [rad],
wanted_acceleration [m/s^2], lateral_error [m], heading_error and hitch_angle [rad].)")
      .def("__bool__", [](const DriveResult& self) { return self.has_arrived && !self.contact; })
      .def("__repr__", [](const DriveResult& self) {
        const char* const arrived = self.has_arrived ? "arrived" : "did not arrive";
        return fmt::format("<vandplan.DriveResult: {}, {:.2f} s, {:.3f} m beside the path{}>",
                           arrived, self.duration, self.largest_lateral,
                           self.contact ? ", " + self.contact->what : "");
      });
}

void bind_executable(py::module_& module) {
  ValueClass<Execution> execution(
      module, "Execution", R"(Result of driving a path without feedback; true if it passes.)");
  execution
      .field("passes", &Execution::passes,
             "Whether the vehicle touches nothing and ends within 1 cm and 1 degree.")
      .field("reason", &Execution::reason, "Why it does not pass; empty if it passes.")
      .field("duration", &Execution::duration, "Duration of the drive [s].")
      .field("end_distance", &Execution::end_distance, "Distance from the end of the path [m].")
      .field("end_heading", &Execution::end_heading,
             "Absolute difference of the heading at the end of the path [rad].");
  execution.pickled().def("__bool__", [](const Execution& self) { return self.passes; });
  ValueClass<ExecutableCheck> check(module, "ExecutableCheck",
                                    R"(Two drives of one path without feedback.)");
  check
      .field("flowing", &ExecutableCheck::flowing,
             "The `Execution` that stops only at start, goal and gear changes.")
      .field("pausing", &ExecutableCheck::pausing,
             "The `Execution` that also stops at jumps of the curvature.")
      .field("jumps", &ExecutableCheck::jumps,
             "Number of curvature jumps, without those at the start and at gear changes.");
  check.pickled();
}

}  // namespace

py::array_t<double> log_table(const std::vector<DriveMoment>& log) {
  constexpr py::ssize_t width = moment_numbers.size() + 5;
  py::array_t<double> table({static_cast<py::ssize_t>(log.size()), width});
  double* out = table.mutable_data();
  for (const DriveMoment& m : log) {
    for (const auto& [name, member] : moment_numbers) *out++ = m.*member;
    const double missing = std::numeric_limits<double>::quiet_NaN();
    for (const double number :
         {m.pose.x, m.pose.y, m.pose.heading, static_cast<double>(direction_of(m.gear)),
          m.hitch_angle.value_or(missing)}) {
      *out++ = number;
    }
  }
  return table;
}

std::vector<DriveMoment> log_from(const py::handle& given) {
  const Numbers table = numbers_from(given, "pickle");
  std::vector<DriveMoment> log(static_cast<std::size_t>(table.shape(0)));
  const double* in = table.data();
  for (DriveMoment& m : log) {
    for (const auto& [name, member] : moment_numbers) m.*member = *in++;
    m.pose = {in[0], in[1], in[2]};
    m.gear = gear_of(in[3]);
    if (!std::isnan(in[4])) m.hitch_angle = in[4];
    in += 5;
  }
  return log;
}

py::dict log_columns(const std::vector<DriveMoment>& log) {
  py::dict columns;
  for (const auto& [name, member] : moment_numbers) {
    columns[name] = column_of(log, [of = member](const DriveMoment& m) { return m.*of; });
  }
  columns["x"] = column_of(log, [](const DriveMoment& m) { return m.pose.x; });
  columns["y"] = column_of(log, [](const DriveMoment& m) { return m.pose.y; });
  columns["heading"] = column_of(log, [](const DriveMoment& m) { return m.pose.heading; });
  columns["direction"] = column_of(log, [](const DriveMoment& m) { return direction_of(m.gear); });
  columns["hitch_angle"] = column_of(log, [](const DriveMoment& m) {
    return m.hitch_angle.value_or(std::numeric_limits<double>::quiet_NaN());
  });
  return columns;
}

void take_drive_options(py::dict& keywords, DriveOptions& options) {
  take(keywords, "controller", options.controller);
  take(keywords, "noise", options.noise);
  take(keywords, "delay", options.delay);
  take(keywords, "reserve", options.reserve);
  take(keywords, "spare_steering", options.spare_steering);
  take(keywords, "seed", options.seed);
  take(keywords, "keep_log", options.keep_log);
}

void expect_nothing_left(const py::dict& keywords) {
  for (const auto& [name, value] : keywords) {
    throw InputError(py::str(name), "is an unknown keyword");
  }
}

void bind_driving(py::module_& module) {
  bind_parts(module);
  bind_drive_result(module);
  bind_executable(module);
  module.def("drive", &driven, "scenario"_a, "path"_a,
             R"(drive(scenario, path, *, controller="", noise=0.0, delay=0.0, reserve=0.1,
    spare_steering=0.0, seed=1, keep_log=False) -> DriveResult

Simulates a vehicle that drives a path from standstill to standstill, and tests all that it sweeps.

`path` is a `Path`, or a `SpeedProfile` or `Result` of which only the path is used. Moving obstacles
are ignored. The result repeats bit for bit.

- `controller`: one of `controllers()`; empty: "rear-axle-feedback", with a trailer "lqr".
- `noise`: scale of the errors of sensors and actuators, 0 to 10.
- `delay`: delay from a measurement to its effect [s], 0 to 1.
- `reserve`: share of the limits that planned speeds leave for corrections, 0 to 0.5.
- `spare_steering`: share by which the wheels turn further than min_turning_radius, 0 to 0.5.
- `seed`: seed of the noise.
- `keep_log`: fills `DriveResult.log`.

Raises InputError naming a keyword that is wrong or unknown.)");
  module.def("executable", &execution_of, "scenario"_a, "path"_a,
             R"(executable(scenario, path) -> ExecutableCheck

Drives a path without feedback, by the criterion of CommonParking (2026).

`path` is a `Path`, or a `SpeedProfile` or `Result` of which only the path is used. The speed is
that of the fastest drive; the wheels turn as fast as they can to where they should be.)");
  module.def("controllers", &controllers_list, R"(controllers() -> list of dict

All controllers of `drive`, each a dict of name, summary, drives_reverse and steers_trailer.)");
}

}  // namespace vandplan::python

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// A vehicle that drives a path: simulated, or without looking.

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
  ValueClass<Contact> contact(module, "Contact",
                              R"(The moment when a vehicle touches something first.)");
  contact.field("t", &Contact::t, "Time since the start [s].")
      .field("s", &Contact::s, "Distance along the planned path [m].")
      .field("pose", &Contact::pose, "Pose of the vehicle.")
      .field("what", &Contact::what, "What happens: \"the footprint hits obstacles[3]\".");
  contact.pickled().def("__repr__", [](const Contact& self) {
    return fmt::format("<vandplan.Contact: {} at t = {:.2f} s>", self.what, self.t);
  });
  ValueClass<TrailerDeviation> trailer(
      module, "TrailerDeviation",
      R"(How far a trailer is from where it would be behind a tractor that is on the path.)");
  trailer
      .field("largest_lateral", &TrailerDeviation::largest_lateral,
             "Largest distance of its axle's midpoint across its heading [m].")
      .field("rms_lateral", &TrailerDeviation::rms_lateral,
             "Root of the mean square of that distance [m].")
      .field("end_distance", &TrailerDeviation::end_distance,
             "Distance of its axle's midpoint from where it should end [m].")
      .field("end_heading", &TrailerDeviation::end_heading,
             "Difference of the heading there, without sign [rad].")
      .field("hitch_deviation", &TrailerDeviation::hitch_deviation,
             "How much further the rig folded up than on the path [rad].");
  trailer.pickled();
}

void bind_drive_result(py::module_& module) {
  ValueClass<DriveResult> drive(module, "DriveResult",
                                R"(What came of a drive; true if it arrived without contact.)");
  drive.field("has_arrived", &DriveResult::has_arrived, "Whether it stands at the end of the path.")
      .field("duration", &DriveResult::duration, "Duration of the drive [s].")
      .field("planned_duration", &DriveResult::planned_duration,
             "Duration of the fastest drive that leaves the reserve [s].")
      .field("largest_lateral", &DriveResult::largest_lateral,
             "Largest distance of the rear axle from the path [m].")
      .field("rms_lateral", &DriveResult::rms_lateral,
             "Root of the mean square of that distance [m].")
      .field("largest_heading", &DriveResult::largest_heading,
             "Largest difference of the headings [rad].")
      .field("rms_heading", &DriveResult::rms_heading,
             "Root of the mean square of that difference [rad].")
      .field("end_distance", &DriveResult::end_distance,
             "Distance of the rear axle from the end of the path [m].")
      .field("end_heading", &DriveResult::end_heading,
             "Difference of the heading there, without sign [rad].")
      .field("trailer", &DriveResult::trailer, "A `TrailerDeviation`; None without a trailer.")
      .field("outline_deviation", &DriveResult::outline_deviation, R"(Which margin is enough [m].

How far the outline was beyond where it would be on the path.)")
      .field("out_of_bounds", &DriveResult::out_of_bounds,
             "How far the rear axle was outside of the bounds [m].")
      .field("clearance", &DriveResult::clearance,
             "Least distance from anything [m]; infinite without obstacles.")
      .field("contact", &DriveResult::contact, "The first `Contact`, or None.")
      .part([](const DriveResult& self) { return log_table(self.log); },
            [](DriveResult& self, const py::handle& table) { self.log = log_from(table); });
  drive.pickled()
      .def_property_readonly(
          "log", [](const DriveResult& self) { return log_columns(self.log); },
          R"(Columns of the drive every 0.02 s, if they were asked for with keep_log=True.

t [s], s [m], x, y, heading, direction, v [m/s], steering_angle and wanted_steering [rad],
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
  ValueClass<Execution> execution(module, "Execution",
                                  R"(How a path is driven without looking; true if it passes.)");
  execution
      .field("passes", &Execution::passes,
             "Whether it touches nothing and ends within 1 cm and 1 degree.")
      .field("reason", &Execution::reason, "Why it does not pass; or empty.")
      .field("duration", &Execution::duration, "Duration [s].")
      .field("end_distance", &Execution::end_distance, "Distance from the end of the path [m].")
      .field("end_heading", &Execution::end_heading,
             "Difference of the heading there, without sign [rad].");
  execution.pickled().def("__bool__", [](const Execution& self) { return self.passes; });
  ValueClass<ExecutableCheck> check(module, "ExecutableCheck",
                                    R"(Whether a path can be executed, driven in two ways.)");
  check
      .field("flowing", &ExecutableCheck::flowing,
             "The `Execution` that stands at start, goal and gear changes only.")
      .field("pausing", &ExecutableCheck::pausing,
             "The `Execution` that stands at jumps of the curvature, too.")
      .field("jumps", &ExecutableCheck::jumps,
             "Number of jumps of the curvature on the way, gear changes left out.");
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
         {m.pose.x, m.pose.y, m.pose.heading, static_cast<double>(m.direction),
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
    m.direction = static_cast<int>(in[3]);
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
  columns["direction"] = column_of(log, [](const DriveMoment& m) { return m.direction; });
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

Simulates a vehicle that drives a `Path`, a `SpeedProfile` or the path of a `Result` from standing to
standing, and looks at everything that it sweeps; it heeds nobody that moves. `controller` is one of
`controllers()`, or empty. `noise` scales the errors of sensors and actuators, 0 to 10; `delay` is
that from a measurement to what follows from it, 0 to 1 [s]. `reserve` is the share of the limits
that is left for corrections, `spare_steering` the share by which the wheels turn further than
min_turning_radius says; both 0 to 0.5. Repeats bit for bit.)");
  module.def("executable", &execution_of, "scenario"_a, "path"_a,
             R"(executable(scenario, path) -> ExecutableCheck

Whether a path can be driven without looking, by the criterion of CommonParking (2026).)");
  module.def("controllers", &controllers_list, R"(controllers() -> list of dict

All controllers that `drive` knows: name, summary, drives_reverse and steers_trailer.)");
}

}  // namespace vandplan::python

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Speeds along a path.

#include "vandplan/motion.h"

#include <fmt/format.h>

#include <array>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/drive.h"
#include "bindings/python/core/renamed.h"
#include "bindings/python/core/value.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

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
  add("direction", [](const Motion& m) { return direction_of(m.gear); });
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

/// Fastest drive of a vehicle along a path.
PathDrive fastest_drive(const Path& path, const Vehicle& vehicle, const SpeedOptions& options) {
  return {path, vehicle, speed_profile(path, vehicle, options)};
}

/// Drive of a vehicle that heeds nobody.
PathDrive drive_of(const py::object& vehicle, const py::object& path, double start_curvature) {
  if (py::isinstance<RunResult>(path) && planned_drive(path.cast<const RunResult&>())) {
    throw InputError("vehicle",
                     "is given, but the times of this result are those of its own "
                     "vehicle among what moves; pass result.path for others");
  }
  return fastest_drive(path_from(path), vehicle_from(vehicle),
                       {.start_curvature = start_curvature});
}

/// Drive of a scenario's vehicle: the planned one, if the path has times.
PathDrive drive_in(const Scenario& scenario, const py::object& path,
                   std::optional<double> start_curvature) {
  if (py::isinstance<RunResult>(path)) {
    if (auto planned = planned_drive(path.cast<const RunResult&>())) return *std::move(planned);
  }
  if (!scenario.moving.empty()) {
    throw InputError("path",
                     "has no times, and something moves in its scenario: pass its vehicle "
                     "for a drive that heeds nobody");
  }
  const Path given = path_from(path);
  SpeedOptions options = speed_options(scenario, given);
  if (start_curvature) options.start_curvature = *start_curvature;
  return fastest_drive(given, scenario.vehicle, options);
}

/// Drive by the arguments of version 0.2: speed_profile(path, vehicle=None, start_curvature=0).
PathDrive drive_by_old_order(const py::object& path, const py::object& vehicle,
                             std::optional<double> start_curvature) {
  warn(
      "speed_profile(path, vehicle) is now speed_profile(scenario, path) or "
      "speed_profile(vehicle, path)",
      PyExc_DeprecationWarning);
  if (!vehicle.is_none()) return drive_of(vehicle, path, start_curvature.value_or(0.0));
  if (!py::isinstance<RunResult>(path)) {
    throw InputError("vehicle", "is missing: a path does not say who drives it");
  }
  return drive_in(path.cast<const RunResult&>().scenario.scenario(), path, {});
}

PathDrive chosen_drive(const py::object& scenario, const py::object& path,
                       std::optional<double> start_curvature, const py::object& vehicle) {
  if (scenario.is_none()) return drive_by_old_order(path, vehicle, start_curvature);
  if (py::isinstance<Path>(scenario) || py::isinstance<PathDrive>(scenario) ||
      py::isinstance<RunResult>(scenario)) {
    return drive_by_old_order(scenario, path.is_none() ? vehicle : path, start_curvature);
  }
  if (!vehicle.is_none()) throw InputError("vehicle", "is that of the scenario");
  if (!py::isinstance<CheckedScenario>(scenario)) {
    return drive_of(scenario, path, start_curvature.value_or(0.0));
  }
  return drive_in(scenario.cast<const CheckedScenario&>().scenario(), path, start_curvature);
}

constexpr std::array knot_numbers = {&SpeedKnot::t, &SpeedKnot::s, &SpeedKnot::v, &SpeedKnot::a,
                                     &SpeedKnot::jerk};
constexpr std::array stop_numbers = {&Stop::t, &Stop::s, &Stop::pause, &Stop::curvature_before,
                                     &Stop::curvature_after};

/// Table with a row for each value and a column for each member.
template <typename Value, std::size_t size>
py::array_t<double> table_of(const std::vector<Value>& values,
                             const std::array<double Value::*, size>& members) {
  py::array_t<double> table({static_cast<py::ssize_t>(values.size()), py::ssize_t{size}});
  double* out = table.mutable_data();
  for (const Value& value : values) {
    for (const auto member : members) *out++ = value.*member;
  }
  return table;
}

template <typename Value, std::size_t size>
std::vector<Value> values_from(const py::handle& given,
                               const std::array<double Value::*, size>& members) {
  const Numbers table = numbers_from(given, "pickle");
  std::vector<Value> values(static_cast<std::size_t>(table.size()) / size);
  const double* number = table.data();
  for (Value& value : values) {
    for (const auto member : members) value.*member = *number++;
  }
  return values;
}

py::list stops_of(const PathDrive& self) {
  py::list stops;
  for (const Stop& stop : self.profile.stops) {
    stops.append(py::dict("t"_a = stop.t, "s"_a = stop.s, "pause"_a = stop.pause,
                          "curvature_before"_a = stop.curvature_before,
                          "curvature_after"_a = stop.curvature_after));
  }
  return stops;
}

py::dict knots_of(const PathDrive& self) {
  const std::vector<SpeedKnot>& knots = self.profile.knots;
  const py::array_t<double> table = table_of(knots, knot_numbers);
  py::dict columns;
  py::ssize_t column = 0;
  for (const char* const name : {"t", "s", "v", "a", "jerk"}) {
    columns[name] = table[py::make_tuple(py::ellipsis(), column++)];
  }
  py::list bounds;
  for (const SpeedKnot& knot : knots) bounds.append(name_of(knot.bound));
  columns["bound"] = bounds;
  return columns;
}

}  // namespace

std::optional<PathDrive> planned_drive(const RunResult& result) {
  const PlanResult& plan = result.record.result;
  if (!plan.path || !plan.speeds) return std::nullopt;
  return PathDrive{*plan.path, result.scenario.scenario().vehicle, *plan.speeds};
}

py::tuple profile_state(const SpeedProfile& profile) {
  std::vector<int> bounds;
  for (const SpeedKnot& knot : profile.knots) bounds.push_back(static_cast<int>(knot.bound));
  return py::make_tuple(table_of(profile.knots, knot_numbers), bounds,
                        table_of(profile.stops, stop_numbers), profile.duration, profile.standing);
}

SpeedProfile profile_from(const py::handle& given) {
  const auto state = py::reinterpret_borrow<py::tuple>(given);
  SpeedProfile profile{values_from(state[0], knot_numbers), values_from(state[2], stop_numbers),
                       state[3].cast<double>(), state[4].cast<double>()};
  const auto bounds = state[1].cast<std::vector<int>>();
  for (std::size_t i = 0; i < profile.knots.size(); ++i) {
    profile.knots[i].bound = static_cast<SpeedBound>(bounds.at(i));
  }
  return profile;
}

void bind_speed(py::module_& module) {
  ValueClass<PathDrive> drive(
      module, "SpeedProfile",
      R"(A drive: a path with times and speeds. At its end the vehicle stands.)");
  drive.field("path", &PathDrive::path, "Path that is driven.")
      .field("vehicle", &PathDrive::vehicle, "Vehicle that drives.")
      .field("start_speed", &PathDrive::start_speed, "Speed at the begin of the drive [m/s].")
      .part([](const PathDrive& self) { return profile_state(self.profile); },
            [](PathDrive& self, const py::handle& state) { self.profile = profile_from(state); });
  py::class_<PathDrive>& bound = drive.pickled();
  bound
      .def_property_readonly(
          "duration", [](const PathDrive& self) { return self.profile.duration; },
          "Duration of the whole drive [s].")
      .def_property_readonly(
          "standing", [](const PathDrive& self) { return self.profile.standing; },
          "Time during which the vehicle stands and turns its wheels [s].")
      .def_property_readonly("stops", &stops_of, R"(Stops on the way, each a dict.

Keys: t [s], s [m], pause [s], curvature_before and curvature_after [1/m].)")
      .def_property_readonly(
          "knots", &knots_of,
          R"(Knots of the speed profile, a dict of columns. Between knots the jerk is constant.

Keys: t [s], s [m], v [m/s], a [m/s^2], jerk [m/s^3], and bound, the limit until the next knot.)")
      .def("sampled", &motions_of, "step"_a = 0.05, R"(sampled(step=0.05) -> dict of arrays

Motion at start and goal, at begin and end of stops, and at multiples of `step` [s] between them.

The result is a dict of columns. Multiples within step/1000 of another time are left out.

Keys: t [s], s [m], x, y, heading, curvature [1/m], steering_angle [rad], direction, v [m/s], a
[m/s^2]. v is negative in reverse.)")
      .def("motion_at", &motions_at, "t"_a,
           "motion_at(t) -> dict of arrays\n\nMotion at these times [s], with the columns of "
           "`sampled`.")
      .def("__repr__", [](const PathDrive& self) {
        return fmt::format("<vandplan.SpeedProfile: {:.2f} m in {:.2f} s, {} stops>",
                           length(self.path), self.profile.duration, self.profile.stops.size());
      });
  add_old_method(bound, "motions", "sampled", "(step=0.05) -> dict of arrays", &motions_of,
                 "step"_a = 0.05);
  add_old_method(bound, "at", "motion_at", "(t) -> dict of arrays", &motions_at, "t"_a);
  module.def("speed_profile", &chosen_drive, "scenario"_a = py::none(), "path"_a = py::none(),
             "start_curvature"_a = py::none(), py::kw_only(), "vehicle"_a = py::none(),
             R"(speed_profile(scenario, path, start_curvature=None) -> SpeedProfile

Fastest drive along a `Path`, or along the path of a `Result`, within the limits of the vehicle.

The vehicle stops wherever the gear changes or the curvature jumps, until the wheels are turned.
`start_curvature` is the curvature that they are turned to before the start [1/m]; that of the
scenario by default. A `Result` that was planned among moving obstacles has a drive already,
`Result.speeds`, which is returned. A vehicle in place of the scenario heeds nobody.)");
}

}  // namespace vandplan::python

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// A vehicle that replans while it drives.

#include "vandplan/replanner.h"

#include <fmt/format.h>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/drive.h"
#include "bindings/python/core/driving.h"
#include "bindings/python/core/interrupt.h"
#include "bindings/python/core/replanner.h"
#include "bindings/python/core/scenario.h"
#include "bindings/python/core/value.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

Prediction prediction_named(const std::string& word) {
  for (const Prediction one : {Prediction::known, Prediction::constant_velocity}) {
    if (word == name_of(one)) return one;
  }
  throw InputError("prediction", "is \"" + word + "\", expected known or constant-velocity");
}

// ---- drives in a closed loop ----

std::function<void(const Action&)> callback_of(const py::object& function) {
  if (function.is_none()) return {};
  return [&function](const Action& action) {
    const py::gil_scoped_acquire lock;
    function(action_dict(action));
  };
}

LiveRun driven_live(const CheckedScenario& scenario, const py::kwargs& keywords) {
  LiveDriveOptions options;
  py::dict rest(keywords);
  std::string prediction{name_of(options.prediction)};
  double range = 0.0;
  const bool is_short_sighted = rest.contains("sensor_range") && !rest["sensor_range"].is_none();
  py::object on_action = py::none();
  take(rest, "period", options.period);
  take(rest, "sensor_range", range);
  take(rest, "prediction", prediction);
  take(rest, "horizon", options.horizon);
  take(rest, "longest", options.longest);
  take(rest, "action_rate", options.action_rate);
  take(rest, "on_action", on_action);
  const std::shared_ptr<SharedSiteTable> site = take_replan_options(rest, options.replan);
  take_drive_options(rest, options.drive);
  options.drive.reserve = options.replan.reserve;
  if (is_short_sighted) options.sensor_range = range;
  options.prediction = prediction_named(prediction);
  rest["seed"] = options.drive.seed;
  options.replan.plan = replanned_options(rest, scenario);
  LiveRun run;
  {
    const Interruptible interruptible;
    options.replan.plan.budget.stop = interruptible.stop();
    const auto report = callback_of(on_action);
    std::optional<Alone::Busy> busy;
    if (site) busy.emplace(site->alone);
    const Scenario& s = scenario.scenario();
    const py::gil_scoped_release release;
    static_cast<LiveDriveResult&>(run) = drive_live(s, options, report);
  }
  raise_signals();
  run.drive = {run.driven.path, scenario.scenario().vehicle, run.driven.speeds};
  run.driven = {};
  return run;
}

void bind_live_result(py::module_& module) {
  ValueClass<LiveRun> live(
      module, "LiveDriveResult",
      R"(Result of a drive with replanning; true if the vehicle arrived without contact.)");
  live.field("has_arrived", &LiveRun::has_arrived, "Whether the vehicle stopped at the goal.")
      .field("duration", &LiveRun::duration, "Duration of the drive [s].")
      .field("ticks", &LiveRun::ticks, "Number of planning steps.")
      .field("ticks_without_answer", &LiveRun::ticks_without_answer,
             "Number of ticks whose answer is not safe.")
      .field("stops", &LiveRun::stops, "Number of stops on the way.")
      .field("new_ways", &LiveRun::new_ways, "Number of ways after the first one.")
      .field("new_times", &LiveRun::new_times,
             "Number of times that the speeds changed along the same way.")
      .field("stopping_ticks", &LiveRun::stopping_ticks,
             "Number of ticks that found no drive to the goal.")
      .field("end_distance", &LiveRun::end_distance, "Distance of the rear axle from the goal [m].")
      .field("end_heading", &LiveRun::end_heading,
             "Absolute difference of the heading at the goal [rad].")
      .field("clearance", &LiveRun::clearance,
             "Least distance from standing obstacles [m]; or infinite.")
      .field("moving_clearance", &LiveRun::moving_clearance,
             "Least distance from moving obstacles [m]; or infinite.")
      .field("contact", &LiveRun::contact,
             "First `Contact` with a standing or moving obstacle, or None.")
      .field("driven", &LiveRun::drive,
             "Drive that took place, a `SpeedProfile` with arcs of 5 ms.")
      .part([](const LiveRun& self) { return log_table(self.log); },
            [](LiveRun& self, const py::handle& table) { self.log = log_from(table); });
  live.pickled()
      .def_property_readonly(
          "log", [](const LiveRun& self) { return log_columns(self.log); },
          "Motion of the vehicle with keep_log=True, as in `DriveResult.log`.")
      .def("__bool__", [](const LiveRun& self) { return self.has_arrived && !self.contact; })
      .def("__repr__", [](const LiveRun& self) {
        const char* const arrived = self.has_arrived ? "arrived" : "did not arrive";
        return fmt::format("<vandplan.LiveDriveResult: {}, {:.2f} s, {} ticks{}>", arrived,
                           self.duration, self.ticks,
                           self.contact ? ", " + self.contact->what : "");
      });
}

}  // namespace

void bind_live(py::module_& module) {
  bind_live_result(module);
  module.def(
      "drive_live", &driven_live, "scenario"_a,
      R"(drive_live(scenario, *, period=0.1, sensor_range=None, prediction="known", horizon=6.0,
    longest=600.0, controller="", noise=0.0, delay=0.0, spare_steering=0.0, reserve=0.1, committed=1.0,
    better=0.1, tick_iterations=100, tick_states=2000, site=None, action_rate=0.0, on_action=None,
    seed=1, keep_log=False, time_limit=None, max_iterations=None, **options) -> LiveDriveResult

Drives to the goal in a closed loop of replanning, controller and simulated vehicle.

The vehicle plans every `period` [s], a multiple of 0.02. It sees what is within `sensor_range` [m];
None: it knows all. It expects of moving obstacles the `prediction` "known", or "constant-velocity"
for `horizon` [s]. The drive ends after `longest` [s]. `on_action` is called `action_rate` times a
second with a dict of t, steering_angle, v and a. All other keywords are those of `drive`,
`Replanner` and `plan`. Without a `time_limit` the result repeats bit for bit.)");
}

}  // namespace vandplan::python

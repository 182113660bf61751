// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Python functions and classes of the judge.

#include "bindings/python/core/check.h"

#include <fmt/format.h>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/drive.h"
#include "bindings/python/core/value.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

constexpr const char* planned_times = "planned";
constexpr const char* fastest_times = "fastest";

Verdict with_drive(PathCheck path, const DriveCheck& drive, const char* times) {
  Verdict verdict{std::move(path), drive, times};
  if (!verdict.valid || drive.valid) return verdict;
  verdict.valid = false;
  verdict.reason = drive.reason;
  verdict.at = drive.at;
  if (times == fastest_times) {
    verdict.reason = "the path has no times; driven as fast as it may be, " + drive.reason;
  }
  return verdict;
}

/// Drive of the object that is checked; empty for a path without times.
std::optional<PathDrive> drive_from(const py::handle& given) {
  if (py::isinstance<PathDrive>(given)) return given.cast<PathDrive>();
  if (py::isinstance<RunResult>(given)) return planned_drive(given.cast<const RunResult&>());
  return std::nullopt;
}

Verdict judged(const Problem& problem, const Path& path, const PathClaims& claims,
               const std::optional<PathDrive>& given) {
  PathCheck checked = check_path(problem, path, claims);
  const bool has_times = given || !problem.task().moving.empty();
  if (!checked.valid || !has_times) return {std::move(checked)};
  const TimedPath drive =
      given ? given->timed()
            : TimedPath{path, speed_profile(path, problem.vehicle(), speed_options(problem, path))};
  const DriveClaims stated{.margin = claims.clearance.margin,
                           .start_speed = given ? given->start_speed : 0.0};
  return with_drive(std::move(checked), check_drive(problem, drive, stated),
                    given ? planned_times : fastest_times);
}

Verdict check(const CheckedScenario& scenario, const py::object& given, double margin,
              double margin_ramp, const std::string& steering, const std::string& gears) {
  const Path path = path_from(given);
  const std::optional<PathDrive> drive = drive_from(given);
  PathClaims claims{.clearance = {margin, margin_ramp},
                    .steering = steering_named(steering),
                    .gears = gears_named(gears)};
  if (py::isinstance<RunResult>(given)) claims = claims_of(given.cast<const RunResult&>());
  const Problem& problem = scenario.problem();
  const py::gil_scoped_release release;
  return judged(problem, path, claims, drive);
}

std::string verdict_text(const Verdict& self) {
  if (!self.valid) return fmt::format("<vandplan.PathCheck: {}>", self.reason);
  const char* const without_times =
      self.times == fastest_times ? ", without times: as the fastest drive" : "";
  return fmt::format("<vandplan.PathCheck: valid{}, {:.3f} m, clearance {:.3f} m>", without_times,
                     self.length, self.clearance.value_or(0.0));
}

void bind_drive_check(py::module_& module) {
  ValueClass<DriveCheck> drive(module, "DriveCheck",
                               R"(The judge's verdict on the times of a drive; true if valid.)");
  drive.field("valid", &DriveCheck::valid, "Whether the judge found no fault.")
      .field("reason", &DriveCheck::reason, "First fault; empty if valid.")
      .field("t", &DriveCheck::t, "Time of the fault [s]; None without one.")
      .field("at", &DriveCheck::at,
             "Place of the vehicle at the fault, as in `PathCheck.at`; None without one.")
      .field("duration", &DriveCheck::duration, "Duration of the drive [s].")
      .field("clearance", &DriveCheck::clearance,
             R"(Least distance from moving obstacles, during the drive and after it [m].

Infinite without moving obstacles; None if a fault was found before.)");
  drive.pickled()
      .def("__bool__", [](const DriveCheck& self) { return self.valid; })
      .def("__repr__", [](const DriveCheck& self) {
        if (!self.valid) return fmt::format("<vandplan.DriveCheck: {}>", self.reason);
        return fmt::format("<vandplan.DriveCheck: valid, {:.2f} s>", self.duration);
      });
}

void bind_path_check(py::module_& module) {
  ValueClass<Verdict> check(
      module, "PathCheck",
      R"(The judge's verdict on a path, and on its times if there are any; true if valid.)");
  check.field("valid", &Verdict::valid, "Whether the judge found no fault.")
      .field("reason", &Verdict::reason, "First fault; empty if valid.")
      .field("at", &Verdict::at,
             "Place of the fault: a dict of s [m], pose, curvature [1/m] and gear; or None.")
      .field(
          "hit", &Verdict::hit,
          R"(Object that is hit, or area that is left, if that is the fault: a dict; otherwise None.

"what" is a key of the scenario: "obstacles", "kerbs", "inside", "zones", "masks" (each with its
number as "index"), "map" or "bounds".)")
      .field("goal", &Verdict::goal,
             "Goal of a set that the path ends at, a `ReachedGoal`; None without a set of goals.")
      .field("via", &Verdict::via,
             "Where the path passes each via of the scenario, `PassedVia` objects.")
      .field("length", &Verdict::length, "Driven distance [m].")
      .field("reverse_length", &Verdict::reverse_length, "Distance driven in reverse [m].")
      .field("gear_changes", &Verdict::gear_changes, "Number of gear changes.")
      .field("largest_hitch_angle", &Verdict::largest_hitch_angle,
             "Largest absolute hitch angle [rad]; 0 without a trailer.")
      .field("curvature_change", &Verdict::curvature_change,
             "Total variation of the curvature [1/m].")
      .field("clearance", &Verdict::clearance, R"(Least distance from an obstacle [m].

Infinite without obstacles; None if a fault was found before.)")
      .field("drive", &Verdict::drive,
             "Verdict on the times, a `DriveCheck`; None if no times were judged.")
      .field("times", &Verdict::times,
             R"(Times that were judged: "planned", "fastest", or empty if none were judged.

"planned": those that came with the path. "fastest": the path came without times, and obstacles
move; the judge took those of the fastest drive.)");
  check.pickled()
      .def("__bool__", [](const Verdict& self) { return self.valid; })
      .def("__repr__", &verdict_text);
}

}  // namespace

std::optional<Verdict> verdict_of(const PlanResult& result) {
  if (!result.check) return std::nullopt;
  if (!result.drive_check) return Verdict{*result.check};
  return with_drive(*result.check, *result.drive_check, planned_times);
}

void bind_check(py::module_& module) {
  bind_drive_check(module);
  bind_path_check(module);
  module.def(
      "check", &check, "scenario"_a, "path"_a, py::kw_only(), "margin"_a = 0.0,
      "margin_ramp"_a = 0.0, "steering"_a = "reeds-shepp", "gears"_a = "both",
      R"(check(scenario, path, *, margin=0, margin_ramp=0, steering="reeds-shepp", gears="both") -> PathCheck

Checks a path with the independent judge.

`path` is one of:

- a `Path` or `SpeedProfile`. It must keep the `margin` [m], relaxed over `margin_ramp` [m] near a
  start or goal with less clearance. It must obey `steering` and `gears`.
- a `Result`. It must obey its own options, cost and bound; the keywords are ignored.

Times are judged too, if they come with the path or if obstacles move. A `Path` without times among
moving obstacles is judged as the fastest drive; `PathCheck.times` says so.)");
}

}  // namespace vandplan::python

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The judge.

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

/// The times that were handed over; none with a bare path.
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
            : TimedPath{path, speed_profile(path, problem.vehicle(),
                                            {.start_curvature = problem.curvatures().start})};
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
  drive.field("valid", &DriveCheck::valid, "Whether nothing is wrong.")
      .field("reason", &DriveCheck::reason, "The first thing found wrong; or empty.")
      .field("t", &DriveCheck::t, "When it is wrong [s]; or None.")
      .field("at", &DriveCheck::at, "Where the vehicle is then, as in `PathCheck.at`; or None.")
      .field("duration", &DriveCheck::duration, "Duration of the drive [s].")
      .field("clearance", &DriveCheck::clearance,
             R"(Least distance from anything that moves, on the way or ever after [m].

Infinite if nothing moves; None if the times were found wrong before.)");
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
      R"(The judge's verdict on a path and, where something moves, on its times; true if valid.)");
  check.field("valid", &Verdict::valid, "Whether nothing is wrong.")
      .field("reason", &Verdict::reason, "The first thing found wrong; or empty.")
      .field("at", &Verdict::at,
             "Where it is wrong: a dict of s, pose, curvature and direction; or None.")
      .field("hit", &Verdict::hit,
             R"(What is hit or left, if that is what is wrong: a dict; or None.

"what" is the key of the scenario: "obstacles", "kerbs", "inside" (then "index" is its number), "map"
or "bounds".)")
      .field("goal", &Verdict::goal,
             "The goal that the path ends at, a `ReachedGoal`; None without a set of goals.")
      .field("length", &Verdict::length, "Driven distance [m].")
      .field("reverse_length", &Verdict::reverse_length, "Distance driven in reverse [m].")
      .field("gear_changes", &Verdict::gear_changes, "How often the direction changes.")
      .field("largest_hitch_angle", &Verdict::largest_hitch_angle,
             "Largest angle between vehicle and trailer, absolute [rad]; 0 without a trailer.")
      .field("curvature_change", &Verdict::curvature_change,
             "Total variation of the curvature [1/m].")
      .field("clearance", &Verdict::clearance, R"(Least distance from an obstacle [m].

Infinite without obstacles; None if something was wrong before.)")
      .field("drive", &Verdict::drive,
             "The verdict on the times, a `DriveCheck`; None where nothing moves.")
      .field("times", &Verdict::times, R"(Which times were judged where something moves.

"planned": those that came with the path. "fastest": the path has none, so it was driven as fast as
the vehicle may. Empty where nothing moves.)");
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

Lets the independent judge look at a `Path` or a `SpeedProfile`, which has to keep the margin,
steer and be driven in gears as is said, or at a `Result`, which is held to its own options, cost, bound and times. Where
something moves the times are judged, too. A bare `Path` has none: it is driven as fast as the
vehicle may, and the verdict says so.)");
}

}  // namespace vandplan::python

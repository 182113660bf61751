// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "bindings/python/core/result.h"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <cmath>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/check.h"
#include "bindings/python/core/drive.h"
#include "bindings/python/core/options.h"
#include "bindings/python/core/renamed.h"
#include "vandplan/draw.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/recording.h"

namespace vandplan::python {
namespace {

using namespace py::literals;
using FileName = std::filesystem::path;  // Accepts str and os.PathLike.

const PlanResult& plan_of(const RunResult& self) { return self.record.result; }

std::optional<double> result_cost(const RunResult& self) {
  if (!plan_of(self).path) return std::nullopt;
  return plan_of(self).cost;
}

std::optional<double> result_gap(const RunResult& self) {
  const PlanResult& result = plan_of(self);
  if (!result.path || !result.lower_bound) return std::nullopt;
  return result.cost / *result.lower_bound - 1.0;
}

py::array_t<double> result_anytime(const RunResult& self) {
  const std::vector<CostSample>& samples = plan_of(self).anytime;
  py::array_t<double> array({static_cast<py::ssize_t>(samples.size()), py::ssize_t{3}});
  double* out = array.mutable_data();
  for (const CostSample& sample : samples) {
    *out++ = sample.time;
    *out++ = static_cast<double>(sample.iteration);
    *out++ = sample.cost;
  }
  return array;
}

py::object result_tree(const RunResult& self) {
  const std::optional<TreeSnapshot>& tree = plan_of(self).tree;
  if (!tree) return py::none();
  py::array_t<std::int32_t> parents(static_cast<py::ssize_t>(tree->parents.size()));
  std::ranges::copy(tree->parents, parents.mutable_data());
  return py::make_tuple(array_of(std::span<const Pose>(tree->poses)), parents);
}

py::dict counters_of(const RunResult& self) {
  py::dict counters;
  for (const auto& [name, value] : plan_of(self).counters) counters[name.c_str()] = value;
  return counters;
}

py::dict phases_of(const RunResult& self) {
  py::dict phases;
  for (const auto& [name, seconds] : plan_of(self).phases) phases[name.c_str()] = seconds;
  return phases;
}

std::string result_text(const RunResult& self) {
  const PlanResult& result = plan_of(self);
  if (!result.path) {
    const std::string why = result.reason.empty() ? "" : ", " + result.reason;
    return fmt::format("<vandplan.Result: {}{}>", name_of(result.status), why);
  }
  const std::optional<double> gap = result_gap(self);
  const std::string proven = gap ? fmt::format(", gap {:.1f} %", 100 * *gap) : "";
  const bool is_time = self.record.options.cost.measure == CostMeasure::time;
  return fmt::format(
      "<vandplan.Result: {}, {:.2f} m, gear changes: {}, cost {:.2f} {}{}, {:.3g} s>",
      name_of(result.status), length(*result.path), gear_changes(*result.path), result.cost,
      is_time ? "s" : "m", proven, result.time_total);
}

std::string picture_of(const CheckedScenario& scenario, const RunResult* result,
                       PictureFormat format, int width) {
  const Drawing drawing = drawing_of(scenario, result);
  const py::gil_scoped_release release;
  return vandplan::draw(drawing, format, width);
}

RunResult result_in(py::object given, py::object file) {
  if (py::isinstance<CheckedScenario>(file)) {
    std::swap(given, file);
    warn("read_result(file, scenario) is now read_result(scenario, file)",
         PyExc_DeprecationWarning);
  }
  const auto& scenario = given.cast<const CheckedScenario&>();
  std::vector<ResultRecord> records = read_results(file.cast<FileName>().string(), scenario.file());
  return RunResult{scenario, nullptr, std::move(records.front())};
}

void draw_to(const CheckedScenario& scenario, const RunResult* result, const FileName& file,
             int width) {
  const PictureFormat format = picture_format(file.string());
  write_file(file.string(), picture_of(scenario, result, format, width));
}

/// A drive of `drive` or `drive_live` as it is recorded; none for None.
std::optional<RecordedDrive> recorded_drive(const py::object& given) {
  const auto of = [](const auto& drive) {
    if (drive.log.empty()) throw InputError("drive", "has no log, expected keep_log=True");
    return RecordedDrive{drive.log, drive.has_arrived, drive.contact};
  };
  if (given.is_none()) return std::nullopt;
  if (py::isinstance<DriveResult>(given)) return of(given.cast<const DriveResult&>());
  if (py::isinstance<LiveRun>(given)) return of(given.cast<const LiveRun&>());
  throw InputError("drive", "expected a DriveResult or a LiveDriveResult");
}

void record_to(const CheckedScenario& scenario, const RunResult* result, const FileName& file,
               const py::object& drive) {
  const Recording recording{.scenario = &scenario.scenario(),
                            .plan = result == nullptr ? nullptr : &plan_of(*result),
                            .drive = recorded_drive(drive)};
  const py::gil_scoped_release release;
  record(file.string(), recording);
}

void bind_result_class(py::module_& module) {
  py::class_<RunResult> result(module, "Result", R"(Result of a run; true if there is a path.)");
  const auto property = [&](const char* name, auto get, const char* about) {
    result.def_property_readonly(
        name, [get](const RunResult& self) { return get(plan_of(self)); }, about);
  };
  property(
      "status", [](const PlanResult& r) { return name_of(r.status); },
      R"("solved", or why there is no path: "start_in_collision", "goal_in_collision",
"iteration_limit", "node_limit", "time_limit", "stopped", "no_path" (proven), "rejected".)");
  property(
      "reason", [](const PlanResult& r) { return r.reason; },
      "Why there is no path, one line; empty if there is one.");
  property(
      "hit", [](const PlanResult& r) { return r.hit; },
      R"(Object that a start or goal in collision hits: a dict; otherwise None.

"what" is a key of the scenario: "obstacles", "kerbs", "inside", "zones" or "masks" (each with
its number as "index"), "map" (with the middle of the cell [m] as "cell") or "bounds".)");
  property(
      "path", [](const PlanResult& r) { return r.path; }, "The path, or None.");
  property(
      "goal", [](const PlanResult& r) { return r.goal; },
      "Goal of a set that the path ends at, a `ReachedGoal`; None without a set of goals.");
  property(
      "via", [](const PlanResult& r) { return r.via; },
      "Where the path passes each via of the scenario, `PassedVia` objects.");
  property(
      "lower_bound", [](const PlanResult& r) { return r.lower_bound; },
      "Proven lower bound on the cost of all paths, in the unit of `cost`; None if nothing is "
      "proven.");
  property(
      "time_total", [](const PlanResult& r) { return r.time_total; }, "Time in the planner [s].");
  add_old_property(result, "bound", "lower_bound",
                   [](const RunResult& self) { return plan_of(self).lower_bound.value_or(0.0); });
  add_old_property(result, "time", "time_total",
                   [](const RunResult& self) { return plan_of(self).time_total; });
  add_old_property(result, "trace", "anytime", &result_anytime);
  property(
      "iterations", [](const PlanResult& r) { return r.iterations; }, "Iterations of the planner.");
  property("check", &verdict_of,
           "Verdict of the judge, a `PathCheck`, also for a rejected path; None without one.");
  result
      .def_property_readonly(
          "cost", &result_cost,
          "Cost of the path [m], or [s] if the cost is the time; None without a path.")
      .def_property_readonly("speeds", &planned_drive,
                             R"(Planned speeds, a `SpeedProfile`.

None if the planner left the times open, as it does without moving obstacles.)")
      .def_property_readonly("gap", &result_gap,
                             "Optimality gap, cost / lower_bound - 1; None if nothing is proven.")
      .def_property_readonly(
          "anytime", &result_anytime,
          "Rows [time, iteration, cost], one for each better path; shape (N, 3).")
      .def_property_readonly("counters", &counters_of, "Counters of the planner by name.")
      .def_property_readonly("phases", &phases_of,
                             "Seconds in each phase, with the option profile.")
      .def_property_readonly("tree", &result_tree, "Search tree as (poses, parents), or None.")
      .def_property_readonly("options", &result_options,
                             "Options that were in force by name; None if they are unknown.")
      .def_property_readonly(
          "planner", [](const RunResult& self) { return self.record.planner; },
          "Name of the planner.")
      .def_property_readonly(
          "scenario", [](const RunResult& self) { return self.scenario; }, "Scenario of the run.")
      .def(
          "save",
          [](const RunResult& self, const FileName& file) {
            write_results(file.string(), self.scenario.file(), {self.record});
          },
          "file"_a,
          "save(file)\n\nWrites a result file for the command line: binary if the name ends in "
          ".vpr, "
          "otherwise JSON.")
      .def("__bool__", [](const RunResult& self) { return plan_of(self).path.has_value(); })
      .def("__repr__", &result_text)
      .def("_repr_png_", [](const RunResult& self) {
        return py::bytes(picture_of(self.scenario, &self, PictureFormat::png, 700));
      });
  pickle_result(result);
}

}  // namespace

py::object result_options(const RunResult& result) {
  if (!result.planner) return result.known_options;
  return dict_of(*result.planner, result.record.options);
}

PathClaims claims_of(const RunResult& result) {
  if (!result.planner) return result.record.claims;
  const PlanOptions& options = result.record.options;
  const PlanResult& plan = result.record.result;
  return {
      .cost = StatedCost{.cost = plan.cost, .rule = options.cost, .lower_bound = plan.lower_bound},
      .clearance = options.clearance,
      .steering = options.steering.value_or(Steering::reeds_shepp),
      .gears = options.cost.gears,
      .goal = plan.goal};
}

Drawing drawing_of(const CheckedScenario& scenario, const RunResult* result) {
  Drawing drawing{.scenario = &scenario.scenario()};
  if (result == nullptr) return drawing;
  const PlanResult& plan = plan_of(*result);
  if (plan.path) drawing.path = &*plan.path;
  if (plan.path && plan.speeds) drawing.speeds = &*plan.speeds;
  if (plan.tree) drawing.tree = &*plan.tree;
  drawing.hit = plan.hit;
  return drawing;
}

const Path& path_from(const py::handle& given) {
  if (py::isinstance<Path>(given)) return given.cast<const Path&>();
  if (py::isinstance<PathDrive>(given)) return given.cast<const PathDrive&>().path;
  if (!py::isinstance<RunResult>(given)) {
    throw InputError("path", "expected a Path, a SpeedProfile or a Result");
  }
  const PlanResult& result = plan_of(given.cast<const RunResult&>());
  if (result.path) return *result.path;
  throw InputError("path", "there is none, the result is " + std::string(name_of(result.status)));
}

void bind_result(py::module_& module) {
  bind_result_class(module);
  module.def("draw", &draw_to, "scenario"_a, "result"_a.none(true), "file"_a, "width"_a = 800,
             R"(draw(scenario, result, file, width=800)

Draws a scenario, and a result unless that is None, into a file (.png, .svg or .pdf).

`width` is in pixels or points. `plot` draws with matplotlib instead.)");
  module.def("record", &record_to, "scenario"_a, "result"_a.none(true), "file"_a,
             "drive"_a = py::none(), R"(record(scenario, result, file, drive=None)

Writes a recording for Foxglove or Lichtblick (.mcap).

`result` is a `Result` or None, `drive` a `DriveResult` or `LiveDriveResult` with a log
(keep_log=True). Without a drive the recording shows the run of the planner, and the fastest drive
along its path.)");
  module.def("read_result", &result_in, "scenario"_a, "file"_a,
             "read_result(scenario, file) -> Result\n\nReads a result file that belongs to this "
             "scenario.");
}

}  // namespace vandplan::python

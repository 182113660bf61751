// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// A replanner, and what it answers.

#include "vandplan/replanner.h"

#include <fmt/format.h>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/drive.h"
#include "bindings/python/core/driving.h"
#include "bindings/python/core/goal.h"
#include "bindings/python/core/interrupt.h"
#include "bindings/python/core/options.h"
#include "bindings/python/core/renamed.h"
#include "bindings/python/core/replanner.h"

namespace vandplan::python {

using namespace py::literals;

std::shared_ptr<SharedSiteTable> take_replan_options(py::dict& keywords, ReplanOptions& options) {
  take(keywords, "tick_iterations", options.tick_iterations);
  take(keywords, "tick_states", options.tick_states);
  take(keywords, "committed", options.committed);
  take(keywords, "better", options.better);
  take(keywords, "reserve", options.reserve);
  py::object site = py::none();
  take(keywords, "site", site);
  if (site.is_none()) return nullptr;
  if (!py::isinstance<SharedSiteTable>(site)) {
    throw InputError("site", "expected a ChangingSiteTable, which can be repaired");
  }
  const auto shared = site.cast<std::shared_ptr<SharedSiteTable>>();
  options.site = {shared, &shared->table};
  return shared;
}

PlanOptions replanned_options(py::dict& keywords, const CheckedScenario& scenario) {
  RunKeywords run;
  const auto take_limit = [&](const char* name, auto& limit) {
    typename std::remove_reference_t<decltype(limit)>::value_type value{};
    const bool is_given = keywords.contains(name) && !keywords[name].is_none();
    take(keywords, name, value);
    if (is_given) limit = value;
  };
  if (keywords.contains("time")) warn_of_old_name("time", "time_limit");
  take_limit("time", run.time_limit);
  take_limit("time_limit", run.time_limit);
  take_limit("max_iterations", run.max_iterations);
  take(keywords, "seed", run.seed);
  run.options = keywords;
  return options_for(default_planner(), scenario.options(), run, scenario.scenario().vehicle);
}

py::dict action_dict(const Action& action) {
  return py::dict("t"_a = action.t, "steering_angle"_a = action.steering_angle, "v"_a = action.v,
                  "a"_a = action.a);
}

namespace {

// ---- answers ----

/// Answer of a replanner, with its vehicle.
struct Answered {
  ReplanAnswer answer;
  Vehicle vehicle;
};

std::optional<PathDrive> answered_drive(const Answered& self) {
  if (!self.answer.drive) return std::nullopt;
  return PathDrive{self.answer.drive->path, self.vehicle, self.answer.drive->speeds,
                   self.answer.start_speed};
}

py::dict action_of(const Answered& self, double t) {
  if (!self.answer.drive) throw InputError("answer", "has no drive: nothing was planned yet");
  if (!std::isfinite(t)) throw InputError("t", "is not finite");
  return action_dict(action_at(self.answer, self.vehicle, t));
}

TickOutcome outcome_named(const std::string& word) {
  for (const TickOutcome one :
       {TickOutcome::kept, TickOutcome::new_times, TickOutcome::new_way, TickOutcome::stop}) {
    if (word == name_of(one)) return one;
  }
  return TickOutcome::none;
}

py::tuple answer_state(const Answered& self) {
  const ReplanAnswer& a = self.answer;
  return py::make_tuple(name_of(a.outcome), a.begin, answered_drive(self), a.start_speed,
                        a.reaches_goal, a.is_safe, a.reason, self.vehicle, a.has_arrived,
                        a.start_hitch_angle, a.without_site);
}

Answered answer_from_state(const py::tuple& state) {
  Answered self{{.outcome = outcome_named(state[0].cast<std::string>()),
                 .begin = state[1].cast<double>(),
                 .start_speed = state[3].cast<double>(),
                 .start_hitch_angle = state[9].cast<double>(),
                 .reaches_goal = state[4].cast<bool>(),
                 .has_arrived = state[8].cast<bool>(),
                 .is_safe = state[5].cast<bool>(),
                 .reason = state[6].cast<std::string>(),
                 .without_site = state[10].cast<std::string>()},
                state[7].cast<Vehicle>()};
  if (!state[2].is_none()) {
    self.answer.drive =
        std::make_shared<const TimedPath>(state[2].cast<const PathDrive&>().timed());
  }
  return self;
}

void bind_answer(py::module_& module) {
  py::class_<Answered> answer(module, "ReplanAnswer",
                              R"(Drive of a vehicle from now on; true if it is safe.)");
  const auto property = [&](const char* name, auto get, const char* about) {
    answer.def_property_readonly(
        name, [get](const Answered& self) { return get(self.answer); }, about);
  };
  property(
      "outcome", [](const ReplanAnswer& a) { return name_of(a.outcome); },
      R"("kept", "new_times" (along the same way), "new_way", "stop" or "none".

"stop": no drive to the goal was found, so the drive ends in an earlier standstill. "none": no safe
drive was found, so the vehicle brakes as hard as it can, or goes on if that touches something
later.)");
  property(
      "begin", [](const ReplanAnswer& a) { return a.begin; },
      "Time at which the drive begins, on the replanner's clock [s].");
  property(
      "start_hitch_angle", [](const ReplanAnswer& a) { return a.start_hitch_angle; },
      "Hitch angle with which the drive begins [rad]; 0 without a trailer.");
  property(
      "reaches_goal", [](const ReplanAnswer& a) { return a.reaches_goal; },
      "Whether the drive ends at the goal; otherwise it stops on the way.");
  property(
      "has_arrived", [](const ReplanAnswer& a) { return a.has_arrived; },
      "Whether the vehicle stands at the goal.");
  property(
      "is_safe", [](const ReplanAnswer& a) { return a.is_safe; },
      "Whether the rest of the drive touches no known obstacle, by the judge.");
  property(
      "reason", [](const ReplanAnswer& a) { return a.reason; },
      "Why the drive is not safe, or does not reach the goal; otherwise empty.");
  property(
      "without_site", [](const ReplanAnswer& a) { return a.without_site; },
      "Why this tick left the table of the site aside; otherwise empty.");
  answer
      .def_property_readonly(
          "drive", &answered_drive,
          "The drive, a `SpeedProfile` that begins at `begin`; None before the first tick.")
      .def("action_at", &action_of, "t"_a, R"(action_at(t) -> dict

Command at a time of the replanner's clock [s]: t, steering_angle [rad], v [m/s], a [m/s^2].)")
      .def("__bool__", [](const Answered& self) { return self.answer.is_safe; })
      .def("__repr__",
           [](const Answered& self) {
             return fmt::format("<vandplan.ReplanAnswer: {}, {}>", name_of(self.answer.outcome),
                                self.answer.is_safe ? "safe" : self.answer.reason);
           })
      .def(py::pickle(&answer_state, &answer_from_state));
}

// ---- the replanner ----

/// Replanner that only one thread at a time may call, and its table of the site with it.
struct OwnReplanner {
  Vehicle vehicle;
  Replanner replanner;
  std::shared_ptr<SharedSiteTable> site;
  Alone itself = Alone("replanner");

  /// Runs `work` without Python's lock. Throws InputError if another thread is at work.
  template <typename Work>
  void alone(Work work) {
    std::optional<Alone::Busy> busy;
    if (site) busy.emplace(site->alone);
    itself.run(work);
  }
};

std::shared_ptr<OwnReplanner> made_replanner(const CheckedScenario& scenario,
                                             const py::kwargs& keywords) {
  ReplanOptions options;
  py::dict rest(keywords);
  const std::shared_ptr<SharedSiteTable> site = take_replan_options(rest, options);
  options.plan = replanned_options(rest, scenario);
  const Scenario& s = scenario.scenario();
  std::optional<Alone::Busy> busy;
  if (site) busy.emplace(site->alone);
  const py::gil_scoped_release release;
  return std::make_shared<OwnReplanner>(OwnReplanner{s.vehicle, Replanner(s, options), site});
}

/// Rectangle of cells from a tuple (row, column, cells).
CellPatch cell_patch_from(const py::handle& given) {
  const auto parts = py::reinterpret_borrow<py::tuple>(given);
  if (!py::isinstance<py::tuple>(given) || parts.size() != 3) {
    throw InputError("cells", "expected tuples (row, column, 2-D array)");
  }
  constexpr double any_resolution = 1.0;
  const OccupancyGrid grid = grid_from(parts[2], any_resolution, py::make_tuple(0, 0, 0), false);
  return {.column = parts[1].cast<std::int32_t>(),
          .row = parts[0].cast<std::int32_t>(),
          .columns = grid.columns,
          .rows = grid.rows,
          .cells = *grid.cells};
}

void patch(OwnReplanner& self, const py::iterable& cells, const py::dict& added,
           const std::vector<std::int64_t>& removed) {
  WorldPatch changes{.removed = removed};
  for (const py::handle item : cells) changes.cells.push_back(cell_patch_from(item));
  for (const auto& [name, outline] : added) {
    changes.added.push_back({name.cast<std::int64_t>(), polygon_from(outline, "added")});
  }
  self.alone([&] { self.replanner.patch(changes); });
}

void set_goal(OwnReplanner& self, const py::object& goal) {
  const std::vector<GoalRegion> set = goal_set_from(goal);
  const Pose pose = set.empty() ? pose_from(goal, "goal") : Pose{};
  self.alone([&] {
    if (set.empty()) {
      self.replanner.set_goal(pose);
    } else {
      self.replanner.set_goal(set);
    }
  });
}

std::optional<VehicleState> vehicle_state(const py::object& pose, double v, double curvature,
                                          std::optional<double> hitch_angle) {
  if (pose.is_none()) {
    if (hitch_angle) throw InputError("hitch_angle", "is given without a pose, expected both");
    return std::nullopt;
  }
  const VehicleState state{pose_from(pose, "pose"), v, curvature, hitch_angle};
  for (const double number :
       {state.pose.x, state.pose.y, state.pose.heading, state.v, state.curvature}) {
    if (!std::isfinite(number)) throw InputError("pose, v, curvature", "are not finite");
  }
  return state;
}

Answered tick(OwnReplanner& self, double t, const py::object& pose, double v, double curvature,
              std::optional<double> hitch_angle, std::optional<double> time_limit) {
  if (!std::isfinite(t)) throw InputError("t", "is not finite");
  const std::optional<VehicleState> state = vehicle_state(pose, v, curvature, hitch_angle);
  Answered answered{{}, self.vehicle};
  {
    const Interruptible interruptible;
    const TickLimit limit{.time_limit = time_limit, .stop = interruptible.stop()};
    self.alone([&] {
      answered.answer =
          state ? self.replanner.tick(t, *state, limit) : self.replanner.tick(t, limit);
    });
  }
  raise_signals();
  return answered;
}

void bind_replanner(py::module_& module) {
  py::class_<OwnReplanner, std::shared_ptr<OwnReplanner>>(
      module, "Replanner",
      R"(Replanner(scenario, *, tick_iterations=100, tick_states=2000, committed=1.0, better=0.1,
    reserve=0.1, site=None, time_limit=None, max_iterations=None, seed=1, **options)

Replanner for one vehicle on its way to one goal, in a changing world.

The moving obstacles of the scenario are known from the start. Equal calls give equal answers, bit
for bit, unless a tick has a time limit. `options` are those of `plan`.

- `tick_iterations`, `tick_states`: work of a tick for ways, and for speeds among moving obstacles.
- `committed`: time for which a drive stays unchanged if possible [s].
- `better`: share by which a new way must be cheaper, 0 to 1.
- `reserve`: share of the limits left for corrections, 0.01 to 0.5.
- `site`: a `ChangingSiteTable`. Plans begin with its ways, and ticks repair it after patches.
- `time_limit` [s], `max_iterations`: budget of the first plan.)")
      .def(py::init(&made_replanner), "scenario"_a)
      .def("tick", &tick, "t"_a, "pose"_a = py::none(), py::kw_only(), "v"_a = 0.0,
           "curvature"_a = 0.0, "hitch_angle"_a = py::none(), "time_limit"_a = py::none(),
           R"(tick(t, pose=None, *, v=0.0, curvature=0.0, hitch_angle=None, time_limit=None)
    -> ReplanAnswer

Plans at time `t` [s] for a vehicle that follows the last answer.

`t` must not be before that of the last tick. `pose`, speed `v` [m/s], `curvature` of the wheels
[1/m] and `hitch_angle` [rad] are measurements; None: the hitch angle of the last answer. The plan
begins there if the vehicle is more than 0.5 m, 0.5 m/s or 10 degrees away from the last answer. The
first tick ignores them and begins at the start.

With a `time_limit` the tick answers within that time [s]. It looks for better drives until 10 ms
before, or for half of a shorter limit. Without one, equal calls give equal answers.)")
      .def("patch", &patch, py::kw_only(), "cells"_a = py::tuple(), "added"_a = py::dict(),
           "removed"_a = std::vector<std::int64_t>{},
           R"(patch(*, cells=(), added={}, removed=())

Changes the ground from now on.

`cells` are tuples (row, column, array) with new cells of the grid. `added` are polygons by whole
numbers, `removed` numbers of polygons; unknown ones are ignored. The scenario's obstacles have the
numbers 0, 1, ...)")
      .def(
          "set_moving",
          [](OwnReplanner& self, const std::vector<MovingObstacle>& moving) {
            self.alone([&] { self.replanner.set_moving(moving); });
          },
          "moving"_a, R"(set_moving(moving)

Sets the `MovingObstacle` objects from now on, with times of the replanner's clock.)")
      .def("set_goal", &set_goal, "goal"_a, R"(set_goal(goal)

Drives to another goal from now on: a pose, a `GoalRegion` or a list of them.

The drive stays as it is until a tick finds one to the new goal. A goal that is invalid raises
InputError, and the old one stays.)")
      .def_property_readonly(
          "answer",
          [](const OwnReplanner& self) {
            self.itself.expect();
            return Answered{self.replanner.answer(), self.vehicle};
          },
          "The last `ReplanAnswer`.");
}

}  // namespace

void bind_replan(py::module_& module) {
  bind_answer(module);
  bind_replanner(module);
}

}  // namespace vandplan::python

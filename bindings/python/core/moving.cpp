// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Moving obstacles.

#include "vandplan/motion.h"

#include <fmt/format.h>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/drive.h"
#include "bindings/python/core/value.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

constexpr const char* expected_rows = "expected rows [t, x, y, heading]";

std::vector<TimedPose> trajectory_from(const py::handle& given) {
  const Numbers rows = numbers_from(given, "trajectory");
  if (rows.ndim() != 2 || rows.shape(1) != 4) throw InputError("trajectory", expected_rows);
  std::vector<TimedPose> trajectory;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    trajectory.push_back({rows.at(i, 0), {rows.at(i, 1), rows.at(i, 2), rows.at(i, 3)}});
  }
  return trajectory;
}

py::array_t<double> rows_of(const std::vector<TimedPose>& trajectory) {
  py::array_t<double> array({static_cast<py::ssize_t>(trajectory.size()), py::ssize_t{4}});
  double* out = array.mutable_data();
  for (const auto& [t, pose] : trajectory) {
    for (const double number : {t, pose.x, pose.y, pose.heading}) *out++ = number;
  }
  return array;
}

Afterwards afterwards_named(const std::string& word) {
  for (const Afterwards after : {Afterwards::stays, Afterwards::leaves}) {
    if (word == name_of(after)) return after;
  }
  throw InputError("after", "is \"" + word + "\", expected stays or leaves");
}

/// Checks one obstacle as in a scenario. Errors name "outline" or another key.
void expect_mover(const MovingObstacle& obstacle) {
  try {
    check_scenario({.bounds = {-1.0, 1.0, -1.0, 1.0}, .moving = {obstacle}});
  } catch (const InputError& error) {
    constexpr std::string_view prefix = "moving[0].";
    const std::string& where = error.where();
    throw InputError(where.starts_with(prefix) ? where.substr(prefix.size()) : where,
                     error.problem());
  }
}

MovingObstacle made_obstacle(const py::object& outline, const py::object& trajectory,
                             const std::string& after, double inflate) {
  MovingObstacle obstacle{polygon_from(outline, "outline"), trajectory_from(trajectory),
                          afterwards_named(after), inflate};
  expect_mover(obstacle);
  return obstacle;
}

py::tuple mover_state(const MovingObstacle& self) {
  return py::make_tuple(array_of(std::span<const Point>(self.outline)), rows_of(self.trajectory),
                        name_of(self.after), self.inflate);
}

std::optional<Meeting> meeting_on(const PathDrive& drive, const std::vector<MovingObstacle>& moving,
                                  double margin) {
  if (!(margin >= 0.0 && margin <= 1000.0)) throw InputError("margin", "expected 0 to 1000");
  const py::gil_scoped_release release;
  return first_meeting(drive.timed(), drive.vehicle, moving, margin);
}

void bind_obstacle(py::module_& module) {
  py::class_<MovingObstacle>(module, "MovingObstacle",
                             R"(MovingObstacle(outline, trajectory, after="stays", inflate=0)

Obstacle with a known motion: a vehicle, a person or a door.

- `outline`: simple polygon in a frame of its own [m], shape (N, 2).
- `trajectory`: poses of that frame, rows [t, x, y, heading] with increasing t [s].
- `after`: "stays" or "leaves" after the last row.
- `inflate`: growth of the outline on all sides [m/s], from t = 0 to the last row.

Between rows the obstacle moves and turns uniformly. Before the first row it stands there.)")
      .def(py::init(&made_obstacle), "outline"_a, "trajectory"_a, "after"_a = "stays",
           "inflate"_a = 0.0)
      .def_property_readonly(
          "outline",
          [](const MovingObstacle& self) { return array_of(std::span<const Point>(self.outline)); },
          "Corners in the obstacle's own frame [m]; shape (N, 2).")
      .def_property_readonly(
          "trajectory", [](const MovingObstacle& self) { return rows_of(self.trajectory); },
          "Poses of the frame over time, rows [t, x, y, heading]; shape (N, 4).")
      .def_property_readonly(
          "after", [](const MovingObstacle& self) { return name_of(self.after); },
          "What the obstacle does after the last row: \"stays\" or \"leaves\".")
      .def_readonly("inflate", &MovingObstacle::inflate, "Growth of the outline [m/s].")
      .def(
          "pose_at", [](const MovingObstacle& self, double t) { return pose_at(self, t); }, "t"_a,
          "pose_at(t) -> array or None\n\nPose of the frame at a time [s]; None once it has left.")
      .def(
          "growth_at", [](const MovingObstacle& self, double t) { return growth_at(self, t); },
          "t"_a, "growth_at(t) -> float\n\nGrowth of the outline on all sides at a time [m].")
      .def("__eq__",
           [](const MovingObstacle& self, const MovingObstacle& other) { return self == other; })
      .def("__eq__", [](const MovingObstacle&, const py::object&) { return false; })
      .def("__repr__",
           [](const MovingObstacle& self) {
             return fmt::format("<vandplan.MovingObstacle: {} corners, {} rows, {}>",
                                self.outline.size(), self.trajectory.size(), name_of(self.after));
           })
      .def(py::pickle(&mover_state,
                      [](const py::tuple& state) {
                        return made_obstacle(state[0], state[1], state[2].cast<std::string>(),
                                             state[3].cast<double>());
                      }))
      .attr("__hash__") = py::none();
}

}  // namespace

void bind_moving(py::module_& module) {
  bind_obstacle(module);
  ValueClass<Meeting> meeting(
      module, "Meeting", R"(First moment when a vehicle comes too near to a moving obstacle.)");
  meeting.field("t", &Meeting::t, "Time of the meeting [s].")
      .field("s", &Meeting::s, "Driven distance at that time [m].")
      .field("pose", &Meeting::pose, "Pose [x, y, heading] of the vehicle at that time.")
      .field("obstacle", &Meeting::obstacle, "Index of the moving obstacle.");
  meeting.pickled().def("__repr__", [](const Meeting& self) {
    return fmt::format("<vandplan.Meeting: moving[{}] at t = {:.3f} s>", self.obstacle, self.t);
  });
  module.def(
      "end_of_motion",
      [](const std::vector<MovingObstacle>& moving) { return end_of_motion(moving); }, "moving"_a,
      "end_of_motion(moving) -> float\n\nTime at which the last moving obstacle stops or leaves "
      "[s]; "
      "0 without obstacles.");
  module.def("first_meeting", &meeting_on, "drive"_a, "moving"_a, "margin"_a = 0.0,
             R"(first_meeting(drive, moving, margin=0) -> Meeting or None

First moment at which the vehicle of a `SpeedProfile` is within `margin` [m] of a moving obstacle.

The time after the drive counts too, when the vehicle stands at the end. The test has no time steps,
so it misses no meeting.)");
}

}  // namespace vandplan::python

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Paths, and the steering functions that create them.

#include "bindings/python/core/path.h"
#include "bindings/python/core/renamed.h"

#include <fmt/format.h>

#include <cmath>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "vandplan/input_error.h"
#include "vandplan/steering.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

Path made_path(const py::object& start, const py::object& segments) {
  const Pose first = pose_from(start, "start");
  if (!std::isfinite(first.x + first.y + first.heading)) throw InputError("start", "is not finite");
  return {first, segments_from(segments)};
}

/// Array with the results of `write(s, out)` for each distance; `last` numbers for each, one if it
/// is 0.
template <typename Write>
py::object at_distances(const py::object& given, int last, Write write) {
  const Numbers distances = numbers_from(given, "s");
  const std::span shape(distances.shape(), static_cast<std::size_t>(distances.ndim()));
  py::array_t<double> out = empty_array(shape, last);
  const double* const s = distances.data();
  double* const values = out.mutable_data();
  const auto size = static_cast<std::size_t>(distances.size());
  unlocked(size, [&] {
    for (std::size_t i = 0; i < size; ++i) write(s[i], values + i * static_cast<std::size_t>(last));
  });
  return out;
}

py::object poses_at(const Path& path, const py::object& s) {
  return at_distances(s, 3, [&](double distance, double* out) {
    const Pose pose = pose_at(path, distance);
    out[0] = pose.x;
    out[1] = pose.y;
    out[2] = pose.heading;
  });
}

std::vector<PathPoint> points_of(const Path& path, double step) {
  expect_positive(step, "step");
  constexpr double most_points = 1e8;
  if (!(length(path) / step < most_points)) {
    throw InputError("step", "is too small: there would be more than 1e8 poses");
  }
  return sampled(path, step);
}

py::array_t<double> poses_of(const Path& path, double step) {
  std::vector<Pose> poses;
  for (const PathPoint& point : points_of(path, step)) poses.push_back(point.pose);
  return array_of(poses);
}

py::dict samples_of(const Path& path, double step) {
  const std::vector<PathPoint> points = points_of(path, step);
  const auto column = [&](auto value_of) {
    py::array_t<decltype(value_of(points[0]))> array(static_cast<py::ssize_t>(points.size()));
    auto* out = array.mutable_data();
    for (const PathPoint& point : points) *out++ = value_of(point);
    return array;
  };
  py::dict columns;
  columns["s"] = column([](const PathPoint& p) { return p.s; });
  columns["x"] = column([](const PathPoint& p) { return p.pose.x; });
  columns["y"] = column([](const PathPoint& p) { return p.pose.y; });
  columns["heading"] = column([](const PathPoint& p) { return p.pose.heading; });
  columns["curvature"] = column([](const PathPoint& p) { return p.curvature; });
  columns["direction"] = column([](const PathPoint& p) { return direction_of(p.gear); });
  return columns;
}

std::string path_text(const Path& path) {
  return fmt::format("<vandplan.Path: {:.3f} m, {} segments, {} gear changes>", length(path),
                     path.segments.size(), gear_changes(path));
}

void bind_path_class(py::module_& module) {
  py::class_<Path> path(module, "Path", R"(Path(start, segments)

Path from a start pose [x, y, heading] along segments.

`segments` are rows [curvature, length, curvature_rate]; the last number may be missing. The
curvature is that at the segment's start [1/m], positive to the left. The length [m] is negative in
reverse. The rate [1/m^2] is the change of curvature per metre driven.)");
  path.def(py::init(&made_path), "start"_a, "segments"_a)
      .def_property_readonly(
          "start", [](const Path& self) { return array_of(self.start); },
          "First pose [x, y, heading].")
      .def_property_readonly(
          "end_pose", [](const Path& self) { return array_of(end_pose(self)); },
          "Last pose [x, y, heading].")
      .def_property_readonly(
          "segments",
          [](const Path& self) { return array_of(std::span<const Segment>(self.segments)); },
          "Rows [curvature, length, curvature_rate], one for each segment; shape (K, 3).")
      .def_property_readonly(
          "length", [](const Path& self) { return length(self); },
          "Driven distance in both gears [m].")
      .def_property_readonly(
          "gear_changes", [](const Path& self) { return gear_changes(self); },
          "Number of gear changes.")
      .def("poses", &poses_of, "step"_a = 0.1, R"(poses(step=0.1) -> array of shape (N, 3)

Poses along the path at most `step` apart [m], with both ends of every segment.)")
      .def("sampled", &samples_of, "step"_a = 0.1, R"(sampled(step=0.1) -> dict of arrays

Columns at the places of `poses`: s [m], x, y, heading, curvature [1/m], direction.

The direction is 1 forward, -1 in reverse. `pandas.DataFrame(path.sampled())` makes a table.)")
      .def("pose_at", &poses_at, "s"_a, R"(pose_at(s) -> array

Pose after `s` metres, clamped to [0, length].

The shape is (3,) for a number and (..., 3) for an array.)")
      .def("__eq__", [](const Path& self, const Path& other) { return self == other; })
      .def("__eq__", [](const Path&, const py::object&) { return false; })
      .def("__repr__", &path_text)
      .def(py::pickle(
          [](const Path& self) {
            return py::make_tuple(array_of(self.start),
                                  array_of(std::span<const Segment>(self.segments)));
          },
          [](const py::tuple& state) { return made_path(state[0], state[1]); }))
      .attr("__hash__") = py::none();
  add_old_property(path, "end", "end_pose",
                   [](const Path& self) { return array_of(end_pose(self)); });
  add_old_method(path, "samples", "sampled", "(step=0.1) -> dict of arrays", &samples_of,
                 "step"_a = 0.1);
}

}  // namespace

Continuity continuity_named(std::string_view name) {
  if (name == "between-stops") return Continuity::between_stops;
  if (name == "throughout") return Continuity::throughout;
  throw InputError("continuity",
                   "is \"" + std::string(name) + "\", expected between-stops or throughout");
}

Path path_of(const Pose& start, const Piece& piece) {
  return {start, {piece.view().begin(), piece.view().end()}};
}

std::vector<Segment> segments_from(const py::handle& given) {
  const Numbers rows = numbers_from(given, "segments");
  if (rows.size() == 0) return {};
  if (rows.ndim() != 2 || rows.shape(1) < 2 || rows.shape(1) > 3) {
    throw InputError("segments",
                     "expected rows [curvature, length] or [curvature, length, curvature_rate]");
  }
  std::vector<Segment> segments;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const double rate = rows.shape(1) == 3 ? rows.at(i, 2) : 0.0;
    const Segment segment{rows.at(i, 0), rows.at(i, 1), rate};
    if (!std::isfinite(segment.curvature) || !std::isfinite(segment.length) ||
        !std::isfinite(rate)) {
      throw InputError(fmt::format("segments[{}]", i), "is not finite");
    }
    segments.push_back(segment);
  }
  return segments;
}

void bind_path(py::module_& module) {
  bind_path_class(module);
  const auto between = [&](const char* name, auto steer, const char* about) {
    module.def(
        name,
        [steer](const py::object& start, const py::object& goal, double radius) {
          expect_positive(radius, "radius");
          const Pose from = pose_from(start, "start");
          return path_of(from, steer(from, pose_from(goal, "goal"), radius));
        },
        "start"_a, "goal"_a, "radius"_a, about);
  };
  between("reeds_shepp", &reeds_shepp, R"(reeds_shepp(start, goal, radius) -> Path

Shortest path in either gear on open ground, for a turning radius [m].)");
  between("dubins", &dubins, R"(dubins(start, goal, radius) -> Path

Shortest path in forward gear on open ground, for a turning radius [m].)");
  module.def(
      "continuous_path",
      [](const py::object& start, const py::object& goal, double radius, double curvature_rate,
         const std::string& continuity) {
        const ContinuousSteering steering(radius, curvature_rate, continuity_named(continuity));
        const Pose from = pose_from(start, "start");
        return path_of(from, steering.steer(from, pose_from(goal, "goal")));
      },
      "start"_a, "goal"_a, "radius"_a, "curvature_rate"_a, "continuity"_a = "between-stops",
      R"(continuous_path(start, goal, radius, curvature_rate, continuity="between-stops") -> Path

Short path in either gear whose curvature changes by at most `curvature_rate` per metre [1/m^2].

`radius` is the turning radius [m]; `continuity` is described at `continuous_length`.)");
}

}  // namespace vandplan::python

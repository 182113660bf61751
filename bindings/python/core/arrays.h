// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do Python arrays become poses, polygons and numbers, and back?
//
// Contiguous float64 arrays are not copied; everything else is copied once.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/judge.h"
#include "vandplan/path.h"

namespace vandplan::python {

namespace py = pybind11;

/// Array of numbers in row-major order without gaps.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Poses from Python: an array whose last axis is [x, y, heading], or anything numpy converts to
/// one. A list or tuple of three numbers is read without numpy.
class Poses {
 public:
  /// Throws InputError naming `where` if `given` is no such array.
  Poses(const py::handle& given, const char* where);
  Poses(const Poses&) = delete;
  Poses& operator=(const Poses&) = delete;

  [[nodiscard]] std::span<const Pose> view() const noexcept { return view_; }
  /// All axes except the last; empty for one pose.
  [[nodiscard]] std::span<const py::ssize_t> shape() const noexcept { return shape_; }

 private:
  bool read_one(const py::handle& given);

  Pose one_ = {};
  py::object array_;  // Keeps the memory of `view_` alive.
  std::span<const Pose> view_;
  std::span<const py::ssize_t> shape_;
};

/// One pose. Throws InputError naming `where` if it is not exactly one.
[[nodiscard]] Pose pose_from(const py::handle& given, const char* where);

/// Issues a Python UserWarning for the first heading that looks like degrees. `where` names the
/// poses: "start" becomes "start.heading", or "starts[3].heading" among several.
void warn_of_degrees(std::span<const Pose> poses, const std::string& where);

/// Issues a Python warning at the caller's line.
void warn(const std::string& message, PyObject* category = PyExc_UserWarning);

/// Polygon from an (N, 2) array of corners, or from an object with `__geo_interface__`, such as a
/// polygon of shapely. Throws InputError naming `where`.
[[nodiscard]] Polygon polygon_from(const py::handle& given, const std::string& where);

/// Polygons from a sequence of what `polygon_from` takes, or from one object of shapely or
/// geopandas. Throws InputError naming `where`.
[[nodiscard]] std::vector<Polygon> polygons_from(const py::object& given, const std::string& where);

/// Numbers from an array of any shape. Throws InputError naming `where` if they are none.
[[nodiscard]] Numbers numbers_from(const py::handle& given, const char* where);

[[nodiscard]] py::array_t<double> array_of(const Pose& pose);
[[nodiscard]] py::array_t<double> array_of(std::span<const Pose> poses);
/// Corners of a polygon: an array that shapely reads, too.
[[nodiscard]] py::object array_of(std::span<const Point> points);
/// Array with a row [curvature, length, curvature_rate] for each segment.
[[nodiscard]] py::array_t<double> array_of(std::span<const Segment> segments);

/// Uninitialised array with the axes `shape` and, unless `last` is 0, a last axis of that size.
[[nodiscard]] py::array_t<double> empty_array(std::span<const py::ssize_t> shape, int last = 0);

/// Computes numbers for pairs of poses from number `first` on. `from` and `to` hold one pose for
/// all pairs, or one for each pair.
using PairLoop =
    std::function<void(std::span<const Pose> from, std::span<const Pose> to, std::size_t first)>;

/// Shape of the pairs of two arrays of poses by numpy's broadcasting rules. Throws InputError if
/// they do not fit.
[[nodiscard]] std::vector<py::ssize_t> shape_of_pairs(const Poses& from, const Poses& to);

/// Calls `loop` for runs of pairs until all are covered; `first` is the index of a run's first pair
/// in row-major order. Releases Python's lock if there are many.
void for_pairs(const Poses& from, const Poses& to, std::span<const py::ssize_t> shape,
               const PairLoop& loop);

/// Calls `work`, without Python's lock if `size` is large.
template <typename Work>
void unlocked(std::size_t size, Work work) {
  if (size < 64) {
    work();
    return;
  }
  const py::gil_scoped_release release;
  work();
}

/// Throws InputError naming `where` unless the number is finite and above 0.
void expect_positive(double value, const char* where);

}  // namespace vandplan::python

namespace pybind11::detail {

/// Conversion of a pose to and from an array [x, y, heading].
template <>
struct type_caster<vandplan::Pose> {
  PYBIND11_TYPE_CASTER(vandplan::Pose, const_name("pose"));
  bool load(handle given, bool) {
    value = vandplan::python::pose_from(given, "pose");
    return true;
  }
  static handle cast(const vandplan::Pose& pose, return_value_policy, handle) {
    return vandplan::python::array_of(pose).release();
  }
};

/// Conversion of a place on a path to and from a dict of s, pose, curvature and gear; `direction`
/// is the gear as it was, 1 or -1.
template <>
struct type_caster<vandplan::PathPoint> {
  PYBIND11_TYPE_CASTER(vandplan::PathPoint, const_name("place"));
  bool load(handle given, bool) {
    value = {given["s"].cast<double>(), given["pose"].cast<vandplan::Pose>(),
             given["curvature"].cast<double>(),
             vandplan::gear_of(given["direction"].cast<double>())};
    return true;
  }
  static handle cast(const vandplan::PathPoint& place, return_value_policy, handle) {
    dict values;
    values["s"] = place.s;
    values["pose"] = vandplan::python::array_of(place.pose);
    values["curvature"] = place.curvature;
    values["gear"] = vandplan::name_of(place.gear);
    values["direction"] = vandplan::direction_of(place.gear);
    return values.release();
  }
};

/// Conversion of a hit object to and from a dict of what, and index or cell if there is one.
template <>
struct type_caster<vandplan::Hit> {
  PYBIND11_TYPE_CASTER(vandplan::Hit, const_name("hit"));
  bool load(handle given, bool) {
    const auto values = reinterpret_borrow<dict>(given);
    const auto kind = vandplan::hit_kind_named(values["what"].cast<std::string>());
    if (!kind) return false;
    value.kind = *kind;
    if (values.contains("index")) value.index = values["index"].cast<std::size_t>();
    if (values.contains("cell")) {
      const auto [x, y] = values["cell"].cast<std::pair<double, double>>();
      value.cell = vandplan::Point{x, y};
    }
    return true;
  }
  static handle cast(const vandplan::Hit& hit, return_value_policy, handle) {
    dict values;
    values["what"] = std::string(name_of(hit.kind));
    if (has_index(hit.kind)) values["index"] = hit.index;
    if (hit.cell) values["cell"] = make_tuple(hit.cell->x, hit.cell->y);
    return values.release();
  }
};

}  // namespace pybind11::detail

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "bindings/python/core/arrays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan::python {
namespace {

// Layout of poses in memory, which lets an array of poses be used without a copy.
static_assert(std::is_standard_layout_v<Pose> && sizeof(Pose) == 3 * sizeof(double));
static_assert(offsetof(Pose, x) == 0 && offsetof(Pose, y) == sizeof(double) &&
              offsetof(Pose, heading) == 2 * sizeof(double));
static_assert(std::is_standard_layout_v<Point> && sizeof(Point) == 2 * sizeof(double));

std::string text_of_shape(std::span<const py::ssize_t> shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(shape[i]);
  }
  return text + (shape.size() == 1 ? ",)" : ")");
}

std::span<const py::ssize_t> shape_of(const py::array& array) {
  return {array.shape(), static_cast<std::size_t>(array.ndim())};
}

std::string type_name(const py::handle& given) { return Py_TYPE(given.ptr())->tp_name; }

/// Array whose last axis has `width` numbers.
Numbers rows_from(const py::handle& given, py::ssize_t width, const std::string& where,
                  const char* expected) {
  Numbers numbers = Numbers::ensure(given);
  if (!numbers) throw InputError(where, "is a " + type_name(given) + ", expected " + expected);
  const py::ssize_t axes = numbers.ndim();
  if (axes < 1 || numbers.shape(axes - 1) != width) {
    throw InputError(
        where, "has the shape " + text_of_shape(shape_of(numbers)) + ", expected " + expected);
  }
  return numbers;
}

constexpr const char* expected_poses = "poses [x, y, heading] of the shape (3,) or (N, 3)";

}  // namespace

bool Poses::read_one(const py::handle& given) {
  PyObject* const sequence = given.ptr();
  const bool is_list = PyList_CheckExact(sequence);
  if (!is_list && !PyTuple_CheckExact(sequence)) return false;
  if (PySequence_Fast_GET_SIZE(sequence) != 3) return false;
  std::array<double, 3> values{};
  for (py::ssize_t i = 0; i < 3; ++i) {
    PyObject* const item = PySequence_Fast_GET_ITEM(sequence, i);
    if (!PyFloat_Check(item) && !PyLong_Check(item)) return false;
    values[static_cast<std::size_t>(i)] = PyFloat_AsDouble(item);
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  }
  one_ = {values[0], values[1], values[2]};
  view_ = {&one_, 1};
  return true;
}

Poses::Poses(const py::handle& given, const char* where) {
  if (read_one(given)) return;
  const Numbers numbers = rows_from(given, 3, where, expected_poses);
  array_ = numbers;
  shape_ = shape_of(numbers).first(static_cast<std::size_t>(numbers.ndim() - 1));
  view_ = {reinterpret_cast<const Pose*>(numbers.data()),
           static_cast<std::size_t>(numbers.size() / 3)};
}

Pose pose_from(const py::handle& given, const char* where) {
  const Poses poses(given, where);
  if (poses.view().size() == 1) return poses.view().front();
  throw InputError(where, "has " + std::to_string(poses.view().size()) +
                              " poses, expected one, [x, y, heading]");
}

void warn(const std::string& message, PyObject* category) {
  if (PyErr_WarnEx(category, message.c_str(), 1) != 0) throw py::error_already_set();
}

void warn_of_degrees(std::span<const Pose> poses, const std::string& where) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::string doubt = heading_doubt(poses[i].heading);
    if (doubt.empty()) continue;
    const std::string number = poses.size() == 1 ? "" : "[" + std::to_string(i) + "]";
    warn(where + number + ".heading: " + doubt);
    return;  // One warning is enough.
  }
}

namespace {

/// Whether an object is one of shapely, geopandas or another library with the same protocol.
bool is_shape(const py::handle& given) {
  return !py::isinstance<py::array>(given) && py::hasattr(given, "__geo_interface__");
}

/// Python's list with the corners of each polygon of such an object.
py::list rings_of(const py::handle& shape, const std::string& where) {
  return py::module_::import("vandplan.shapes").attr("rings_of")(shape, where);
}

}  // namespace

Polygon polygon_from(const py::handle& given, const std::string& where) {
  const char* const expected = "the corners of a polygon, of the shape (N, 2)";
  if (is_shape(given)) {
    const py::list rings = rings_of(given, where);
    if (rings.size() == 1) return polygon_from(rings[0], where);
    throw InputError(where, "has " + std::to_string(rings.size()) + " polygons, expected one");
  }
  const Numbers numbers = rows_from(given, 2, where, expected);
  const auto* const corners = reinterpret_cast<const Point*>(numbers.data());
  return {corners, corners + numbers.size() / 2};
}

std::vector<Polygon> polygons_from(const py::object& given, const std::string& where) {
  std::vector<Polygon> polygons;
  const auto place = [&] { return where + "[" + std::to_string(polygons.size()) + "]"; };
  const py::object all = is_shape(given) ? py::object(rings_of(given, where)) : given;
  for (const py::handle one : all) {
    if (!is_shape(one)) {
      polygons.push_back(polygon_from(one, place()));
      continue;
    }
    for (const py::handle ring : rings_of(one, place())) {
      polygons.push_back(polygon_from(ring, place()));
    }
  }
  return polygons;
}

Numbers numbers_from(const py::handle& given, const char* where) {
  Numbers numbers = Numbers::ensure(given);
  if (numbers) return numbers;
  throw InputError(where, "is a " + type_name(given) + ", expected numbers");
}

py::array_t<double> array_of(const Pose& pose) {
  py::array_t<double> array(3);
  std::copy_n(&pose, 1, reinterpret_cast<Pose*>(array.mutable_data()));
  return array;
}

py::array_t<double> array_of(std::span<const Pose> poses) {
  py::array_t<double> array({static_cast<py::ssize_t>(poses.size()), py::ssize_t{3}});
  std::ranges::copy(poses, reinterpret_cast<Pose*>(array.mutable_data()));
  return array;
}

py::object array_of(std::span<const Point> points) {
  py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
  std::ranges::copy(points, reinterpret_cast<Point*>(array.mutable_data()));
  return array.attr("view")(py::module_::import("vandplan.shapes").attr("Polygon"));
}

py::array_t<double> array_of(std::span<const Segment> segments) {
  py::array_t<double> array({static_cast<py::ssize_t>(segments.size()), py::ssize_t{3}});
  double* out = array.mutable_data();
  for (const Segment& segment : segments) {
    *out++ = segment.curvature;
    *out++ = segment.length;
    *out++ = segment.curvature_rate;
  }
  return array;
}

py::array_t<double> empty_array(std::span<const py::ssize_t> shape, int last) {
  std::vector<py::ssize_t> axes(shape.begin(), shape.end());
  if (last != 0) axes.push_back(last);
  return py::array_t<double>(axes);
}

std::vector<py::ssize_t> shape_of_pairs(const Poses& from, const Poses& to) {
  const std::size_t axes = std::max(from.shape().size(), to.shape().size());
  std::vector<py::ssize_t> shape(axes, 1);
  for (const std::span<const py::ssize_t> given : {from.shape(), to.shape()}) {
    const std::size_t less = axes - given.size();
    for (std::size_t i = 0; i < given.size(); ++i) {
      py::ssize_t& size = shape[less + i];
      if (given[i] == 1 || given[i] == size) continue;
      if (size != 1) {
        throw InputError("starts, goals", "have the shapes " + text_of_shape(from.shape()) +
                                              " and " + text_of_shape(to.shape()) +
                                              " of poses, which do not fit together");
      }
      size = given[i];
    }
  }
  return shape;
}

namespace {

/// Steps in poses along each axis of the pairs; 0 along axes that are broadcast.
std::vector<std::size_t> strides_in(std::span<const py::ssize_t> given, std::size_t axes) {
  std::vector<std::size_t> strides(axes, 0);
  std::size_t stride = 1;
  for (std::size_t i = given.size(); i-- > 0;) {
    if (given[i] != 1) strides[axes - given.size() + i] = stride;
    stride *= static_cast<std::size_t>(given[i]);
  }
  return strides;
}

}  // namespace

void for_pairs(const Poses& from, const Poses& to, std::span<const py::ssize_t> shape,
               const PairLoop& loop) {
  std::size_t total = 1;
  for (const py::ssize_t size : shape) total *= static_cast<std::size_t>(size);
  if (total == 0) return;
  // Most calls need a single run.
  const std::size_t from_size = from.view().size();
  const std::size_t to_size = to.view().size();
  if ((from_size == 1 || from_size == total) && (to_size == 1 || to_size == total)) {
    unlocked(total, [&] { loop(from.view(), to.view(), 0); });
    return;
  }
  const std::vector<std::size_t> from_strides = strides_in(from.shape(), shape.size());
  const std::vector<std::size_t> to_strides = strides_in(to.shape(), shape.size());
  const auto row = static_cast<std::size_t>(shape.back());
  unlocked(total, [&] {
    for (std::size_t first = 0; first < total; first += row) {
      std::size_t from_at = 0;
      std::size_t to_at = 0;
      std::size_t rest = first / row;
      for (std::size_t axis = shape.size() - 1; axis-- > 0;) {
        const auto size = static_cast<std::size_t>(shape[axis]);
        from_at += rest % size * from_strides[axis];
        to_at += rest % size * to_strides[axis];
        rest /= size;
      }
      loop(from.view().subspan(from_at, from_strides.back() == 0 ? 1 : row),
           to.view().subspan(to_at, to_strides.back() == 0 ? 1 : row), first);
    }
  });
}

void expect_positive(double value, const char* where) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw InputError(
      where, "is " + std::string(py::str(py::float_(value))) + ", expected a positive number");
}

}  // namespace vandplan::python

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Methods by which others read our objects: numpy, shapely and geopandas, notebooks.

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/drive.h"
#include "bindings/python/core/result.h"
#include "vandplan/draw.h"
#include "vandplan/input_error.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

constexpr int html_width = 700;  // Width of a picture in a notebook [points].
constexpr double path_step = 0.1;

void replace_all(std::string& text, std::string_view part, const std::string& other) {
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + other.size())) {
    text.replace(at, part.size(), other);
  }
}

/// Picture as HTML. Identifiers in it are its own, so that a page may hold many pictures.
std::string html_of(Drawing drawing) {
  const py::gil_scoped_release release;
  drawing.footprints = true;
  std::string svg = draw(drawing, PictureFormat::svg, html_width);
  const std::string own = "v" + std::to_string(std::hash<std::string>()(svg)) + "-";
  replace_all(svg, " id=\"", " id=\"" + own);
  replace_all(svg, "\"#", "\"#" + own);
  replace_all(svg, "url(#", "url(#" + own);
  svg.erase(0, svg.find("<svg "));
  svg.insert(5, "style=\"max-width:100%;height:auto\" ");
  return "<div>" + svg + "</div>";
}

/// Picture of a path on open ground.
std::string html_of_path(const Path& path, const Vehicle& vehicle, const SpeedProfile* speeds,
                         const std::string& caption) {
  constexpr double around = 100.0;
  Bounds bounds{path.start.x, path.start.x, path.start.y, path.start.y};
  for (const PathPoint& point : sampled(path, std::max(length(path) / 1000, path_step))) {
    bounds = {std::min(bounds.x_min, point.pose.x), std::max(bounds.x_max, point.pose.x),
              std::min(bounds.y_min, point.pose.y), std::max(bounds.y_max, point.pose.y)};
  }
  bounds = {bounds.x_min - around, bounds.x_max + around, bounds.y_min - around,
            bounds.y_max + around};
  const Scenario ground{
      .vehicle = vehicle, .bounds = bounds, .start = path.start, .goal = end_pose(path)};
  return html_of({.scenario = &ground, .path = &path, .speeds = speeds, .caption = caption});
}

py::object array_of_path(const py::object& self, const py::object& dtype, const py::object& copy) {
  if (!copy.is_none() && !copy.cast<bool>()) {
    throw py::value_error("poses of a path are computed: copy=False is not possible");
  }
  const py::object poses = self.attr("poses")(path_step);
  return dtype.is_none() ? poses : poses.attr("astype")(dtype);
}

/// Class of the module that is already there.
template <typename Class>
Class class_named(const py::module_& module, const char* name) {
  return py::reinterpret_borrow<Class>(module.attr(name));
}

/// Adds the property by which shapely and geopandas read an object; `function` of the Python module
/// `vandplan.shapes` makes it.
template <typename Class>
void add_geometry(Class bound, const char* function, const char* about) {
  bound.def_property_readonly(
      "__geo_interface__",
      [function](const py::object& self) {
        return py::module_::import("vandplan.shapes").attr(function)(self);
      },
      about);
}

}  // namespace

void bind_protocols(py::module_& module) {
  auto path = class_named<py::class_<Path>>(module, "Path");
  path.def("__array__", &array_of_path, "dtype"_a = py::none(), "copy"_a = py::none());
  add_geometry(path, "line_of", "Line of the rear axle, for shapely and geopandas.");
  path.def("_repr_html_", [](const Path& self) {
    return html_of_path(self, {}, nullptr, "Under the mouse: footprints of the usual truck");
  });
  class_named<py::class_<PathDrive>>(module, "SpeedProfile")
      .def("_repr_html_", [](const PathDrive& self) {
        return html_of_path(self.path, self.vehicle, &self.profile, "");
      });
  auto scenario = class_named<py::class_<CheckedScenario>>(module, "Scenario");
  add_geometry(scenario, "features_of",
               "Features with the columns what, index and heading, for shapely and geopandas.");
  scenario.def("_repr_html_",
               [](const CheckedScenario& self) { return html_of({.scenario = &self.scenario()}); });
  class_named<py::class_<RunResult>>(module, "Result")
      .def("_repr_html_",
           [](const RunResult& self) { return html_of(drawing_of(self.scenario, &self)); });
}

}  // namespace vandplan::python

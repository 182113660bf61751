// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Occupancy grids.

#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include <cstdint>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/scenario.h"
#include "vandplan/input_error.h"

namespace vandplan::python {
namespace {

using namespace py::literals;
using FileName = std::filesystem::path;  // Accepts str and os.PathLike.

template <typename Number>
std::vector<Cell> cells_from(const py::array& array) {
  const auto values = py::array_t<Number, py::array::c_style | py::array::forcecast>(array);
  std::vector<Cell> cells(static_cast<std::size_t>(values.size()));
  const Number* const given = values.data();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Number value = given[i];
    cells[i] = value == Number{0} ? Cell::free : value > Number{0} ? Cell::occupied : Cell::unknown;
  }
  return cells;
}

py::array_t<std::int8_t> cells_of(const OccupancyGrid& grid) {
  py::array_t<std::int8_t> array({grid.rows, grid.columns});
  std::int8_t* out = array.mutable_data();
  for (const Cell cell : *grid.cells) {
    *out++ = static_cast<std::int8_t>(cell == Cell::free ? 0 : cell == Cell::occupied ? 100 : -1);
  }
  return array;
}

py::tuple grid_state(const OccupancyGrid& grid) {
  return py::make_tuple(cells_of(grid), grid.resolution, array_of(grid.origin),
                        grid.unknown_is_free);
}

OccupancyGrid grid_from_state(const py::tuple& state) {
  return grid_from(state[0], state[1].cast<double>(), state[2], state[3].cast<bool>());
}

}  // namespace

OccupancyGrid grid_from(const py::object& given, double resolution, const py::object& origin,
                        bool unknown_is_free) {
  auto array = py::array::ensure(given);
  if (!array || array.ndim() != 2 || array.size() == 0) {
    throw InputError("map", "expected a 2-D array of bool or whole numbers");
  }
  const char kind = array.dtype().kind();
  if (kind != 'b' && kind != 'i' && kind != 'u') {
    throw InputError("map", "is an array of " + std::string(py::str(array.dtype())) +
                                ", expected bool or whole numbers");
  }
  if (array.size() > most_map_cells) {
    throw InputError("map", fmt::format("has more than {} cells", most_map_cells));
  }
  OccupancyGrid grid{.origin = pose_from(origin, "map.origin"),
                     .resolution = resolution,
                     .columns = static_cast<std::int32_t>(array.shape(1)),
                     .rows = static_cast<std::int32_t>(array.shape(0)),
                     .unknown_is_free = unknown_is_free};
  const bool is_small = array.itemsize() == 1 && kind != 'u';
  grid.cells =
      is_small ? cells_from<std::int8_t>(array.view("int8")) : cells_from<std::int64_t>(array);
  check_map(grid);
  return grid;
}

void bind_grid(py::module_& module) {
  py::class_<OccupancyGrid>(
      module, "OccupancyGrid",
      R"(OccupancyGrid(cells, resolution, origin=(0, 0, 0), unknown_is_free=False)

Map of square cells with sides of `resolution` [m].

`cells` is a 2-D array of bool or whole numbers. 0 or False is free, negative is unknown, everything
else is an obstacle. `origin` is the pose [x, y, heading] of the corner of cells[0, 0]. Columns
count along its heading, rows to the left, as in ROS. Rows of images count downwards: use
cells[::-1].

With `unknown_is_free` unknown cells and the ground outside the map are free, otherwise they are
obstacles. Raises InputError naming "map" or a key of it.)")
      .def(py::init(&grid_from), "cells"_a, "resolution"_a, "origin"_a = py::make_tuple(0, 0, 0),
           "unknown_is_free"_a = false)
      .def_property_readonly("cells", &cells_of,
                             "Cells as a new array of int8: 0 free, 100 occupied, -1 unknown.")
      .def_property_readonly(
          "shape",
          [](const OccupancyGrid& grid) { return py::make_tuple(grid.rows, grid.columns); },
          "Numbers of rows and columns.")
      .def_readonly("resolution", &OccupancyGrid::resolution, "Side of a cell [m].")
      .def_property_readonly(
          "origin", [](const OccupancyGrid& grid) { return array_of(grid.origin); },
          "Pose [x, y, heading] of the corner of cells[0, 0]; columns count along its heading.")
      .def_readonly("unknown_is_free", &OccupancyGrid::unknown_is_free,
                    "Whether unknown cells and the ground outside the map are free.")
      .def_property_readonly(
          "outline",
          [](const OccupancyGrid& grid) { return array_of(std::span<const Point>(outline(grid))); },
          "Corners of the map [m]; shape (4, 2).")
      .def(py::pickle(&grid_state, &grid_from_state))
      .def("__repr__", [](const OccupancyGrid& grid) {
        return fmt::format("<vandplan.OccupancyGrid: {} x {} cells of {} m>", grid.rows,
                           grid.columns, grid.resolution);
      });
  module.def(
      "read_map", [](const FileName& file) { return read_map(file.string()); }, "file"_a,
      "read_map(file) -> OccupancyGrid\n\nReads a map of ROS' map_server from its YAML file and "
      "the image that it names.");
}

}  // namespace vandplan::python

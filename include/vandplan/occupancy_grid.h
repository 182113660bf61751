// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which cells of a map are obstacles?
//
// A cell is a closed square: touching a blocked one is a collision. Theory of the collision checks:
// docs/algorithms/occupancy_grid.md; how a map file becomes a grid: docs/formats.md.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan {

/// What a map knows of a cell.
enum class Cell : std::uint8_t { free, occupied, unknown };

/// A rectangle of square cells. Copies share the cells, which nobody changes.
struct OccupancyGrid {
  Pose origin = {};          ///< corner of cell (0, 0); columns count along its heading, rows left
  double resolution = 1.0;   ///< side of a cell [m]; > 0
  std::int32_t columns = 0;  ///< >= 1
  std::int32_t rows = 0;     ///< >= 1
  /// All cells, row by row: columns * rows of them.
  std::shared_ptr<const std::vector<Cell>> cells = {};
  /// Whether unknown cells, and all that lies outside of the grid, are free; by default they are
  /// obstacles.
  bool unknown_is_free = false;
};

/// The most cells that a grid may have.
inline constexpr std::int64_t most_map_cells = 400'000'000;

/// A rectangle of cells of a grid.
struct CellRange {
  std::int32_t column = 0;  ///< of its first cell
  std::int32_t row = 0;
  std::int32_t columns = 0;
  std::int32_t rows = 0;
};

/// Whether a cell is an obstacle. One outside of the grid, or that `cells` lack, is unknown.
[[nodiscard]] inline bool is_blocked(const OccupancyGrid& grid, std::int32_t column,
                                     std::int32_t row) noexcept {
  if (column < 0 || row < 0 || column >= grid.columns || row >= grid.rows) {
    return !grid.unknown_is_free;
  }
  const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                            static_cast<std::size_t>(column);
  if (!grid.cells || index >= grid.cells->size()) return !grid.unknown_is_free;
  const Cell cell = (*grid.cells)[index];
  return cell == Cell::occupied || (cell == Cell::unknown && !grid.unknown_is_free);
}

/// The four corners of the whole grid, in the frame that its `origin` is given in [m],
/// counter-clockwise from there.
[[nodiscard]] Polygon outline(const OccupancyGrid& grid);

}  // namespace vandplan

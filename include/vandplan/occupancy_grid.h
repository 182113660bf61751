// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which cells of a map are obstacles?
//
// A cell is a closed square: touching a blocked cell is a collision. Theory of the collision
// checks: docs/algorithms/occupancy_grid.md. How a map file becomes a grid: docs/formats.md.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan {

/// What a map says about a cell.
enum class Cell : std::uint8_t { free, occupied, unknown };

/// Cells that copies share and nobody changes. Reads as a pointer to a vector; null without cells.
class SharedCells : public std::shared_ptr<const std::vector<Cell>> {
 public:
  using shared_ptr::shared_ptr;
  SharedCells() noexcept = default;
  /// Cells that others may share already.
  SharedCells(std::shared_ptr<const std::vector<Cell>> cells) noexcept
      : shared_ptr(std::move(cells)) {}
  /// Cells of a vector, which is moved or copied.
  SharedCells(std::vector<Cell> cells)
      : shared_ptr(std::make_shared<const std::vector<Cell>>(std::move(cells))) {}
  /// Copy of cells that lie anywhere.
  SharedCells(std::span<const Cell> cells)
      : SharedCells(std::vector<Cell>(cells.begin(), cells.end())) {}
};

/// A rectangle of square cells. Copies share the cells, which nobody changes. The values are
/// checked by `check_map`, `World` and `make_problem` (problem.h). They throw InputError naming
/// "map.resolution", "map.origin" or "map".
struct OccupancyGrid {
  /// Corner of cell (0, 0) [m] and direction of the rows [rad]. Columns count along its heading,
  /// rows to the left of it.
  Pose origin = {};
  double resolution = 1.0;   ///< side of a cell [m]; 1e-6 to 1e6
  std::int32_t columns = 0;  ///< number of columns; >= 1
  std::int32_t rows = 0;     ///< number of rows; >= 1
  /// All cells, row by row: columns * rows of them. Cell (column, row) has the index
  /// row * columns + column. Assign a vector, a span to copy, or a shared pointer.
  SharedCells cells = {};
  /// Whether unknown cells and all ground outside the grid are free. By default they are obstacles.
  bool unknown_is_free = false;
};

/// Largest number of cells that a grid may have.
inline constexpr std::int64_t most_map_cells = 400'000'000;

/// A rectangle of cells of a grid, given by its first cell and its size.
struct CellRange {
  std::int32_t column = 0;   ///< column of the first cell
  std::int32_t row = 0;      ///< row of the first cell
  std::int32_t columns = 0;  ///< number of columns
  std::int32_t rows = 0;     ///< number of rows
};

/// Whether a cell is an obstacle. A cell outside the grid, or one that `cells` lack, counts as
/// unknown.
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

/// The four corners of the whole grid [m], in the frame in which `origin` is given. They are
/// counter-clockwise and begin at the origin.
[[nodiscard]] Polygon outline(const OccupancyGrid& grid);

}  // namespace vandplan

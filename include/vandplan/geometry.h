// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a point, a pose, a polygon, an angle?
//
// Units are metres and radians. Headings count counter-clockwise from the x axis. A value does not
// know its frame: the function or field that holds it names the frame (docs/conventions.md).

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace vandplan {

/// A position in the plane [m].
struct Point {
  double x = 0.0;
  double y = 0.0;
  bool operator==(const Point&) const = default;
};

/// Position of the midpoint of the rear axle [m] and heading of the vehicle [rad].
struct Pose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
  bool operator==(const Pose&) const = default;
};

/// A value in the frame of a world, in which checkers and planners work. A `Local<T>` converts to a
/// `T`. A `T` becomes local by name only, `Local(pose)`, and keeps its numbers. `to_local`
/// (problem.h) moves a pose from the scenario's frame to the world's. Where a `U` converts to a
/// `T`, a `Local<U>` converts to a `Local<T>`.
template <class T>
struct Local : T {
  Local() = default;
  constexpr explicit Local(T value) noexcept : T(std::move(value)) {}
  template <class U>
  requires std::convertible_to<U, T>
  constexpr Local(const Local<U>& other) noexcept  // NOLINT(google-explicit-constructor)
      : T(static_cast<const U&>(other)) {}
};

/// A pose in the frame of a world.
using LocalPose = Local<Pose>;

/// Many poses as three columns of float, for batch queries: x and y [m], heading [rad] in
/// [-pi, pi]. The columns have equal sizes.
struct PoseColumns {
  std::span<const float> x;
  std::span<const float> y;
  std::span<const float> heading;
};

/// Corners of a simple polygon in order [m], at least three. It is convex or concave, in either
/// orientation. The last corner differs from the first.
using Polygon = std::vector<Point>;

/// A closed box along the axes [m]: points on its border are inside.
struct Bounds {
  double x_min = 0.0;
  double x_max = 0.0;
  double y_min = 0.0;
  double y_max = 0.0;
  bool operator==(const Bounds&) const = default;
};

/// The angle in [-pi, pi) that differs from `angle` by whole turns [rad].
[[nodiscard]] double wrap_angle(double angle) noexcept;

/// The pose `local`, which is given in the frame of the pose `frame`, in the frame in which `frame`
/// is given. The heading is in [-pi, pi).
[[nodiscard]] Pose compose(const Pose& frame, const Pose& local) noexcept;
/// `compose` for a pose `frame` in the world's frame: the result is in the world's frame.
[[nodiscard]] inline LocalPose compose(const LocalPose& frame, const Pose& local) noexcept {
  return Local(compose(static_cast<const Pose&>(frame), local));
}

/// The pose `pose` as seen from the pose `frame`: the inverse of `compose`. Both arguments are
/// given in one frame. The heading is in [-pi, pi).
[[nodiscard]] Pose relative(const Pose& frame, const Pose& pose) noexcept;

/// Whether the point lies in the box or on its border.
[[nodiscard]] bool contains(const Bounds& bounds, const Point& point) noexcept;

/// The smallest box around the points [m]. All its numbers are zero if there are no points.
[[nodiscard]] Bounds bounding_box(std::span<const Point> points) noexcept;

/// Whether a simple polygon is convex, decided exactly. Corners on the line between their
/// neighbours are allowed.
[[nodiscard]] bool is_convex(std::span<const Point> polygon);

/// Whether a point lies inside a simple polygon, decided exactly. For a point on a side either
/// answer is possible.
[[nodiscard]] bool contains(std::span<const Point> polygon, const Point& point);

// ---- Which cells of a map are obstacles? ----
//
// A cell is a closed square: touching a blocked cell is a collision. Theory of the collision
// checks: docs/algorithms/occupancy_grid.md. How a map file becomes a grid: docs/formats.md.

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

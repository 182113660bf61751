// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "problem/map_hit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/text.h"
#include "base/trigonometry.h"
#include "vandplan/vehicle.h"

namespace vandplan::problem {
namespace {

/// Corners of a body at a pose, in the frame of a map [cells]. Body and pose are in metres.
Polygon in_cells(const Polygon& body, const Pose& pose, const OccupancyGrid& map) {
  Polygon corners;
  const auto [sin, cos] = base::sin_cos(pose.heading - map.origin.heading);
  const auto [map_sin, map_cos] = base::sin_cos(map.origin.heading);
  const double dx = pose.x - map.origin.x;
  const double dy = pose.y - map.origin.y;
  for (const Point& p : body) {
    corners.push_back({(map_cos * dx + map_sin * dy + cos * p.x - sin * p.y) / map.resolution,
                       (map_cos * dy - map_sin * dx + sin * p.x + cos * p.y) / map.resolution});
  }
  return corners;
}

/// Whether a convex, counter-clockwise polygon [cells] touches a cell.
bool meets_cell(const Polygon& body, double column, double row) {
  for (std::size_t i = 0; i < body.size(); ++i) {
    const Point& a = body[i];
    const Point& b = body[(i + 1) % body.size()];
    const double nx = b.y - a.y;  // normal of the side, out of the body
    const double ny = a.x - b.x;
    const double nearest =
        nx * (column + (nx > 0 ? 0 : 1) - a.x) + ny * (row + (ny > 0 ? 0 : 1) - a.y);
    if (nearest > 0) return false;
  }
  return true;
}

/// The nearest blocked cell that was found so far.
struct Hit {
  /// Squared distance from the rear axle to `middle` [cells^2].
  double squared_distance = std::numeric_limits<double>::infinity();
  Point middle = {};      ///< middle of the cell [cells]
  std::string what = {};  ///< why the cell is blocked; empty: no cell was found
};

std::string what_of(const OccupancyGrid& map, std::int32_t column, std::int32_t row) {
  if (column < 0 || row < 0 || column >= map.columns || row >= map.rows) {
    return "beyond the edge of the map";
  }
  const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                     static_cast<std::size_t>(column);
  return (*map.cells)[index] == Cell::occupied ? "occupied" : "unknown";
}

/// Updates `best` with blocked cells under one body that are nearer to the axle; all in cells.
void look_under(const OccupancyGrid& map, const Polygon& body, const Point& axle, Hit& best) {
  const Bounds box = bounding_box(body);
  const auto cell = [](double value) { return static_cast<std::int32_t>(std::floor(value)); };
  for (std::int32_t row = cell(box.y_min); row <= cell(box.y_max); ++row) {
    for (std::int32_t column = cell(box.x_min); column <= cell(box.x_max); ++column) {
      if (!is_blocked(map, column, row) || !meets_cell(body, column, row)) continue;
      const Point middle{column + 0.5, row + 0.5};
      const double squared =
          (middle.x - axle.x) * (middle.x - axle.x) + (middle.y - axle.y) * (middle.y - axle.y);
      if (squared < best.squared_distance) best = {squared, middle, what_of(map, column, row)};
    }
  }
}

std::string rounded(double metres) { return base::shortest_text(std::round(metres * 1e3) / 1e3); }

}  // namespace

std::optional<CellHit> map_hit(const Problem& problem, const State& state) {
  const World& world = *problem.world();
  const std::optional<OccupancyGrid>& map = world.local().map;
  if (!map) return std::nullopt;
  const Vehicle& vehicle = problem.vehicle();
  const LocalState local = to_local(world, state);
  const double largest = 1e8;  // distance from the map [cells]; cell numbers are 32-bit
  const Point axle = in_cells({{0, 0}}, local.pose, *map).front();
  if (!(std::abs(axle.x) < largest && std::abs(axle.y) < largest)) return std::nullopt;
  Hit hit;
  look_under(*map, in_cells(body_outline(vehicle), local.pose, *map), axle, hit);
  if (vehicle.trailer) {
    const Pose pose = trailer_pose(vehicle, local);
    look_under(*map, in_cells(body_outline(*vehicle.trailer), pose, *map), axle, hit);
  }
  if (hit.what.empty()) return std::nullopt;
  const auto [sin, cos] = base::sin_cos(map->origin.heading);
  const double along = hit.middle.x * map->resolution;
  const double left = hit.middle.y * map->resolution;
  const double x = world.origin().x + map->origin.x + cos * along - sin * left;
  const double y = world.origin().y + map->origin.y + sin * along + cos * left;
  return CellHit{hit.what + " at x = " + rounded(x) + ", y = " + rounded(y), {x, y}};
}

}  // namespace vandplan::problem

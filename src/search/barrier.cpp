// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/barrier.h"

#include <algorithm>
#include <cmath>

#include "geometry/boxes.h"
#include "geometry/polygon.h"
#include "vandplan/vehicle.h"

namespace vandplan::search {
namespace {

constexpr double coarsest_cell = 0.5;  // [m]
constexpr double finest_cell = 0.05;   // [m]
constexpr double most_barrier_cells = 4e6;
constexpr double slack_of_edges = 2e-3;  // of places; larger than all tolerances [m]
constexpr double slack_of_ends = 2e-6;   // of a path's ends; larger than the judge's [m]
constexpr int cells_of_step = 64;
constexpr std::uint8_t both_floods = 3, known_open = 4, known_closed = 8;

}  // namespace

// Where a way leaves the box around all that counts, each of its places can be moved to the nearest
// one of the box, where there are no rules and obstacles.
Barrier::Barrier(const Task& task, GearSign only)
    : task_(task),
      clearance_(inner_radius(task.vehicle)),
      one_way_(task.world->local().zones, {0.0, clearance_}, task.vehicle.min_turning_radius) {
  const Surroundings& ground = task.world->local();
  const Point ends[] = {{task.start.x, task.start.y}, {task.goal.x, task.goal.y}};
  Bounds scene = bounding_box(ends);
  for (const Zone& zone : ground.zones) {
    const AllowedGears wrong = only > 0 ? AllowedGears::reverse : AllowedGears::forward;
    if (!zone.closed && (only == 0 || zone.gears != wrong)) continue;
    closed_.push_back({zone.area, zone.body ? clearance_ : 0.0});
    scene = geometry::united(scene, bounding_box(zone.area));
  }
  const std::vector<Bounds> streets = one_way_.barring();
  for (const Bounds& street : streets) scene = geometry::united(scene, street);
  if (closed_.empty() && streets.empty()) return;
  for (const Polygon& obstacle : ground.obstacles)
    scene = geometry::united(scene, bounding_box(obstacle));
  if (ground.map) scene = geometry::united(scene, bounding_box(outline(*ground.map)));
  const double around = 2 * (clearance_ + task.least_margin) + 2 * coarsest_cell;
  box_ = geometry::shared(ground.bounds, geometry::widened(scene, around));
  side_ = 2 * coarsest_cell;
  if (!next_lattice()) side_ = 0.0;
}

/// Takes the next lattice on which the cells of start and goal are open and differ. False if there
/// is none.
bool Barrier::next_lattice() {
  for (;;) {
    side_ /= 2;
    const double columns = (box_.x_max - box_.x_min) / side_ + 1;
    const double rows = (box_.y_max - box_.y_min) / side_ + 1;
    if (side_ < finest_cell || !(columns * rows < most_barrier_cells)) return false;
    columns_ = static_cast<std::int64_t>(columns);
    rows_ = static_cast<std::int64_t>(rows);
    const double near = clearance_ + task_.least_margin - side_ * std::sqrt(0.5) - slack_of_edges;
    uses_obstacles_ = near > 0.0;
    if (uses_obstacles_) open_rows_ = OpenRows(task_, box_, side_, near);
    cells_.assign(static_cast<std::size_t>(columns_ * rows_), 0);
    const bool meet = root(start, task_.start) || root(goal, task_.goal);
    if (!meet && !fronts_[start].empty() && !fronts_[goal].empty()) return true;
  }
}

/// Lets a flood begin at the open cells around one of its places. True if the floods meet there.
bool Barrier::root(End end, const LocalPose& pose) {
  fronts_[end].clear();
  const auto mark = static_cast<std::uint8_t>(1U << end);
  for (const double x : {pose.x - slack_of_ends, pose.x + slack_of_ends}) {
    for (const double y : {pose.y - slack_of_ends, pose.y + slack_of_ends}) {
      const auto column = static_cast<std::int64_t>((x - box_.x_min) / side_);
      const auto row = static_cast<std::int64_t>((y - box_.y_min) / side_);
      const std::int64_t cell = std::clamp<std::int64_t>(row, 0, rows_ - 1) * columns_ +
                                std::clamp<std::int64_t>(column, 0, columns_ - 1);
      std::uint8_t& known = cells_[static_cast<std::size_t>(cell)];
      if ((known & mark) != 0 || !is_open(cell)) continue;
      known = static_cast<std::uint8_t>(known | mark);
      if ((known & both_floods) == both_floods) return true;
      fronts_[end].push_back(cell);
    }
  }
  return false;
}

Point Barrier::middle_of(std::int64_t cell) const {
  const std::int64_t column = cell % columns_;
  const std::int64_t row = cell / columns_;
  return {box_.x_min + (static_cast<double>(column) + 0.5) * side_,
          box_.y_min + (static_cast<double>(row) + 0.5) * side_};
}

bool Barrier::find_open(std::int64_t cell) {
  if (uses_obstacles_) {
    const auto column = static_cast<std::int32_t>(cell % columns_);
    const OpenRows::Row& runs = open_rows_.row(static_cast<std::int32_t>(cell / columns_));
    const auto is_in = [&](const OpenRows::Run& r) { return r.begin <= column && column < r.end; };
    if (std::none_of(runs.begin(), runs.end(), is_in)) return false;
  }
  const Point middle = middle_of(cell);
  const double most = -side_ * std::sqrt(0.5) - slack_of_edges;
  return std::none_of(closed_.begin(), closed_.end(), [&](const ClosedArea& closed) {
    return geometry::distance_from_border(closed.area, middle) <= closed.near + most;
  });
}

bool Barrier::is_open(std::int64_t cell) {
  std::uint8_t& known = cells_[static_cast<std::size_t>(cell)];
  if ((known & (known_open | known_closed)) == 0) {
    known = static_cast<std::uint8_t>(known | (find_open(cell) ? known_open : known_closed));
  }
  return (known & known_open) != 0;
}

/// Whether no path crosses a side of a cell in a sense. `side`: where it is, seen from the middle.
bool Barrier::is_barred(std::int64_t cell, int side, int sense) const {
  constexpr std::array<Point, 4> towards = {Point{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const Point& to = towards[static_cast<std::size_t>(side)];
  const Point middle = middle_of(cell);
  return one_way_.bars({middle.x + to.x * side_ / 2, middle.y + to.y * side_ / 2}, side_, sense);
}

/// Expands a cell of a flood. True when the floods meet.
bool Barrier::expand(End end) {
  const std::int64_t cell = fronts_[end].back();
  fronts_[end].pop_back();
  const std::int64_t column = cell % columns_, row = cell / columns_;
  const std::array<bool, 4> is_there = {column + 1 < columns_, row + 1 < rows_, column > 0,
                                        row > 0};
  const std::array<std::int64_t, 4> beside = {cell + 1, cell + columns_, cell - 1, cell - columns_};
  const auto mark = static_cast<std::uint8_t>(1U << end);
  for (int side = 0; side < 4; ++side) {
    const auto i = static_cast<std::size_t>(side);
    if (!is_there[i]) continue;
    std::uint8_t& known = cells_[static_cast<std::size_t>(beside[i])];
    if ((known & mark) != 0 || !is_open(beside[i])) continue;
    if (is_barred(cell, side, end == start ? side : (side + 2) % 4)) continue;
    known = static_cast<std::uint8_t>(known | mark);
    if ((known & both_floods) == both_floods) return true;
    fronts_[end].push_back(beside[i]);
  }
  return false;
}

bool Barrier::step() {
  if (side_ == 0.0 || is_proven_) return false;
  for (int i = 0; i < cells_of_step; ++i) {
    const End end = fronts_[start].size() <= fronts_[goal].size() ? start : goal;
    if (fronts_[end].empty()) {
      is_proven_ = true;
      return false;
    }
    if (!expand(end)) continue;
    if (!next_lattice()) side_ = 0.0;
    return side_ != 0.0;
  }
  return true;
}

}  // namespace vandplan::search

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/known_ground.h"

#include <algorithm>
#include <string>
#include <utility>

#include "problem/checks.h"
#include "vandplan/input_error.h"

namespace vandplan::replanning {
namespace {

/// A polygon that has shrunk to a point or a line has as many corners as one needs.
void pad(Polygon& polygon) {
  while (polygon.size() < 3) polygon.push_back(polygon.back());
}

void check_cells(const CellPatch& patch, const std::optional<OccupancyGrid>& map,
                 const std::string& where) {
  if (!map) throw InputError(where, "is there, and the scenario has no map");
  const bool is_on_map = patch.column >= 0 && patch.row >= 0 && patch.columns >= 1 &&
                         patch.rows >= 1 && patch.columns <= map->columns - patch.column &&
                         patch.rows <= map->rows - patch.row;
  if (!is_on_map) throw InputError(where, "is not on the map, expected cells that are");
  const auto count = static_cast<std::size_t>(patch.columns) * static_cast<std::size_t>(patch.rows);
  if (patch.cells.size() == count) return;
  throw InputError(where + ".cells", "are " + std::to_string(patch.cells.size()) + ", expected " +
                                         std::to_string(count));
}

/// Whether a cell became another one.
bool write(const CellPatch& patch, std::int32_t columns, std::vector<Cell>& cells) {
  bool has_changed = false;
  for (std::int32_t y = 0; y < patch.rows; ++y) {
    const auto from = patch.cells.begin() + static_cast<std::ptrdiff_t>(y) * patch.columns;
    const auto to =
        cells.begin() + static_cast<std::ptrdiff_t>(patch.row + y) * columns + patch.column;
    if (std::equal(from, from + patch.columns, to)) continue;
    has_changed = true;
    std::copy(from, from + patch.columns, to);
  }
  return has_changed;
}

}  // namespace

KnownGround::KnownGround(std::shared_ptr<const World> world)
    : origin_(world->origin()), ground_(world->local()) {
  for (std::vector<Polygon>* polygons : {&ground_.obstacles, &ground_.kerbs}) {
    for (Polygon& polygon : *polygons) pad(polygon);
  }
  for (std::size_t i = 0; i < ground_.obstacles.size(); ++i) {
    names_.push_back(static_cast<std::int64_t>(i));
  }
  world_ = std::make_shared<const World>(ground_, Point{});
}

void KnownGround::patch(const WorldPatch& patch) {
  Surroundings ground = ground_;
  std::vector<std::int64_t> names = names_;
  bool has_changed = false;
  const auto remove = [&](std::int64_t name) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) return;
    ground.obstacles.erase(ground.obstacles.begin() + (found - names.begin()));
    names.erase(found);
    has_changed = true;
  };
  for (const std::int64_t name : patch.removed) remove(name);
  for (std::size_t i = 0; i < patch.added.size(); ++i) {
    const auto& [name, outline] = patch.added[i];
    Polygon local =
        problem::local_polygon(outline, origin_, "added[" + std::to_string(i) + "].outline");
    pad(local);
    const auto found = std::ranges::find(names, name);
    if (found != names.end() &&
        ground.obstacles[static_cast<std::size_t>(found - names.begin())] == local) {
      continue;
    }
    remove(name);
    ground.obstacles.push_back(std::move(local));
    names.push_back(name);
    has_changed = true;
  }
  if (!patch.cells.empty()) {
    for (std::size_t i = 0; i < patch.cells.size(); ++i) {
      check_cells(patch.cells[i], ground.map, "cells[" + std::to_string(i) + "]");
    }
    auto cells = std::make_shared<std::vector<Cell>>(*ground.map->cells);
    bool has_new_cells = false;
    for (const CellPatch& each : patch.cells) {
      has_new_cells = write(each, ground.map->columns, *cells) || has_new_cells;
    }
    if (has_new_cells) ground.map->cells = std::move(cells);
    has_changed = has_changed || has_new_cells;
  }
  if (!has_changed) return;
  world_ = std::make_shared<const World>(ground, Point{});
  ground_ = std::move(ground);
  names_ = std::move(names);
  ++version_;
}

}  // namespace vandplan::replanning

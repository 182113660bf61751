// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/known_ground.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "judge/ground.h"
#include "problem/checks.h"
#include "problem/masks.h"
#include "vandplan/input_error.h"

namespace vandplan::replanning {
namespace {

/// Repeats the last corner of a polygon that has shrunk to a point or a line, up to three corners.
void pad(Polygon& polygon) {
  while (polygon.size() < 3) polygon.push_back(polygon.back());
}

bool is_on(const OccupancyGrid& map, const CellRange& range) {
  return range.column >= 0 && range.row >= 0 && range.columns >= 1 && range.rows >= 1 &&
         range.columns <= map.columns - range.column && range.rows <= map.rows - range.row;
}

/// Checks that a patch has a value for each cell of a range of a map.
void check_range(const OccupancyGrid& map, const CellRange& range, std::size_t values,
                 const std::string& where, const std::string& where_values) {
  if (!is_on(map, range)) throw InputError(where, "is not on the map, expected cells that are");
  const auto count = static_cast<std::size_t>(range.columns) * static_cast<std::size_t>(range.rows);
  if (values == count) return;
  throw InputError(where_values,
                   "are " + std::to_string(values) + ", expected " + std::to_string(count));
}

CellRange range_of(const CellPatch& patch) {
  return {patch.column, patch.row, patch.columns, patch.rows};
}

void check_cells(const CellPatch& patch, const std::optional<OccupancyGrid>& map,
                 const std::string& where) {
  if (!map) throw InputError(where, "is there, and the scenario has no map");
  check_range(*map, range_of(patch), patch.cells.size(), where, where + ".cells");
}

void check_mask(const MaskPatch& patch, const std::vector<Mask>& masks, const std::string& where) {
  const bool is_one = patch.mask < masks.size() && masks[patch.mask].percents &&
                      masks[patch.mask].use != MaskUse::obstacles;
  if (!is_one) {
    throw InputError(where, "is of mask " + std::to_string(patch.mask) +
                                ", expected one with percentages that are speeds or costs");
  }
  const Mask& mask = masks[patch.mask];
  check_range(mask.map, patch.range, patch.percents.size(), where, where + ".percents");
  problem::check_percents(mask, patch.percents, where);
}

/// Writes the values of a patch into those of a map with so many columns. Returns a range that
/// holds all changed cells; none if none changed.
template <typename Value>
std::optional<CellRange> written(const CellRange& range, const std::vector<Value>& values,
                                 std::int32_t columns, std::vector<Value>& cells) {
  std::int32_t left = range.columns, right = -1, low = range.rows, high = -1;
  for (std::int32_t y = 0; y < range.rows; ++y) {
    const Value* const from = values.data() + static_cast<std::ptrdiff_t>(y) * range.columns;
    Value* const to =
        cells.data() + static_cast<std::ptrdiff_t>(range.row + y) * columns + range.column;
    for (std::int32_t x = 0; x < range.columns; ++x) {
      if (to[x] == from[x]) continue;
      to[x] = from[x];
      left = std::min(left, x);
      right = std::max(right, x);
      low = std::min(low, y);
      high = y;
    }
  }
  if (high < 0) return std::nullopt;
  return CellRange{range.column + left, range.row + low, right - left + 1, high - low + 1};
}

/// Surroundings of which another world can be made, in the frame of a world.
Surroundings copied_ground(const World& world) {
  Surroundings ground = world.without_fences();
  for (std::vector<Polygon>* polygons : {&ground.obstacles, &ground.kerbs}) {
    for (Polygon& polygon : *polygons) pad(polygon);
  }
  for (Zone& zone : ground.zones) pad(zone.area);
  return ground;
}

}  // namespace

KnownGround::KnownGround(const World& world) : KnownGround(copied_ground(world), Point{}) {
  origin_ = world.origin();
}

KnownGround::KnownGround(Surroundings ground, const Point& near) {
  if (ground.map && ground.map->cells) {
    cells_ = std::make_shared<std::vector<Cell>>(*ground.map->cells);
    ground.map->cells = cells_;
  }
  for (Mask& mask : ground.masks) {
    auto& percents = percents_.emplace_back();
    if (!mask.percents) continue;
    percents = std::make_shared<std::vector<std::uint8_t>>(*mask.percents);
    mask.percents = percents;
  }
  world_ = std::make_shared<World>(ground, near);
  origin_ = world_->origin();
  // Fences come first. Their names count up from the least integer, so they do not clash with
  // others.
  for (std::size_t i = 0; i < world_->fences(); ++i) {
    names_.push_back(std::numeric_limits<std::int64_t>::min() + static_cast<std::int64_t>(i));
  }
  for (std::size_t i = 0; i < ground.obstacles.size(); ++i) {
    names_.push_back(static_cast<std::int64_t>(i));
  }
}

void KnownGround::patch(const WorldPatch& patch) {
  // 1. Errors are thrown before anything has changed.
  const std::optional<OccupancyGrid>& map = world_->local().map;
  for (std::size_t i = 0; i < patch.cells.size(); ++i) {
    check_cells(patch.cells[i], map, "cells[" + std::to_string(i) + "]");
  }
  for (std::size_t i = 0; i < patch.masks.size(); ++i) {
    check_mask(patch.masks[i], world_->local().masks, "masks[" + std::to_string(i) + "]");
  }
  std::vector<Polygon> obstacles = world_->local().obstacles;
  std::vector<std::int64_t> names = names_;
  bool has_changed = false;
  const auto remove = [&](std::int64_t name) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) return;
    obstacles.erase(obstacles.begin() + (found - names.begin()));
    names.erase(found);
    has_changed = true;
  };
  for (const std::int64_t name : patch.removed) remove(name);
  for (std::size_t i = 0; i < patch.added.size(); ++i) {
    const auto& [name, outline] = patch.added[i];
    Polygon local =
        problem::local_polygon(outline, origin_, "added[" + std::to_string(i) + "].outline");
    const auto found = std::ranges::find(names, name);
    if (found != names.end() &&
        obstacles[static_cast<std::size_t>(found - names.begin())] == local) {
      continue;
    }
    remove(name);
    obstacles.push_back(std::move(local));
    names.push_back(name);
    has_changed = true;
  }
  // 2. Nothing throws from here on.
  std::vector<CellRange> changed;
  for (const CellPatch& each : patch.cells) {
    const auto range = written(range_of(each), each.cells, map->columns, *cells_);
    if (range) changed.push_back(*range);
  }
  for (const auto& [mask, range, percents] : patch.masks) {
    const std::int32_t columns = world_->local().masks[mask].map.columns;
    if (written(range, percents, columns, *percents_[mask])) has_changed = true;
  }
  if (!has_changed && changed.empty()) return;
  const auto judged = judge::ground_of(*world_);
  world_->change(std::move(obstacles), changed);
  judge::renew_ground(*world_, *judged, changed);
  names_ = std::move(names);
  ++version_;
}

}  // namespace vandplan::replanning

namespace vandplan {

ChangingWorld::ChangingWorld(const Surroundings& surroundings, const Point& near)
    : ground_(std::make_unique<replanning::KnownGround>(surroundings, near)) {}

ChangingWorld::~ChangingWorld() = default;
ChangingWorld::ChangingWorld(ChangingWorld&&) noexcept = default;
ChangingWorld& ChangingWorld::operator=(ChangingWorld&&) noexcept = default;

void ChangingWorld::patch(const WorldPatch& patch) { ground_->patch(patch); }

std::shared_ptr<const World> ChangingWorld::world() const noexcept { return ground_->world(); }

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "sites/ground_changes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>

#include "geometry/boxes.h"
#include "vandplan/path.h"

namespace vandplan::sites {
namespace {

bool is_before(const Polygon& a, const Polygon& b) {
  const auto is_left = [](const Point& p, const Point& q) {
    return std::pair(p.x, p.y) < std::pair(q.x, q.y);
  };
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), is_left);
}

/// Adds the polygons that only one of two lists has. Its second list is what stands now.
void compare(std::vector<Polygon> before, std::vector<Polygon> now,
             std::vector<GroundChange>& changes) {
  std::ranges::sort(before, is_before);
  std::ranges::sort(now, is_before);
  std::vector<Polygon> gone;
  std::vector<Polygon> come;
  std::set_difference(before.begin(), before.end(), now.begin(), now.end(),
                      std::back_inserter(gone), is_before);
  std::set_difference(now.begin(), now.end(), before.begin(), before.end(),
                      std::back_inserter(come), is_before);
  for (const Polygon& polygon : gone) changes.push_back({bounding_box(polygon), true});
  for (const Polygon& polygon : come) changes.push_back({bounding_box(polygon), false});
}

void compare(const std::vector<Zone>& before, const std::vector<Zone>& now,
             std::vector<GroundChange>& changes) {
  const auto add = [&changes](const std::vector<Zone>& zones, const std::vector<Zone>& others) {
    for (const Zone& zone : zones) {
      if (std::ranges::find(others, zone) != others.end()) continue;
      changes.push_back({bounding_box(zone.area), true});
    }
  };
  add(before, now);
  add(now, before);
}

/// Box around some cells of a map.
Bounds box_of(const OccupancyGrid& map, std::int32_t column, std::int32_t row, std::int32_t columns,
              std::int32_t rows) {
  Polygon corners;
  for (const auto& [x, y] :
       {std::pair(column, row), std::pair(column + columns, row), std::pair(column, row + rows),
        std::pair(column + columns, row + rows)}) {
    const Pose along = advance(map.origin, Segment{0.0, x * map.resolution});
    const Pose corner = advance({along.x, along.y, along.heading + std::numbers::pi / 2},
                                Segment{0.0, y * map.resolution});
    corners.push_back({corner.x, corner.y});
  }
  return bounding_box(corners);
}

/// Adds the cells of a map that differ, and copies them: a box for each run of rows.
template <typename Value>
void compare(const OccupancyGrid& map, const std::vector<Value>& now, std::vector<Value>& before,
             std::vector<GroundChange>& changes) {
  const auto columns = static_cast<std::size_t>(map.columns);
  std::int32_t first = 0, left = map.columns, right = -1;
  for (std::int32_t row = 0; row <= map.rows; ++row) {
    bool is_other = false;
    if (row < map.rows) {
      const auto at = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * columns);
      const std::span<const Value> fresh(now.data() + at, columns);
      const std::span<Value> known(before.data() + at, columns);
      const auto begin =
          std::mismatch(known.begin(), known.end(), fresh.begin(), fresh.end()).first;
      is_other = begin != known.end();
      if (is_other) {
        if (right < 0) first = row;
        std::size_t last = columns - 1;
        while (known[last] == fresh[last]) --last;
        left = std::min(left, static_cast<std::int32_t>(begin - known.begin()));
        right = std::max(right, static_cast<std::int32_t>(last));
        std::ranges::copy(fresh, known.begin());
      }
    }
    if (is_other || right < 0) continue;
    changes.push_back({box_of(map, left, first, right - left + 1, row - first), true});
    left = map.columns;
    right = -1;
  }
}

/// Whether two maps are equal but for their cells.
bool same_shape(const OccupancyGrid& a, const OccupancyGrid& b) {
  return a.origin == b.origin && a.resolution == b.resolution && a.columns == b.columns &&
         a.rows == b.rows && a.unknown_is_free == b.unknown_is_free;
}

bool same_cells(const Mask& a, const Mask& b) {
  if (a.percents || a.map.cells == b.map.cells) return true;
  return a.map.cells && b.map.cells && *a.map.cells == *b.map.cells;
}

/// Whether masks are equal but for their percentages.
bool same_shape(const std::vector<Mask>& a, const std::vector<Mask>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Mask& one, const Mask& other) {
    return same_shape(one.map, other.map) && one.use == other.use && one.base == other.base &&
           one.multiplier == other.multiplier && !one.percents == !other.percents &&
           same_cells(one, other);
  });
}

}  // namespace

SeenGround::SeenGround(const World& world) : origin_(world.origin()), ground_(world.local()) {
  if (ground_.map && ground_.map->cells) cells_ = *ground_.map->cells;
  for (const Mask& mask : ground_.masks) {
    percents_.push_back(mask.percents ? *mask.percents : std::vector<std::uint8_t>{});
  }
}

std::optional<std::vector<GroundChange>> SeenGround::look(const World& world) {
  const Surroundings& now = world.local();
  const bool is_like = world.origin() == origin_ && now.bounds == ground_.bounds &&
                       now.map.has_value() == ground_.map.has_value() &&
                       (!now.map || same_shape(*now.map, *ground_.map)) &&
                       same_shape(now.masks, ground_.masks);
  if (!is_like) return std::nullopt;
  std::vector<GroundChange> changes;
  compare(ground_.obstacles, now.obstacles, changes);
  compare(ground_.kerbs, now.kerbs, changes);
  compare(ground_.zones, now.zones, changes);
  if (now.map && now.map->cells) compare(*now.map, *now.map->cells, cells_, changes);
  for (std::size_t i = 0; i < now.masks.size(); ++i) {
    const Mask& mask = now.masks[i];
    if (mask.percents) compare(mask.map, *mask.percents, percents_[i], changes);
  }
  ground_.obstacles = now.obstacles;
  ground_.kerbs = now.kerbs;
  ground_.zones = now.zones;
  return changes;
}

}  // namespace vandplan::sites

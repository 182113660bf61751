// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/collision.h"

#include <optional>

#include "grid_obstacles.h"
#include "obstacles.h"
#include "sweep.h"

namespace vandplan {
namespace {

bool holds(const Bounds& outer, const Bounds& inner) {
  return inner.x_min >= outer.x_min && inner.x_max <= outer.x_max && inner.y_min >= outer.y_min &&
         inner.y_max <= outer.y_max;
}

}  // namespace

struct CollisionChecker::Data {
  Footprint footprint;
  Bounds bounds;
  Obstacles obstacles;
  std::optional<GridObstacles> map = {};

  /// Whether no side is touched and the bounds are kept. Together with a start outside of all
  /// polygons that is all: whatever is entered later is entered across a side.
  [[nodiscard]] bool crosses_nothing(const PlacedSegment& placed) const noexcept {
    if (!holds(bounds, placed.axle_box())) return false;
    if (obstacles.is_empty()) return true;
    const Sweep sweep(footprint, placed);
    return !obstacles.any_near(sweep.box(), [&](const Sides& s) { return sweep.touches(s); });
  }
};

CollisionChecker::CollisionChecker(const Footprint& footprint, const Bounds& bounds,
                                   std::span<const Polygon> obstacles)
    : data_(std::make_unique<const Data>(Data{footprint, bounds, Obstacles(obstacles)})) {}

CollisionChecker::CollisionChecker(const Vehicle& vehicle, const Surroundings& surroundings) {
  const Footprint body = footprint(vehicle);
  const auto& [bounds, obstacles, map] = surroundings;
  auto data = std::make_unique<Data>(Data{body, bounds, Obstacles(obstacles)});
  if (map) data->map.emplace(*map, body);
  data_ = std::move(data);
}

CollisionChecker::~CollisionChecker() = default;

bool CollisionChecker::is_free(const Pose& pose) const noexcept { return is_free(pose, Segment{}); }

bool CollisionChecker::is_free(const Pose& from, const Segment& segment) const noexcept {
  return is_free(from, std::span<const Segment>(&segment, 1));
}

bool CollisionChecker::is_free(const Pose& from, std::span<const Segment> segments) const noexcept {
  if (segments.empty()) return is_free(from);
  const std::optional<GridObstacles>& map = data_->map;
  if (data_->obstacles.contain({from.x, from.y})) return false;
  if (map && map->contain({from.x, from.y})) return false;
  Placement placement = placement_of(from);
  for (const Segment& segment : segments) {
    const PlacedSegment placed(placement, segment);
    if (!data_->crosses_nothing(placed)) return false;
    if (map && !map->is_clear(placed)) return false;
    placement = placed.to;
  }
  return true;
}

bool CollisionChecker::map_is_within(const Point& point, double distance) const noexcept {
  return data_->map && data_->map->is_within(point, distance);
}

}  // namespace vandplan

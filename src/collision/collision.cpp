// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/collision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "collision/clothoid_arcs.h"
#include "collision/grid_obstacles.h"
#include "collision/obstacles.h"
#include "collision/sweep.h"

namespace vandplan {
namespace {

bool holds(const Bounds& outer, const Bounds& inner) {
  return inner.x_min >= outer.x_min && inner.x_max <= outer.x_max && inner.y_min >= outer.y_min &&
         inner.y_max <= outer.y_max;
}

/// The furthest point of a footprint from its rear axle [m].
double reach_of(const Footprint& body) {
  const double x = std::max(body.rear, body.front);
  return std::sqrt(x * x + body.half_width * body.half_width);
}

}  // namespace

struct CollisionChecker::Data {
  /// Polygons, and what must not touch them.
  struct Layer {
    Footprint footprint;
    Obstacles obstacles;

    [[nodiscard]] bool is_crossed(const PlacedSegment& placed) const noexcept {
      if (obstacles.is_empty()) return false;
      const Sweep sweep(footprint, placed);
      return obstacles.any_near(sweep.box(), [&](const Sides& s) { return sweep.touches(s); });
    }
  };

  Bounds bounds;
  Layer walls;
  Layer kerbs;
  std::optional<GridObstacles> map = {};

  /// Whether nothing contains the place of a rear axle.
  [[nodiscard]] bool is_outside(const Point& axle) const noexcept {
    return !walls.obstacles.contain(axle) && !kerbs.obstacles.contain(axle) &&
           !(map && map->contain(axle));
  }

  /// Whether no side is touched and the rear axle stays in the box. Together with a start outside
  /// of all that is enough: whatever is entered later is entered across a side.
  [[nodiscard]] bool crosses_nothing(const PlacedSegment& placed,
                                     const Bounds& box) const noexcept {
    return holds(box, placed.axle_box()) && !walls.is_crossed(placed) &&
           !kerbs.is_crossed(placed) && !(map && !map->is_clear(placed));
  }

  [[nodiscard]] bool crosses_nothing(Placement& placement, const Segment& clothoid) const noexcept;
};

/// Whether a clothoid touches no side and keeps to the bounds; `placement` goes on to its end. Out
/// of line, so that arcs and lines do not pay for it.
[[gnu::noinline, gnu::cold]] bool CollisionChecker::Data::crosses_nothing(
    Placement& placement, const Segment& clothoid) const noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr Bounds everywhere{-infinity, infinity, -infinity, infinity};
  const double reach = std::max(reach_of(walls.footprint), reach_of(kerbs.footprint));
  // The boxes of the arcs do not count: the axle is held to the bounds on the clothoid itself.
  ClothoidArcs arcs(placement, clothoid, reach);
  if (!contains(bounds, placement.position) || arcs.are_too_many()) return false;
  for (; !arcs.is_done(); arcs.advance()) {
    if (!arcs.keeps_to(bounds) || !crosses_nothing(arcs.arc(), everywhere)) return false;
  }
  placement = arcs.here();
  return true;
}

CollisionChecker::CollisionChecker(const Footprint& footprint, const Bounds& bounds,
                                   std::span<const Polygon> obstacles)
    : data_(std::make_unique<const Data>(Data{bounds, {footprint, Obstacles(obstacles)}, {}})) {}

CollisionChecker::CollisionChecker(const Vehicle& vehicle, const Surroundings& surroundings) {
  const Footprint body = footprint(vehicle);
  const auto& [bounds, obstacles, kerbs, map] = surroundings;
  auto data = std::make_unique<Data>(
      Data{bounds, {body, Obstacles(obstacles)}, {wheel_footprint(vehicle), Obstacles(kerbs)}});
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
  if (!data_->is_outside({from.x, from.y})) return false;
  Placement placement = placement_of(from);
  for (const Segment& segment : segments) {
    if (segment.curvature_rate != 0.0 && segment.length != 0.0) {
      if (!data_->crosses_nothing(placement, segment)) return false;
      continue;
    }
    const PlacedSegment placed(placement, segment);
    if (!data_->crosses_nothing(placed, data_->bounds)) return false;
    placement = placed.to;
  }
  return true;
}

bool CollisionChecker::map_is_within(const Point& point, double distance) const noexcept {
  return data_->map && data_->map->is_within(point, distance);
}

}  // namespace vandplan

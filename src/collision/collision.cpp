// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/collision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "collision/bodies.h"
#include "collision/clothoid_part.h"
#include "collision/crossed.h"
#include "collision/ground.h"
#include "collision/trailer_part.h"
#include "collision/zones.h"
#include "vandplan/vehicle.h"

namespace vandplan {

using collision::Body, collision::ClothoidPart, collision::DiscRows, collision::Obstacles,
    collision::OutlineSweep, collision::PlacedSegment, collision::Placement,
    collision::placement_of, collision::reach_of, collision::RigPlacement, collision::Shape,
    collision::Towed, collision::TrailerPart;

namespace {

bool holds(const Bounds& outer, const Bounds& inner) {
  return inner.x_min >= outer.x_min && inner.x_max <= outer.x_max && inner.y_min >= outer.y_min &&
         inner.y_max <= outer.y_max;
}

/// Margin that is wanted with the rear axle at a place [m]. If `around` is positive, the largest
/// margin wanted within that distance; if it is negative, the least.
double wanted_at(const Margin& margin, const Point& axle, double around) noexcept {
  double wanted = margin.wanted;
  for (const auto& [centre, least, reach] : margin.ramps) {
    const double distance = std::hypot(axle.x - centre.x, axle.y - centre.y) + around;
    if (distance >= reach) continue;
    wanted = std::min(wanted, least + (margin.wanted - least) * std::max(distance, 0.0) / reach);
  }
  return wanted;
}

}  // namespace

struct CollisionChecker::Data {
  Data(Shape of_body, const Footprint& of_wheels, const Margin& kept,
       std::shared_ptr<const collision::Ground> on)
      : body(std::move(of_body), of_wheels, kept.wanted), margin(kept), ground(std::move(on)) {}

  Data(const Vehicle& vehicle, const Margin& kept, std::shared_ptr<const collision::Ground> on,
       std::span<const Zone> all_zones, std::span<const Mask> masks)
      : Data(collision::shape_of(vehicle), wheel_footprint(vehicle), kept, std::move(on)) {
    if (vehicle.trailer) towed.emplace(vehicle, kept.wanted);
    const auto grades = [](const Mask& mask) { return mask.use != MaskUse::obstacles; };
    const bool has_grades = std::any_of(masks.begin(), masks.end(), grades);
    if (has_grades || !all_zones.empty()) zones.emplace(vehicle, all_zones, masks);
  }

  Body body;
  Margin margin;
  std::shared_ptr<const collision::Ground> ground;
  std::optional<Towed> towed = {};
  std::optional<collision::Zones> zones = {};

  /// Whether a rear axle may begin at a place: no obstacle, kerb or blocked cell contains it, and
  /// `may_begin_at` holds.
  [[nodiscard]] bool is_outside(const Point& axle) const noexcept {
    return !ground->walls.contain(axle) && !ground->kerbs.contain(axle) &&
           !(ground->map && ground->map->contain(axle)) && may_begin_at(axle);
  }

  /// Whether one of the `inside` areas contains the axle; true if there are none.
  [[nodiscard]] bool may_begin_at(const Point& axle) const noexcept {
    const auto holds_it = [&](const Obstacles& area) { return area.contain(axle); };
    const bool is_in_any = std::any_of(ground->inside.begin(), ground->inside.end(), holds_it);
    return ground->inside.empty() || is_in_any;
  }

  /// Whether the bodies of a rig, judged by their axles, begin in one area.
  [[nodiscard]] bool begin_together(const Point& axle, const Point& trailer) const noexcept {
    const auto holds_both = [&](const Obstacles& area) {
      return area.contain(axle) && area.contain(trailer);
    };
    return ground->inside.empty() ||
           std::any_of(ground->inside.begin(), ground->inside.end(), holds_both);
  }

  /// Whether no kerb, blocked cell or obstacle contains a trailer's axle. If both bodies contain
  /// the hitch, obstacles need no test here: one around the axle touches a body, as the line over
  /// the hitch to the tractor's axle stays in the bodies.
  [[nodiscard]] bool is_trailer_outside(const Point& axle) const noexcept {
    return (towed->holds_hitch || !ground->walls.contain(axle)) && !ground->kerbs.contain(axle) &&
           !(ground->map && ground->map->contain(axle));
  }

  /// Whether the body touches no side and the rear axle stays in the box. If it also starts outside
  /// all obstacles, the segment is free, since a body enters an obstacle only across a side.
  [[nodiscard]] bool crosses_nothing(const PlacedSegment& placed,
                                     const Bounds& box) const noexcept {
    return holds(box, placed.axle_box()) &&
           (margin.ramps.empty() ? keeps(body, margin.wanted, body.discs, placed)
                                 : keeps_margin(placed));
  }

  /// Whether a body keeps a distance [m]. `around`: discs that cover the body and that distance.
  [[nodiscard]] bool keeps(const Body& moved, double distance, const DiscRows& around,
                           const PlacedSegment& placed) const noexcept {
    if (!moved.shape.corners.empty() && placed.length > OutlineSweep::longest) {
      const double half = placed.length / 2;
      return keeps(moved, distance, around, placed.part(0, half)) &&
             keeps(moved, distance, around, placed.part(half, placed.length));
    }
    return !is_crossed(ground->walls, moved.shape, distance, placed) &&
           !is_crossed(ground->kerbs, moved.wheels, distance, placed) &&
           !(ground->map && !ground->map->is_clear(moved.shape, distance, around, placed));
  }

  [[nodiscard]] bool keeps(const Body& moved, double distance,
                           const PlacedSegment& placed) const noexcept {
    if (!ground->map || distance == margin.wanted) {
      return keeps(moved, distance, moved.discs, placed);
    }
    return keeps(moved, distance, DiscRows(moved.shape, distance), placed);
  }

  [[nodiscard]] double clearance(const Body& standing, const Placement& placement, double most,
                                 double enough) const noexcept {
    if (!is_outside(placement.position)) return 0.0;
    double least = distance_from(ground->walls, standing.shape, placement, most);
    least = distance_from(ground->kerbs, standing.wheels, placement, least);
    if (!ground->map) return least;
    return ground->map->clearance({standing.shape, standing.slim}, placement, least, enough);
  }

  [[nodiscard]] bool is_tractor_free(const Pose& from,
                                     std::span<const Segment> segments) const noexcept;
  [[nodiscard]] bool is_trailer_free(const State& from,
                                     std::span<const Segment> segments) const noexcept;
  [[nodiscard]] bool keeps_margin(const PlacedSegment& placed) const noexcept;
  [[nodiscard]] bool crosses_nothing(const ClothoidPart& part, double reach) const noexcept;
  [[nodiscard]] bool crosses_nothing(Placement& placement, const Segment& clothoid) const noexcept;
  [[nodiscard]] bool crosses_nothing(const TrailerPart& part) const noexcept;
};

/// Whether a margin that changes on the way is kept. The margins wanted on a part lie between two
/// bounds; a part is halved only if they give different answers.
bool CollisionChecker::Data::keeps_margin(const PlacedSegment& placed) const noexcept {
  constexpr double close_enough = 0.2e-3;  // Difference of margins that does not matter [m].
  const auto keeps_all = [&](double distance) { return keeps(body, distance, placed); };
  const double half = placed.length / 2;
  const Point axle = placed.at(half).position;
  const double most = wanted_at(margin, axle, half);
  if (keeps_all(most)) return true;
  const double least = wanted_at(margin, axle, -half);
  if (most - least <= close_enough || !keeps_all(least)) return false;
  return keeps_margin(placed.part(0, half)) && keeps_margin(placed.part(half, placed.length));
}

/// Whether a part of a clothoid touches no side and stays in the bounds. It does if the arc in its
/// place does with a margin as large as its deviation, or if both halves do.
bool CollisionChecker::Data::crosses_nothing(const ClothoidPart& part,
                                             double reach) const noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr Bounds everywhere{-infinity, infinity, -infinity, infinity};
  if (part.is_simple()) {
    const PlacedSegment arc = part.arc();
    const double off = part.deviation(reach);
    // The arc's box does not count, as the axle is held to the bounds on the clothoid itself.
    if (off <= collision::arc_deviation) {
      return part.keeps_to(ground->bounds) && crosses_nothing(arc, everywhere);
    }
    const auto& [x_min, x_max, y_min, y_max] = arc.axle_box();
    if (holds(ground->bounds, {x_min - off, x_max + off, y_min - off, y_max + off})) {
      if (keeps(body, margin.wanted + off, arc)) return true;
    }
  }
  const auto [first, second] = part.halves();
  return crosses_nothing(first, reach) && crosses_nothing(second, reach);
}

/// Whether a clothoid touches no side and stays in the bounds; moves `placement` to its end. Not
/// inlined, so that arcs and lines do not pay for it.
[[gnu::noinline, gnu::cold]] bool CollisionChecker::Data::crosses_nothing(
    Placement& placement, const Segment& clothoid) const noexcept {
  const double reach = std::max(reach_of(body.shape.box), reach_of(body.wheels.box));
  const ClothoidPart whole(placement, clothoid);
  if (!contains(ground->bounds, placement.position) || whole.is_too_long(reach)) return false;
  placement = whole.to();
  return crosses_nothing(whole, reach);
}

/// Whether the trailer touches no side. It does not if the arc in place of its way keeps the
/// deviation as a margin, plus the largest margin wanted on the part; or if both halves touch none.
bool CollisionChecker::Data::crosses_nothing(const TrailerPart& part) const noexcept {
  constexpr double close_enough = 0.2e-3;  // Difference of margins that does not matter [m].
  if (part.is_simple()) {
    const PlacedSegment arc = part.arc();
    const double off = part.deviation(towed->reach);
    const bool is_exact = off <= collision::arc_deviation;
    const double beside = is_exact ? 0.0 : off;
    if (margin.ramps.empty()) {
      const bool is_clear = keeps(towed->body, margin.wanted + beside, arc);
      if (is_clear || is_exact) return is_clear;
    } else {
      const Point tractor = part.tractor_in_the_middle();
      const double most = wanted_at(margin, tractor, part.half_length());
      if (keeps(towed->body, most + beside, arc)) return true;
      const double least = wanted_at(margin, tractor, -part.half_length());
      if (is_exact && (most - least <= close_enough || !keeps(towed->body, least, arc))) {
        return false;
      }
    }
  }
  const auto [first, second] = part.halves();
  return crosses_nothing(first) && crosses_nothing(second);
}

bool CollisionChecker::Data::is_tractor_free(const Pose& from,
                                             std::span<const Segment> segments) const noexcept {
  if (!std::isfinite(from.x + from.y + from.heading)) return false;
  if (!is_outside({from.x, from.y})) return false;
  Placement placement = placement_of(from);
  for (const Segment& segment : segments) {
    if (!std::isfinite(segment.curvature + segment.length + segment.curvature_rate)) return false;
    if (segment.curvature_rate != 0.0 && segment.length != 0.0) {
      if (!crosses_nothing(placement, segment)) return false;
      continue;
    }
    const PlacedSegment placed(placement, segment);
    if (!crosses_nothing(placed, ground->bounds)) return false;
    placement = placed.to;
  }
  return true;
}

/// Whether the trailer is free while its tractor drives free segments.
bool CollisionChecker::Data::is_trailer_free(const State& from,
                                             std::span<const Segment> segments) const noexcept {
  if (!std::isfinite(from.hitch_angle)) return false;
  const Vehicle& vehicle = towed->vehicle;
  RigPlacement rig(vehicle, placement_of(from.pose), from.hitch_angle);
  if (!is_trailer_outside(rig.trailer.position)) return false;
  if (!begin_together({from.pose.x, from.pose.y}, rig.trailer.position)) return false;
  for (const Segment& segment : segments) {
    const TrailerPart part(vehicle, rig, segment);
    if (part.is_too_long() || !crosses_nothing(part)) return false;
    rig = part.to();
  }
  return true;
}

double Margin::least() const noexcept {
  double least = wanted;
  for (const MarginRamp& ramp : ramps) least = std::min(least, ramp.least);
  return least;
}

CollisionChecker::CollisionChecker(const Footprint& footprint, const Bounds& bounds,
                                   std::span<const Polygon> obstacles)
    : data_(std::make_unique<const Data>(
          Shape{footprint}, footprint, Margin{},
          std::make_shared<const collision::Ground>(Surroundings{
              .bounds = bounds, .obstacles = {obstacles.begin(), obstacles.end()}}))) {}

CollisionChecker::CollisionChecker(const Vehicle& vehicle, const Surroundings& surroundings,
                                   const Margin& margin)
    : CollisionChecker(vehicle, std::make_shared<const collision::Ground>(surroundings), margin,
                       surroundings.zones, surroundings.masks) {}

CollisionChecker::CollisionChecker(const Vehicle& vehicle,
                                   std::shared_ptr<const collision::Ground> ground,
                                   const Margin& margin, std::span<const Zone> zones,
                                   std::span<const Mask> masks)
    : data_(std::make_unique<const Data>(vehicle, margin, std::move(ground), zones, masks)) {}

CollisionChecker::~CollisionChecker() = default;

bool CollisionChecker::is_free(const LocalState& state) const noexcept {
  return is_free(state, Segment{});
}

bool CollisionChecker::is_free(const LocalState& from, const Segment& segment,
                               InTime in_time) const noexcept {
  return is_free(from, std::span<const Segment>(&segment, 1), in_time);
}

bool CollisionChecker::is_free(const LocalState& from, std::span<const Segment> segments,
                               InTime in_time) const noexcept {
  if (segments.empty()) return is_free(from);
  return data_->is_tractor_free(from.pose, segments) &&
         (!data_->towed || data_->is_trailer_free(from, segments)) &&
         (!data_->zones || data_->zones->allow(from, segments, in_time));
}

bool CollisionChecker::obeys_zones(const LocalState& from, const Segment& segment,
                                   InTime in_time) const noexcept {
  return !data_->zones || data_->zones->allow(from, {&segment, 1}, in_time);
}

bool CollisionChecker::has_prices() const noexcept {
  return data_->zones && data_->zones->have_prices();
}

bool CollisionChecker::has_speed_limits() const noexcept {
  return data_->zones && data_->zones->have_speed_limits();
}

std::vector<GroundPart> CollisionChecker::ground_along(const LocalState& from,
                                                       const Segment& segment,
                                                       GroundRules which) const {
  if (!data_->zones) return {{0.0, std::abs(segment.length)}};
  return data_->zones->along(from, segment, which);
}

bool CollisionChecker::tractor_is_free(const LocalPose& from,
                                       std::span<const Segment> segments) const noexcept {
  constexpr Segment standing;
  return data_->is_tractor_free(from, segments.empty() ? std::span(&standing, 1) : segments);
}

double CollisionChecker::clearance(const LocalState& state, double most,
                                   double enough) const noexcept {
  const auto& [x, y, heading] = state.pose;
  if (!std::isfinite(x + y + heading)) return 0.0;
  const double of_tractor = data_->clearance(data_->body, placement_of(state.pose), most, enough);
  if (!data_->towed || of_tractor == 0.0) return of_tractor;
  if (!std::isfinite(state.hitch_angle)) return 0.0;
  const Placement trailer = placement_of(trailer_pose(data_->towed->vehicle, state));
  return data_->clearance(data_->towed->body, trailer, of_tractor, enough);
}

bool CollisionChecker::map_is_within(const Local<Point>& point, double distance) const noexcept {
  return data_->ground->map && data_->ground->map->is_within(point, distance);
}

CollisionChecker::Range CollisionChecker::map_distance(const Local<Point>& point) const noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!data_->ground->map) return {infinity, infinity};
  const auto [least, most] = data_->ground->map->distance(point);
  return {least, most};
}

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "nasty/naive_zones.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "nasty/naive_geometry.h"
#include "nasty/naive_judge.h"
#include "vandplan/collision.h"

namespace vandplan::nasty {
namespace {

constexpr Real allowed_turn = 1e-5;         // by which a direction of travel may be off [rad]
constexpr Real beside = 4 * allowed_depth;  // both sides of a way are so far from it [m]
constexpr Real longest_look = 300;  // length of a path that is looked at millimetre by millimetre

/// A zone, its area counted from the start.
struct Area {
  const Zone* zone;
  Thing thing;
};

class Zones {
 public:
  explicit Zones(const Scenario& scenario)
      : scenario_(scenario), body_(body_of(scenario.vehicle, -allowed_depth)) {
    if (scenario.vehicle.trailer) trailer_ = body_of(*scenario.vehicle.trailer, -allowed_depth);
    for (const Zone& zone : scenario.zones) {
      areas_.push_back({&zone, thing_of(zone.name, zone.area, scenario.start)});
    }
  }

  /// Whether what the rules of a zone are about is in its area, by more than the allowed depth.
  [[nodiscard]] bool is_in(const Area& area, const Drive& at) const {
    if (!area.zone->body) {
      return holds(area.thing.corners, at.place) &&
             from_border(area.thing.corners, at.place) > allowed_depth;
    }
    const Frame vehicle = frame_at(at.place, at.heading);
    if (hits(area.thing, body_, vehicle)) return true;
    if (!scenario_.vehicle.trailer) return false;
    const Vector hitch = vehicle.placed({scenario_.vehicle.hitch, 0});
    const Frame behind = frame_at(hitch, at.heading - at.angle);
    const Vector axle = behind.placed({-scenario_.vehicle.trailer->wheelbase, 0});
    return hits(area.thing, trailer_, frame_at(axle, at.heading - at.angle));
  }

  /// Rule that is broken while the vehicle drives in a gear; gear 0: stands.
  [[nodiscard]] std::string broken(const Drive& at, int gear) const {
    for (const Area& area : areas_) {
      const Zone& zone = *area.zone;
      const bool is_wrong_gear =
          gear != 0 && zone.gears == (gear > 0 ? AllowedGears::reverse : AllowedGears::forward);
      const bool is_astray =
          gear != 0 && zone.direction &&
          beyond_headings(at.heading + (gear < 0 ? pi : 0), *zone.direction) > allowed_turn;
      if ((zone.closed || is_wrong_gear || is_astray) && is_in(area, at)) {
        return zone.closed     ? "is in a closed zone"
               : is_wrong_gear ? "drives in the wrong gear"
                               : "drives astray";
      }
    }
    return "";
  }

  /// How many times as much a metre costs there.
  [[nodiscard]] Real factor(const Drive& at) const {
    Real factor = 1;
    for (const Area& area : areas_) {
      if (area.zone->cost != 1 && is_in(area, at)) factor *= area.zone->cost;
    }
    for (const Mask& mask : scenario_.masks) {
      if (mask.use == MaskUse::cost) factor *= of_mask(mask, at.place, 1);
    }
    return factor;
  }

  /// By how much that factor differs on both sides of a way: it may run along the border of an
  /// area, or of a cell. A body touches what is nearer than the checker's tolerance.
  [[nodiscard]] Real doubt(const Drive& at) const {
    const Real near = difference(at, beside);
    const auto is_of_body = [](const Area& area) { return area.zone->body; };
    if (std::ranges::none_of(areas_, is_of_body)) return near;
    return std::max(near, difference(at, beside + CollisionChecker::tolerance));
  }

  /// Largest speed there by zones and masks.
  [[nodiscard]] Real speed(const Drive& at) const {
    Real speed = std::numeric_limits<Real>::infinity();
    for (const Area& area : areas_) {
      if (area.zone->max_speed && is_in(area, at)) {
        speed = std::min<Real>(speed, *area.zone->max_speed);
      }
    }
    for (const Mask& mask : scenario_.masks) {
      if (mask.use == MaskUse::max_speed) speed = std::min(speed, of_mask(mask, at.place, speed));
    }
    return speed;
  }

 private:
  /// By how much the factor differs that far to the left and to the right.
  [[nodiscard]] Real difference(Drive at, Real distance) const {
    const Vector place = at.place;
    const Vector aside = {-std::sin(at.heading) * distance, std::cos(at.heading) * distance};
    at.place = {place.x + aside.x, place.y + aside.y};
    const Real left = factor(at);
    at.place = {place.x - aside.x, place.y - aside.y};
    return std::abs(left - factor(at));
  }

  [[nodiscard]] static Real from_border(const std::vector<Vector>& area, const Vector& p) {
    Real least = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0, j = area.size() - 1; i < area.size(); j = i++) {
      least = std::min(least, from_segment(p, area[j], area[i]));
    }
    return least;
  }

  [[nodiscard]] Real of_mask(const Mask& mask, const Vector& place, Real otherwise) const {
    const Pose& start = scenario_.start;
    const Pose& origin = mask.map.origin;
    const Frame frame =
        frame_at({Real{origin.x} - start.x, Real{origin.y} - start.y}, origin.heading);
    const Vector p = frame.seen(place);
    const auto column = std::floor(p.x / mask.map.resolution);
    const auto row = std::floor(p.y / mask.map.resolution);
    if (column < 0 || row < 0 || column >= mask.map.columns || row >= mask.map.rows) {
      return otherwise;
    }
    const auto at = static_cast<std::size_t>(row * mask.map.columns + column);
    const Cell cell = (*mask.map.cells)[at];
    int percent = cell == Cell::occupied ? 100 : cell == Cell::free ? 0 : Mask::unknown;
    if (mask.percents) percent = (*mask.percents)[at];
    if (percent == Mask::unknown) return otherwise;
    if (percent == 0 && mask.use == MaskUse::max_speed) return otherwise;
    return mask.base + Real{mask.multiplier} * percent;
  }

  const Scenario& scenario_;
  Body body_;
  Body trailer_ = {};
  std::vector<Area> areas_;
};

}  // namespace

ZoneLook naive_look_at_zones(const Scenario& scenario, const Path& path) {
  ZoneLook look;
  if (scenario.zones.empty() && scenario.masks.empty()) return look;
  const Zones zones(scenario);
  Drive at{{}, scenario.start.heading, scenario.hitch_angles.start};
  look.flaw = zones.broken(at, 0);
  Real sum = 0, unsure = 0, duration = 0, before = zones.factor(at);
  const Real step = std::max<Real>(1e-3L, 1e-3L * length(path) / longest_look);
  for (const Segment& segment : path.segments) {
    const auto steps = static_cast<long>(std::abs(Real{segment.length}) / step) + 1;
    const Real part = Real{segment.length} / steps;
    for (long i = 0; i < 2 * steps; ++i) {  // looks in the middle of each step
      const Real curvature = segment.curvature + segment.curvature_rate * std::abs(part) * i / 2;
      if (scenario.vehicle.trailer) {
        at.fold(scenario.vehicle, curvature, segment.curvature_rate, part / 2);
      }
      at.step(curvature, segment.curvature_rate, part / 2);
      if (i % 2 != 0) continue;
      if (look.flaw.empty()) look.flaw = zones.broken(at, segment.length < 0 ? -1 : 1);
      const Real factor = zones.factor(at);
      sum += factor * std::abs(part);
      unsure += (std::abs(factor - before) + zones.doubt(at)) * std::abs(part);
      duration += std::abs(part) / zones.speed(at);
      before = factor;
    }
  }
  look.priced_length = static_cast<double>(sum);
  look.unsure = static_cast<double>(unsure);
  look.least_duration = static_cast<double>(duration);
  return look;
}

}  // namespace vandplan::nasty

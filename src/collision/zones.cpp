// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/zones.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vandplan::collision {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double direction_slack = 1e-9;  // by which a direction of travel may be off [rad]
constexpr double speck = 1e-4;            // half the side of what stands for the axle [m]
// Bounds beyond all worlds. They are finite, since checks subtract them.
constexpr Bounds everywhere{-1e8, 1e8, -1e8, 1e8};

bool has_rule(const Zone& zone) {
  return zone.closed || zone.gears != AllowedGears::both || zone.direction;
}

double reach_of(const Footprint& body) {
  return std::hypot(std::max(body.rear, body.front), body.half_width);
}

/// Largest distance of a point of the vehicle or its trailer from the rear axle [m].
double reach_of(const Vehicle& vehicle) {
  const double of_vehicle = reach_of(footprint(vehicle));
  if (!vehicle.trailer) return of_vehicle;
  const Trailer& trailer = *vehicle.trailer;
  return std::max(of_vehicle,
                  std::abs(vehicle.hitch) + trailer.wheelbase + reach_of(footprint(trailer)));
}

/// Distance of a place from a box [m].
double distance_from(const Bounds& box, const Pose& place) {
  const double x = std::max({box.x_min - place.x, place.x - box.x_max, 0.0});
  const double y = std::max({box.y_min - place.y, place.y - box.y_max, 0.0});
  return std::hypot(x, y);
}

/// A checker that takes the area for an obstacle of what the rules are about.
std::unique_ptr<const CollisionChecker> keeper_of(const Vehicle& vehicle, const Zone& zone) {
  const std::vector<Polygon> area{zone.area};
  if (!zone.body) {
    return std::make_unique<const CollisionChecker>(Footprint{speck, speck, speck}, everywhere,
                                                    area);
  }
  return std::make_unique<const CollisionChecker>(
      vehicle, Surroundings{.bounds = everywhere, .obstacles = area});
}

/// Direction of travel along a segment: `first` + `curvature` s + `rate` s^2 / 2 after s metres.
struct Travel {
  Travel(const Pose& from, const Segment& segment, int gear)
      : first(from.heading + (gear < 0 ? pi : 0.0)),
        curvature(segment.length < 0 ? -segment.curvature : segment.curvature),
        rate(segment.length < 0 ? -segment.curvature_rate : segment.curvature_rate),
        length(std::abs(segment.length)) {}

  [[nodiscard]] double at(double s) const { return first + s * (curvature + rate * s / 2); }

  /// Adds the places where the direction is `angle` but for whole turns.
  void add_places(double angle, std::vector<double>& places) const {
    double least = std::min(first, at(length)), most = std::max(first, at(length));
    const double vertex = rate != 0.0 ? -curvature / rate : -1.0;
    if (vertex > 0 && vertex < length) {
      least = std::min(least, at(vertex));
      most = std::max(most, at(vertex));
    }
    for (double turns = std::ceil((least - angle) / (2 * pi)); angle + 2 * pi * turns <= most;
         ++turns) {
      add_roots(angle + 2 * pi * turns - first, places);
    }
  }

  double first, curvature, rate, length;

 private:
  /// Adds the places where the vehicle has turned by `turn`.
  void add_roots(double turn, std::vector<double>& places) const {
    const double square = std::max(0.0, curvature * curvature + 2 * rate * turn);
    const double sum = curvature + std::copysign(std::sqrt(square), curvature);
    for (const double s : {sum != 0.0 ? 2 * turn / sum : -1.0, rate != 0.0 ? -sum / rate : -1.0}) {
      if (s > 0 && s < length) places.push_back(s);
    }
  }
};

/// Calls `breaks(begin, end)` for parts of a segment where the direction of travel is outside of a
/// range, until it returns true. Returns whether it did.
template <typename Breaks>
bool any_astray(const Travel& travel, const HeadingRange& allowed, Breaks breaks) {
  const double wide = width(allowed) + 2 * direction_slack;
  if (wide >= 2 * pi) return false;
  const double begin = allowed.from - direction_slack;
  std::vector<double> places{0.0, travel.length};
  travel.add_places(begin, places);
  travel.add_places(begin + wide, places);
  std::sort(places.begin(), places.end());
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double last = places[i - 1], next = places[i];
    if (!(next > last)) continue;
    const double off = travel.at(last + (next - last) / 2) - begin;
    if (off - 2 * pi * std::floor(off / (2 * pi)) > wide && breaks(last, next)) return true;
  }
  return false;
}

}  // namespace

/// A zone with what is needed to check its rules.
struct Zones::Checked {
  Checked(const Vehicle& vehicle, const Zone& of)
      : zone(of),
        keeper(keeper_of(vehicle, of)),
        box(bounding_box(of.area)),
        reach((of.body ? reach_of(vehicle) : speck) + CollisionChecker::tolerance) {}

  /// Whether a segment may begin or lead into the area. `gear`: direction of travel in time.
  [[nodiscard]] bool allows(const Vehicle& vehicle, const LocalState& from, const Segment& segment,
                            int gear) const {
    if (distance_from(box, from.pose) > reach + std::abs(segment.length)) return true;
    if (zone.closed) return keeper->is_free(from, segment);
    if (segment.length == 0.0) return true;
    if (zone.gears == (gear > 0 ? AllowedGears::reverse : AllowedGears::forward)) {
      return keeper->is_free(from, segment);
    }
    return !zone.direction ||
           !any_astray(
               Travel(from.pose, segment, gear), *zone.direction, [&](double begin, double end) {
                 const LocalState there = advance(vehicle, from, part_of(segment, 0.0, begin));
                 return !keeper->is_free(there, part_of(segment, begin, end));
               });
  }

  Zone zone;
  std::unique_ptr<const CollisionChecker> keeper;
  Bounds box;
  double reach;  // Largest distance from the rear axle of what the rules are about [m].
};

Zones::Zones(const Vehicle& vehicle, std::span<const Zone> zones) : vehicle_(vehicle) {
  for (const Zone& zone : zones) {
    if (has_rule(zone)) all_.emplace_back(vehicle, zone);
  }
}

Zones::~Zones() = default;

bool Zones::is_empty() const noexcept { return all_.empty(); }

bool Zones::allow(const LocalState& from, std::span<const Segment> segments,
                  InTime in_time) const noexcept {
  const int sign = in_time == InTime::onward ? 1 : -1;
  LocalState state = from;
  for (const Segment& segment : segments) {
    const int gear = segment.length < 0 ? -sign : sign;
    for (const Checked& each : all_) {
      if (!each.allows(vehicle_, state, segment, gear)) return false;
    }
    state = advance(vehicle_, state, segment);
  }
  return true;
}

}  // namespace vandplan::collision

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/zones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

#include "collision/travel.h"
#include "geometry/boxes.h"

namespace vandplan::collision {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
constexpr double direction_slack = 1e-9;  // by which a direction of travel may be off [rad]
constexpr double speck = 1e-4;            // half the side of what stands for the axle [m]
constexpr double on_side = 1e-9;          // relative slack at the ends of a side
// Where a body enters or leaves is known to `finest`. A body that touches an area twice within
// `surely` touches it in between [m].
constexpr double finest = 1e-4;
constexpr double surely = 0.1;
// Bounds beyond all worlds. They are finite, since checks subtract them.
constexpr Bounds everywhere{-1e8, 1e8, -1e8, 1e8};

double furthest_of(const Footprint& body) {
  return std::hypot(std::max(body.rear, body.front), body.half_width);
}

/// Largest distance of a point of the vehicle or its trailer from the rear axle [m].
double furthest_of(const Vehicle& vehicle) {
  const double of_vehicle = furthest_of(footprint(vehicle));
  if (!vehicle.trailer) return of_vehicle;
  const Trailer& trailer = *vehicle.trailer;
  return std::max(of_vehicle,
                  std::abs(vehicle.hitch) + trailer.wheelbase + furthest_of(footprint(trailer)));
}

/// Box around all places up to `length` [m] from a place.
Bounds box_around(const Pose& place, double length) {
  return {place.x - length, place.x + length, place.y - length, place.y + length};
}

/// Box around all places of the rear axle on a segment: around the ellipse of ways of its length
/// from its begin to its end.
Bounds box_of_axle(const Pose& from, const Segment& segment, const Pose& to) {
  constexpr double rounding = 1e-6;  // [m]
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double bulge =
      std::sqrt(std::max(segment.length * segment.length - dx * dx - dy * dy, 0.0)) / 2 + rounding;
  return {std::min(from.x, to.x) - bulge, std::max(from.x, to.x) + bulge,
          std::min(from.y, to.y) - bulge, std::max(from.y, to.y) + bulge};
}

bool are_apart(const Bounds& a, const Bounds& b) {
  return a.x_min > b.x_max || b.x_min > a.x_max || a.y_min > b.y_max || b.y_min > a.y_max;
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

/// Calls `breaks(begin, end)` for parts of a segment where the direction of travel is outside of a
/// range, until it returns true. Returns whether it did.
template <typename Breaks>
bool any_astray(const Travel& travel, const HeadingRange& allowed, Breaks breaks) {
  const double wide = width(allowed) + 2 * direction_slack;
  if (wide >= full_turn) return false;
  const double begin = allowed.from - direction_slack;
  std::vector<double> places{0.0, travel.length};
  travel.add_places(begin, places);
  travel.add_places(begin + wide, places);
  std::sort(places.begin(), places.end());
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double last = places[i - 1], next = places[i];
    if (!(next > last)) continue;
    const double off = travel.at(last + (next - last) / 2) - begin;
    if (off - full_turn * std::floor(off / full_turn) > wide && breaks(last, next)) return true;
  }
  return false;
}

/// Adds the places where the axle crosses the side from `a` to `b`. `axle`: box of the axle.
void add_crossings(const Pose& from, const Segment& segment, const Bounds& axle, const Point& a,
                   const Point& b, std::vector<double>& places) {
  // Most sides are out of reach.
  if (are_apart(axle, bounding_box(std::array{a, b}))) return;
  const Point side{b.x - a.x, b.y - a.y};
  const double squared = side.x * side.x + side.y * side.y;
  const Point off{from.x - a.x, from.y - a.y};
  const double reach = std::abs(segment.length) * std::sqrt(squared);
  const double ahead = side.x * off.x + side.y * off.y;
  if (std::abs(side.x * off.y - side.y * off.x) > reach) return;
  if (ahead < -reach - on_side * squared || ahead > squared + reach + on_side * squared) return;
  const Travel travel(from, segment, segment.length < 0 ? -1 : 1);
  const auto axle_at = [&](double s) { return advance(from, part_of(segment, 0.0, s)); };
  const auto left_of = [&](const Pose& p) { return side.x * (p.y - a.y) - side.y * (p.x - a.x); };
  // Between places where it travels along the side, the axle crosses the side's line at most once.
  const std::vector<double> turns = travel.places_along(std::atan2(side.y, side.x));
  double before = left_of(from);
  for (std::size_t i = 1; i < turns.size(); ++i) {
    const double after = left_of(axle_at(turns[i]));
    if ((before < 0) != (after < 0)) {
      const auto height = [&](double s) { return left_of(axle_at(s)); };
      const double end = crossing(turns[i - 1], turns[i], before, after, height);
      const Pose there = axle_at(end);
      const double part = (side.x * (there.x - a.x) + side.y * (there.y - a.y)) / squared;
      if (part >= -on_side && part <= 1 + on_side) places.push_back(end);
    }
    before = after;
  }
}

}  // namespace

bool has_rules(const Zone& zone) noexcept {
  return zone.closed || zone.gears != AllowedGears::both || zone.direction;
}

/// A zone with what is needed to find out where it holds.
struct Zones::Checked {
  Checked(const Vehicle& vehicle, const Zone& of)
      : zone(of),
        keeper(keeper_of(vehicle, of)),
        box(geometry::widened(bounding_box(of.area), (of.body ? furthest_of(vehicle) : speck) +
                                                         CollisionChecker::tolerance)) {}

  /// Whether a segment near the area may begin or lead into it. `gear`: direction of travel in
  /// time.
  [[nodiscard]] bool allows(const Vehicle& vehicle, const LocalState& from, const Segment& segment,
                            int gear) const {
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

  /// Whether the zone holds in a state.
  [[nodiscard]] bool holds(const LocalState& state) const {
    return zone.body ? !keeper->is_free(state)
                     : contains(zone.area, Point{state.pose.x, state.pose.y});
  }

  /// Adds the places where the zone begins or ceases to hold.
  void add_changes(const Vehicle& vehicle, const LocalState& from, const Segment& segment,
                   const Bounds& axle, std::vector<double>& places) const {
    if (zone.body) {
      add_touches(vehicle, from, segment, 0.0, std::abs(segment.length), places);
      return;
    }
    for (std::size_t i = 0; i < zone.area.size(); ++i) {
      add_crossings(from.pose, segment, axle, zone.area[i], zone.area[(i + 1) % zone.area.size()],
                    places);
    }
  }

  Zone zone;
  std::unique_ptr<const CollisionChecker> keeper;
  Bounds box;  // Around all places of the rear axle where the zone can hold.

 private:
  /// Adds the ends of parts on which the body may touch the area.
  void add_touches(const Vehicle& vehicle, const LocalState& from, const Segment& segment,
                   double begin, double end, std::vector<double>& places) const {
    const auto at = [&](double s) { return advance(vehicle, from, part_of(segment, 0.0, s)); };
    const LocalState first = at(begin);
    if (keeper->is_free(first, part_of(segment, begin, end))) return;
    const double middle = begin + (end - begin) / 2;
    const bool is_touching = end - begin <= surely && holds(first) && holds(at(end));
    if (is_touching || end - begin <= finest) {
      places.push_back(begin);
      places.push_back(end);
      return;
    }
    add_touches(vehicle, from, segment, begin, middle, places);
    add_touches(vehicle, from, segment, middle, end, places);
  }
};

Zones::Zones(const Vehicle& vehicle, std::span<const Zone> zones, std::span<const Mask> masks)
    : vehicle_(vehicle) {
  for (const Zone& zone : zones) all_.emplace_back(vehicle, zone);
  for (const Checked& each : all_) {
    if (has_rules(each.zone)) ruling_.push_back({each.box, &each});
    if (each.zone.cost != 1.0) telling_.push_back({each.box, &each});
  }
  price_zones_ = telling_.size();
  for (const Checked& each : all_) {
    if (each.zone.cost == 1.0 && each.zone.max_speed) telling_.push_back({each.box, &each});
  }
  const auto add_masks = [&](MaskUse use) {
    for (const Mask& mask : masks) {
      if (mask.use == use) masks_.emplace_back(mask);
    }
  };
  add_masks(MaskUse::cost);
  price_masks_ = masks_.size();
  add_masks(MaskUse::max_speed);
}

Zones::~Zones() = default;

bool Zones::have_prices() const noexcept {
  const auto is_price = [](const MaskCells& mask) { return mask.use() == MaskUse::cost; };
  return std::ranges::any_of(all_, [](const Checked& each) { return each.zone.cost != 1.0; }) ||
         std::ranges::any_of(masks_, is_price);
}

bool Zones::have_speed_limits() const noexcept {
  const auto limits = [](const Checked& each) { return each.zone.max_speed.has_value(); };
  const auto is_limit = [](const MaskCells& mask) { return mask.use() == MaskUse::max_speed; };
  return std::ranges::any_of(all_, limits) || std::ranges::any_of(masks_, is_limit);
}

// Whether no zone can hold within `length` [m] of a place.
bool Zones::is_far_from(std::span<const Boxed> zones, const Pose& place, double length) noexcept {
  const Bounds reached = box_around(place, length);
  return std::ranges::all_of(zones,
                             [&](const Boxed& each) { return are_apart(reached, each.box); });
}

bool Zones::allow(const LocalState& from, std::span<const Segment> segments,
                  InTime in_time) const noexcept {
  if (ruling_.empty()) return true;
  const int sign = in_time == InTime::onward ? 1 : -1;
  LocalState state = from;
  double left = length(segments);
  for (const Segment& segment : segments) {
    if (is_far_from(ruling_, state.pose, left)) return true;
    const int gear = segment.length < 0 ? -sign : sign;
    const LocalState end = advance(vehicle_, state, segment);
    const Bounds axle = box_of_axle(state.pose, segment, end.pose);
    for (const auto& [box, zone] : ruling_) {
      if (!are_apart(axle, box) && !zone->allows(vehicle_, state, segment, gear)) return false;
    }
    state = end;
    left -= std::abs(segment.length);
  }
  return true;
}

std::vector<GroundPart> Zones::along(const LocalState& from, const Segment& segment,
                                     GroundRules which) const {
  const double length = std::abs(segment.length);
  const bool is_all = which == GroundRules::all;
  const auto zones = std::span(telling_).first(is_all ? telling_.size() : price_zones_);
  const auto masks = std::span(masks_).first(is_all ? masks_.size() : price_masks_);
  if (masks.empty() && is_far_from(zones, from.pose, length)) return {{0.0, length}};
  const Bounds axle = box_of_axle(from.pose, segment, advance(from.pose, segment));
  std::vector<const Checked*> near;
  std::vector<double> places{0.0, length};
  for (const auto& [box, zone] : zones) {
    if (are_apart(axle, box)) continue;
    near.push_back(zone);
    zone->add_changes(vehicle_, from, segment, axle, places);
  }
  for (const MaskCells& mask : masks) mask.add_changes(from.pose, segment, places);
  if (near.empty() && masks.empty()) return {{0.0, length}};
  std::sort(places.begin(), places.end());
  std::vector<GroundPart> parts;
  for (std::size_t i = 1; i < places.size(); ++i) {
    GroundPart part{places[i - 1], places[i]};
    if (!(part.end > part.begin)) continue;
    const double middle = part.begin + (part.end - part.begin) / 2;
    const LocalState there = advance(vehicle_, from, part_of(segment, 0.0, middle));
    for (const Checked* each : near) {
      if (!each->holds(there)) continue;
      part.cost *= each->zone.cost;
      if (is_all) {
        part.max_speed = std::min(part.max_speed, each->zone.max_speed.value_or(part.max_speed));
      }
    }
    for (const MaskCells& mask : masks) mask.tell({there.pose.x, there.pose.y}, part);
    if (!parts.empty() && parts.back().cost == part.cost &&
        parts.back().max_speed == part.max_speed) {
      parts.back().end = part.end;
    } else {
      parts.push_back(part);
    }
  }
  return parts;
}

}  // namespace vandplan::collision

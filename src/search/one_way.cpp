// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/one_way.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/trigonometry.h"
#include "geometry/boxes.h"
#include "geometry/polygon.h"

namespace vandplan::search {
namespace {

constexpr double slack_of_sides = 2e-3;       // of places; larger than all tolerances [m]
constexpr double slack_of_directions = 1e-5;  // larger than the judge's [rad]
constexpr double slack_of_half = 1e-6;        // by which half of all directions may be off [rad]

/// Whether none of the directions has the sense: all point the other way, by more than `room`
/// [rad].
bool bars_sense(const HeadingRange& allowed, int sense, double room) {
  const double half = width(allowed) / 2;
  const double off = std::abs(wrap_angle(allowed.from + half - sense * std::numbers::pi / 2));
  return off - half > std::numbers::pi / 2 + room;
}

}  // namespace

// While the rear axle moves on by a metre, the centre moves by as much, and to the side by up to
// its distance from the axle over the radius.
OneWay::OneWay(const std::vector<Zone>& zones, const Disc& disc, double radius,
               const Bounds& bounds)
    : bounds_(bounds) {
  const double room = slack_of_directions + std::atan(std::abs(disc.ahead) / radius);
  for (const Zone& zone : zones) {
    if (!zone.direction) continue;
    const double near = zone.body ? disc.radius : -std::abs(disc.ahead);
    Street street{zone.area, bounding_box(zone.area), *zone.direction, near, {}, {}};
    const double half = width(*zone.direction) / 2;
    if (half + std::atan(std::abs(disc.ahead) / radius) <= std::numbers::pi / 2 + slack_of_half) {
      const auto [sin, cos] = base::sin_cos(zone.direction->from + half);
      street.onward = Point{cos, sin};
    }
    for (int sense = 0; sense < 4; ++sense) {
      street.bars[static_cast<std::size_t>(sense)] = bars_sense(*zone.direction, sense, room);
    }
    streets_.push_back(std::move(street));
  }
}

std::vector<Bounds> OneWay::barring() const {
  std::vector<Bounds> boxes;
  boxes.reserve(streets_.size());
  for (const Street& street : streets_) {
    const auto& bars = street.bars;
    const bool bars_any = std::find(bars.begin(), bars.end(), true) != bars.end();
    if (bars_any || street.onward) boxes.push_back(street.box);
  }
  return boxes;
}

bool OneWay::Street::holds(const Bounds& bounds, const Point& middle, double off) const {
  return contains(geometry::widened(box, std::max(near, 0.0) + off), middle) &&
         geometry::distance_in_bounds(area, bounds, middle) <= near - off - slack_of_sides;
}

bool OneWay::bars(const Point& middle, double length, int sense) const {
  return std::any_of(streets_.begin(), streets_.end(), [&](const Street& street) {
    return street.bars[static_cast<std::size_t>(sense)] &&
           street.holds(bounds_, middle, length / 2);
  });
}

// A pose where the vehicle may not move is on no path: what is near it is forbidden, too.
bool OneWay::forbids(const Point& centre, double off, double heading, double turn,
                     GearSign only) const {
  return std::any_of(streets_.begin(), streets_.end(), [&](const Street& street) {
    const double half = width(street.direction) / 2;
    const auto is_wrong = [&](double direction) {
      return std::abs(wrap_angle(direction - street.direction.from - half)) >
             half + turn + slack_of_directions;
    };
    const bool is_astray =
        (only < 0 || is_wrong(heading)) && (only > 0 || is_wrong(heading + std::numbers::pi));
    return is_astray && street.holds(bounds_, centre, off);
  });
}

int OneWay::street_of(const Point& middle, double off) const {
  const auto street = std::find_if(streets_.begin(), streets_.end(), [&](const Street& each) {
    return each.onward && each.holds(bounds_, middle, off);
  });
  return street == streets_.end() ? -1 : static_cast<int>(street - streets_.begin());
}

OneWay::Along OneWay::range_along(int street, const Point& middle, double off,
                                  bool is_backward) const {
  const auto& [area, box, direction, near, bars, onward] =
      streets_[static_cast<std::size_t>(street)];
  const double sign = is_backward ? -1.0 : 1.0;
  const double x = onward->x * (middle.x - box.x_min);
  const double y = onward->y * (middle.y - box.y_min);
  const double most = off * std::max(std::abs(onward->x), std::abs(onward->y));
  return {static_cast<float>(sign * (x + y) - most), static_cast<float>(sign * (x + y) + most)};
}

}  // namespace vandplan::search

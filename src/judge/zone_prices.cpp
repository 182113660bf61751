// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/zone_prices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "judge/mask_look.h"
#include "judge/zones.h"

namespace vandplan::judge {
namespace {

constexpr double axle_slack = 1e-6;    // distance from an edge at which the axle may be inside [m]
constexpr double body_slack = 1.5e-3;  // distance at which a body may touch [m]
constexpr double beyond_zone = 1.0;    // distances above are not distinguished [m]
// Part of which only the ends are looked at: so short that its price does not matter [m].
constexpr Real longest_unseen = 1e-3, price_unseen = 2e-3;
constexpr Real surely = 0.02;  // part on which a body touches if it does at three places [m]
constexpr int halvings_of_edge = 50;

/// Distance of a place from the sides of a polygon [m].
Real depth_in(const Polygon& area, const Position& place) {
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Point& a = area[i];
    const Point& b = area[(i + 1) % area.size()];
    const Real ux = static_cast<Real>(b.x) - a.x, uy = static_cast<Real>(b.y) - a.y;
    const Real px = place.x - a.x, py = place.y - a.y;
    const Real part = std::clamp<Real>((px * ux + py * uy) / (ux * ux + uy * uy), 0, 1);
    least = std::min(least, std::hypot(px - part * ux, py - part * uy));
  }
  return least;
}

bool is_priced(const Zone& zone) { return zone.cost != 1 || zone.max_speed; }

/// Where one zone holds on a track.
class Holding {
 public:
  Holding(const Zone& zone, const Vehicle& vehicle, const Track& track, const Trailing* trailing,
          AtEdge at_edge)
      : zone_(zone), bodies_(zone, vehicle, track, trailing) {
    const bool is_most = at_edge == AtEdge::inside;
    if (zone.cost > 1) {
      shortest_ = std::clamp<Real>(price_unseen / (zone.cost - 1), 1e-6, longest_unseen);
    }
    level_ = zone.body ? (is_most ? body_slack : 0.0) : (is_most ? axle_slack : -axle_slack);
  }

  void apply_to(PricedPart& part) const {
    part.factor *= zone_.cost;
    if (zone_.max_speed) part.max_speed = std::min<Real>(part.max_speed, *zone_.max_speed);
  }
  [[nodiscard]] bool holds(const Place& place) { return distance(place) <= level_; }

  /// Adds the places of a stretch where the zone begins or ceases to hold.
  void add_changes(std::size_t stretch, Real begin, Real end, std::vector<Real>& places) {
    const Place middle{stretch, (begin + end) / 2};
    const Real half = (end - begin) / 2;
    if (steady_at(middle) > half) return;
    if (end - begin <= shortest_) {
      add_change(stretch, begin, end, places);
      return;
    }
    if (zone_.body && end - begin <= surely && holds({stretch, begin}) && holds(middle) &&
        holds({stretch, end})) {
      return;
    }
    add_changes(stretch, begin, middle.t, places);
    add_changes(stretch, middle.t, end, places);
  }

 private:
  /// Distance of what counts from the area [m]. For an axle inside it is negative.
  [[nodiscard]] Real distance(const Place& place) {
    double least = beyond_zone;
    for (const Body& body : bodies_.all()) {
      least = clearance_of(body, place, least, effort_);
    }
    if (zone_.body || least > 0) return least;
    const Track& track = bodies_.all().front().track;
    return -depth_in(zone_.area, after(track.stretches[place.stretch], place.t));
  }

  /// Metres before and after a place on which nothing changes.
  [[nodiscard]] Real steady_at(const Place& place) {
    const Real off = distance(place) - level_;
    if (zone_.body && off <= 0) return 0;
    double speed = 0;
    for (const Body& body : bodies_.all()) {
      speed = std::max(speed, speed_of(body, body.track.stretches[place.stretch]));
    }
    return std::abs(off) / speed;
  }

  void add_change(std::size_t stretch, Real begin, Real end, std::vector<Real>& places) {
    const bool first = holds({stretch, begin});
    if (first == holds({stretch, end})) return;
    for (int i = 0; i < halvings_of_edge; ++i) {
      const Real middle = (begin + end) / 2;
      (holds({stretch, middle}) == first ? begin : end) = middle;
    }
    places.push_back(end);
  }

  const Zone& zone_;
  ZoneBodies bodies_;
  Real level_ = 0;
  Real shortest_ = longest_unseen;
  Effort effort_;
};

}  // namespace

bool has_prices(const Surroundings& ground) {
  return std::any_of(ground.zones.begin(), ground.zones.end(), is_priced) ||
         std::any_of(ground.masks.begin(), ground.masks.end(), is_graded);
}

std::vector<PricedPart> priced_parts(const Surroundings& ground, const Vehicle& vehicle,
                                     const Track& track, const Trailing* trailing, AtEdge at_edge) {
  std::vector<std::unique_ptr<Holding>> priced;
  for (const Zone& zone : ground.zones) {
    if (!is_priced(zone)) continue;
    priced.push_back(std::make_unique<Holding>(zone, vehicle, track, trailing, at_edge));
  }
  std::vector<MaskLook> masks;
  for (const Mask& mask : ground.masks) {
    if (is_graded(mask)) masks.emplace_back(mask, track, at_edge);
  }
  std::vector<PricedPart> parts;
  for (std::size_t i = 0; i < track.stretches.size(); ++i) {
    const Real length = track.stretches[i].length;
    std::vector<Real> places = {0, length};
    for (const auto& zone : priced) zone->add_changes(i, 0, length, places);
    for (const MaskLook& mask : masks) mask.add_changes(i, 0, length, places);
    std::sort(places.begin(), places.end());
    for (std::size_t k = 1; k < places.size(); ++k) {
      PricedPart part{i, places[k - 1], places[k]};
      if (!(part.end > part.begin)) continue;
      const Place middle{i, (part.begin + part.end) / 2};
      for (const auto& zone : priced) {
        if (zone->holds(middle)) zone->apply_to(part);
      }
      for (const MaskLook& mask : masks) mask.apply_to(part, middle);
      parts.push_back(part);
    }
  }
  return parts;
}

Real max_speed_at(const std::vector<PricedPart>& parts, const Place& place) {
  const auto is_before = [](const PricedPart& part, const Place& there) {
    return part.stretch != there.stretch ? part.stretch < there.stretch : part.end < there.t;
  };
  const auto part = std::lower_bound(parts.begin(), parts.end(), place, is_before);
  return part == parts.end() ? std::numeric_limits<Real>::infinity() : part->max_speed;
}

}  // namespace vandplan::judge

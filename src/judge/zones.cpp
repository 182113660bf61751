// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/zones.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "judge/text.h"

namespace vandplan::judge {
namespace {

// Largest motion of a point of a body between two looks [m]: who cuts a corner by a millimetre is
// seen.
constexpr double most_moved = 1e-4;
constexpr Real direction_slack = 1e-6;  // tolerance of directions of travel [rad]
constexpr double far_enough = 1.0;      // clearances above are not distinguished [m]
constexpr int bisections = 80;          // halvings that find a direction on a stretch

/// Part of a stretch.
struct PartOfStretch {
  Real begin, end;
};

/// Direction of travel after `t` metres of a stretch [rad]; it is not wrapped.
Real direction_at(const Stretch& stretch, Real t) {
  const Real turned = stretch.direction * t * (stretch.curvature + stretch.rate * t / 2);
  return stretch.start.heading + turned + (stretch.direction < 0 ? full_turn / 2 : 0);
}

/// Place between `begin` and `end` where the direction is `wanted`. It changes in one sense there.
Real place_of(const Stretch& stretch, Real wanted, Real begin, Real end) {
  const bool grows = direction_at(stretch, end) > direction_at(stretch, begin);
  for (int i = 0; i < bisections; ++i) {
    const Real middle = (begin + end) / 2;
    ((direction_at(stretch, middle) < wanted) == grows ? begin : end) = middle;
  }
  return (begin + end) / 2;
}

/// Ends of the parts of a stretch on which the direction is either allowed or not.
std::vector<Real> changes_of(const Stretch& stretch, Real length, Real first, Real last) {
  std::vector<Real> ends = {0, length};
  const Real vertex = stretch.rate != 0 ? -stretch.curvature / stretch.rate : -1;
  if (vertex > 0 && vertex < length) ends.insert(ends.begin() + 1, vertex);
  std::vector<Real> all = ends;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const Real from = direction_at(stretch, ends[i - 1]), to = direction_at(stretch, ends[i]);
    const auto [least, most] = std::minmax(from, to);
    for (const Real edge : {first, last}) {
      Real angle = edge + full_turn * std::ceil((least - edge) / full_turn);
      for (; angle <= most; angle += full_turn) {
        all.push_back(place_of(stretch, angle, ends[i - 1], ends[i]));
      }
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Parts of a stretch where the direction of travel is outside of a range.
std::vector<PartOfStretch> astray(const Stretch& stretch, Real length, const HeadingRange& range) {
  Real wide = static_cast<Real>(range.to) - range.from;
  if (wide < 0) wide -= full_turn * std::floor(wide / full_turn);
  wide += 2 * direction_slack;
  std::vector<PartOfStretch> parts;
  if (wide >= full_turn) return parts;
  const Real first = range.from - direction_slack;
  const std::vector<Real> ends = changes_of(stretch, length, first, first + wide);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (!(ends[i] > ends[i - 1])) continue;
    const Real off = direction_at(stretch, (ends[i - 1] + ends[i]) / 2) - first;
    if (off - full_turn * std::floor(off / full_turn) > wide) {
      parts.push_back({ends[i - 1], ends[i]});
    }
  }
  return parts;
}

bool is_wrong_gear(const Stretch& stretch, AllowedGears gears) {
  return gears == (stretch.direction > 0 ? AllowedGears::reverse : AllowedGears::forward);
}

/// One zone, and the bodies whose being there counts.
class ZoneCheck {
 public:
  ZoneCheck(const Zone& zone, std::size_t index, const Vehicle& vehicle, const Track& track,
            const Trailing* trailing)
      : zone_(zone), index_(index), track_(track), bodies_(zone, vehicle, track, trailing) {}

  [[nodiscard]] std::optional<Fault> broken() {
    for (std::size_t i = 0; i < track_.stretches.size(); ++i) {
      const Stretch& stretch = track_.stretches[i];
      if (zone_.closed) {
        if (auto rule = broken_on(i, {{0, length_on(stretch)}}, "which is closed")) return rule;
      }
      if (!(stretch.length > 0)) continue;
      if (is_wrong_gear(stretch, zone_.gears)) {
        const std::string gears(name_of(zone_.gears));
        if (auto rule = broken_on(i, {{0, length_on(stretch)}},
                                  text("where the gears are: %s", gears.c_str()))) {
          return rule;
        }
      }
      if (!zone_.direction) continue;
      const auto& [from, to] = *zone_.direction;
      if (auto rule = broken_on(i, astray(stretch, length_on(stretch), *zone_.direction),
                                text("where the direction of travel is %g to %g rad", from, to))) {
        return rule;
      }
    }
    return std::nullopt;
  }

 private:
  /// Length of a stretch that has to be looked at [m].
  [[nodiscard]] Real length_on(const Stretch& stretch) const {
    return length_to_look_at(bodies_.all().back(), stretch);
  }

  /// The rule if a body is in the area on one of the parts. `rule` is half a sentence.
  [[nodiscard]] std::optional<Fault> broken_on(std::size_t stretch,
                                               const std::vector<PartOfStretch>& parts,
                                               const std::string& rule) {
    for (const PartOfStretch& part : parts) {
      for (const Body& body : bodies_.all()) {
        const auto place = first_in_area(body, stretch, part);
        if (!place) continue;
        const std::string name = zone_.name.empty() ? "" : " (" + zone_.name + ")";
        const char* const what = body.trailing != nullptr ? "the trailer"
                                 : zone_.body             ? "the footprint"
                                                          : "the rear axle";
        return Fault{
            std::string(what) + " is in zones[" + std::to_string(index_) + "]" + name + ", " + rule,
            *place, Hit{HitKind::zone, index_}};
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_in_area(const Body& body, const Place& place) {
    return clearance_of(body, place, far_enough, effort_) == 0;
  }

  /// A place of the part where the body is in the area.
  [[nodiscard]] std::optional<Place> first_in_area(const Body& body, std::size_t stretch,
                                                   const PartOfStretch& part) {
    for (const Place& end : {Place{stretch, part.begin}, Place{stretch, part.end}}) {
      if (is_in_area(body, end)) return end;
    }
    return between(body, stretch, part);
  }

  [[nodiscard]] std::optional<Place> between(const Body& body, std::size_t stretch,
                                             const PartOfStretch& part) {
    const Place middle{stretch, (part.begin + part.end) / 2};
    const Onlooker there = onlooker_at(body, middle);
    const auto half = static_cast<double>((part.end - part.begin) / 2);
    if (clearance_of(there, half, far_enough, effort_) > 0) return std::nullopt;
    if (clearance_of(there, 0, far_enough, effort_) == 0) return middle;
    if (2 * half * speed_of(body, there.stretch) <= most_moved) return std::nullopt;
    if (auto place = between(body, stretch, {part.begin, middle.t})) return place;
    return between(body, stretch, {middle.t, part.end});
  }

  const Zone& zone_;
  std::size_t index_;
  const Track& track_;
  ZoneBodies bodies_;
  Effort effort_;
};

}  // namespace

ZoneBodies::ZoneBodies(const Zone& zone, const Vehicle& vehicle, const Track& track,
                       const Trailing* trailing)
    : surroundings_{.obstacles = {zone.area}}, ground_(surroundings_) {
  const Outline axle{0, 0, 0, 0};
  bodies_.push_back({track, ground_, zone.body ? outlines_of(vehicle) : Outlines{axle, axle}});
  if (!zone.body || trailing == nullptr) return;
  bodies_.push_back({track, ground_, outlines_of(*vehicle.trailer), trailing});
}

std::optional<Fault> broken_rule(const std::vector<Zone>& zones, const Vehicle& vehicle,
                                 const Track& track, const Trailing* trailing) {
  for (std::size_t i = 0; i < zones.size(); ++i) {
    ZoneCheck check(zones[i], i, vehicle, track, trailing);
    if (auto rule = check.broken()) return rule;
  }
  return std::nullopt;
}

}  // namespace vandplan::judge

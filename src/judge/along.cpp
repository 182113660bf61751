// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/along.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace vandplan::judge {
namespace {

// Largest motion of any point of a body between two looks [m].
constexpr double look_distance = 1e-3;
constexpr double clearance_error = 1e-3;  // largest error of the reported clearance [m]

bool is_before(const Place& a, const Place& b) {
  return std::tie(a.stretch, a.t) < std::tie(b.stretch, b.t);
}

/// Part of a stretch.
struct StretchPart {
  double bound = 0.0;  ///< lower bound of the clearance on the part [m]
  std::size_t stretch = 0;
  Real begin = 0;
  Real end = 0;

  [[nodiscard]] Place middle() const { return {stretch, (begin + end) / 2}; }
};

struct MayComeNearer {
  bool operator()(const StretchPart& a, const StretchPart& b) const { return a.bound > b.bound; }
};

class ClearanceSearch {
 public:
  ClearanceSearch(const Body& body, const Keeping& keeping)
      : body_(body), track_(body.track), keeping_(keeping) {}

  /// Look at the ends of all stretches, and between them. Both lower `least`; if it becomes 0,
  /// `touch` is the place.
  void look_at_ends();
  void look_between();

  /// First place where the body touches an obstacle; `known` is one such place.
  [[nodiscard]] Place first_touch(const Place& known);

  [[nodiscard]] double least() const { return least_; }
  [[nodiscard]] const std::optional<Place>& touch() const { return touch_; }
  [[nodiscard]] const Effort& effort() const { return effort_; }

 private:
  [[nodiscard]] StretchPart whole(std::size_t stretch) const {
    return {0, stretch, 0, length_to_look_at(body_, track_.stretches[stretch])};
  }
  [[nodiscard]] double kept_within(const Place& place, double half) const {
    if (keeping_.ramps.empty()) return keeping_.margin;
    return keeping_.most_within(after(track_.stretches[place.stretch], place.t), half);
  }
  /// Clearance beyond the required distance [m]: at least 0, cut off at `most`.
  [[nodiscard]] double clearance(const Onlooker& there, const Place& place, double half,
                                 double most);
  [[nodiscard]] double clearance(const Place& place, double most) {
    return clearance(onlooker_at(body_, place), place, 0, most);
  }
  [[nodiscard]] double bound_of(const StretchPart& part, const Onlooker& in_middle, double most) {
    const auto half = static_cast<double>((part.end - part.begin) / 2);
    return clearance(in_middle, part.middle(), half, most);
  }
  [[nodiscard]] bool does_not_matter(double bound) const {
    return bound > 0 && bound >= least_ - clearance_error;
  }
  /// Whether no point of the body moves more than `look_distance` on the part.
  [[nodiscard]] bool is_short(const StretchPart& part) const {
    return static_cast<double>(part.end - part.begin) * speed_on(part) <= look_distance;
  }
  /// Upper bound of the motion of any point of the body on the part, per metre driven.
  [[nodiscard]] double speed_on(const StretchPart& part) const {
    return speed_of(body_, track_.stretches[part.stretch]);
  }
  [[nodiscard]] bool touches(const Place& place) { return clearance(place, look_distance) == 0; }
  void look(const Onlooker& there, const Place& place) {
    least_ = clearance(there, place, 0, least_);
    if (least_ == 0) touch_ = place;
  }
  void look(const Place& place) { look(onlooker_at(body_, place), place); }
  [[nodiscard]] std::optional<Place> first_touch_on(const StretchPart& part, const Place& known);
  /// First touch on a short part; the body touches at place `last`.
  [[nodiscard]] Place contact(const StretchPart& part, const Place& last);

  const Body& body_;
  const Track& track_;
  const Keeping& keeping_;
  double least_ = std::numeric_limits<double>::infinity();
  std::optional<Place> touch_;
  Effort effort_;
};

double ClearanceSearch::clearance(const Onlooker& there, const Place& place, double half,
                                  double most) {
  const double kept = kept_within(place, half);
  return std::max(clearance_of(there, half, most + kept, effort_) - kept, 0.0);
}

void ClearanceSearch::look_at_ends() {
  const std::size_t count = track_.stretches.size();
  for (std::size_t i = 0; i < count && least_ > 0; ++i) look({i, 0});
  if (least_ > 0) look({count - 1, track_.stretches.back().length});
}

void ClearanceSearch::look_between() {
  std::priority_queue<StretchPart, std::vector<StretchPart>, MayComeNearer> parts;
  for (std::size_t i = 0; i < track_.stretches.size(); ++i) parts.push(whole(i));
  while (!parts.empty() && least_ > 0) {
    effort_.parts = std::max(effort_.parts, parts.size());
    const StretchPart part = parts.top();
    if (does_not_matter(part.bound)) return;
    parts.pop();
    const Place middle = part.middle();
    const Onlooker in_middle = onlooker_at(body_, middle);
    const double bound = bound_of(part, in_middle, least_);
    if (does_not_matter(bound)) continue;
    look(in_middle, middle);
    if (is_short(part)) continue;
    parts.push({bound, part.stretch, part.begin, middle.t});
    parts.push({bound, part.stretch, middle.t, part.end});
  }
}

Place ClearanceSearch::first_touch(const Place& known) {
  for (std::size_t i = 0; i <= known.stretch; ++i) {
    if (!is_before({i, 0}, known)) break;
    if (touches({i, 0})) return {i, 0};
    if (const auto touch = first_touch_on(whole(i), known)) return *touch;
  }
  return known;
}

std::optional<Place> ClearanceSearch::first_touch_on(const StretchPart& part, const Place& known) {
  const Place middle = part.middle();
  if (!is_before({part.stretch, part.begin}, known)) return std::nullopt;
  if (bound_of(part, onlooker_at(body_, middle), look_distance) > 0) return std::nullopt;
  if (is_short(part)) {
    for (const Place& place : {middle, Place{part.stretch, part.end}}) {
      const Place last = is_before(place, known) ? place : known;
      if (touches(last)) return contact(part, last);
    }
    return std::nullopt;
  }
  const StretchPart first{0, part.stretch, part.begin, middle.t};
  if (const auto touch = first_touch_on(first, known)) return touch;
  return first_touch_on({0, part.stretch, middle.t, part.end}, known);
}

/// Steps as long as the clearance cannot pass the first touch. If there are too many steps, the
/// result is late by at most half of `look_distance`.
Place ClearanceSearch::contact(const StretchPart& part, const Place& last) {
  constexpr int most_steps = 100;
  constexpr double least_step = 1e-12;  // least motion of any point of the body in a step [m]
  Place place{part.stretch, part.begin};
  for (int i = 0; i < most_steps && is_before(place, last); ++i) {
    const double distance = clearance(place, look_distance);
    if (distance == 0) return place;
    place.t += std::max(distance, least_step) / speed_on(part);
  }
  return last;
}

}  // namespace

double Keeping::most_within(const Position& place, double half) const {
  double most = margin;
  for (const auto& [centre, least, reach] : ramps) {
    const auto middle = static_cast<double>(std::hypot(place.x - centre.x, place.y - centre.y));
    const double part = (middle + half) / reach;
    if (part < 1) most = std::min(most, least + (margin - least) * part);
  }
  return most;
}

Nearest nearest_along(const Body& body, const Keeping& keeping) {
  if (body.ground.is_empty()) return {std::numeric_limits<double>::infinity(), {}, {}};
  ClearanceSearch search(body, keeping);
  search.look_at_ends();
  search.look_between();
  std::optional<Place> touch = search.touch();
  if (touch) touch = search.first_touch(*touch);
  return {search.least(), touch, search.effort()};
}

}  // namespace vandplan::judge

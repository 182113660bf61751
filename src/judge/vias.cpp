// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/vias.h"

#include <algorithm>
#include <cmath>

#include "judge/goals.h"
#include "judge/steering.h"
#include "judge/text.h"

namespace vandplan::judge {
namespace {

constexpr Real passed_tolerance = 1e-6;          // tolerance of places [m] and angles [rad]
constexpr Real stated_passing_tolerance = 1e-5;  // tolerance of stated, rounded numbers [m, rad]
constexpr Real finest = 1e-7;                    // half of the shortest part that is looked at [m]

/// Finds where a track passes one via.
class Passing {
 public:
  Passing(const Task& task, const Track& track, const Trailing* trailing, const Via& via)
      : vehicle_(task.vehicle), track_(track), trailing_(trailing), via_(via) {}

  /// Whether the vehicle is in a region of the via, up to `allowed` [m, rad].
  [[nodiscard]] bool is_in(const Place& place, Real allowed) const {
    return may_be_in(place, allowed, {});
  }

  /// First place from `from` on; none if there is none.
  [[nodiscard]] std::optional<Place> first(const Place& from) const {
    for (std::size_t i = from.stretch; i < track_.stretches.size(); ++i) {
      const Real begin = i == from.stretch ? from.t : 0;
      const Real end = track_.stretches[i].length;
      if (is_in({i, begin}, passed_tolerance)) return Place{i, begin};
      const std::optional<Real> t = first_between(i, begin, end);
      if (!t) continue;
      const bool is_at_end = end - *t <= 3 * passed_tolerance && is_in({i, end}, passed_tolerance);
      return Place{i, is_at_end ? end : *t};
    }
    return std::nullopt;
  }

  /// First begin of a stretch from `from` on where the curvature jumps, in a region of the via.
  [[nodiscard]] std::optional<Place> first_jump(const Place& from) const {
    for (std::size_t i = from.stretch + (from.t > 0 ? 1 : 0); i < track_.stretches.size(); ++i) {
      if (jumps_rolling(track_, vehicle_, i) && is_in({i, 0}, passed_tolerance)) return Place{i, 0};
    }
    return std::nullopt;
  }

 private:
  /// By how much place, heading and hitch angle may change near a place [m, rad].
  struct Slack {
    Real place = 0, turn = 0, fold = 0;
  };

  [[nodiscard]] bool may_be_in(const Place& place, Real allowed, const Slack& change) const {
    const Position axle = after(track_.stretches[place.stretch], place.t);
    const Real angle = trailing_ == nullptr ? 0 : trailing_->angle(place);
    return std::any_of(via_.any_of.begin(), via_.any_of.end(), [&](const GoalRegion& region) {
      const bool is_of_trailer = region.is_of_trailer && trailing_ != nullptr;
      const Position at = is_of_trailer ? trailing_->position(place) : axle;
      return distance_from(region, at.x, at.y) <= allowed + change.place &&
             std::abs(turn_into(region, at.heading)) <= allowed + change.turn &&
             std::abs(fold_into(region, angle)) <= allowed + change.fold;
    });
  }

  /// Changes within `half` metres of a place on a stretch.
  [[nodiscard]] Slack slack_of(const Stretch& stretch, Real half) const {
    const Real turn = steepest(stretch);
    if (trailing_ == nullptr) return {half, half * turn, 0};
    const Real hitch = std::abs(static_cast<Real>(vehicle_.hitch));
    const Real swing = (1 + hitch * turn) / vehicle_.trailer->wheelbase;
    const Real place = std::max<Real>(1, trailing_->speed(stretch, 0));
    return {half * place, half * std::max(turn, swing), half * (turn + swing)};
  }

  /// First place between two on a stretch.
  [[nodiscard]] std::optional<Real> first_between(std::size_t i, Real begin, Real end) const {
    const Real half = (end - begin) / 2;
    const Real middle = begin + half;
    if (!may_be_in({i, middle}, passed_tolerance, slack_of(track_.stretches[i], half))) {
      return std::nullopt;
    }
    if (half <= finest) {
      return is_in({i, middle}, passed_tolerance) ? std::optional(middle) : std::nullopt;
    }
    const std::optional<Real> t = first_between(i, begin, middle);
    return t ? t : first_between(i, middle, end);
  }

  const Vehicle& vehicle_;
  const Track& track_;
  const Trailing* trailing_;
  const Via& via_;
};

/// Place `s` metres from the start of a track.
Place place_behind(const Track& track, Real s) {
  std::size_t i = 0;
  while (i + 1 < track.stretches.size() && track.stretches[i + 1].s <= s) ++i;
  const Stretch& stretch = track.stretches[i];
  return {i, std::clamp<Real>(s - stretch.s, 0, stretch.length)};
}

}  // namespace

Passings passings(const Task& task, const Track& track, const Trailing* trailing,
                  Steering steering) {
  Passings passed;
  Place from;
  for (const Via& via : task.via) {
    const Passing passing(task, track, trailing, via);
    std::optional<Place> place;
    if (via.stop && steering == Steering::continuous_between_stops) {
      place = passing.first_jump(from);
    }
    if (!place) place = passing.first(from);
    if (!place) break;
    passed.places.push_back(*place);
    if (via.stop) passed.stops.push_back(*place);
    from = *place;
  }
  return passed;
}

std::optional<std::string> false_passings(const Task& task, const Track& track,
                                          const Trailing* trailing,
                                          const std::vector<PassedVia>& stated) {
  if (stated.empty()) return std::nullopt;
  if (stated.size() != task.via.size()) {
    return text("%zu vias are stated, the scenario has %zu", stated.size(), task.via.size());
  }
  Real last = 0;
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const auto& [s, pose] = stated[i];
    const bool is_ahead =
        s >= last - stated_passing_tolerance && s <= track.length + stated_passing_tolerance;
    if (!is_ahead) return text("the stated via[%zu] is not between the one before and the end", i);
    const Place place = place_behind(track, s);
    const Position at = after(track.stretches[place.stretch], place.t);
    const Real turn = std::remainder(at.heading - static_cast<Real>(pose.heading), full_turn);
    const bool is_there = std::hypot(at.x - pose.x, at.y - pose.y) <= stated_passing_tolerance &&
                          std::abs(turn) <= stated_passing_tolerance;
    const Passing passing(task, track, trailing, task.via[i]);
    if (!is_there || !passing.is_in(place, 2 * stated_passing_tolerance)) {
      return text("the stated via[%zu] is not where the path passes it", i);
    }
    last = s;
  }
  return std::nullopt;
}

}  // namespace vandplan::judge

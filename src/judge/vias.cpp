// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/vias.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "judge/goals.h"
#include "judge/speed_knots.h"
#include "judge/steering.h"
#include "judge/text.h"

namespace vandplan::judge {
namespace {

constexpr Real passed_tolerance = 1e-6;          // tolerance of places [m] and angles [rad]
constexpr Real stated_passing_tolerance = 1e-5;  // tolerance of stated, rounded numbers [m, rad]
constexpr Real joint_slack = 1e-9;               // joints so near are at one place [m]
constexpr Real finest = 1e-7;                    // half of the shortest part that is looked at [m]

/// Place where a segment begins, or the end of a track.
struct Joint {
  Place place;
  bool stands = true;       // whether the vehicle stands there, via or not
  bool needs_stop = false;  // whether wheels turn at once there, though the gear stays
};

/// Which joints are looked for.
enum class Wanted : std::uint8_t { all, standing, needing_stop };

std::vector<Joint> joints_of(const Track& track, const Vehicle& vehicle) {
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < track.stretches.size(); ++i) {
    if (!track.stretches[i].is_first) continue;
    const bool keeps_gear =
        i > 0 && track.stretches[i].direction == track.stretches[i - 1].direction;
    const bool needs_stop = keeps_gear && jumps(track, vehicle, i);
    joints.push_back({{i, 0}, !keeps_gear || needs_stop, needs_stop});
  }
  joints.push_back({{track.stretches.size() - 1, track.stretches.back().length}});
  return joints;
}

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

  /// First of the wanted joints from `from` on that is in a region of the via; none if there is
  /// none. A joint at `from` has had its stop.
  [[nodiscard]] std::optional<Place> first_of(const std::vector<Joint>& joints, const Place& from,
                                              Wanted wanted) const {
    for (const Joint& joint : joints) {
      const bool is_stop = wanted == Wanted::needing_stop;
      const bool is_wanted = is_stop ? joint.needs_stop : joint.stands || wanted == Wanted::all;
      const Real ahead = driven(joint.place) - driven(from);
      if (!is_wanted || ahead < (is_stop ? joint_slack : -joint_slack)) continue;
      if (is_in(joint.place, passed_tolerance)) return joint.place;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Real driven(const Place& place) const {
    return track_.stretches[place.stretch].s + place.t;
  }

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

/// Finds where a track passes all vias.
class AllPassings {
 public:
  AllPassings(const Task& task, const Track& track, const Trailing* trailing)
      : via_(task.via), joints_(joints_of(track, task.vehicle)) {
    for (const Via& via : via_) passings_.emplace_back(task, track, trailing, via);
  }

  [[nodiscard]] Passings find() const {
    Passings passed;
    Place from;
    for (std::size_t i = 0; i < via_.size(); ++i) {
      const std::optional<Place> first = passings_[i].first(from);
      if (!first) break;
      from = via_[i].stop ? place_to_stand(i, from, *first) : *first;
      passed.places.push_back(from);
      if (via_[i].stop) passed.stops.push_back(from);
    }
    return passed;
  }

 private:
  /// Number of vias from `i` on that are passed behind a place.
  [[nodiscard]] std::size_t passed_behind(Place place, std::size_t i) const {
    std::size_t count = 0;
    for (; i < via_.size(); ++i, ++count) {
      const std::optional<Place> next = passings_[i].first(place);
      if (!next) break;
      place = *next;
    }
    return count;
  }

  [[nodiscard]] Place place_to_stand(std::size_t i, const Place& from, const Place& first) const {
    for (const Wanted wanted : {Wanted::needing_stop, Wanted::standing, Wanted::all}) {
      const std::optional<Place> joint = passings_[i].first_of(joints_, from, wanted);
      if (joint && passed_behind(*joint, i + 1) == passed_behind(first, i + 1)) return *joint;
    }
    return first;
  }

  const std::vector<Via>& via_;
  std::vector<Joint> joints_;
  std::vector<Passing> passings_;
};

}  // namespace

Passings passings(const Task& task, const Track& track, const Trailing* trailing) {
  return AllPassings(task, track, trailing).find();
}

std::size_t passed_by(const Task& task, const Track& track, const SpeedProfile& speeds) {
  std::optional<Trailing> trailing;
  if (task.vehicle.trailer) trailing.emplace(track, task.vehicle, task.hitch_angles.start);
  std::vector<Joint> stops;
  for (const SpeedKnot& knot : speeds.knots) {
    if (knot.v <= speed_slack) stops.push_back({place_behind(track, knot.s)});
  }
  Place from;
  for (std::size_t i = 0; i < task.via.size(); ++i) {
    const Passing passing(task, track, trailing ? &*trailing : nullptr, task.via[i]);
    const std::optional<Place> next =
        task.via[i].stop ? passing.first_of(stops, from, Wanted::standing) : passing.first(from);
    if (!next) return i;
    from = *next;
  }
  return task.via.size();
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

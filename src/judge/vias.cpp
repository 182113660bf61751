// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/vias.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "judge/goals.h"
#include "judge/speed_knots.h"
#include "judge/steering.h"
#include "judge/text.h"

namespace vandplan::judge {
namespace {

constexpr Real passed_tolerance = 1e-6;          // tolerance of places [m] and angles [rad]
constexpr Real stated_passing_tolerance = 1e-5;  // tolerance of stated, rounded numbers [m, rad]
constexpr Real stop_slack = 1e-9;                // rounding of the driven distance of a stop [m]
constexpr Real finest = 1e-7;  // change within half of the shortest part that is looked at [m, rad]

/// Place where a segment begins, or the end of a track.
struct Joint {
  Place place;
  bool stands = true;       // whether the vehicle stands there, via or not
  bool needs_stop = false;  // whether wheels turn at once there, though the gear stays
};

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

/// Driven distance of a place from the start [m].
Real driven(const Track& track, const Place& place) {
  return track.stretches[place.stretch].s + place.t;
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
    const Place end = end_of(track_);
    return is_in(end, passed_tolerance) ? std::optional(end) : std::nullopt;
  }

 private:
  /// By how much place, heading and hitch angle may change near a place [m, rad].
  struct Slack {
    Real place = 0, turn = 0, fold = 0;

    [[nodiscard]] Real largest() const { return std::max({place, turn, fold}); }
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

  /// Changes within `half` metres of a place, on its stretch. Beside the place the hitch angle
  /// changes at most by `bend` faster for each metre: a trailer that is nearly straight hardly
  /// moves in line.
  [[nodiscard]] Slack slack_of(const Place& place, Real half) const {
    const Stretch& stretch = track_.stretches[place.stretch];
    const Real turn = steepest(stretch);
    if (trailing_ == nullptr) return {half, half * turn, 0};
    const Real wheelbase = vehicle_.trailer->wheelbase;
    const Real hitch = std::abs(static_cast<Real>(vehicle_.hitch));
    const Real swing = (1 + hitch * turn) / wheelbase;
    const Real bend = std::abs(stretch.rate) * (1 + hitch / wheelbase) + (turn + swing) * swing;
    const Real rate = trailing_->rate(place);
    const Real fold = std::min(turn + swing, std::abs(rate) + half * bend);
    const Real turning = stretch.direction * curvature_at(stretch, place.t) - rate;
    const Real turn_behind =
        std::min(swing, std::abs(turning) + half * (bend + std::abs(stretch.rate)));
    const Real way = std::max<Real>(1, trailing_->speed(stretch, 0));
    return {half * way, half * std::max(turn, turn_behind), half * fold};
  }

  /// First place between two on a stretch. The tighter the vehicle turns, the shorter are the
  /// shortest parts: else it would turn by more than the tolerance in one of them.
  [[nodiscard]] std::optional<Real> first_between(std::size_t i, Real begin, Real end) const {
    const Real half = (end - begin) / 2;
    const Real middle = begin + half;
    const Slack change = slack_of({i, middle}, half);
    if (!may_be_in({i, middle}, passed_tolerance, change)) return std::nullopt;
    const bool can_be_halved = begin < middle && middle < end;  // numbers have digits left
    if (change.largest() <= finest || !can_be_halved) {
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

/// Three numbers of stops, the first of which counts most: stops where wheels turn at once though
/// the gear stays, stops where the vehicle stands anyway, stops where a segment begins.
using Worth = std::array<int, 3>;

/// A place where a via is passed, the last one so far.
struct Reached {
  Place place;
  Real s = 0;                       // driven distance to there [m]
  Worth worth = {};                 // of all stops so far
  std::size_t last = 0;             // number of the place where the via before is passed
  std::optional<Place> stood = {};  // last place where it stands for a via
};

/// Finds the places where a track passes its vias. It passes as many vias as possible. Of such
/// places, the stops are worth as much as possible, and come as early as possible.
class AllPassings {
 public:
  AllPassings(const Task& task, const Track& track, const Trailing* trailing)
      : task_(task), track_(track), trailing_(trailing), joints_(joints_of(track, task.vehicle)) {}

  [[nodiscard]] Passings find() const {
    std::vector<std::vector<Reached>> reached = {{Reached{}}};
    for (const Via& via : task_.via) {
      std::vector<Reached> next = passed_next(via, reached.back());
      if (next.empty()) break;
      reached.push_back(std::move(next));
    }
    Passings passed;
    std::size_t number = reached.back().size() - 1;  // the one whose stops are worth most
    for (std::size_t i = reached.size() - 1; i > 0; --i) {
      const Reached& here = reached[i][number];
      passed.places.push_back(here.place);
      if (task_.via[i - 1].stop) passed.stops.push_back(here.place);
      number = here.last;
    }
    std::ranges::reverse(passed.places);
    std::ranges::reverse(passed.stops);
    return passed;
  }

 private:
  /// Places where a via may be passed behind those where the one before may be. A place comes
  /// before those farther on, whose stops are worth more.
  [[nodiscard]] std::vector<Reached> passed_next(const Via& via,
                                                 const std::vector<Reached>& before) const {
    const Passing passing(task_, track_, trailing_, via);
    std::vector<const Joint*> inside;
    for (const Joint& joint : joints_) {
      if (via.stop && passing.is_in(joint.place, passed_tolerance)) inside.push_back(&joint);
    }
    std::vector<Reached> places;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const std::optional<Place> first = passing.first(before[i].place);
      if (!first) continue;
      const std::optional<Place>& stood = before[i].stood;
      places.push_back(
          {*first, driven(track_, *first), before[i].worth, i, via.stop ? first : stood});
      for (const Joint* joint : inside) {
        if (joint->place < before[i].place) continue;
        const bool is_new = stood != joint->place;
        const auto [turns, standing, beginning] = before[i].worth;
        const Worth worth = {turns + static_cast<int>(joint->needs_stop && is_new),
                             standing + static_cast<int>(joint->stands), beginning + 1};
        const Real s = driven(track_, joint->place);
        places.push_back({joint->place, s, worth, i, joint->place});
      }
    }
    return best_of(std::move(places));
  }

  /// The places whose stops are worth more than those of every earlier place, in their order.
  [[nodiscard]] static std::vector<Reached> best_of(std::vector<Reached> places) {
    std::ranges::stable_sort(places, [](const Reached& a, const Reached& b) {
      return a.s != b.s ? a.s < b.s : a.worth > b.worth;
    });
    std::vector<Reached> best;
    for (const Reached& place : places) {
      if (best.empty() || place.worth > best.back().worth) best.push_back(place);
    }
    return best;
  }

  const Task& task_;
  const Track& track_;
  const Trailing* trailing_;
  std::vector<Joint> joints_;
};

}  // namespace

Passings passings(const Task& task, const Track& track, const Trailing* trailing) {
  return AllPassings(task, track, trailing).find();
}

std::size_t passed_by(const Task& task, const Track& track, const SpeedProfile& speeds) {
  std::optional<Trailing> trailing;
  if (task.vehicle.trailer) trailing.emplace(track, task.vehicle, task.hitch_angles.start);
  std::vector<Place> stops;
  for (const SpeedKnot& knot : speeds.knots) {
    if (knot.v <= speed_slack) stops.push_back(place_behind(track, knot.s));
  }
  Place from;
  for (std::size_t i = 0; i < task.via.size(); ++i) {
    const Passing passing(task, track, trailing ? &*trailing : nullptr, task.via[i]);
    std::optional<Place> next;
    if (!task.via[i].stop) {
      next = passing.first(from);
    } else {
      const auto is_there = [&](const Place& stop) {
        return driven(track, stop) >= driven(track, from) - stop_slack &&
               passing.is_in(stop, passed_tolerance);
      };
      const auto stop = std::ranges::find_if(stops, is_there);
      if (stop != stops.end()) next = *stop;
    }
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

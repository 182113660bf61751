// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/strokes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "search/wheels.h"

namespace vandplan::anytime {
namespace {

using search::Connector, search::gear_of, search::DrivenBeside, search::Leg, search::Route;

/// Distances by which a gear may change later, in the order of trial, as shares of what the stroke
/// lacks.
constexpr double shares[] = {1.0, 2.0, 4.0, 8.0, 0.5};
/// Least reduction of what all strokes lack, as a share of what the stroke lacks.
constexpr double worth_it = 0.25;
constexpr double rounding = 1e-7;           // a stroke that lacks less is long enough [m]
constexpr std::size_t tries_of_stroke = 4;  // most changes, for each stroke of the given route
constexpr std::size_t legs_beside = 2;      // legs on either side that are steered anew at most
/// Strokes before a changed one that the change may concern: two legs that are steered anew, and
/// the strokes that steer these anew.
constexpr std::size_t strokes_beside = 5;
constexpr std::size_t segments_of_short_leg = 3;

/// Legs of one gear: [first, last).
struct LegStroke {
  std::size_t first;
  std::size_t last;
  double length;
};

search::GearSign gear_of(const Leg& leg) { return gear_of(leg.piece.view().front()); }

Piece piece_of(std::span<const Segment> segments) {
  Piece piece;
  for (const Segment& segment : segments) {
    piece.segments[piece.count++] = segment;
    piece.length += std::abs(segment.length);
  }
  return piece;
}

/// The route with legs that are driven in one gear each.
Route cut_at_changes(const Route& route) {
  Route result{route.start, {}, 0.0};
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    LocalPose from = route.begin_of(i);
    std::span<const Segment> rest = route.legs[i].piece.view();
    while (!rest.empty()) {
      const auto changes = [&](const Segment& s) { return gear_of(s) != gear_of(rest.front()); };
      const auto change = std::ranges::find_if(rest, changes);
      const auto count = static_cast<std::size_t>(change - rest.begin());
      const Piece head = piece_of(rest.first(count));
      rest = rest.subspan(count);
      from = rest.empty() ? route.legs[i].end : search::end_of(from, head);
      result.legs.push_back({head, from});
    }
  }
  return result;
}

std::vector<LegStroke> strokes_of(const Route& route) {
  std::vector<LegStroke> result;
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    if (i == 0 || gear_of(route.legs[i]) != gear_of(route.legs[i - 1])) {
      result.push_back({i, i, 0.0});
    }
    result.back().last = i + 1;
    result.back().length += route.legs[i].piece.length;
  }
  return result;
}

/// By how much the stroke is shorter than `least` [m].
double lack_of(const LegStroke& stroke, double least) {
  const double lack = least - stroke.length;
  return lack > rounding ? lack : 0.0;
}

/// By how much all strokes together are shorter than `least` [m].
double missing(const Route& route, double least) {
  const std::vector<LegStroke> strokes = strokes_of(route);
  if (strokes.size() < 2) return 0.0;
  double sum = 0.0;
  for (const LegStroke& stroke : strokes) sum += lack_of(stroke, least);
  return sum;
}

class Lengthener {
 public:
  Lengthener(Connector& connector, const DrivenBeside& beside, Route route, double least)
      : connector_(connector), beside_(beside), route_(cut_at_changes(route)), least_(least) {}

  Route lengthened();

 private:
  void try_without(const LegStroke& stroke);
  void try_later(std::size_t cusp, double by);
  void consider(std::size_t first, std::size_t last, const std::vector<Leg>& legs);

  Connector& connector_;
  DrivenBeside beside_;
  Route route_;
  double least_;
  double wanted_ = 0.0;  // most that all strokes may lack after a change [m]
  std::optional<Route> best_;
};

// Keeps the route with `legs` in the place of [first, last), if it is free, lacks at most
// `wanted_`, and is cheaper than the kept route.
void Lengthener::consider(std::size_t first, std::size_t last, const std::vector<Leg>& legs) {
  Route trial = route_;
  trial.replace(first, last, legs);
  trial = cut_at_changes(trial);
  if (missing(trial, least_) > wanted_) return;
  LocalPose from = route_.begin_of(first);
  for (const Leg& leg : legs) {
    if (!connector_.is_free(from, leg.piece)) return;
    from = leg.end;
  }
  price(connector_, trial);
  if (!best_ || trial.cost < best_->cost) best_ = std::move(trial);
}

// Tries to drive from before a stroke to behind it at once.
void Lengthener::try_without(const LegStroke& stroke) {
  for (std::size_t before = 0; before <= std::min(legs_beside, stroke.first); ++before) {
    for (std::size_t after = 0; after <= legs_beside && stroke.last + after <= route_.legs.size();
         ++after) {
      const std::size_t first = stroke.first - before;
      const std::size_t last = stroke.last + after;
      const DrivenBeside beside = driven_around(beside_, route_, first, last);
      const LocalPose& to = route_.legs[last - 1].end;
      const std::optional<Piece> piece = connector_.steer(route_.begin_of(first), to, beside);
      if (piece && piece->count > 0) consider(first, last, {{*piece, to}});
    }
  }
}

// Tries to change gear `by` metres later than before leg `cusp`, with the curvature of either side
// or straight ahead. If the wheels may be so on both sides, driving back the same way is tried,
// too.
void Lengthener::try_later(std::size_t cusp, double by) {
  const Leg& before = route_.legs[cusp - 1];
  const Leg& after = route_.legs[cusp];
  const double curvature_before = search::last_driven(before.piece).curvature;
  const double curvature_after = search::first_driven(after.piece).curvature;
  for (const double curvature : {curvature_before, curvature_after, 0.0}) {
    const Segment on{curvature, by * gear_of(before)};
    const LocalPose via = advance(before.end, on);
    const Segment back{curvature, -on.length};
    const bool goes_on = may_follow(connector_, search::last_driven(before.piece), on) &&
                         may_follow(connector_, search::last_driven(back), after.piece.view()[0]);
    if (goes_on) {
      consider(cusp, cusp, {{piece_of({&on, 1}), via}, {piece_of({&back, 1}), before.end}});
    }
    for (std::size_t ahead = 1; ahead <= std::min(legs_beside, cusp); ++ahead) {
      for (std::size_t behind = 1; behind <= std::min(legs_beside, route_.legs.size() - cusp);
           ++behind) {
        const std::size_t first = cusp - ahead;
        const std::size_t last = cusp + behind;
        const DrivenBeside beside = driven_around(beside_, route_, first, last);
        const std::optional<Piece> there =
            connector_.steer(route_.begin_of(first), via, {beside.before, gear_of(after)});
        if (!there || there->count == 0) continue;
        const LocalPose& to = route_.legs[last - 1].end;
        const std::optional<Piece> onward =
            connector_.steer(via, to, {search::last_driven(*there), beside.after});
        if (onward && onward->count > 0) consider(first, last, {{*there, via}, {*onward, to}});
      }
    }
  }
}

// Makes short strokes longer. A longer stroke may make another one shorter, so tries are limited.
Route Lengthener::lengthened() {
  bool changed = true;
  std::size_t next = 0;  // strokes before this one cannot be made longer
  for (std::size_t tries = tries_of_stroke * strokes_of(route_).size(); changed && tries > 0;
       --tries) {
    const std::vector<LegStroke> strokes = strokes_of(route_);
    changed = false;
    for (std::size_t k = next; k < strokes.size() && strokes.size() > 1 && !changed; ++k) {
      const LegStroke& stroke = strokes[k];
      const double lack = lack_of(stroke, least_);
      if (lack == 0.0) continue;
      best_.reset();
      wanted_ = missing(route_, least_) - worth_it * lack;
      try_without(stroke);
      for (const double share : shares) {
        if (best_) break;
        if (k > 0) try_later(stroke.first, share * lack);
        if (k + 1 < strokes.size()) try_later(stroke.last, share * lack);
      }
      changed = best_.has_value();
      if (!best_) continue;
      route_ = *std::move(best_);
      next = k - std::min(k, strokes_beside);
    }
  }
  price(connector_, route_);
  return route_;
}

}  // namespace

search::Route with_strokes(search::Connector& connector, const search::DrivenBeside& beside,
                           search::Route route, double least) {
  if (missing(cut_at_changes(route), least) == 0.0) return route;
  return Lengthener(connector, beside, std::move(route), least).lengthened();
}

search::Route legs_along(const Path& path, const LocalPose& goal) {
  Route route{Local(path.start), {}, 0.0};
  LocalPose pose = route.start;
  std::span<const Segment> rest = path.segments;
  while (!rest.empty()) {
    const Piece piece = piece_of(rest.first(std::min(segments_of_short_leg, rest.size())));
    rest = rest.subspan(piece.count);
    pose = rest.empty() ? goal : search::end_of(pose, piece);
    route.legs.push_back({piece, pose});
  }
  return route;
}

}  // namespace vandplan::anytime

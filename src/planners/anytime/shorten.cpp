// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/shorten.h"

#include <algorithm>
#include <cmath>

namespace vandplan::anytime {
namespace {

constexpr double progress = 5e-4;  // share of the cost that counts as progress
constexpr double least_gain = 1e-9;
constexpr double guide_leeway = 1.3;  // what costs so much more may be better by another measure
constexpr int patience = 200;         // trials without progress after which a route is stalled,
constexpr int patience_for_each_leg = 60;  // and more for each leg

}  // namespace

Shortener::Shortener(Connector& connector, Route route, std::uint64_t seed,
                     std::function<double(const Route&)> measure)
    : connector_(connector),
      measure_(std::move(measure)),
      route_(std::move(route)),
      rng_(seed),
      progress_cost_(route_.cost) {}

bool Shortener::is_stalled() const {
  return idle_ > patience + patience_for_each_leg * static_cast<int>(route_.legs.size());
}

Shortener::Place Shortener::random_place() {
  double s = uniform(0.0, route_.length(), rng_);
  std::size_t leg = 0;
  while (leg + 1 < route_.legs.size() && s > route_.legs[leg].piece.length) {
    s -= route_.legs[leg++].piece.length;
  }
  const Piece& piece = route_.legs[leg].piece;
  s = std::min(s, piece.length);
  return {leg, connector_.continuous() != nullptr ? nearest_cut(piece, s, connector_.radius()) : s};
}

Pose Shortener::pose_at(const Place& place) const {
  const Leg& leg = route_.legs[place.leg];
  if (place.s == leg.piece.length) return leg.end;
  return end_of(route_.begin_of(place.leg), prefix(leg.piece, place.s));
}

// In the vehicle's own frame, at a random scale: what is left to gain shrinks as the route settles.
Pose Shortener::perturbed(const Pose& pose) {
  const double scale = std::exp2(uniform(-10.0, -0.5, rng_));
  const double reach = scale * connector_.radius();
  const Pose local{uniform(-reach, reach, rng_), uniform(-reach, reach, rng_),
                   uniform(-scale, scale, rng_)};
  return compose(pose, local);
}

double Shortener::cost_of_legs(std::span<const Leg> legs, const Gears& gears) const {
  const CostRule& rule = connector_.rule();
  Driven driven = gears.before;
  double sum = 0.0;
  for (const Leg& leg : legs) {
    sum += rule.is_length() ? leg.piece.length
                            : drive_cost(rule, leg.piece.view(), driven) + leg.clearance_cost;
  }
  return rule.is_length() ? sum : sum + change_cost(rule, driven, gears.after);
}

// The legs that a trial would replace, and what it has to undercut.
Shortener::Stretch Shortener::stretch(std::size_t first, std::size_t last) const {
  const bool needs_gears = !connector_.rule().is_length() || connector_.continuous() != nullptr;
  const Gears gears = needs_gears ? gears_around(connector_.rule(), route_, first, last) : Gears{};
  const double cost = cost_of_legs(std::span(route_.legs).subspan(first, last - first), gears);
  return {first, last, gears, measure_ ? guide_leeway * cost : cost};
}

// Finds what being near things adds to the cost of the trial. False if that takes up the gain.
bool Shortener::stays_cheaper(Pose from, double gain) {
  if (connector_.rule().clearance_weight == 0.0) return true;
  for (Leg& leg : trial_) {
    leg.clearance_cost = connector_.clearance_cost(from, leg.piece.view(), gain);
    gain -= leg.clearance_cost;
    if (gain < least_gain) return false;
    from = leg.end;
  }
  return true;
}

// Puts the trial in the place of the stretch if that is cheaper and free. `fresh` are the legs of
// the trial that have to be checked; the others were cut from the route.
bool Shortener::replace(const Stretch& old, std::span<const Leg> fresh) {
  const double gain = old.cost - cost_of_legs(trial_, old.gears);
  if (gain < least_gain) return false;
  for (const Leg& leg : fresh) {
    const bool is_first = &leg == trial_.data();
    const Pose& from = is_first ? route_.begin_of(old.first) : (&leg - 1)->end;
    if (!connector_.is_free(from, leg.piece)) return false;
  }
  if (!stays_cheaper(route_.begin_of(old.first), gain)) return false;
  if (measure_) {
    Route changed = route_;
    exchange(changed, old);
    changed.cost = measure_(changed);
    if (route_.cost - changed.cost < least_gain) return false;
    route_ = std::move(changed);
    return true;
  }
  exchange(route_, old);
  route_.cost = cost_of(connector_.rule(), route_);
  return true;
}

void Shortener::exchange(Route& route, const Stretch& old) const {
  const auto at = route.legs.begin() + static_cast<std::ptrdiff_t>(old.first);
  const auto next = route.legs.erase(at, at + static_cast<std::ptrdiff_t>(old.last - old.first));
  route.legs.insert(next, trial_.begin(), trial_.end());
}

// Exact steering between two places of the route.
bool Shortener::shortcut() {
  Place a = random_place();
  Place b = random_place();
  if (b.leg < a.leg || (b.leg == a.leg && b.s < a.s)) std::swap(a, b);
  if (a.leg == b.leg) return false;
  const Pose from = pose_at(a);
  const Pose to = pose_at(b);
  const Piece head = prefix(route_.legs[a.leg].piece, a.s);
  const Piece tail = suffix(route_.legs[b.leg].piece, b.s);
  const Stretch old = stretch(a.leg, b.leg + 1);
  const double kept =
      connector_.cost(head, {old.gears.before, 0}) + connector_.cost(tail, {0, old.gears.after});
  const Gears gears{head.count > 0 ? last_driven(head) : old.gears.before,
                    tail.count > 0 ? first_driven(tail) : old.gears.after};
  trial_.clear();
  if (head.count > 0) trial_.push_back({head, from});
  const std::optional<Piece> piece = connector_.steer(from, to, gears, old.cost - kept);
  if (!piece) return false;
  trial_.push_back({*piece, to});
  if (tail.count > 0) trial_.push_back({tail, route_.legs[b.leg].end});
  return replace(old, std::span(trial_).subspan(head.count > 0 ? 1 : 0, 1));
}

// Leaves a via pose out.
bool Shortener::drop_via() {
  const std::size_t legs = route_.legs.size();
  if (legs < 2) return false;
  const auto i = static_cast<std::size_t>(rng_() % (legs - 1));
  const Pose& to = route_.legs[i + 1].end;
  const Stretch old = stretch(i, i + 2);
  const std::optional<Piece> piece = connector_.steer(route_.begin_of(i), to, old.gears, old.cost);
  if (!piece) return false;
  trial_.assign(1, {*piece, to});
  return replace(old, trial_);
}

// Drives the stretch by way of another pose. Where the curvature is continuous, the gear changes
// there if `cusp` is the gear driven then.
bool Shortener::replace_by_way_of(const Pose& via, const Stretch& old, GearSign cusp) {
  const Pose& from = route_.begin_of(old.first);
  const Pose& to = route_.legs[old.last - 1].end;
  double left = old.cost;
  if (!connector_.rule().is_length()) {
    left -= connector_.least_cost(via, to, {0, old.gears.after});
    if (left <= 0.0) return false;
  }
  const Driven next = connector_.continuous() != nullptr ? cusp : 0;
  const std::optional<Piece> first = connector_.steer(from, via, {old.gears.before, next}, left);
  if (!first) return false;
  trial_.assign(1, {*first, via});
  const Driven between = last_driven(trial_[0].piece);
  const double spent = connector_.cost(trial_[0].piece, {old.gears.before, 0});
  if (!connector_.rule().is_length() && spent >= left) return false;
  const std::optional<Piece> second =
      connector_.steer(via, to, {between, old.gears.after}, old.cost - spent);
  if (!second) return false;
  trial_.push_back({*second, to});
  return replace(old, trial_);
}

// Moves a via pose and steers anew from the one before and to the one after it.
bool Shortener::move_via() {
  const std::size_t legs = route_.legs.size();
  if (legs < 2) return move_place();
  const auto i = static_cast<std::size_t>(rng_() % (legs - 1));
  const Pose via = perturbed(route_.legs[i].end);
  const GearSign before = last_driven(route_.legs[i].piece).gear;
  const GearSign after = first_driven(route_.legs[i + 1].piece).gear;
  return replace_by_way_of(via, stretch(i, i + 2), after == -before ? after : 0);
}

// Makes a via pose beside a place of the route.
bool Shortener::move_place() {
  const Place place = random_place();
  const Pose via = perturbed(pose_at(place));
  return replace_by_way_of(via, stretch(place.leg, place.leg + 1), 0);
}

bool Shortener::step() {
  const double kind = uniform01(rng_);
  const bool shorter = kind < 0.3   ? shortcut()
                       : kind < 0.4 ? drop_via()
                       : kind < 0.9 ? move_via()
                                    : move_place();
  ++idle_;
  if (route_.cost < progress_cost_ * (1 - progress)) {
    progress_cost_ = route_.cost;
    idle_ = 0;
  }
  return shorter;
}

}  // namespace vandplan::anytime

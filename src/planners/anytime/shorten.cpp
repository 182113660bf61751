// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/shorten.h"

#include <algorithm>
#include <cmath>

#include "planners/commands/wheels.h"

namespace vandplan::anytime {
namespace {

constexpr double least_gain = 1e-9;  // smallest gain of a trial [m]
// Cost of one crumb when a measure compares two routes [m or s, as the measure]. Without it drives
// keep wiggles of some centimetres: 25 in 80 random worlds.
constexpr double price_of_crumb = 0.4;
constexpr int patience = 200;  // trials in a row without a gain that stall a route

constexpr std::size_t legs_of_window = 16;  // legs in a window
constexpr int idle_trials_of_window = 48;   // trials without a gain after which the window moves

/// Number of segments that are too short for a driver.
double crumbs_of(const Route& route, double radius) {
  const double crumb = commands::crumb_length(radius);
  const std::vector<Segment> segments = path_of(route).segments;
  const auto is_crumb = [&](const Segment& segment) { return std::abs(segment.length) < crumb; };
  return static_cast<double>(std::count_if(segments.begin(), segments.end(), is_crumb));
}

}  // namespace

Shortener::Shortener(Connector& connector, Route route, std::uint64_t seed,
                     std::function<double(const Route&)> measure,
                     std::optional<DrivenBeside> beside)
    : connector_(connector),
      measure_(std::move(measure)),
      route_(std::move(route)),
      beside_(beside.value_or(
          DrivenBeside{connector.rule().initial_gear, connector.rule().final_gear})),
      last_(route_.legs.size()),
      rng_(seed) {
  if (measure_ || route_.legs.size() <= 2 * legs_of_window) return;
  // The first window is anywhere. Otherwise each shortener that takes a route over would begin with
  // the same legs.
  first_ = last_ = rng_() % route_.legs.size();
  next_window();
}

Route Shortener::route() const {
  Route whole = route_;
  if (!is_whole()) whole.cost = cost_of(connector_.rule(), whole);
  return whole;
}

bool Shortener::is_stalled() const { return idle_ > patience; }

double Shortener::trials_for_one() const {
  if (is_whole()) return 1.0;
  return static_cast<double>(route_.legs.size()) / static_cast<double>(legs_of_window);
}

// Half of the window stays, so that legs across its end come into the middle of the next window. At
// an end of the route, windows turn back.
void Shortener::move_window() {
  const std::size_t half = legs_in_window() / 2;
  const bool is_at_end = goes_back_ ? first_ == 0 : last_ == route_.legs.size();
  if (is_at_end) goes_back_ = !goes_back_;
  if (goes_back_) {
    last_ -= half;
  } else {
    first_ += half;
  }
  next_window();
}

// Fills the window on the side to which windows move.
void Shortener::next_window() {
  const std::size_t more = legs_of_window - std::min(legs_of_window, legs_in_window());
  if (goes_back_) {
    first_ -= std::min(first_, more);
  } else {
    last_ += std::min(route_.legs.size() - last_, more);
  }
  idle_visit_ = 0;
  if (is_whole()) route_.cost = cost_of(connector_.rule(), route_);
}

Shortener::Place Shortener::random_place() {
  double length = 0.0;
  for (std::size_t i = first_; i < last_; ++i) length += route_.legs[i].piece.length;
  double s = uniform(0.0, length, rng_);
  std::size_t leg = first_;
  while (leg + 1 < last_ && s > route_.legs[leg].piece.length) {
    s -= route_.legs[leg++].piece.length;
  }
  const Piece& piece = route_.legs[leg].piece;
  s = std::min(s, piece.length);
  return {leg, connector_.continuous() != nullptr ? nearest_cut(piece, s, connector_.radius()) : s};
}

// Index of a leg of the window that is not its last one. The window has two legs or more.
std::size_t Shortener::random_via() { return first_ + rng_() % (legs_in_window() - 1); }

LocalPose Shortener::pose_at(const Place& place) const {
  const Leg& leg = route_.legs[place.leg];
  if (place.s == leg.piece.length) return leg.end;
  return end_of(route_.begin_of(place.leg), prefix(leg.piece, place.s));
}

// Moves a pose in its own frame at a random scale, because possible gains shrink as the route
// settles.
LocalPose Shortener::perturbed(const LocalPose& pose) {
  const double scale = std::exp2(uniform(-10.0, -0.5, rng_));
  const double reach = scale * connector_.radius();
  const Pose local{uniform(-reach, reach, rng_), uniform(-reach, reach, rng_),
                   uniform(-scale, scale, rng_)};
  return compose(pose, local);
}

double Shortener::cost_of_legs(std::span<const Leg> legs, const DrivenBeside& beside) const {
  const CostRule& rule = connector_.rule();
  Driven driven = beside.before;
  double sum = 0.0;
  for (const Leg& leg : legs) {
    sum += rule.is_length() ? leg.piece.length
                            : drive_cost(rule, leg.piece.view(), driven) + leg.clearance_cost;
  }
  return rule.is_length() ? sum : sum + change_cost(rule, driven, beside.after);
}

// The legs that a trial would replace, and the cost that it must undercut.
Shortener::Stretch Shortener::stretch(std::size_t first, std::size_t last) const {
  const DrivenBeside beside = driven_around(beside_, route_, first, last);
  const double cost = cost_of_legs(std::span(route_.legs).subspan(first, last - first), beside);
  return {first, last, beside, measure_ ? guide_leeway * cost : cost};
}

// Adds the clearance cost of the trial. False if it uses up the gain.
bool Shortener::stays_cheaper(LocalPose from, double gain) {
  if (!connector_.rule().has_surcharge()) return true;
  for (Leg& leg : trial_) {
    leg.clearance_cost = connector_.clearance_cost(from, leg.piece.view(), gain);
    gain -= leg.clearance_cost;
    if (gain < least_gain) return false;
    from = leg.end;
  }
  return true;
}

// Puts the trial in the place of the stretch if that is cheaper and free. `fresh`: legs of the
// trial that must be checked; the other legs were cut from the route.
bool Shortener::replace(const Stretch& old, std::span<const Leg> fresh) {
  const double gain = old.cost - cost_of_legs(trial_, old.beside);
  if (gain < least_gain) return false;
  for (const Leg& leg : fresh) {
    const bool is_first = &leg == trial_.data();
    const LocalPose& from = is_first ? route_.begin_of(old.first) : (&leg - 1)->end;
    if (!connector_.is_free(from, leg.piece)) return false;
  }
  if (!stays_cheaper(route_.begin_of(old.first), gain)) return false;
  if (measure_) {
    Route changed = route_;
    changed.replace(old.first, old.last, trial_);
    changed.cost = measure_(changed);
    const double fewer_crumbs =
        crumbs_of(route_, connector_.radius()) - crumbs_of(changed, connector_.radius());
    if (route_.cost - changed.cost + price_of_crumb * fewer_crumbs < least_gain) return false;
    route_ = std::move(changed);
    last_ = route_.legs.size();
    return true;
  }
  const bool was_whole = is_whole();
  route_.replace(old.first, old.last, trial_);
  last_ += trial_.size() - (old.last - old.first);
  if (was_whole) {
    route_.cost = cost_of(connector_.rule(), route_);
  } else {
    route_.cost -= old.cost - cost_of_legs(trial_, old.beside);
  }
  return true;
}

// Steers exactly between two random places of the route.
bool Shortener::shortcut() {
  Place a = random_place();
  Place b = random_place();
  if (b.leg < a.leg || (b.leg == a.leg && b.s < a.s)) std::swap(a, b);
  if (a.leg == b.leg) return false;
  const LocalPose from = pose_at(a);
  const LocalPose to = pose_at(b);
  const Piece head = prefix(route_.legs[a.leg].piece, a.s);
  const Piece tail = suffix(route_.legs[b.leg].piece, b.s);
  const Stretch old = stretch(a.leg, b.leg + 1);
  const double kept =
      connector_.cost(head, {old.beside.before, 0}) + connector_.cost(tail, {0, old.beside.after});
  const DrivenBeside beside{head.count > 0 ? last_driven(head) : old.beside.before,
                            tail.count > 0 ? first_driven(tail) : old.beside.after};
  trial_.clear();
  if (head.count > 0) trial_.push_back({head, from});
  const std::optional<Piece> piece = connector_.steer(from, to, beside, old.cost - kept);
  if (!piece) return false;
  trial_.push_back({*piece, to});
  if (tail.count > 0) trial_.push_back({tail, route_.legs[b.leg].end});
  return replace(old, std::span(trial_).subspan(head.count > 0 ? 1 : 0, 1));
}

// Leaves a via pose out.
bool Shortener::drop_via() {
  if (legs_in_window() < 2) return false;
  const std::size_t i = random_via();
  const LocalPose& to = route_.legs[i + 1].end;
  const Stretch old = stretch(i, i + 2);
  const std::optional<Piece> piece = connector_.steer(route_.begin_of(i), to, old.beside, old.cost);
  if (!piece) return false;
  trial_.assign(1, {*piece, to});
  return replace(old, trial_);
}

// Drives the stretch by way of another pose. With continuous curvature the gear changes to `cusp`
// there, unless that is 0.
bool Shortener::replace_by_way_of(const LocalPose& via, const Stretch& old, GearSign cusp) {
  const LocalPose& from = route_.begin_of(old.first);
  const LocalPose& to = route_.legs[old.last - 1].end;
  double left = old.cost;
  if (!connector_.rule().is_length()) {
    left -= connector_.least_cost(via, to, {0, old.beside.after});
    if (left <= 0.0) return false;
  }
  const Driven next = connector_.continuous() != nullptr ? cusp : 0;
  const std::optional<Piece> first = connector_.steer(from, via, {old.beside.before, next}, left);
  if (!first) return false;
  trial_.assign(1, {*first, via});
  const Driven between = last_driven(trial_[0].piece);
  const double spent = connector_.cost(trial_[0].piece, {old.beside.before, 0});
  if (!connector_.rule().is_length() && spent >= left) return false;
  const std::optional<Piece> second =
      connector_.steer(via, to, {between, old.beside.after}, old.cost - spent);
  if (!second) return false;
  trial_.push_back({*second, to});
  return replace(old, trial_);
}

// Moves a via pose, and steers to it from the pose before and from it to the pose after.
bool Shortener::move_via() {
  if (legs_in_window() < 2) return move_place();
  const std::size_t i = random_via();
  const LocalPose via = perturbed(route_.legs[i].end);
  const GearSign before = last_driven(route_.legs[i].piece).gear;
  const GearSign after = first_driven(route_.legs[i + 1].piece).gear;
  return replace_by_way_of(via, stretch(i, i + 2), after == -before ? after : 0);
}

// Makes a via pose beside a place of the route.
bool Shortener::move_place() {
  const Place place = random_place();
  const LocalPose via = perturbed(pose_at(place));
  return replace_by_way_of(via, stretch(place.leg, place.leg + 1), 0);
}

bool Shortener::step() {
  const double kind = uniform01(rng_);
  const bool shorter = kind < 0.3   ? shortcut()
                       : kind < 0.4 ? drop_via()
                       : kind < 0.9 ? move_via()
                                    : move_place();
  idle_ = shorter ? 0 : idle_ + 1;
  if (is_whole()) return shorter;
  idle_visit_ = shorter ? 0 : idle_visit_ + 1;
  if (idle_visit_ >= idle_trials_of_window) move_window();
  return shorter;
}

}  // namespace vandplan::anytime

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vandplan::anytime {
namespace {

constexpr double curvature_rounding = 1e-12;  // relative rounding of curvatures and rates
constexpr double sideways = 0.3;              // share of repairs without a gain that are kept
constexpr std::size_t max_spanned_legs = 6;   // most legs at an end that one piece replaces
constexpr int repairs = 12;                   // trials to free a route along a path

}  // namespace

bool may_follow(const Connector& connector, const Driven& before, const Segment& segment) {
  // NaN if the curvature before is unknown.
  const double jump = std::abs(segment.curvature - before.curvature);
  return !(jump * connector.radius() > straight_wheels) ||
         connector.may_jump(before, {gear_of(segment), segment.curvature});
}

bool can_drive(const Connector& connector, const Segment& segment) {
  if (!may_drive(connector.rule(), std::span(&segment, 1))) return false;
  const double sharpest = (1 + curvature_rounding) / connector.radius();
  const double end = curvature_at(segment, std::abs(segment.length));
  if (std::max(std::abs(segment.curvature), std::abs(end)) > sharpest) return false;
  const ContinuousSteering* const continuous = connector.continuous();
  const double fastest = continuous == nullptr ? 0.0 : continuous->curvature_rate();
  return std::abs(segment.curvature_rate) <= fastest * (1 + curvature_rounding);
}

Chain::Chain(const Task& task, Connector& connector, const Path& old, std::uint64_t seed)
    : task_(task), connector_(connector), old_(old), rng_(seed), vias_(vias_of(old)) {
  double s = 0.0;
  for (const Segment& segment : old.segments) {
    begins_.push_back(s);
    s += std::abs(segment.length);
  }
  vias_.front().pose = task.start;
  vias_.back().pose = task.goal;
}

/// Places of a path where one piece may end and the next one begin, with both ends of the path.
std::vector<Chain::Via> Chain::vias_of(const Path& path) {
  const LocalPose start(path.start);
  std::vector<Via> vias = {{start, 0.0, 0}};
  LocalPose pose = start;
  double s = 0.0;
  const Segment* before = nullptr;
  for (const Segment& segment : path.segments) {
    if (segment.length == 0.0) continue;  // an empty segment would make two equal places
    const double length = std::abs(segment.length);
    const double end = curvature_at(segment, length);
    if (before != nullptr) {
      const bool changes = before->length * segment.length < 0.0;
      const double last = last_driven(*before).curvature;
      if (changes || last * segment.curvature < 0.0) {
        vias.push_back({pose, s, changes ? gear_of(segment) : 0});
      }
    }
    const bool is_line = segment.curvature == 0.0 && end == 0.0;
    if (is_line || segment.curvature * end < 0.0) {
      const double there =
          is_line ? length / 2 : length * segment.curvature / (segment.curvature - end);
      vias.push_back({advance(pose, part_of(segment, 0.0, there)), s + there, 0});
    }
    pose = advance(pose, segment);
    s += length;
    before = &segment;
  }
  vias.push_back({pose, s, 0});
  return vias;
}

bool Chain::is_free() const {
  return std::ranges::all_of(legs_, [](const Link& link) { return link.is_free; });
}

/// Gears and curvatures before leg `first` and from leg `last` on.
DrivenBeside Chain::driven_beside(std::size_t first, std::size_t last) const {
  const DrivenBeside ends = driven_at_ends(task_, connector_.rule());
  return {first == 0 ? ends.before : last_driven(legs_[first - 1].piece),
          last == legs_.size() ? ends.after : first_driven(legs_[last].piece)};
}

/// Pieces from place to place; `around`: what is driven before and after them. None if two places
/// cannot be joined.
std::optional<std::vector<Chain::Link>> Chain::links(std::span<const Via> vias,
                                                     const DrivenBeside& around) {
  std::vector<Link> result;
  Driven before = around.before;
  for (std::size_t i = 0; i + 1 < vias.size(); ++i) {
    const bool is_last = i + 2 == vias.size();
    const Driven after = is_last ? around.after : Driven(vias[i + 1].next);
    const LocalPose& from = vias[i].pose;
    const std::optional<Piece> piece = connector_.steer(from, vias[i + 1].pose, {before, after});
    if (!piece) return std::nullopt;
    result.push_back({*piece, connector_.is_free(from, *piece)});
    before = last_driven(*piece);
  }
  return result;
}

bool Chain::join() {
  const DrivenBeside ends = driven_at_ends(task_, connector_.rule());
  auto all = links(vias_, ends);
  if (!all) {  // with straight wheels there is always a way
    for (Via& via : vias_) via.next = 0;
    all = links(vias_, ends);
  }
  if (!all) return false;
  legs_ = *std::move(all);
  return true;
}

// The piece of the old path between two places, if the vehicle can drive it.
std::optional<Piece> Chain::old_piece(const Via& from, const Via& to, Driven before) const {
  Piece piece;
  const auto after = std::ranges::upper_bound(begins_, from.s);
  // Rounding may leave a rest of the segment before.
  const std::ptrdiff_t first = std::max<std::ptrdiff_t>(after - begins_.begin() - 2, 0);
  for (auto i = static_cast<std::size_t>(first); i < begins_.size(); ++i) {
    const Segment& segment = old_.segments[i];
    const double s = begins_[i];
    if (s >= to.s) break;
    const double length = std::abs(segment.length);
    const double begin = std::max(from.s - s, 0.0);
    const double end = std::min(to.s - s, length);
    if (begin >= end) continue;
    const Segment part = part_of(segment, begin, end);
    if (piece.count == SegmentRoom::size()) return std::nullopt;
    if (!can_drive(connector_, part) || !may_follow(connector_, before, part)) return std::nullopt;
    piece.segments[piece.count++] = part;
    piece.length += end - begin;
    before = last_driven(part);
  }
  return piece;
}

bool Chain::take_over() {
  const DrivenBeside ends = driven_at_ends(task_, connector_.rule());
  Driven before = ends.before;
  for (std::size_t i = 0; i + 1 < vias_.size(); ++i) {
    const bool is_last = i + 2 == vias_.size();
    const bool is_old = !is_last && (i > 0 || task_.start == old_.start);
    const LocalPose& from = vias_[i].pose;
    const LocalPose& to = vias_[i + 1].pose;
    std::optional<Piece> piece;
    if (is_old) piece = old_piece(vias_[i], vias_[i + 1], before);
    const Driven after = is_last ? ends.after : Driven(vias_[i + 1].next);
    if (!piece) piece = connector_.steer(from, to, {before, after});
    if (!piece) return false;
    legs_.push_back({*piece, connector_.is_free(from, *piece)});
    before = last_driven(*piece);
  }
  leave_out();
  return true;
}

// Replaces the legs [first, last).
void Chain::exchange(std::size_t first, std::size_t last, const std::vector<Link>& fresh) {
  const auto begin = legs_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = legs_.begin() + static_cast<std::ptrdiff_t>(last);
  legs_.insert(legs_.erase(begin, end), fresh.begin(), fresh.end());
}

// Clearance cost of the legs [first, last).
double Chain::clearance_cost(std::size_t first, std::size_t last) const {
  double sum = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    sum += connector_.clearance_cost(vias_[i].pose, legs_[i].piece.view());
  }
  return sum;
}

// Replaces the legs [first, last) by one piece that is free, if one of them is blocked or the piece
// is cheaper.
void Chain::span_legs(std::size_t first, std::size_t last) {
  const DrivenBeside beside = driven_beside(first, last);
  double cost = 0.0;
  Driven before = beside.before;
  for (std::size_t i = first; i < last; ++i) {
    const Driven after = i + 1 == last ? beside.after : Driven{};
    if (!legs_[i].is_free) cost = std::numeric_limits<double>::infinity();
    cost += connector_.cost(legs_[i].piece, {before, after});
    before = last_driven(legs_[i].piece);
  }
  const LocalPose& from = vias_[first].pose;
  const std::optional<Piece> piece = connector_.steer(from, vias_[last].pose, beside, cost);
  if (!piece || !connector_.is_free(from, *piece)) return;
  const double gain = cost - connector_.cost(*piece, beside);
  if (gain <= 0.0) return;
  if (std::isfinite(cost) &&
      connector_.clearance_cost(from, piece->view()) >= gain + clearance_cost(first, last)) {
    return;
  }
  exchange(first, last, {{*piece, true}});
  const auto at = vias_.begin() + static_cast<std::ptrdiff_t>(first) + 1;
  vias_.erase(at, at + static_cast<std::ptrdiff_t>(last - first - 1));
}

// Replaces several legs at each end of the chain by one piece, where that is free and better.
void Chain::leave_out() {
  const auto most = [&] { return std::min(max_spanned_legs, legs_.size()); };
  for (std::size_t count = 2; count <= most(); ++count) span_legs(0, count);
  for (std::size_t count = 2; count <= most(); ++count) {
    span_legs(legs_.size() - count, legs_.size());
  }
}

/// A random place near position `s` of the old path, at a random scale.
Chain::Via Chain::beside(double s, GearSign next) {
  const double scale = std::exp2(uniform(-9.0, 0.0, rng_));
  const double reach = scale * connector_.radius();
  const Pose by{uniform(-reach, reach, rng_), uniform(-reach, reach, rng_),
                uniform(-scale, scale, rng_)};
  return {Local(compose(pose_at(old_, s), by)), s, next};
}

/// Moves an end of a blocked leg, or adds a place in its middle. The change is kept if fewer legs
/// are blocked then, and sometimes if as many are.
void Chain::repair() {
  std::vector<std::size_t> blocked;
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    if (!legs_[i].is_free) blocked.push_back(i);
  }
  const std::size_t leg = blocked[rng_() % blocked.size()];
  const bool inserts = legs_.size() == 1 || uniform01(rng_) < 0.3;
  const bool moves_end = leg == 0 || (leg + 1 < legs_.size() && rng_() % 2 == 0);
  const std::size_t first = inserts || moves_end ? leg : leg - 1;
  const std::size_t last = inserts ? leg + 1 : first + 2;  // index behind the legs that change
  const Via& from = vias_[first];
  const Via& to = vias_[last];
  const Via between = inserts ? beside(uniform(from.s, to.s, rng_), 0)
                              : beside(vias_[first + 1].s, vias_[first + 1].next);
  const std::array<Via, 3> trial = {from, between, to};
  const auto fresh = links(trial, driven_beside(first, last));
  if (!fresh) return;
  const auto begin = legs_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = legs_.begin() + static_cast<std::ptrdiff_t>(last);
  const auto is_blocked = [](const Link& link) { return !link.is_free; };
  const auto was = std::count_if(begin, end, is_blocked);
  const auto is = std::count_if(fresh->begin(), fresh->end(), is_blocked);
  if (is > was || (is == was && uniform01(rng_) > sideways)) return;
  exchange(first, last, *fresh);
  const auto at = vias_.begin() + static_cast<std::ptrdiff_t>(first) + 1;
  if (inserts) {
    vias_.insert(at, between);
  } else {
    *at = between;
  }
}

Route Chain::route() const {
  Route route{vias_.front().pose, {}, 0.0};
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    route.legs.push_back({legs_[i].piece, vias_[i + 1].pose});
  }
  price(connector_, route);
  return route;
}

std::optional<Route> route_along(const Task& task, Connector& connector, const Path& path,
                                 std::uint64_t seed) {
  Chain chain(task, connector, path, seed);
  if (!chain.take_over()) return std::nullopt;
  for (int i = 0; i < repairs && !chain.is_free(); ++i) chain.repair();
  if (!chain.is_free()) return std::nullopt;
  return chain.route();
}

}  // namespace vandplan::anytime

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/splice.h"
#include "search/wheels.h"

namespace vandplan::anytime {
namespace {

constexpr double sideways = 0.3;             // share of repairs without a gain that are kept
constexpr std::size_t max_spanned_legs = 6;  // most links at an end that one piece replaces
constexpr int repairs = 12;                  // trials to free a route along a path

}  // namespace

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
  return std::ranges::all_of(links_, [](const Link& link) { return link.is_free; });
}

/// Gears and curvatures before link `first` and from link `last` on.
DrivenBeside Chain::driven_beside(std::size_t first, std::size_t last) const {
  const DrivenBeside ends = driven_at_ends(task_, connector_.rule().initial_gear);
  return {first == 0 ? ends.before : last_driven(links_[first - 1].piece),
          last == links_.size() ? ends.after : first_driven(links_[last].piece)};
}

/// Links from place to place; `around`: what is driven before and after them. `keeps_old`: whether
/// pieces of the old path that the vehicle can drive are kept; they are not where the start has
/// moved, nor at the goal. None if two places cannot be joined.
std::optional<std::vector<Chain::Link>> Chain::linked(std::span<const Via> vias,
                                                      const DrivenBeside& around, bool keeps_old) {
  std::vector<Link> result;
  Driven before = around.before;
  for (std::size_t i = 0; i + 1 < vias.size(); ++i) {
    const bool is_last = i + 2 == vias.size();
    const bool is_old = keeps_old && !is_last && (i > 0 || task_.start == old_.start);
    const Via& from = vias[i];
    const Via& to = vias[i + 1];
    std::optional<Piece> piece;
    if (is_old) piece = old_piece(from, to, before);
    const Driven after = is_last ? around.after : Driven(to.next);
    if (!piece) piece = connector_.steer(from.pose, to.pose, {before, after});
    if (!piece) return std::nullopt;
    result.push_back({*piece, to, connector_.is_free(from.pose, *piece)});
    before = last_driven(*piece);
  }
  return result;
}

bool Chain::join() {
  const DrivenBeside ends = driven_at_ends(task_, connector_.rule().initial_gear);
  auto all = linked(vias_, ends);
  if (!all) {  // with straight wheels there is always a way
    for (Via& via : vias_) via.next = 0;
    all = linked(vias_, ends);
  }
  if (!all) return false;
  links_ = *std::move(all);
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
  auto all = linked(vias_, driven_at_ends(task_, connector_.rule().initial_gear), true);
  if (!all) return false;
  links_ = *std::move(all);
  leave_out();
  return true;
}

// Clearance cost of the links [first, last).
double Chain::clearance_cost(std::size_t first, std::size_t last) const {
  double sum = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    sum += connector_.clearance_cost(begin_of(i).pose, links_[i].piece.view());
  }
  return sum;
}

// Replaces the links [first, last) by one piece that is free, if one of them is blocked or the
// piece is cheaper.
void Chain::span_links(std::size_t first, std::size_t last) {
  const DrivenBeside beside = driven_beside(first, last);
  double cost = 0.0;
  Driven before = beside.before;
  for (std::size_t i = first; i < last; ++i) {
    const Driven after = i + 1 == last ? beside.after : Driven{};
    if (!links_[i].is_free) cost = std::numeric_limits<double>::infinity();
    cost += connector_.cost(links_[i].piece, {before, after});
    before = last_driven(links_[i].piece);
  }
  const LocalPose& from = begin_of(first).pose;
  const Via to = begin_of(last);
  const std::optional<Piece> piece = connector_.steer(from, to.pose, beside, cost);
  if (!piece || !connector_.is_free(from, *piece)) return;
  const double gain = cost - connector_.cost(*piece, beside);
  if (gain <= 0.0) return;
  if (std::isfinite(cost) &&
      connector_.clearance_cost(from, piece->view()) >= gain + clearance_cost(first, last)) {
    return;
  }
  const Link fresh[] = {{*piece, to, true}};
  base::splice(links_, first, last, fresh);
}

// Replaces several links at each end of the chain by one piece, where that is free and better.
void Chain::leave_out() {
  const auto most = [&] { return std::min(max_spanned_legs, links_.size()); };
  for (std::size_t count = 2; count <= most(); ++count) span_links(0, count);
  for (std::size_t count = 2; count <= most(); ++count) {
    span_links(links_.size() - count, links_.size());
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

/// Moves an end of a blocked link, or adds a place in its middle. The change is kept if fewer links
/// are blocked then, and sometimes if as many are.
void Chain::repair() {
  std::vector<std::size_t> blocked;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (!links_[i].is_free) blocked.push_back(i);
  }
  const std::size_t at = blocked[rng_() % blocked.size()];
  const bool inserts = links_.size() == 1 || uniform01(rng_) < 0.3;
  const bool moves_end = at == 0 || (at + 1 < links_.size() && rng_() % 2 == 0);
  const std::size_t first = inserts || moves_end ? at : at - 1;
  const std::size_t last = inserts ? at + 1 : first + 2;  // index behind the links that change
  const Via& from = begin_of(first);
  const Via& to = begin_of(last);
  const Via& moved = links_[first].to;
  const Via between =
      inserts ? beside(uniform(from.s, to.s, rng_), 0) : beside(moved.s, moved.next);
  const std::array<Via, 3> trial = {from, between, to};
  const auto fresh = linked(trial, driven_beside(first, last));
  if (!fresh) return;
  const auto begin = links_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = links_.begin() + static_cast<std::ptrdiff_t>(last);
  const auto is_blocked = [](const Link& link) { return !link.is_free; };
  const auto was = std::count_if(begin, end, is_blocked);
  const auto is = std::count_if(fresh->begin(), fresh->end(), is_blocked);
  if (is > was || (is == was && uniform01(rng_) > sideways)) return;
  base::splice(links_, first, last, *fresh);
}

Route Chain::route() const {
  Route route{vias_.front().pose, {}, 0.0};
  for (const Link& link : links_) route.legs.push_back({link.piece, link.to.pose});
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

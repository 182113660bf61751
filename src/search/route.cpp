// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/route.h"

#include <algorithm>
#include <cmath>

#include "base/splice.h"

namespace vandplan::search {

double Route::length() const {
  double sum = 0.0;
  for (const Leg& leg : legs) sum += leg.piece.length;
  return sum;
}

void Route::replace(std::size_t first, std::size_t last, std::span<const Leg> fresh) {
  base::splice(legs, first, last, fresh);
}

void drive_on(std::vector<Leg>& legs, const Segment& segment, const LocalPose& end,
              std::size_t most, bool begins_leg) {
  Leg* leg = legs.empty() ? nullptr : &legs.back();
  Segment* last = leg == nullptr ? nullptr : &leg->piece.segments[leg->piece.count - 1U];
  if (last != nullptr && last->curvature == segment.curvature && last->curvature_rate == 0.0 &&
      segment.curvature_rate == 0.0 && last->length * segment.length > 0.0) {
    last->length += segment.length;
  } else {
    if (leg == nullptr || begins_leg || leg->piece.count == most) leg = &legs.emplace_back();
    leg->piece.segments[leg->piece.count++] = segment;
  }
  leg->piece.length += std::abs(segment.length);
  leg->end = end;
}

DrivenBeside driven_around(const DrivenBeside& ends, const Route& route, std::size_t first,
                           std::size_t last) {
  DrivenBeside beside{ends.before, 0};
  for (std::size_t i = first; i > 0 && (i == first || beside.before.gear == 0); --i) {
    beside.before = last_driven(route.legs[i - 1].piece);
  }
  for (std::size_t i = last; i < route.legs.size() && beside.after.gear == 0; ++i) {
    beside.after = first_driven(route.legs[i].piece);
  }
  if (beside.after.gear == 0) beside.after = ends.after;
  return beside;
}

double cost_of(const CostRule& rule, const Route& route) {
  Driven driven = rule.initial_gear;
  double sum = 0.0;
  for (const Leg& leg : route.legs) {
    sum += drive_cost(rule, leg.piece.view(), driven) + leg.clearance_cost;
  }
  return sum + change_cost(rule, driven, rule.final_gear);
}

void price(const Connector& connector, Route& route) {
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    Leg& leg = route.legs[i];
    leg.clearance_cost = connector.clearance_cost(route.begin_of(i), leg.piece.view());
  }
  route.cost = cost_of(connector.rule(), route);
}

Route reversed(const Route& route) {
  if (route.legs.empty()) return route;
  Route result{route.legs.back().end, {}, route.cost};
  for (std::size_t i = route.legs.size(); i > 0; --i) {
    const Leg& leg = route.legs[i - 1];
    result.legs.push_back({reversed(leg.piece), route.begin_of(i - 1), leg.clearance_cost});
  }
  return result;
}

Route part_of(const Route& route, double begin, double end) {
  Route result{route.start, {}, 0.0};
  double driven = 0.0;
  for (std::size_t i = 0; i < route.legs.size() && driven < end; ++i) {
    const Leg& leg = route.legs[i];
    const double next = driven + leg.piece.length;
    const bool is_last = next >= end;
    if (next > begin) {
      const Piece head = is_last && next > end ? prefix(leg.piece, end - driven) : leg.piece;
      const LocalPose to = is_last && next > end ? end_of(route.begin_of(i), head) : leg.end;
      const bool is_cut = begin > driven;
      if (is_cut) result.start = end_of(route.begin_of(i), prefix(leg.piece, begin - driven));
      if (result.legs.empty() && !is_cut) result.start = route.begin_of(i);
      const Piece piece = is_cut ? suffix(head, begin - driven) : head;
      if (piece.count > 0) result.legs.push_back({piece, to});
    }
    driven = next;
  }
  return result;
}

double nearest_cut(const Task& task, const Route& route, double s) {
  if (task.steering == Steering::reeds_shepp) return s;
  const double radius = task.vehicle.min_turning_radius;
  double driven = 0.0;
  for (const Leg& leg : route.legs) {
    const double next = driven + leg.piece.length;
    if (s < next || &leg == &route.legs.back()) {
      const double within = nearest_cut(leg.piece, s - driven, radius);
      return within == leg.piece.length ? next : driven + within;
    }
    driven = next;
  }
  return 0.0;
}

bool are_alike(const Route& a, const Route& b, double near) {
  constexpr int places = 16;
  const Path path_a = path_of(a);
  const Path path_b = path_of(b);
  if (gear_changes(path_a) != gear_changes(path_b)) return false;
  const double length_a = length(path_a);
  const double length_b = length(path_b);
  for (int i = 1; i < places; ++i) {
    const Pose p = pose_at(path_a, length_a * i / places);
    const Pose q = pose_at(path_b, length_b * i / places);
    if (std::hypot(p.x - q.x, p.y - q.y) > near) return false;
  }
  return true;
}

Path path_of(const Route& route) {
  std::vector<Segment> segments;
  for (const Leg& leg : route.legs) {
    segments.insert(segments.end(), leg.piece.view().begin(), leg.piece.view().end());
  }
  return {route.start, merged(segments)};
}

std::vector<Segment> part_of(std::span<const Segment> segments, double begin, double end) {
  constexpr double crumb = 1e-9;  // what is shorter is left out [m]
  std::vector<Segment> part;
  part.reserve(segments.size());
  double s = 0.0;
  for (const Segment& segment : segments) {
    const double length = std::abs(segment.length);
    const double from = std::clamp(begin - s, 0.0, length);
    const double to = std::clamp(end - s, 0.0, length);
    if (to - from > crumb) part.push_back(part_of(segment, from, to));
    s += length;
  }
  return part;
}

}  // namespace vandplan::search

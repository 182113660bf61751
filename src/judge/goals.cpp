// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/goals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vandplan::judge {
namespace {

constexpr Real tolerance = 1e-6;  // tolerance of places [m], angles [rad] and curvatures [1/m]

struct Spot {
  Real x = 0, y = 0;
};

Real distance(const Spot& a, const Spot& b) { return std::hypot(a.x - b.x, a.y - b.y); }

Spot nearest_on_side(const Spot& p, const Point& a, const Point& b) {
  const Real dx = static_cast<Real>(b.x) - a.x, dy = static_cast<Real>(b.y) - a.y;
  const Real square = dx * dx + dy * dy;
  const Real t = square > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0;
  const Real inside = std::clamp(t, Real{0}, Real{1});
  return {a.x + inside * dx, a.y + inside * dy};
}

// A place is inside if a ray to the right crosses an odd number of sides.
bool is_in(const Polygon& area, Real x, Real y) {
  bool is_inside = false;
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Point& a = area[i];
    const Point& b = area[(i + 1) % area.size()];
    if ((a.y > y) == (b.y > y)) continue;
    const Real crossing = a.x + (y - a.y) * (static_cast<Real>(b.x) - a.x) / (b.y - a.y);
    if (x < crossing) is_inside = !is_inside;
  }
  return is_inside;
}

/// Nearest place to `p` in a closed polygon.
Spot nearest_in(const Polygon& area, const Spot& p) {
  if (is_in(area, p.x, p.y)) return p;
  Spot nearest{area[0].x, area[0].y};
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Point& a = area[i];
    const Point& b = area[(i + 1) % area.size()];
    const Spot there = nearest_on_side(p, a, b);
    if (distance(there, p) < distance(nearest, p)) nearest = there;
  }
  return nearest;
}

Real clamped(Real value, const Interval& interval) {
  return std::clamp<Real>(value, interval.least, interval.most);
}

/// Nearest place to `p` in a region.
Spot nearest_in(const GoalRegion& region, const Spot& p) {
  if (!region.area.empty()) return nearest_in(region.area, p);
  return {clamped(p.x, region.x), clamped(p.y, region.y)};
}

/// Turn from `heading` to the nearest heading of `range` plus `turned` [rad].
Real turn_into_range(const HeadingRange& range, Real heading, Real turned) {
  Real width = static_cast<Real>(range.to) - range.from;
  if (width < 0) width += full_turn * std::ceil(-width / full_turn);
  const Real half = width / 2;
  const Real off = std::remainder(heading - (range.from + turned + half), full_turn);
  return std::clamp(off, -half, half) - off;
}

Real beyond(Real off) { return std::max(std::abs(off) - tolerance, Real{0}); }

/// Length of the line in one gear with which a track ends [m]. It is straight if its heading
/// changes by no more than the tolerance.
Real straight_end(const Track& track) {
  Real turned = 0, length = 0, direction = 0;
  for (std::size_t i = track.stretches.size(); i > 0; --i) {
    const Stretch& stretch = track.stretches[i - 1];
    if (!(stretch.length > 0)) continue;
    if (direction * stretch.direction < 0) break;
    direction = stretch.direction;
    const Real most = steepest(stretch);
    if (turned + most * stretch.length > tolerance) return length + (tolerance - turned) / most;
    turned += most * stretch.length;
    length += stretch.length;
  }
  return length;
}

/// Position of the tractor for a position of its trailer and a hitch angle [rad].
Position tractor_ahead_of(const Position& trailer, const Vehicle& vehicle, Real angle) {
  const Real length = vehicle.trailer->wheelbase;
  const Real heading = trailer.heading + angle;
  return {trailer.x + length * std::cos(trailer.heading) - vehicle.hitch * std::cos(heading),
          trailer.y + length * std::sin(trailer.heading) - vehicle.hitch * std::sin(heading),
          heading};
}

}  // namespace

Real distance_from(const Polygon& area, Real x, Real y) {
  return distance(nearest_in(area, {x, y}), {x, y});
}

Real turn_into(const GoalRegion& region, Real heading) {
  const Real ahead = turn_into_range(region.heading, heading, 0);
  const Real back = turn_into_range(region.heading, heading, full_turn / 2);
  return region.either_way && std::abs(back) < std::abs(ahead) ? back : ahead;
}

Real distance_from(const GoalRegion& region, Real x, Real y) {
  return distance(nearest_in(region, {x, y}), {x, y});
}

Real fold_into(const GoalRegion& region, Real angle) {
  const Real fold = std::remainder(angle, full_turn);
  return clamped(fold, region.hitch_angle) - fold;
}

Goal nearest_goal(const Task& task, const Track& track, const Trailing* trailing, bool wheels_count,
                  std::optional<std::size_t> only) {
  const Place end{track.stretches.size() - 1, track.stretches.back().length};
  const Real angle = trailing == nullptr ? 0 : trailing->angle(end);
  const Real curvature =
      track.length > 0 ? curvature_at(track.stretches.back(), end.t) : task.curvatures.start;
  const Real straight = straight_end(track);
  Goal nearest;
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < task.goal_set.size(); ++i) {
    if (only && *only != i) continue;
    const GoalRegion& region = task.goal_set[i];
    const bool is_of_trailer = region.is_of_trailer && trailing != nullptr;
    const Position axle = is_of_trailer ? trailing->position(end) : track.end;
    const Spot place{axle.x, axle.y};
    const Spot goal = nearest_in(region, place);
    const Real turn = turn_into(region, axle.heading);
    const Real fold = std::remainder(angle, full_turn);
    const Real hitch_angle = clamped(fold, region.hitch_angle);
    const Real off = beyond(distance(goal, place)) + beyond(turn) + beyond(hitch_angle - fold) +
                     (wheels_count ? beyond(curvature - region.curvature) : 0) +
                     std::max<Real>(region.straight - straight - tolerance, 0);
    if (!(off < least)) continue;
    least = off;
    Position pose{goal.x, goal.y, axle.heading + turn};
    // A small error of the trailer's heading would move the tractor by more than the tolerance.
    if (is_of_trailer) {
      pose = off > 0 ? tractor_ahead_of(pose, task.vehicle, hitch_angle) : track.end;
    }
    nearest = {i,
               {static_cast<double>(pose.x), static_cast<double>(pose.y),
                static_cast<double>(std::remainder(pose.heading, full_turn))},
               region.curvature,
               static_cast<double>(hitch_angle),
               static_cast<double>(std::max<Real>(region.straight - straight, 0))};
  }
  return nearest;
}

}  // namespace vandplan::judge

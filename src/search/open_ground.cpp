// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/open_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "steering/dubins_bound.h"
#include "vandplan/steering.h"

namespace vandplan::search {
namespace {

using steering::Closing, steering::judged_curvature;

// Upper bound of the length between two poses that are `off` from each other: driven ahead, beside
// and turned on the spot.
double longest_between(const Closing& off, double radius) {
  return off.position + reeds_shepp_length({}, {0, off.position, 0}, radius) + radius * off.heading;
}

// How far an end may be off as seen from another one, `distance` metres away, that is off itself.
Closing seen_from_first(const Closing& first, const Closing& last, double distance) {
  const double both = first.position + last.position;
  return {both + (first.heading + judged_curvature) * (distance + both),
          first.heading + last.heading};
}

}  // namespace

// The Reeds-Shepp length is a distance. So moving an end changes it by at most the length of the
// move. A path scaled up by `judged_curvature` keeps to the turning radius, and ends farther away
// by the same share.
OpenGround open_ground(const Pose& first, const Closing& off_first, const Pose& last,
                       const Closing& off_last, double radius) {
  const double shortest = reeds_shepp_length(first, last, radius);
  const double apart = std::hypot(last.x - first.x, last.y - first.y);
  const auto turned = [](const Pose& p) { return Pose{p.x, p.y, p.heading + std::numbers::pi}; };
  const Closing scaled{off_last.position + judged_curvature * apart, off_last.heading};
  const double leeway = longest_between(off_first, radius) + longest_between(scaled, radius);
  const Closing off = seen_from_first(off_first, off_last, apart);
  const double forward = steering::dubins_bound(first, last, radius, off);
  const double reverse = steering::dubins_bound(turned(first), turned(last), radius, off);
  const double slack = 1 + judged_curvature;
  return {forward / slack, reverse / slack, std::max(shortest - leeway, 0.0) / slack, leeway};
}

OpenGround open_ground(const Task& task, const CostRule& rule, const Closing& ends) {
  const double radius = task.vehicle.min_turning_radius;
  if (!rule.is_length()) return open_ground(task.start, ends, task.goal, ends, radius);
  const double shortest = reeds_shepp_length(task.start, task.goal, radius);
  return {shortest, shortest, shortest, 0.0};
}

double length_lower_bound(const OpenGround& ground, const CostRule& rule) {
  return rule.allows_both() ? ground.shortest : rule.allows(1) ? ground.forward : ground.reverse;
}

// A path in one gear may change gear before it begins, unless its length is 0.
double cost_lower_bound(const OpenGround& ground, const CostRule& rule, double around) {
  if (rule.is_length()) return std::max(ground.shortest, around);
  double least = std::numeric_limits<double>::infinity();
  if (rule.allows_both()) {
    const double metre = std::min(rule.forward_weight, rule.reverse_weight);
    least = metre * std::max(ground.shortest, around) + rule.gear_change_cost;
  }
  for (const GearSign gear : {1, -1}) {
    if (!rule.allows(gear)) continue;
    const double length = std::max(gear > 0 ? ground.forward : ground.reverse, around);
    const double change = length > 0.0 ? change_cost(rule, rule.initial_gear, gear) : 0.0;
    least = std::min(least, rule.weight(gear) * length + change);
  }
  return least;
}

}  // namespace vandplan::search

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/open_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "steering/dubins_bound.h"
#include "vandplan/steering.h"

namespace vandplan::anytime {
namespace {

using steering::Closing;

/// Slack of the curvature, relative, as the judge allows. A path scaled up by it keeps to the
/// turning radius, and ends farther away by the same share.
constexpr double curvature_slack = 1e-9;

double distance(const Task& task) {
  return std::hypot(task.goal.x - task.start.x, task.goal.y - task.start.y);
}

// Upper bound of the length between two poses that are `off` from each other: driven ahead, beside
// and turned on the spot.
double longest_between(const Closing& off, double radius) {
  return off.position + reeds_shepp_length({}, {0, off.position, 0}, radius) + radius * off.heading;
}

// How far the goal may be off as seen from the start, if the start is off itself.
Closing seen_from_start(const Task& task, const Closing& ends) {
  const double apart = distance(task) + 2 * ends.position;
  return {2 * ends.position + (ends.heading + curvature_slack) * apart, 2 * ends.heading};
}

}  // namespace

// The Reeds-Shepp length is a distance. So moving an end changes it by at most the length of the
// move.
OpenGround open_ground(const Task& task, const search::CostRule& rule, const Closing& ends) {
  const double radius = task.vehicle.min_turning_radius;
  const double shortest = reeds_shepp_length(task.start, task.goal, radius);
  if (rule.is_length()) return {shortest, shortest, shortest, 0.0};
  const auto turned = [](const Pose& p) { return Pose{p.x, p.y, p.heading + std::numbers::pi}; };
  const Closing scaled{ends.position + curvature_slack * distance(task), ends.heading};
  const double leeway = longest_between(ends, radius) + longest_between(scaled, radius);
  const Closing off = seen_from_start(task, ends);
  const double forward = steering::dubins_bound(task.start, task.goal, radius, off);
  const double reverse = steering::dubins_bound(turned(task.start), turned(task.goal), radius, off);
  const double slack = 1 + curvature_slack;
  return {forward / slack, reverse / slack, std::max(shortest - leeway, 0.0) / slack, leeway};
}

double length_lower_bound(const OpenGround& ground, const search::CostRule& rule) {
  return rule.allows_both() ? ground.shortest : rule.allows(1) ? ground.forward : ground.reverse;
}

// A path in one gear may change gear before it begins, unless its length is 0.
double cost_lower_bound(const OpenGround& ground, const search::CostRule& rule, double around) {
  if (rule.is_length()) return std::max(ground.shortest, around);
  double least = std::numeric_limits<double>::infinity();
  if (rule.allows_both()) {
    const double metre = std::min(rule.forward_weight, rule.reverse_weight);
    least = metre * std::max(ground.shortest, around) + rule.gear_change_cost;
  }
  for (const search::GearSign gear : {1, -1}) {
    if (!rule.allows(gear)) continue;
    const double length = std::max(gear > 0 ? ground.forward : ground.reverse, around);
    const double change = length > 0.0 ? change_cost(rule, rule.initial_gear, gear) : 0.0;
    least = std::min(least, rule.weight(gear) * length + change);
  }
  return least;
}

}  // namespace vandplan::anytime

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/open_ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "steering/dubins_bound.h"
#include "vandplan/reeds_shepp.h"

namespace vandplan::anytime {
namespace {

using steering::Closing, steering::judged;

// Of the curvature, relative: what the judge allows, too. Scaled up by it a path turns within the
// radius, and ends so much farther away.
constexpr double curvature_slack = 1e-9;

double distance(const Task& task) {
  return std::hypot(task.goal.x - task.start.x, task.goal.y - task.start.y);
}

// Between poses that are as far apart as this: one behind the other, beside it, turned on the spot.
double longest_between(const Closing& off, double radius) {
  return off.position + reeds_shepp_length({}, {0, off.position, 0}, radius) + radius * off.heading;
}

// How far the goal may be off as seen from the start, which may be off itself.
Closing seen_from_start(const Task& task) {
  const double apart = distance(task) + 2 * judged.position;
  return {2 * judged.position + (judged.heading + curvature_slack) * apart, 2 * judged.heading};
}

}  // namespace

// The Reeds-Shepp length is a distance, so moving an end changes it by no more than the length of
// the move.
OpenGround open_ground(const Task& task, const search::CostRule& rule) {
  const double radius = task.vehicle.min_turning_radius;
  const double shortest = reeds_shepp_length(task.start, task.goal, radius);
  if (rule.is_length()) return {shortest, shortest, shortest, 0.0};
  const auto turned = [](const Pose& p) { return Pose{p.x, p.y, p.heading + std::numbers::pi}; };
  const Closing scaled{judged.position + curvature_slack * distance(task), judged.heading};
  const double leeway = longest_between(judged, radius) + longest_between(scaled, radius);
  const Closing off = seen_from_start(task);
  const double forward = steering::dubins_bound(task.start, task.goal, radius, off);
  const double reverse = steering::dubins_bound(turned(task.start), turned(task.goal), radius, off);
  const double slack = 1 + curvature_slack;
  return {forward / slack, reverse / slack, std::max(shortest - leeway, 0.0) / slack, leeway};
}

// In one gear only it may have to change gear before it begins.
double least_cost(const OpenGround& ground, const search::CostRule& rule, double around) {
  if (rule.is_length()) return std::max(ground.shortest, around);
  return std::min({rule.forward_weight * std::max(ground.forward, around) +
                       change_cost(rule, rule.initial_gear, 1),
                   rule.reverse_weight * std::max(ground.reverse, around) +
                       change_cost(rule, rule.initial_gear, -1),
                   std::max(ground.shortest, around) + rule.gear_change_cost});
}

}  // namespace vandplan::anytime

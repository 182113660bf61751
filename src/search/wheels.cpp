// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/wheels.h"

#include <algorithm>
#include <cmath>

namespace vandplan::search {
namespace {

constexpr double curvature_rounding = 1e-12;  // relative rounding of curvatures and rates

}  // namespace

bool may_jump(Steering steering, const Driven& before, GearSign next) {
  if (steering != Steering::continuous_between_stops) return steering == Steering::reeds_shepp;
  return before.gear == 0 || before.gear == -next || !before.is_known();
}

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

GearSign rolling_beyond(const Task& task, bool is_start) {
  const auto& [start, goal, stands_at_start, stands_at_goal] = task.beyond;
  if (is_start) return stands_at_start ? 0 : start;
  return stands_at_goal ? 0 : goal;
}

bool holds_wheels(const Task& task, GearSign beyond) {
  if (task.steering == Steering::reeds_shepp) return false;
  return task.steering == Steering::continuous || beyond != 0;
}

DrivenBeside driven_at_ends(const Task& task, GearSign initial) {
  const auto curvature = [&](double given, GearSign beyond) {
    return holds_wheels(task, beyond) ? given : Driven::any;
  };
  const GearSign before = initial != 0 ? initial : task.beyond.start;
  return {{before, curvature(task.curvatures.start, rolling_beyond(task, true))},
          {task.beyond.goal, curvature(task.curvatures.goal, rolling_beyond(task, false))}};
}

DrivenBeside fitted_driven(const Task& task, const DrivenBeside& beside) {
  if (task.steering == Steering::reeds_shepp) return {beside.before.gear, 0};
  return beside;
}

}  // namespace vandplan::search

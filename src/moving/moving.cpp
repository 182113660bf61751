// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/motion.h"

#include <algorithm>

namespace vandplan {

std::string_view name_of(Afterwards after) noexcept {
  return after == Afterwards::stays ? "stays" : "leaves";
}

std::optional<Pose> pose_at(const MovingObstacle& obstacle, double t) noexcept {
  const std::vector<TimedPose>& rows = obstacle.trajectory;
  if (rows.empty()) return std::nullopt;
  if (t >= rows.back().t) {
    if (t > rows.back().t && obstacle.after == Afterwards::leaves) return std::nullopt;
    return rows.back().pose;
  }
  const auto next = std::ranges::upper_bound(rows, t, {}, &TimedPose::t);
  if (next == rows.begin()) return next->pose;
  const TimedPose& from = *std::prev(next);
  const double share = (t - from.t) / (next->t - from.t);
  const double turn = wrap_angle(next->pose.heading - from.pose.heading);
  return Pose{from.pose.x + share * (next->pose.x - from.pose.x),
              from.pose.y + share * (next->pose.y - from.pose.y), from.pose.heading + share * turn};
}

double growth_at(const MovingObstacle& obstacle, double t) noexcept {
  if (obstacle.trajectory.empty()) return 0.0;
  return obstacle.inflate * std::clamp(t, 0.0, std::max(obstacle.trajectory.back().t, 0.0));
}

double end_of_motion(std::span<const MovingObstacle> moving) noexcept {
  double end = 0.0;
  for (const MovingObstacle& obstacle : moving) {
    if (!obstacle.trajectory.empty()) end = std::max(end, obstacle.trajectory.back().t);
  }
  return end;
}

}  // namespace vandplan

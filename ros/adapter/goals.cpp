// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/goals.h"

#include <algorithm>
#include <numbers>

#include "vandplan/input_error.h"

namespace vandplan::ros {
namespace {

constexpr double least_side = 1e-3;  // of half a box, so that it has an area [m]

Pose turned(const Pose& pose) {
  return {pose.x, pose.y, wrap_angle(pose.heading + std::numbers::pi)};
}

/// Corners of a box around a pose, along its heading.
Polygon box_around(const Pose& pose, const GoalSlack& slack) {
  const double ahead = std::max(slack.ahead, least_side);
  const double aside = std::max(slack.aside, least_side);
  Polygon box;
  for (const Point& corner :
       {Point{-ahead, -aside}, Point{ahead, -aside}, Point{ahead, aside}, Point{-ahead, aside}}) {
    const Pose at = compose(pose, {corner.x, corner.y, 0.0});
    box.push_back({at.x, at.y});
  }
  return box;
}

}  // namespace

Pose axle_pose(const Pose& base, double rear_axle) noexcept {
  return rear_axle == 0.0 ? base : compose(base, {rear_axle, 0.0, 0.0});
}

Goals goals_of(const Request& request) {
  if (request.heading == GoalHeading::any && request.rear_axle != 0.0) {
    throw InputError("goal_heading_mode",
                     "is ALL_DIRECTION, expected another one with a rear_axle that is not 0");
  }
  Goals goals;
  for (std::size_t i = 0; i < request.goals.size(); ++i) {
    const Pose& base = request.goals[i];
    GoalRegion region = region_of_pose(axle_pose(base, request.rear_axle));
    if (request.heading == GoalHeading::any) region.heading = any_heading;
    goals.regions.push_back(region);
    goals.origins.push_back(i);
    if (request.heading != GoalHeading::either_way) continue;
    goals.regions.push_back(region_of_pose(axle_pose(turned(base), request.rear_axle)));
    goals.origins.push_back(i);
  }
  return goals;
}

Goals goals_beside(const Request& request) {
  Goals goals;
  const double turn = request.slack.heading;
  const bool is_any = request.heading == GoalHeading::any || turn >= std::numbers::pi;
  for (std::size_t i = 0; i < request.goals.size(); ++i) {
    const Pose axle = axle_pose(request.goals[i], request.rear_axle);
    GoalRegion region{.area = box_around(axle, request.slack),
                      .heading = {axle.heading - turn, axle.heading + turn},
                      .either_way = request.heading == GoalHeading::either_way};
    if (is_any) region.heading = any_heading;
    goals.regions.push_back(region);
    goals.origins.push_back(i);
  }
  return goals;
}

}  // namespace vandplan::ros

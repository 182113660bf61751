// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a test judge what a replanner answers?

#include <cmath>
#include <string>

#include "replanning/timed_path.h"
#include "vandplan/judge.h"
#include "vandplan/replanner.h"

namespace vandplan {

inline constexpr double tick_period = 0.1;  // [s]

/// A lane of 60 m between two walls far apart.
inline Scenario lane() {
  Scenario scenario;
  scenario.bounds = {-20, 80, -30, 30};
  scenario.goal = {60, 0, 0};
  scenario.obstacles = {{{-20, 25}, {80, 25}, {80, 26}, {-20, 26}},
                        {{-20, -26}, {80, -26}, {80, -25}, {-20, -25}}};
  return scenario;
}

inline replanning::CutDrive rest(const ReplanAnswer& answer, const Vehicle& vehicle, double t) {
  return replanning::rest_of(*answer.drive, vehicle, t - answer.begin, answer.start_hitch_angle);
}

inline Pose pose_at(const ReplanAnswer& answer, const Vehicle& vehicle, double t) {
  return motion_at(answer.drive->path, vehicle, answer.drive->speeds, t - answer.begin).pose;
}

/// What a judge says who knows nothing of replanning: why the rest of an answer is no good.
inline std::string fault_of(const ReplanAnswer& answer, const Scenario& scenario, double t) {
  const replanning::CutDrive left = rest(answer, scenario.vehicle, t);
  Scenario now = scenario;
  now.start = left.drive.path.start;
  now.goal = answer.reaches_goal ? scenario.goal : end_pose(left.drive.path);
  now.curvatures.start = left.begin.curvature;
  now.hitch_angles.start = left.begin.hitch_angle;
  if (!answer.reaches_goal) {
    now.hitch_angles.goal = replanning::hitch_angle_after(scenario.vehicle, left.begin.hitch_angle,
                                                          left.drive.path.segments);
  }
  for (MovingObstacle& obstacle : now.moving) {
    for (TimedPose& row : obstacle.trajectory) row.t -= t;
  }
  const Problem problem = make_problem(now);
  const PathCheck way = check_path(problem, left.drive.path);
  if (!way.valid) return way.reason;
  return check_drive(problem, left.drive, {.start_speed = std::abs(left.begin.v)}).reason;
}

}  // namespace vandplan

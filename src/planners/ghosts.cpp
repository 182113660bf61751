// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/ghosts.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/trigonometry.h"
#include "vandplan/input_error.h"
#include "vandplan/vehicle.h"

namespace vandplan::in_time {
namespace {

constexpr double time_step = 0.5;     // spacing of the times of ghosts [s]
constexpr double passing_time = 3.0;  // span of a passing ghost before and after the meeting [s]
constexpr double places_passing = 6;  // outlines of a passing ghost, less one
constexpr double places_of_way = 24;  // outlines of a whole way, less one

/// The outline of an obstacle at a time, in the frame of the task; empty if it has left.
Polygon outline_at(const MovingObstacle& obstacle, double t) {
  const std::optional<Pose> pose = pose_at(obstacle, t);
  Polygon there;
  if (!pose) return there;
  const auto [sin, cos] = base::sin_cos(pose->heading);
  for (const auto& [x, y] : obstacle.outline) {
    there.push_back({pose->x + cos * x - sin * y, pose->y + sin * x + cos * y});
  }
  return there;
}

void add_outlines(const Task& task, const Ghost& ghost, std::vector<Polygon>& outlines) {
  const auto add = [&](const MovingObstacle& obstacle, double t) {
    Polygon outline = outline_at(obstacle, t);
    const bool is_new = std::ranges::find(outlines, outline) == outlines.end();
    if (!outline.empty() && is_new) outlines.push_back(std::move(outline));
  };
  const auto sweep = [&](double begin, double end, double count) {
    for (double i = 0; i <= count; ++i) {
      add(task.moving[ghost.obstacle], begin + (end - begin) * i / count);
    }
  };
  switch (ghost.kind) {
    case Ghost::Kind::where_met:
      add(task.moving[ghost.obstacle], ghost.t);
      break;
    case Ghost::Kind::passing:
      sweep(std::max(ghost.t - passing_time, 0.0), ghost.t + passing_time, places_passing);
      break;
    case Ghost::Kind::whole_way:
      sweep(0.0, std::max(task.moving[ghost.obstacle].trajectory.back().t, 0.0), places_of_way);
      break;
    case Ghost::Kind::at_rest:
      for (const MovingObstacle& obstacle : task.moving) {
        if (obstacle.after == Afterwards::stays) add(obstacle, obstacle.trajectory.back().t);
      }
      break;
  }
}

}  // namespace

std::vector<Ghost> ghosts_at(const Meeting& meeting) {
  const double t = std::round(meeting.t / time_step) * time_step;
  return {{Ghost::Kind::where_met, meeting.obstacle, t},
          {Ghost::Kind::at_rest},
          {Ghost::Kind::passing, meeting.obstacle, t},
          {Ghost::Kind::whole_way, meeting.obstacle}};
}

std::optional<Task> task_around(const Task& task, std::span<const Ghost> ghosts,
                                const ClearanceOptions& clearance) {
  std::vector<Polygon> outlines;
  for (const Ghost& ghost : ghosts) add_outlines(task, ghost, outlines);
  if (outlines.empty()) return std::nullopt;
  try {
    auto world = std::make_shared<const World>(*task.world, outlines);
    const Problem problem = make_problem(std::move(world), task.vehicle, task.start, task.goal,
                                         task.curvatures, task.hitch_angles);
    Task around = task_of(problem, clearance, task.steering);
    around.last_stretch = task.last_stretch;
    around.via = task.via;
    const CollisionChecker& checker = *around.checker;
    if (checker.is_free(start_state(task)) && checker.is_free(goal_state(task))) return around;
  } catch (const InputError&) {
    // By a rounding error a turned outline may touch itself. It is no obstacle then.
  }
  return std::nullopt;
}

}  // namespace vandplan::in_time

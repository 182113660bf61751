// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a test make a problem without a file?

#include <memory>
#include <utility>
#include <vector>

#include "vandplan/problem.h"

namespace vandplan {

inline constexpr Bounds wide_bounds{-200, 200, -200, 200};

/// The default truck among obstacles, planned for in the scenario's own frame.
inline Problem problem_of(const Pose& start, const Pose& goal, std::vector<Polygon> obstacles,
                          const Bounds& bounds = wide_bounds, const Vehicle& vehicle = {}) {
  return {std::make_shared<World>(vehicle, bounds, std::move(obstacles), Point{}), start, goal};
}

inline Polygon box(double x_min, double y_min, double x_max, double y_max) {
  return {{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}};
}

/// The same scenario somewhere else. With whole metres the text of its coordinates keeps its
/// decimals, as long as they are few enough.
inline Scenario moved_by(Scenario scenario, double dx, double dy) {
  const auto move_pose = [&](Pose& pose) { pose = {pose.x + dx, pose.y + dy, pose.heading}; };
  const auto move_polygons = [&](std::vector<Polygon>& polygons) {
    for (Polygon& polygon : polygons) {
      for (Point& corner : polygon) corner = {corner.x + dx, corner.y + dy};
    }
  };
  const Bounds b = scenario.bounds;
  scenario.bounds = {b.x_min + dx, b.x_max + dx, b.y_min + dy, b.y_max + dy};
  move_pose(scenario.start);
  move_polygons(scenario.obstacles);
  for (Goal& goal : scenario.goals) {
    move_pose(goal.pose);
    move_polygons(goal.obstacles);
  }
  return scenario;
}

}  // namespace vandplan

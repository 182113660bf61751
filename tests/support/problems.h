// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a test make a problem without a file?

#include <memory>
#include <utility>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan {

inline constexpr Bounds wide_bounds{-200, 200, -200, 200};

/// Surroundings whose world has the frame of the scenario.
inline std::shared_ptr<const World> world_of(const Surroundings& surroundings) {
  return std::make_shared<const World>(surroundings, Point{});
}

/// A vehicle in surroundings, planned for in the scenario's own frame.
inline Problem problem_in(const Surroundings& surroundings, const Pose& start, const Pose& goal,
                          const Vehicle& vehicle = {}) {
  return make_problem(world_of(surroundings), vehicle, start, goal);
}

/// A vehicle that is asked to drive a path in surroundings.
inline Problem problem_of_path(const Surroundings& surroundings, const Path& path,
                               const Vehicle& vehicle = {}) {
  return problem_in(surroundings, path.start, end_pose(path), vehicle);
}

/// The default truck among obstacles, planned for in the scenario's own frame.
inline Problem problem_of(const Pose& start, const Pose& goal, std::vector<Polygon> obstacles,
                          const Bounds& bounds = wide_bounds, const Vehicle& vehicle = {}) {
  return problem_in({.bounds = bounds, .obstacles = std::move(obstacles)}, start, goal, vehicle);
}

/// What stands in a problem's way.
inline const std::vector<Polygon>& obstacles_of(const Problem& problem) {
  return problem.world()->local().obstacles;
}

inline Polygon box(double x_min, double y_min, double x_max, double y_max) {
  return {{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}};
}

/// A tractor with a semitrailer of 13.6 m.
inline Vehicle semitrailer() {
  Vehicle vehicle{3.6, 1.4, 0.9, 2.55, 5.9};
  vehicle.hitch = 0.6;
  vehicle.trailer = Trailer{7.7, 1.6, 4.3, 2.55};
  return vehicle;
}

/// A dock between two parked trailers, from a yard of 40 m: a rig has to reverse.
inline Scenario dock_for(const Vehicle& rig) {
  return {.name = "dock",
          .vehicle = rig,
          .bounds = {-40, 40, -2, 45},
          .start = {-20, 30, 0},
          .goal = {0, 13, 1.5707963267948966},
          .obstacles = {box(-40, 0, 40, 1), box(-5, 1, -2.4, 14), box(2.4, 1, 5, 14)}};
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
  move_pose(scenario.goal);
  move_polygons(scenario.obstacles);
  move_polygons(scenario.kerbs);
  if (scenario.map) move_pose(scenario.map->origin);
  return scenario;
}

/// The length, with these two prices and no other.
[[nodiscard]] constexpr CostOptions by_length_and(double reverse_weight, double gear_change_cost) {
  CostOptions cost = shortest_style;
  cost.reverse_weight = reverse_weight;
  cost.gear_change_cost = gear_change_cost;
  return cost;
}

}  // namespace vandplan

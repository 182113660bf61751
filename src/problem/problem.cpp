// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/problem.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/decimal.h"
#include "base/text.h"
#include "geometry/polygon.h"
#include "judge/cell_tree.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

constexpr double largest_coordinate = 1e12;  // [m]; doubles there are 0.1 mm apart
constexpr double largest_local_coordinate = 2 * largest_coordinate;
constexpr double largest_distance = 1e5;  // [m], start to goal: the poses of a path fill 1 GB
constexpr double largest_heading = 1e6;   // [rad]; wrapped to better than 1e-9
constexpr double largest_length = 1e6;    // of a vehicle [m]
constexpr double smallest_length = 1e-6;  // of a vehicle, where it may not be zero [m]

void require(bool holds, const std::string& where, const std::string& problem) {
  if (!holds) throw InputError(where, problem);
}

std::string element(std::string_view list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

void require_within(double value, double limit, const std::string& where) {
  if (std::abs(value) <= limit) return;  // most are: no text is made for them
  throw InputError(where, "is " + base::shortest_text(value) + ", expected a number between " +
                              base::shortest_text(-limit) + " and " + base::shortest_text(limit));
}

Vehicle checked(const Vehicle& vehicle) {
  const auto positive = [](double value, const std::string& key) {
    const std::string where = "vehicle." + key;
    require(value > 0.0, where, "is " + base::shortest_text(value) + ", expected more than 0 m");
    require(value >= smallest_length, where,
            "is " + base::shortest_text(value) + ", expected at least 1e-06 m");
    require_within(value, largest_length, where);
  };
  const auto not_negative = [](double value, const std::string& key) {
    const std::string where = "vehicle." + key;
    require(value >= 0.0, where, "is " + base::shortest_text(value) + ", expected 0 m or more");
    require_within(value, largest_length, where);
  };
  positive(vehicle.wheelbase, "wheelbase");
  not_negative(vehicle.front_overhang, "front_overhang");
  not_negative(vehicle.rear_overhang, "rear_overhang");
  positive(vehicle.width, "width");
  positive(vehicle.min_turning_radius, "min_turning_radius");
  if (vehicle.track_width) {
    positive(*vehicle.track_width, "track_width");
    require(*vehicle.track_width <= vehicle.width, "vehicle.track_width",
            "is " + base::shortest_text(*vehicle.track_width) + ", expected at most the width, " +
                base::shortest_text(vehicle.width));
  }
  return vehicle;
}

void check_range(double low, double high, double limit, const std::string& where) {
  require_within(low, limit, where);
  require_within(high, limit, where);
  require(low < high, where,
          "is [" + base::shortest_text(low) + ", " + base::shortest_text(high) +
              "], expected the smaller number first");
}

Bounds checked(const Bounds& bounds, double limit) {
  check_range(bounds.x_min, bounds.x_max, limit, "bounds.x");
  check_range(bounds.y_min, bounds.y_max, limit, "bounds.y");
  return bounds;
}

void check_pose(const Pose& pose, const std::string& where) {
  require_within(pose.x, largest_coordinate, where + ".x");
  require_within(pose.y, largest_coordinate, where + ".y");
  require_within(pose.heading, largest_heading, where + ".heading");
}

void check_corners(const Polygon& polygon, double limit, const std::string& where) {
  for (const Point& corner : polygon) {
    require_within(corner.x, limit, where);
    require_within(corner.y, limit, where);
  }
}

/// A cleaned simple polygon, in the frame of `origin`.
Polygon checked(const Polygon& polygon, const Point& origin, const std::string& where) {
  require(polygon.size() >= 3, where,
          "has " + std::to_string(polygon.size()) + " corner" + (polygon.size() == 1 ? "" : "s") +
              ", expected at least 3");
  Polygon clean = geometry::cleaned(polygon);
  const std::string flaw = geometry::flaw_of(clean, origin);
  require(flaw.empty(), where, flaw);
  return clean;
}

std::vector<Polygon> checked(const std::vector<Polygon>& polygons, const Point& origin,
                             std::string_view name) {
  std::vector<Polygon> result;
  result.reserve(polygons.size());
  for (const Polygon& polygon : polygons) {
    const std::string where = element(name, result.size());
    check_corners(polygon, largest_local_coordinate, where);
    result.push_back(checked(polygon, origin, where));
  }
  return result;
}

/// A grid whose cells are all there.
void check(const OccupancyGrid& grid, double limit) {
  require(grid.resolution >= smallest_length && grid.resolution <= largest_length, "map.resolution",
          "is " + base::shortest_text(grid.resolution) + ", expected 1e-06 m to 1e+06 m");
  require_within(grid.origin.x, limit, "map.origin");
  require_within(grid.origin.y, limit, "map.origin");
  require_within(grid.origin.heading, largest_heading, "map.origin");
  const std::int64_t count = std::int64_t{grid.columns} * grid.rows;
  require(grid.columns >= 1 && grid.rows >= 1 && count <= most_map_cells, "map",
          "has " + std::to_string(grid.columns) + " x " + std::to_string(grid.rows) +
              " cells, expected 1 to " + std::to_string(most_map_cells));
  require(grid.cells != nullptr && grid.cells->size() == static_cast<std::size_t>(count), "map",
          "does not hold all of its cells, expected " + std::to_string(count));
}

Surroundings checked(Surroundings surroundings, const Point& origin) {
  (void)checked(surroundings.bounds, largest_local_coordinate);
  surroundings.obstacles = checked(surroundings.obstacles, origin, "obstacles");
  surroundings.kerbs = checked(surroundings.kerbs, origin, "kerbs");
  if (surroundings.map) check(*surroundings.map, largest_local_coordinate);
  return surroundings;
}

/// The start, rounded to whole metres.
Point local_origin(const Scenario& scenario) {
  return {std::round(scenario.start.x), std::round(scenario.start.y)};
}

Point local_point(const Point& point, const Point& origin) {
  return {base::moved(point.x, -origin.x), base::moved(point.y, -origin.y)};
}

Bounds local_bounds(const Bounds& bounds, const Point& origin) {
  const Point low = local_point({bounds.x_min, bounds.y_min}, origin);
  const Point high = local_point({bounds.x_max, bounds.y_max}, origin);
  return {low.x, high.x, low.y, high.y};
}

Pose local_pose(const Pose& pose, const Point& origin) {
  const Point position = local_point({pose.x, pose.y}, origin);
  return {position.x, position.y, wrap_angle(pose.heading)};
}

Polygon local_polygon(const Polygon& polygon, const Point& origin) {
  Polygon result;
  result.reserve(polygon.size());
  for (const Point& corner : polygon) result.push_back(local_point(corner, origin));
  return result;
}

std::optional<OccupancyGrid> local_map(std::optional<OccupancyGrid> map, const Point& origin) {
  if (map) map->origin = local_pose(map->origin, origin);
  return map;
}

/// "goal" or "goals[3]": where the goal stands in the file.
std::string key_of(const Scenario& scenario, std::size_t goal) {
  return scenario.goals_are_a_row ? element("goals", goal) : "goal";
}

void check_polygons(const std::vector<Polygon>& polygons, const Point& origin,
                    const std::string& name) {
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    check_corners(polygons[i], largest_coordinate, element(name, i));
    (void)checked(local_polygon(polygons[i], origin), origin, element(name, i));
  }
}

/// Checks what all goals share.
void check_shared(const Scenario& scenario) {
  (void)checked(scenario.vehicle);
  (void)checked(scenario.bounds, largest_coordinate);
  check_pose(scenario.start, "start");
  check_polygons(scenario.obstacles, local_origin(scenario), "obstacles");
  check_polygons(scenario.kerbs, local_origin(scenario), "kerbs");
  if (scenario.map) check(*scenario.map, largest_coordinate);
  require(!scenario.goals.empty(), "goals", "is empty, expected at least one goal");
}

void check_distance(const Pose& start, const Pose& goal, const std::string& where) {
  const double distance = std::hypot(goal.x - start.x, goal.y - start.y);
  require(distance <= largest_distance, where,
          "is " + std::to_string(std::llround(distance)) + " m from the start, expected at most " +
              std::to_string(std::llround(largest_distance)) + " m");
}

void check_goal(const Scenario& scenario, std::size_t index) {
  const Goal& goal = scenario.goals[index];
  const std::string key = key_of(scenario, index);
  if (goal.distance) {
    const std::string where = key + ".distance";
    require(*goal.distance >= 0.0, where,
            "is " + base::shortest_text(*goal.distance) + ", expected 0 m or more");
    require_within(*goal.distance, largest_coordinate, where);
  }
  const std::string pose_key = scenario.goals_are_a_row ? key + ".goal" : key;
  check_pose(goal.pose, pose_key);
  check_distance(scenario.start, goal.pose, pose_key);
  check_polygons(goal.obstacles, local_origin(scenario), key + ".obstacles");
}

/// The world of a goal that has these obstacles of its own.
std::shared_ptr<const World> world_of(const Scenario& scenario, const std::vector<Polygon>& own) {
  const Point origin = local_origin(scenario);
  Surroundings surroundings{.bounds = local_bounds(scenario.bounds, origin),
                            .map = local_map(scenario.map, origin)};
  for (const auto* list : {&scenario.obstacles, &own}) {
    for (const Polygon& polygon : *list) {
      surroundings.obstacles.push_back(local_polygon(polygon, origin));
    }
  }
  for (const Polygon& kerb : scenario.kerbs) {
    surroundings.kerbs.push_back(local_polygon(kerb, origin));
  }
  return std::make_shared<const World>(scenario.vehicle, std::move(surroundings), origin);
}

Problem problem_of(const Scenario& scenario, std::size_t goal, std::shared_ptr<const World> world) {
  const Point origin = world->origin();
  return {.world = std::move(world),
          .start = local_pose(scenario.start, origin),
          .goal = local_pose(scenario.goals[goal].pose, origin)};
}

}  // namespace

World::World(const Vehicle& vehicle, const Bounds& bounds, std::vector<Polygon> obstacles,
             const Point& origin)
    : World(vehicle, Surroundings{.bounds = bounds, .obstacles = std::move(obstacles)}, origin) {}

World::World(const Vehicle& vehicle, Surroundings surroundings, const Point& origin)
    : vehicle_(checked(vehicle)),
      surroundings_(checked(std::move(surroundings), origin)),
      origin_(origin),
      checker_(vehicle_, surroundings_),
      judges_cells_(map() ? std::make_shared<const judge::CellTree>(*map()) : nullptr) {}

void check_scenario(const Scenario& scenario) {
  check_shared(scenario);
  for (std::size_t i = 0; i < scenario.goals.size(); ++i) check_goal(scenario, i);
}

void check_map(const OccupancyGrid& map) { check(map, largest_coordinate); }

Problem make_problem(const Scenario& scenario, std::size_t goal) {
  check_shared(scenario);
  assert(goal < scenario.goals.size());
  check_goal(scenario, goal);
  return problem_of(scenario, goal, world_of(scenario, scenario.goals[goal].obstacles));
}

std::vector<Problem> make_problems(const Scenario& scenario) {
  check_scenario(scenario);
  std::shared_ptr<const World> shared;
  std::vector<Problem> problems;
  for (std::size_t goal = 0; goal < scenario.goals.size(); ++goal) {
    const std::vector<Polygon>& own = scenario.goals[goal].obstacles;
    if (own.empty() && shared == nullptr) shared = world_of(scenario, {});
    problems.push_back(problem_of(scenario, goal, own.empty() ? shared : world_of(scenario, own)));
  }
  return problems;
}

Problem make_problem(std::shared_ptr<const World> world, const Pose& start, const Pose& goal) {
  check_pose(start, "start");
  check_pose(goal, "goal");
  check_distance(start, goal, "goal");
  const Pose local_start = to_local(*world, start);
  const Pose local_goal = to_local(*world, goal);
  return {std::move(world), local_start, local_goal};
}

Pose to_local(const World& world, const Pose& pose) noexcept {
  return local_pose(pose, world.origin());
}

Pose to_scenario(const World& world, const Pose& pose) noexcept {
  return {base::moved(pose.x, world.origin().x), base::moved(pose.y, world.origin().y),
          pose.heading};
}

Bounds sampling_region(const Problem& problem, Region region) noexcept {
  const Bounds& bounds = problem.world->bounds();
  if (region == Region::bounds) return bounds;
  constexpr double margin = 20.0;  // [m]
  const Point poses[] = {{problem.start.x, problem.start.y}, {problem.goal.x, problem.goal.y}};
  Bounds scene = bounding_box(poses);
  const auto add = [&](const Bounds& box) {
    scene = {std::min(scene.x_min, box.x_min), std::max(scene.x_max, box.x_max),
             std::min(scene.y_min, box.y_min), std::max(scene.y_max, box.y_max)};
  };
  for (const Polygon& obstacle : problem.world->obstacles()) {
    add(bounding_box(obstacle));
  }
  for (const Polygon& kerb : problem.world->kerbs()) add(bounding_box(kerb));
  if (problem.world->map()) add(bounding_box(outline(*problem.world->map())));
  return {std::clamp(scene.x_min - margin, bounds.x_min, bounds.x_max),
          std::clamp(scene.x_max + margin, bounds.x_min, bounds.x_max),
          std::clamp(scene.y_min - margin, bounds.y_min, bounds.y_max),
          std::clamp(scene.y_max + margin, bounds.y_min, bounds.y_max)};
}

}  // namespace vandplan

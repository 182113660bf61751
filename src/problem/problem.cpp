// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/problem.h"

#include <algorithm>
#include <utility>

#include "base/decimal.h"
#include "base/derived.h"
#include "base/require.h"
#include "collision/ground.h"
#include "geometry/boxes.h"
#include "problem/checks.h"
#include "problem/fences.h"
#include "problem/goal_set.h"
#include "problem/masks.h"
#include "problem/moving.h"
#include "problem/zones.h"
#include "vandplan/input_error.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

/// Surroundings moved into the frame of `origin`, cleaned, with fences and the blocks of masks.
/// Throws InputError naming the wrong key.
Surroundings checked(const Surroundings& given, const Point& origin) {
  Surroundings local{.bounds = problem::local_bounds(given.bounds, origin),
                     .obstacles = problem::local_polygons(given.obstacles, origin, "obstacles"),
                     .kerbs = problem::local_polygons(given.kerbs, origin, "kerbs"),
                     .map = {},
                     .inside = problem::local_areas(given.inside, origin),
                     .zones = problem::local_zones(given.zones, origin),
                     .masks = problem::local_masks(given.masks, origin)};
  std::vector<Polygon> first = problem::fences_around(local.inside);
  for (Mask& mask : local.masks) {
    std::vector<Polygon> blocks;
    if (mask.use == MaskUse::obstacles) blocks = problem::rectangles_over(mask.map);
    mask.blocks = blocks.size();
    first.insert(first.end(), blocks.begin(), blocks.end());
  }
  local.obstacles.insert(local.obstacles.begin(), first.begin(), first.end());
  if (given.map) local.map = problem::local_map(*given.map, origin);
  return local;
}

/// A collision checker, with the vehicle and the margin that it was made for.
struct VehicleChecker {
  Vehicle vehicle;
  double margin;   // margin that the vehicle keeps [m]
  bool has_rules;  // whether the checker knows the zones and masks of the world
  CollisionChecker checker;
};

/// Throws InputError for a default-constructed problem, which has no world.
void expect_made(const Problem& problem) {
  if (problem.world() == nullptr) {
    throw InputError("problem", "is empty, expected one that make_problem returned");
  }
}

/// Checks poses, curvatures and hitch angles of start and goal, or the set of goals.
void check_ends(const Scenario& scenario) {
  problem::check_via(scenario.via, scenario.vehicle, scenario.start);
  if (!scenario.goal_set.empty()) {
    problem::check_goal_set(scenario.goal_set, scenario.vehicle, scenario.start);
    problem::check_curvature(scenario.curvatures.start, scenario.vehicle, "start.curvature");
    problem::check_hitch_angle(scenario.hitch_angles.start, scenario.vehicle, "start.hitch_angles");
    return;
  }
  check_poses(scenario.start, scenario.goal);
  problem::check_curvatures(scenario.curvatures, scenario.vehicle);
  problem::check_hitch_angles(scenario.hitch_angles, scenario.vehicle);
}

Problem at_goal_of(const Scenario& scenario, std::shared_ptr<const World> world) {
  const Vehicle& vehicle = scenario.vehicle;
  const Pose& start = scenario.start;
  if (scenario.goal_set.empty()) {
    return make_problem(std::move(world), vehicle, start, scenario.goal, scenario.curvatures,
                        scenario.hitch_angles);
  }
  return with_goal_set(make_problem(std::move(world), vehicle, start, start,
                                    {scenario.curvatures.start, scenario.curvatures.start},
                                    {scenario.hitch_angles.start, scenario.hitch_angles.start}),
                       scenario.goal_set);
}

}  // namespace

World::World(const Surroundings& surroundings, const Point& near)
    : origin_(problem::local_origin(near)),
      local_(checked(surroundings, origin_)),
      ground_(std::make_shared<collision::Ground>(local_)),
      derived_(std::make_unique<base::Derived>()) {}

World::World(const World& ground, const std::vector<Polygon>& more)
    : local_(ground.local_),
      ground_(std::make_shared<collision::Ground>(*ground.ground_)),
      derived_(std::make_unique<base::Derived>()) {
  for (Polygon& polygon : problem::local_polygons(more, {}, "more")) {
    local_.obstacles.push_back(std::move(polygon));
  }
  ground_->walls = collision::Obstacles(local_.obstacles);
}

World::~World() = default;

std::size_t World::fences() const noexcept {
  std::size_t count = 0;
  for (const Polygon& area : local_.inside) count += area.size();
  for (const Mask& mask : local_.masks) count += mask.blocks;
  return count;
}

Surroundings World::without_fences() const {
  Surroundings given = local_;
  const auto begin = given.obstacles.begin();
  given.obstacles.erase(begin, begin + static_cast<std::ptrdiff_t>(fences()));
  return given;
}

void World::change(std::vector<Polygon> obstacles, std::span<const CellRange> cells) {
  if (obstacles != local_.obstacles) {
    local_.obstacles = std::move(obstacles);
    ground_->walls = collision::Obstacles(local_.obstacles);
  }
  for (const CellRange& range : cells) ground_->map->update(*local_.map, range);
  derived_ = std::make_unique<base::Derived>();
}

std::shared_ptr<const CollisionChecker> World::checker(const Vehicle& vehicle,
                                                       const Margin& margin) const {
  return checker_among(vehicle, margin, local_.zones, local_.masks);
}

std::shared_ptr<const CollisionChecker> World::checker_of_obstacles(const Vehicle& vehicle,
                                                                    const Margin& margin) const {
  return checker_among(vehicle, margin, {}, {});
}

std::shared_ptr<const CollisionChecker> World::checker_among(const Vehicle& vehicle,
                                                             const Margin& margin,
                                                             std::span<const Zone> zones,
                                                             std::span<const Mask> masks) const {
  check_vehicle(vehicle);
  base::require(margin.wanted >= 0.0, "margin", margin.wanted, "a number >= 0 [m]");
  if (!margin.ramps.empty()) {
    return std::make_shared<const CollisionChecker>(vehicle, ground_, margin, zones, masks);
  }
  const bool has_rules = !zones.empty() || !masks.empty();
  const auto found = std::static_pointer_cast<const VehicleChecker>(derived_->find_or_make(
      typeid(VehicleChecker),
      [&](const void* made) {
        const auto& known = *static_cast<const VehicleChecker*>(made);
        return same_lengths(known.vehicle, vehicle) && known.margin == margin.wanted &&
               known.has_rules == has_rules;
      },
      [&] {
        return std::shared_ptr<const VehicleChecker>(
            new VehicleChecker{vehicle, margin.wanted, has_rules,
                               CollisionChecker(vehicle, ground_, margin, zones, masks)});
      }));
  return {found, &found->checker};
}

std::shared_ptr<const void> World::kept(
    std::type_index type, const std::function<std::shared_ptr<const void>()>& make) const {
  return derived_->find_or_make(
      type, [](const void*) { return true; }, make);
}

void check_scenario(const Scenario& scenario) {
  check_vehicle(scenario.vehicle);
  problem::check_pose(scenario.start, "start");
  (void)checked(surroundings(scenario),
                problem::local_origin({scenario.start.x, scenario.start.y}));
  check_ends(scenario);
  (void)problem::local_moving(scenario.moving,
                              problem::local_origin({scenario.start.x, scenario.start.y}));
}

Surroundings surroundings(const Scenario& scenario) {
  return {.bounds = scenario.bounds,
          .obstacles = scenario.obstacles,
          .kerbs = scenario.kerbs,
          .map = scenario.map,
          .inside = scenario.inside,
          .zones = scenario.zones,
          .masks = scenario.masks};
}

Problem make_problem(const Scenario& scenario) {
  check_vehicle(scenario.vehicle);
  problem::check_pose(scenario.start, "start");
  auto world = std::make_shared<const World>(surroundings(scenario),
                                             Point{scenario.start.x, scenario.start.y});
  const Problem made = with_via(at_goal_of(scenario, std::move(world)), scenario.via);
  return with_moving(made, scenario.moving);
}

Problem make_problem(std::shared_ptr<const World> world, const Vehicle& vehicle, const Pose& start,
                     const Pose& goal, const EndCurvatures& curvatures,
                     const EndHitchAngles& hitch_angles) {
  if (world == nullptr) throw InputError("world", "is null, expected a world");
  check_poses(start, goal);
  problem::check_curvatures(curvatures, vehicle);
  problem::check_hitch_angles(hitch_angles, vehicle);
  Problem made;
  made.start_ = start;
  made.goal_ = goal;
  made.task_.checker = world->checker(vehicle);
  made.task_.vehicle = vehicle;
  made.task_.start = to_local(*world, start);
  made.task_.goal = to_local(*world, goal);
  made.task_.curvatures = curvatures;
  made.task_.hitch_angles = hitch_angles;
  made.task_.world = std::move(world);
  return made;
}

Problem with_moving(Problem problem, std::span<const MovingObstacle> moving) {
  expect_made(problem);
  problem.task_.moving = problem::local_moving(moving, problem.world()->origin());
  return problem;
}

Problem with_poses(const Problem& problem, const Pose& start, const Pose& goal) {
  Problem other = make_problem(problem.world(), problem.vehicle(), start, goal);
  other.task_.moving = problem.task_.moving;
  return other;
}

Problem with_goal_set(const Problem& problem, const std::vector<GoalRegion>& set) {
  expect_made(problem);
  problem::check_goal_set(set, problem.vehicle(), problem.start());
  const State some = problem::some_goal(problem.vehicle(), set.front());
  Problem other = problem;
  other.goal_ = some.pose;
  other.goal_set_ = set;
  other.task_.goal = to_local(*problem.world(), some.pose);
  other.task_.curvatures.goal = set.front().curvature;
  other.task_.hitch_angles.goal = some.hitch_angle;
  other.task_.goal_set = problem::local_goal_set(set, problem.world()->origin());
  return other;
}

Problem with_via(const Problem& problem, const std::vector<Via>& via) {
  expect_made(problem);
  problem::check_via(via, problem.vehicle(), problem.start());
  Problem other = problem;
  other.via_ = via;
  other.task_.via = problem::local_via(via, problem.world()->origin());
  return other;
}

Task task_of(const Problem& problem, const ClearanceOptions& options, Steering steering) {
  expect_made(problem);
  validate({.clearance = options});
  Task task = problem.task();
  task.steering = steering;
  problem::tell_ends_apart(task);
  problem::keep_margin(task, options);
  return task;
}

// 1 nm is far below the error that a path's end may have, 1e-6 m.
void problem::tell_ends_apart(Task& task) {
  const bool turns_wheels = task.curvatures.start != task.curvatures.goal;
  if (task.steering == Steering::continuous && turns_wheels && task.start == task.goal) {
    task.goal.x += 1e-9;
  }
}

void problem::keep_margin(Task& task, const ClearanceOptions& options) {
  if (options.margin == 0.0) return;
  Margin margin{.wanted = options.margin};
  if (options.margin_ramp > 0.0) {
    for (const LocalState& state : {start_state(task), goal_state(task)}) {
      const Pose& pose = state.pose;
      const double clearance = task.checker->clearance(state, options.margin);
      if (clearance == 0.0 || clearance >= options.margin) continue;
      // The checker may ask for the margin plus its tolerance. So the margin of the ramp is below
      // the clearance by the tolerance: then the pose itself is free.
      const double least = std::max(clearance - CollisionChecker::tolerance, 0.0);
      margin.ramps.push_back({Local(Point{pose.x, pose.y}), least, options.margin_ramp});
    }
  }
  task.least_margin = margin.least();
  task.checker = task.world->checker(task.vehicle, margin);
}

LocalPose to_local(const World& world, const Pose& pose) noexcept {
  return problem::local_pose(pose, world.origin());
}

Pose to_scenario(const World& world, const LocalPose& pose) noexcept {
  return {base::moved(pose.x, world.origin().x), base::moved(pose.y, world.origin().y),
          pose.heading};
}

Local<Bounds> sampling_region(const Task& task, Region region) noexcept {
  const Surroundings& ground = task.world->local();
  const Bounds& bounds = ground.bounds;
  if (region == Region::bounds) return Local(bounds);
  constexpr double margin = 20.0;  // room around the scene [m]
  const Point poses[] = {{task.start.x, task.start.y}, {task.goal.x, task.goal.y}};
  Bounds scene = bounding_box(poses);
  const auto add = [&](const Bounds& box) { scene = geometry::united(scene, box); };
  for (const Polygon& obstacle : ground.obstacles) add(bounding_box(obstacle));
  for (const Polygon& kerb : ground.kerbs) add(bounding_box(kerb));
  if (ground.map) add(bounding_box(outline(*ground.map)));
  return Local(Bounds{std::clamp(scene.x_min - margin, bounds.x_min, bounds.x_max),
                      std::clamp(scene.x_max + margin, bounds.x_min, bounds.x_max),
                      std::clamp(scene.y_min - margin, bounds.y_min, bounds.y_max),
                      std::clamp(scene.y_max + margin, bounds.y_min, bounds.y_max)});
}

}  // namespace vandplan

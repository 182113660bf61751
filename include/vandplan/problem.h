// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a well-posed planning problem?
//
//  Scenario (unchecked) --make_problem--> Problem in a World (checked) --task--> what planners see
//
// Callers meet one frame, the scenario's. Planners work in the frame of the world, whose origin
// lies near the start: a double resolves no more than a micrometre at 5*10^9 m.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <typeindex>
#include <vector>

#include "vandplan/collision.h"
#include "vandplan/goal_set.h"
#include "vandplan/moving.h"
#include "vandplan/plan_options.h"
#include "vandplan/rig.h"
#include "vandplan/vehicle.h"

namespace vandplan {

namespace base {
class Derived;
}
namespace replanning {
class KnownGround;
}

/// How far the wheels are turned at the ends of a path; of account for `Steering::continuous`
/// alone, as they may be turned at standstill otherwise.
struct EndCurvatures {
  double start = 0.0;  ///< [1/m]
  double goal = 0.0;   ///< [1/m]
  bool operator==(const EndCurvatures&) const = default;
};

/// The angles between a vehicle and its trailer at the ends of a path; 0 without a trailer.
struct EndHitchAngles {
  double start = 0.0;  ///< heading of the vehicle - heading of its trailer [rad]
  double goal = 0.0;   ///< [rad]
  bool operator==(const EndHitchAngles&) const = default;
};

/// A planning problem as somebody states it: unchecked, every number in one frame of his choice.
struct Scenario {
  std::string name = {};
  std::string description = {};
  Vehicle vehicle = {};
  Bounds bounds = {};  ///< where the midpoint of the rear axle may be [m]
  Pose start = {};
  Pose goal = {};
  EndCurvatures curvatures = {};
  EndHitchAngles hitch_angles = {};
  /// Where the path may end: in any of these regions. Empty: at `goal`. Otherwise no notice is
  /// taken of `goal`, `curvatures.goal` and `hitch_angles.goal`.
  std::vector<GoalRegion> goal_set = {};
  std::vector<Polygon> obstacles = {};
  std::vector<Polygon> kerbs = {};          ///< low ones, that overhangs may swing over
  std::vector<Polygon> inside = {};         ///< the whole body stays in one of them; none: anywhere
  std::string map_file = {};                ///< where the map is from; empty without map
  std::optional<OccupancyGrid> map = {};    ///< the occupancy map itself; none: there is no map
  std::vector<MovingObstacle> moving = {};  ///< what else moves while the vehicle drives
};

/// Ground and obstacles, without a vehicle: checked, immutable, shared between threads, vehicles
/// and problems. What depends on a vehicle is made once for each vehicle, at its first problem.
class World {
 public:
  /// Takes surroundings in the scenario's frame; `near` is a place around which one plans, such as
  /// a start: the world's origin is `near`, rounded to whole metres. Throws InputError naming the
  /// key ("bounds.x", "obstacles[2]", "inside[1]", "map.resolution") when a number is not finite or
  /// out of range, bounds are crossed, areas of `inside` touch each other, or a polygon has fewer
  /// than three corners, no area, or crosses or touches itself. Repeated corners are dropped; a
  /// polygon of one repeated corner stands for that point.
  World(const Surroundings& surroundings, const Point& near);
  /// Another world with more obstacles, in the frame of that one, whose origin is 0 here. What was
  /// made of the map is shared. Throws InputError naming "more[2]" as above.
  World(const World& ground, const std::vector<Polygon>& more);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Where the origin of the world's frame lies in the scenario's frame [m]: whole metres. The axes
  /// of both frames are parallel.
  [[nodiscard]] const Point& origin() const noexcept { return origin_; }

  /// The cleaned surroundings in the world's frame, which planners and the judge work in. The first
  /// obstacles are the fences around the areas of `inside`; there are `fences()` of them.
  [[nodiscard]] const Surroundings& local() const noexcept { return local_; }

  /// Number of sides of all areas that the body stays in; each has a fence outside of it, a
  /// micrometre thick.
  [[nodiscard]] std::size_t fences() const noexcept;
  /// `local()` without the fences: what another world like this one is made of.
  [[nodiscard]] Surroundings without_fences() const;

  /// The checker of a vehicle that keeps a margin, in the world's frame. Kept with the world,
  /// unless the margin has ramps. Throws InputError naming "vehicle.width" or another key that is
  /// wrong.
  [[nodiscard]] std::shared_ptr<const CollisionChecker> checker(const Vehicle& vehicle,
                                                                const Margin& margin = {}) const;

  /// A value of that type that a part of the library keeps with the world: the one that `make`
  /// returns at the first call, the same one ever after. From any thread.
  [[nodiscard]] std::shared_ptr<const void> kept(
      std::type_index type, const std::function<std::shared_ptr<const void>()>& make) const;

 private:
  Point origin_;
  Surroundings local_;
  friend class replanning::KnownGround;  // changes a world that nobody else has
  /// Other obstacles, in the world's frame and cleaned, and other cells of the map in some ranges.
  /// What was kept is forgotten.
  void change(std::vector<Polygon> obstacles, std::span<const CellRange> cells);

  std::shared_ptr<collision::Ground> ground_;
  std::unique_ptr<base::Derived> derived_;
};

/// What a planner is asked, in the frame of the world: poses beside the origin, headings in
/// [-pi, pi). Everything that can be reached from here has this frame.
struct Task {
  std::shared_ptr<const World> world;
  std::shared_ptr<const CollisionChecker> checker;  ///< of the vehicle with its margin
  Vehicle vehicle;
  double least_margin = 0.0;  ///< that the vehicle keeps from things wherever it is [m]
  LocalPose start;
  LocalPose goal;  ///< of a set of goals some pose of the first region
  Steering steering = Steering::reeds_shepp;
  EndCurvatures curvatures = {};
  EndHitchAngles hitch_angles = {};
  std::vector<GoalRegion> goal_set = {};    ///< where the path may end instead of at `goal`
  std::vector<MovingObstacle> moving = {};  ///< what else moves; no part of `checker`
};

/// One vehicle, start and goal in a world: checked, immutable, cheap to copy.
class Problem {
 public:
  [[nodiscard]] const std::shared_ptr<const World>& world() const noexcept { return task_.world; }
  [[nodiscard]] const Vehicle& vehicle() const noexcept { return task_.vehicle; }
  /// The start and the goal in the scenario's frame, as they were given.
  [[nodiscard]] const Pose& start() const noexcept { return start_; }
  [[nodiscard]] const Pose& goal() const noexcept { return goal_; }

  /// The set of goals in the scenario's frame, as it was given; empty if `goal` is the only one.
  /// Otherwise `goal` is some pose of its first region.
  [[nodiscard]] const std::vector<GoalRegion>& goal_set() const noexcept { return goal_set_; }

  [[nodiscard]] const EndCurvatures& curvatures() const noexcept { return task_.curvatures; }
  [[nodiscard]] const EndHitchAngles& hitch_angles() const noexcept { return task_.hitch_angles; }

  /// The problem as planners see it, without a margin.
  [[nodiscard]] const Task& task() const noexcept { return task_; }

 private:
  friend Problem make_problem(std::shared_ptr<const World> world, const Vehicle& vehicle,
                              const Pose& start, const Pose& goal, const EndCurvatures& curvatures,
                              const EndHitchAngles& hitch_angles);
  friend Problem with_moving(Problem problem, std::span<const MovingObstacle> moving);
  friend Problem with_poses(const Problem& problem, const Pose& start, const Pose& goal);
  friend Problem with_goal_set(const Problem& problem, const std::vector<GoalRegion>& set);

  Pose start_;
  Pose goal_;
  std::vector<GoalRegion> goal_set_;
  Task task_;
};

/// Checks a scenario without building its world. Throws InputError naming the key that is wrong.
void check_scenario(const Scenario& scenario);

/// Checks a vehicle alone; errors name "vehicle.width" or another key.
void check_vehicle(const Vehicle& vehicle);

/// Checks two poses alone; errors name "start" or "goal". A goal is at most 100 km from its start.
void check_poses(const Pose& start, const Pose& goal);

/// Checks a map alone; errors name "map.resolution", "map.origin" or "map".
void check_map(const OccupancyGrid& map);

/// What of a scenario makes its world.
[[nodiscard]] Surroundings surroundings(const Scenario& scenario);

/// The problem of a scenario, in a world of its own. A start or goal in collision or outside the
/// bounds is no error: `plan` names it. Throws InputError naming the key that is wrong.
[[nodiscard]] Problem make_problem(const Scenario& scenario);

/// One more problem in a world that is there: nothing of it is built again, so thousands of
/// problems may share it, on as many threads as one likes. The poses are in the scenario's frame.
/// Throws InputError naming "vehicle", "start" or "goal" when they are out of range,
/// "start.curvature" or "goal.curvature" when the vehicle cannot turn so sharply,
/// "start.hitch_angles" or "goal.hitch_angles" when its trailer may not stand so.
[[nodiscard]] Problem make_problem(std::shared_ptr<const World> world, const Vehicle& vehicle,
                                   const Pose& start, const Pose& goal,
                                   const EndCurvatures& curvatures = {},
                                   const EndHitchAngles& hitch_angles = {});

/// The problem among what moves, in the scenario's frame, instead of what moved in it before.
/// Throws InputError naming "moving[2].outline" or another key.
[[nodiscard]] Problem with_moving(Problem problem, std::span<const MovingObstacle> moving);

/// The problem from and to somewhere else, with straight wheels: same world, same vehicle, and the
/// same things move. Throws InputError naming "start" or "goal" when they are out of range.
[[nodiscard]] Problem with_poses(const Problem& problem, const Pose& start, const Pose& goal);

/// The problem with a set of goals, in the scenario's frame, instead of what its goal was. Throws
/// InputError naming "goal.x", "goal.area", "goal.any_of[2].heading" or another key when a number
/// is out of range, an interval is crossed, or there is no region.
[[nodiscard]] Problem with_goal_set(const Problem& problem, const std::vector<GoalRegion>& set);

/// The problem as planners see it when the vehicle keeps its distance and steers like this.
[[nodiscard]] Task task_of(const Problem& problem, const ClearanceOptions& options,
                           Steering steering = Steering::reeds_shepp);

/// A pose of the scenario's frame in the world's frame, heading in [-pi, pi); and back. A scenario
/// moved by whole metres has the same poses in its world, bit for bit, as long as its coordinates
/// have at most 15 digits.
[[nodiscard]] LocalPose to_local(const World& world, const Pose& pose) noexcept;
[[nodiscard]] Pose to_scenario(const World& world, const LocalPose& pose) noexcept;
LocalPose to_local(const World& world, const LocalPose& pose) = delete;  ///< it is local already

/// Where samples are drawn; driving is allowed in the bounds either way.
enum class Region {
  bounds,  ///< the bounds of the scenario
  scene,   ///< bounding box of start, goal, obstacles and map plus 20 m, cut to the bounds
};

/// The region of a task, in the world's frame.
[[nodiscard]] Local<Bounds> sampling_region(const Task& task, Region region) noexcept;

}  // namespace vandplan

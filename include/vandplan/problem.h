// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a well-posed planning problem?
//
//  Scenario (unchecked) --make_problem--> Problem in a World (checked) --task--> what planners see
//
// Callers use one frame, the scenario's. Planners work in the frame of the world, whose origin lies
// near the start. The reason: a double resolves only a micrometre at 5*10^9 m.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

#include "vandplan/collision.h"
#include "vandplan/motion.h"
#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/vehicle.h"

namespace vandplan {

namespace base {
class Derived;
}
namespace replanning {
class KnownGround;
}

/// Curvatures to which the wheels are turned at the ends of a path. Only `Steering::continuous`
/// holds paths to them, and `Task::beyond`: otherwise the wheels may turn at standstill. Drives
/// begin with `start`.
struct EndCurvatures {
  double start = 0.0;  ///< curvature at the start [1/m]
  double goal = 0.0;   ///< curvature at the goal [1/m]
  bool operator==(const EndCurvatures&) const = default;
};

/// Gears in which a longer drive goes on beyond the ends of the part of it that a task asks for: 1
/// forward, -1 reverse. 0: nothing is driven there.
struct EndGears {
  int start = 0;                 ///< gear before the start
  int goal = 0;                  ///< gear after the goal
  bool stands_at_start = false;  ///< whether the vehicle stands at the start in that gear
  bool stands_at_goal = false;   ///< whether the vehicle stands at the goal in that gear
  bool operator==(const EndGears&) const = default;
};

/// Hitch angles at the ends of a path: heading of the vehicle less that of its trailer. 0 without
/// one.
struct EndHitchAngles {
  double start = 0.0;  ///< hitch angle at the start [rad]
  double goal = 0.0;   ///< hitch angle at the goal [rad]
  bool operator==(const EndHitchAngles&) const = default;
};

/// A planning problem as somebody states it, unchecked. All numbers share one frame, the
/// scenario's.
struct Scenario {
  std::string name = {};
  std::string description = {};
  Vehicle vehicle = {};
  Bounds bounds = {};  ///< where the midpoint of the rear axle may be [m]
  Pose start = {};
  Pose goal = {};
  EndCurvatures curvatures = {};
  EndHitchAngles hitch_angles = {};
  /// Regions where the path may end. Empty: it ends at `goal`. Otherwise `goal`, `curvatures.goal`
  /// and `hitch_angles.goal` are ignored.
  std::vector<GoalRegion> goal_set = {};
  std::vector<Via> via = {};            ///< what the path passes before the goal, in this order
  std::vector<Polygon> obstacles = {};  ///< outlines that the footprint may not touch [m]
  std::vector<Polygon> kerbs = {};      ///< outlines for the wheels alone [m]
  /// The whole body stays in one of these areas; empty: anywhere.
  std::vector<Polygon> inside = {};
  std::vector<Zone> zones = {};             ///< ground with rules of its own
  std::string map_file = {};                ///< file of the map; empty without a map
  std::optional<OccupancyGrid> map = {};    ///< the occupancy map; none: there is no map
  std::vector<Mask> masks = {};             ///< further maps
  std::vector<MovingObstacle> moving = {};  ///< moving obstacles
};

/// Ground and obstacles, without a vehicle. A world is checked, immutable, and shared between
/// threads, vehicles and problems. What depends on a vehicle is made once, at the first problem of
/// the vehicle.
class World {
 public:
  /// Makes a world of surroundings in the scenario's frame. `near` is a place around which one
  /// plans, such as a start: the world's origin is `near`, rounded to whole metres.
  ///
  /// Throws InputError naming the key ("bounds.x", "obstacles[2]", "inside[1]", "map.resolution")
  /// when a number is not finite or out of range, bounds are crossed, or areas of `inside` touch
  /// each other. Keys of zones and masks are "zones[0].area" and "masks[0].map". It also throws for
  /// a zone without a rule, a polygon with fewer than three corners or no area, or one that crosses
  /// or touches itself. Repeated corners are dropped. A polygon of one repeated corner stands for
  /// that point. Bounds are cut at 1000 km from the origin along each axis.
  World(const Surroundings& surroundings, const Point& near);
  /// Makes a world like `ground` with more obstacles, given in the frame of `ground`. The origin of
  /// the new world is 0. It shares what was made of the map. Throws InputError naming "more[2]".
  World(const World& ground, const std::vector<Polygon>& more);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Origin of the world's frame in the scenario's frame [m]: whole metres. The axes are parallel.
  [[nodiscard]] const Point& origin() const noexcept { return origin_; }

  /// The cleaned surroundings in the world's frame, as planners and judge use them. The first
  /// `fences()` obstacles are the fences around the areas of `inside` and the blocks of masks.
  [[nodiscard]] const Surroundings& local() const noexcept { return local_; }

  /// Number of fences and blocks. A fence is outside of one side of an area of `inside`, a
  /// micrometre thick. Blocks are rectangles that cover the occupied cells of a mask.
  [[nodiscard]] std::size_t fences() const noexcept;
  /// Surroundings without fences and blocks, in the world's frame: a world of the same kind is made
  /// of them.
  [[nodiscard]] Surroundings without_fences() const;

  /// The checker of a vehicle that keeps a margin, in the world's frame. The world keeps it, unless
  /// the margin has ramps. Throws InputError naming "margin", "vehicle.width" or another key that
  /// is wrong.
  [[nodiscard]] std::shared_ptr<const CollisionChecker> checker(const Vehicle& vehicle,
                                                                const Margin& margin = {}) const;
  /// `checker` that knows neither zones nor prices and speeds of masks: for bodies that are only a
  /// part of a vehicle.
  [[nodiscard]] std::shared_ptr<const CollisionChecker> checker_of_obstacles(
      const Vehicle& vehicle, const Margin& margin = {}) const;

  /// A value of that type that a part of the library keeps with the world. The first call makes it
  /// with `make`, later calls return that value. May be called from any thread.
  [[nodiscard]] std::shared_ptr<const void> kept(
      std::type_index type, const std::function<std::shared_ptr<const void>()>& make) const;

 private:
  Point origin_;
  Surroundings local_;
  friend class replanning::KnownGround;  // changes a world that nobody else has
  // Other obstacles, in the world's frame and cleaned, and other cells of the map in some ranges.
  // The values of `kept` are dropped.
  void change(std::vector<Polygon> obstacles, std::span<const CellRange> cells);
  [[nodiscard]] std::shared_ptr<const CollisionChecker> checker_among(
      const Vehicle& vehicle, const Margin& margin, std::span<const Zone> zones,
      std::span<const Mask> masks) const;

  std::shared_ptr<collision::Ground> ground_;
  std::unique_ptr<base::Derived> derived_;
};

/// A problem as planners see it, in the frame of the world: poses near the origin, headings in
/// [-pi, pi). Everything in a task has this frame.
struct Task {
  std::shared_ptr<const World> world;
  std::shared_ptr<const CollisionChecker> checker;  ///< checker of the vehicle with its margin
  Vehicle vehicle;
  double least_margin = 0.0;  ///< margin that the vehicle keeps everywhere, on ramps too [m]
  LocalPose start;
  LocalPose goal;  ///< the goal; with a set of goals a pose of its first region
  Steering steering = Steering::reeds_shepp;
  EndCurvatures curvatures = {};
  EndHitchAngles hitch_angles = {};
  /// Gears beyond the ends, if the task asks for a part of a longer drive. Where a gear goes on, a
  /// gear change has its price. There the wheels are held to `curvatures`, unless they turn at once
  /// or the vehicle stands.
  EndGears beyond = {};
  /// Straight line with which the path ends [m]; negative: driven in reverse. Only the function of
  /// a planner with `Capability::moving` sees another number than 0.
  double last_stretch = 0.0;
  std::vector<GoalRegion> goal_set = {};    ///< regions where the path may end; empty: at `goal`
  std::vector<Via> via = {};                ///< what the path passes before the goal, in this order
  std::vector<MovingObstacle> moving = {};  ///< moving obstacles, which `checker` does not know
};

/// Start of a task: its pose and hitch angle.
[[nodiscard]] inline LocalState start_state(const Task& task) noexcept {
  return Local(State{task.start, task.hitch_angles.start});
}
/// Goal of a task: its pose and hitch angle.
[[nodiscard]] inline LocalState goal_state(const Task& task) noexcept {
  return Local(State{task.goal, task.hitch_angles.goal});
}

/// One vehicle, start and goal in a world. A problem is checked, immutable and cheap to copy.
class Problem {
 public:
  [[nodiscard]] const std::shared_ptr<const World>& world() const noexcept { return task_.world; }
  [[nodiscard]] const Vehicle& vehicle() const noexcept { return task_.vehicle; }
  /// Start and goal in the scenario's frame, as they were given.
  [[nodiscard]] const Pose& start() const noexcept { return start_; }
  [[nodiscard]] const Pose& goal() const noexcept { return goal_; }

  /// The set of goals in the scenario's frame, as it was given. Empty: `goal` is the only goal.
  /// Otherwise `goal` is some pose of the set's first region.
  [[nodiscard]] const std::vector<GoalRegion>& goal_set() const noexcept { return goal_set_; }

  /// What the path passes before the goal, in the scenario's frame, as it was given.
  [[nodiscard]] const std::vector<Via>& via() const noexcept { return via_; }

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
  friend Problem with_via(const Problem& problem, const std::vector<Via>& via);

  Pose start_;
  Pose goal_;
  std::vector<GoalRegion> goal_set_;
  std::vector<Via> via_;
  Task task_;
};

/// Checks a scenario without building its world. Throws InputError naming the key that is wrong.
void check_scenario(const Scenario& scenario);
/// Checks a vehicle alone. Throws InputError naming "vehicle.width" or another key.
void check_vehicle(const Vehicle& vehicle);
/// Checks two poses alone. Throws InputError naming "start.x", "goal" or another key that is wrong.
/// A goal is at most 100 km from its start.
void check_poses(const Pose& start, const Pose& goal);
/// Checks a map alone. Throws InputError naming "map.resolution", "map.origin" or "map".
void check_map(const OccupancyGrid& map);

/// What stands in a scenario, in its frame: all of it but what moves.
[[nodiscard]] Surroundings surroundings(const Scenario& scenario);

/// The problem of a scenario, in a world of its own. Throws InputError naming the key that is
/// wrong. A start or goal in collision or outside the bounds is no error: `plan` reports it as a
/// status.
[[nodiscard]] Problem make_problem(const Scenario& scenario);

/// A problem in a world that exists, with poses in the scenario's frame. Nothing of the world is
/// built again, so thousands of problems may share it, on any number of threads. Throws InputError
/// naming:
///
/// - "world" if it is null, "start.x" or "goal" if a number is out of range,
/// - "start.curvature" or "goal.curvature" if it exceeds 1/min_turning_radius, as 0 does if that is
///   negative,
/// - "start.hitch_angles" or "goal.hitch_angles" if the trailer may not stand so, or is missing and
///   the angle is not 0,
/// - "vehicle.width" or another key of the vehicle, which is checked last.
[[nodiscard]] Problem make_problem(std::shared_ptr<const World> world, const Vehicle& vehicle,
                                   const Pose& start, const Pose& goal,
                                   const EndCurvatures& curvatures = {},
                                   const EndHitchAngles& hitch_angles = {});

/// The problem with these moving obstacles in place of its own, in the scenario's frame. Throws
/// InputError naming "moving[2].outline" or another key.
[[nodiscard]] Problem with_moving(Problem problem, std::span<const MovingObstacle> moving);

/// The problem with another start and goal in the scenario's frame, and straight wheels and trailer
/// at both. It keeps the moving obstacles, but has neither a set of goals nor vias. Throws
/// InputError naming "start.x", "goal" or another key.
[[nodiscard]] Problem with_poses(const Problem& problem, const Pose& start, const Pose& goal);

/// The problem with this set of goals in place of its goal, in the scenario's frame. Throws
/// InputError naming "goal.x", "goal.area", "goal.any_of[2].heading" or another key when a number
/// is out of range or an interval is crossed, or "goal.any_of" without a region.
[[nodiscard]] Problem with_goal_set(const Problem& problem, const std::vector<GoalRegion>& set);

/// The problem with these vias in place of its own, in the scenario's frame. Throws InputError
/// naming "via[1].x", "via[0].any_of[2].heading" or another key that is wrong, as for a set of
/// goals.
[[nodiscard]] Problem with_via(const Problem& problem, const std::vector<Via>& via);

/// The problem as planners see it, with this margin and steering. Throws InputError naming "margin"
/// or "margin_ramp" when it is out of range.
[[nodiscard]] Task task_of(const Problem& problem, const ClearanceOptions& options,
                           Steering steering = Steering::reeds_shepp);

/// Limits of zones and masks on the speed along segments from a state, by the distance from there.
[[nodiscard]] std::vector<SpeedLimit> speed_limits(const Task& task, const LocalState& from,
                                                   std::span<const Segment> segments);

/// What `speed_profile` needs to know of a path of a problem, in the scenario's frame.
[[nodiscard]] SpeedOptions speed_options(const Problem& problem, const Path& path);
/// `speed_options` for the problem of a scenario, which is not made if there are no zones
/// and masks.
[[nodiscard]] SpeedOptions speed_options(const Scenario& scenario, const Path& path);

/// A pose of the scenario's frame in the world's frame; heading in [-pi, pi). A scenario moved by
/// whole metres has equal poses in its world, bit for bit, if its coordinates have at most 15
/// digits.
[[nodiscard]] LocalPose to_local(const World& world, const Pose& pose) noexcept;
/// A pose of the world's frame in the scenario's frame. The heading stays.
[[nodiscard]] Pose to_scenario(const World& world, const LocalPose& pose) noexcept;
/// A state of the scenario's frame in the world's frame. The hitch angle stays.
[[nodiscard]] inline LocalState to_local(const World& world, const State& state) noexcept {
  return Local(State{to_local(world, state.pose), state.hitch_angle});
}
/// What is local stays where it is.
template <class T>
void to_local(const World& world, const Local<T>& local) = delete;

/// Region where planners draw samples. Driving is allowed everywhere in the bounds.
enum class Region {
  bounds,  ///< the bounds of the scenario
  scene,   ///< box around start, `Task::goal`, obstacles, kerbs, map plus 20 m, cut to the bounds
};

/// The region of a task, in the world's frame [m].
[[nodiscard]] Local<Bounds> sampling_region(const Task& task, Region region) noexcept;

// ---- What does a planner answer? ----
//
// The answer of a planner holds segments, not poses, so it means the same in every frame. `plan`
// (planner.h) makes it a result that the judge has checked.

/// How a run ended. There is a path if and only if the status is `solved`.
enum class PlanStatus {
  solved,              ///< a path was found, and the judge accepts it
  start_in_collision,  ///< the start collides, is too near to something, or lies outside the bounds
  goal_in_collision,   ///< the goal collides, is too near to something, or lies outside the bounds
  iteration_limit,     ///< no path within the iterations
  node_limit,          ///< no path, and the search has no nodes or no work left; proves nothing
  time_limit,          ///< no path within the time
  stopped,             ///< the caller stopped the run before it had a path
  no_path,             ///< proven: no path exists
  rejected,  ///< the judge rejects the path of the planner, or its answer contradicts itself
};

/// Name of the status: "solved", "start_in_collision", ...
[[nodiscard]] std::string_view name_of(PlanStatus status) noexcept;

/// All statuses, in the order of the enumeration.
[[nodiscard]] const std::vector<PlanStatus>& plan_statuses();

/// A moment at which the best path of a run became cheaper.
struct CostSample {
  double time = 0.0;           ///< time since the run began [s]
  std::int64_t iteration = 0;  ///< iteration of the run
  /// Cost of the path [m], or [s] where the cost is the time. It falls from sample to sample,
  /// except among moving obstacles: a path that costs more may have a shorter drive.
  double cost = 0.0;
  bool operator==(const CostSample&) const = default;
};

/// A count of a planner, by name: "nodes", "exact_solves", "edge_checks".
struct Counter {
  std::string name;
  std::int64_t value = 0;
  bool operator==(const Counter&) const = default;
};

/// Time spent in one phase of a run, by name: "ranking", "steering", "checking".
struct PhaseTime {
  std::string name;
  double seconds = 0.0;  ///< time in the phase [s]
  bool operator==(const PhaseTime&) const = default;
};

/// A search tree. Parents come before their children. A search that grows several trees has several
/// roots.
struct TreeSnapshot {
  std::vector<Pose> poses;            ///< pose of each node; whoever holds the tree names the frame
  std::vector<std::int32_t> parents;  ///< index of each node's parent; -1 for a root
};

/// What the function of a planner returns. `plan` computes cost and time of the path.
struct PlannerAnswer {
  PlanStatus status = PlanStatus::stopped;
  /// Segments from the task's start to its goal. They are there if and only if the status is
  /// `solved`.
  std::optional<std::vector<Segment>> segments = {};
  /// Speeds along the path. They are needed with a path if the task has moving obstacles.
  std::optional<SpeedProfile> speeds = {};
  /// Proven lower bound of the cost of every path [m] or [s]. None: nothing is proven. A bound that
  /// is not above 0 says nothing, since no cost is negative: `plan` drops it.
  std::optional<double> lower_bound = {};
  std::int64_t iterations = 0;           ///< iterations that the run has spent
  std::vector<CostSample> anytime = {};  ///< moments at which the best path became cheaper
  std::vector<Counter> counters = {};    ///< counts of the planner, by names of its own
  /// Times of phases, if the planner was asked to measure them.
  std::vector<PhaseTime> phases = {};
  std::optional<TreeSnapshot> tree = {};  ///< search tree in the task's frame, if it was asked for
  std::string reason = {};                ///< why there is no path, one line; or empty
};

}  // namespace vandplan

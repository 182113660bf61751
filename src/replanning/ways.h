// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which drives could replace the rest of the current drive?
//
// All drives begin now, in the frame of the known ground.

#include <limits>
#include <optional>
#include <vector>

#include "replanning/deadline.h"
#include "replanning/timed_path.h"
#include "vandplan/planner.h"
#include "vandplan/replanner.h"

namespace vandplan::replanning {

/// World, vehicle, goal and moving obstacles for which drives are searched.
struct Scene {
  std::shared_ptr<const World> world;
  Vehicle vehicle;  ///< vehicle with its own limits
  Vehicle planned;  ///< vehicle with the limits of planned speeds, which leave a reserve
  Pose goal;
  double goal_curvature = 0.0;
  double goal_hitch_angle = 0.0;
  /// Goals that replace `goal`; empty if `goal` is the only one.
  std::vector<GoalRegion> goal_set = {};
  std::vector<Via> via = {};                ///< what lies ahead before the goal, in this order
  std::vector<MovingObstacle> moving = {};  ///< moving obstacles; time 0 is now
};

/// Largest work of a look: iterations of planners, and states of searches for speeds.
struct WorkLimit {
  std::int64_t iterations = 0;
  std::int64_t states = 0;
  std::uint64_t seed = 1;
  bool whole_drive = false;  ///< planners search cheap drives, not paths: slower per iteration
};

/// Work that was done: iterations of planners, and states of searches for speeds.
struct Work {
  std::int64_t iterations = 0;
  std::int64_t states = 0;
};

/// Kind of search for another drive to the goal.
enum class Look : std::uint8_t {
  new_times,     ///< new speeds along the same path
  from_stop,     ///< another path, from the first place where the vehicle can stop
  without_stop,  ///< another path, from the current motion, without a stop
  around,        ///< a path around moving obstacles
};

/// Candidate that may replace the rest of the current drive.
struct NewDrive {
  TimedPath drive;
  TickOutcome outcome = TickOutcome::none;
  bool reaches_goal = false;
  double cost = 0.0;  ///< cost of the drive [m]; with `cost=time` its duration [s]
};

/// Requirements of a new drive to the goal.
struct Wish {
  double committed = 0.0;          ///< time that the new drive shares with the current one [s]
  bool rest_reaches_goal = false;  ///< whether the current drive reaches the goal
  /// Upper bound of the cost; dearer drives are dropped.
  double most = std::numeric_limits<double>::infinity();
};

class Ways {
 public:
  /// All are kept by reference.
  Ways(const Scene& scene, const PlanOptions& options, const Deadline& deadline)
      : scene_(scene), options_(options), deadline_(deadline) {}

  static constexpr int stops = 6;  ///< number of places along a path where a stop is tried

  /// Drive from standstill to the goal; none if none is found.
  [[nodiscard]] std::optional<NewDrive> from_standing(const RigMotion& from,
                                                      const WorkLimit& limit);

  /// Drive to the goal that equals `rest` for the committed seconds; none if the look finds none.
  [[nodiscard]] std::optional<NewDrive> to_goal(Look look, const CutDrive& rest, const Wish& wish,
                                                const WorkLimit& limit);

  /// Drive along `rest` to the i-th place of `stops` where it may stop, the nearest first.
  [[nodiscard]] std::optional<NewDrive> to_stop(int i, const CutDrive& rest, double margin,
                                                const WorkLimit& limit);

  /// Drive that brakes at once, as hard as the vehicle can.
  [[nodiscard]] NewDrive braking(const CutDrive& rest) const;

  /// Cost of a drive: price of its path plus price of its duration [m], or with `cost=time` its
  /// duration [s].
  [[nodiscard]] double cost_of(const TimedPath& drive) const;

  /// Sum of the work of all calls.
  [[nodiscard]] const Work& work() const noexcept { return work_; }

 private:
  [[nodiscard]] std::vector<SpeedLimit> limits_along(const Path& path, const RigMotion& begin,
                                                     const std::vector<Via>& via) const;
  [[nodiscard]] std::optional<TimedPath> timed(const Path& path, const RigMotion& begin,
                                               const std::vector<Via>& via, double t, double margin,
                                               const WorkLimit& limit, double longest);
  [[nodiscard]] std::optional<std::vector<Segment>> segments_to_goal(const RigMotion& from,
                                                                     const std::vector<Via>& via,
                                                                     double t,
                                                                     const PlanOptions& options,
                                                                     bool whole_drive);
  [[nodiscard]] std::optional<Path> path_of(Look look, const CutDrive& from,
                                            const std::vector<Via>& via, double t,
                                            const WorkLimit& limit);
  [[nodiscard]] double braking_distance(double v) const;

  const Scene& scene_;
  const PlanOptions& options_;
  const Deadline& deadline_;  // end of all searches
  Work work_;
};

/// Those of some vias that still lie ahead after a drive from `begin`.
[[nodiscard]] std::vector<Via> via_behind(const Scene& scene, const std::vector<Via>& via,
                                          const RigMotion& begin, const TimedPath& drive);

/// Problem from a place of a drive past the vias to the goals of a scene, without moving obstacles.
[[nodiscard]] Problem problem_from(const Scene& scene, const Vehicle& vehicle,
                                   const RigMotion& from);

/// Problem from a place of a drive to one pose, with that curvature and hitch angle there. Numbers
/// beyond what the vehicle can do are clamped: a measured state may be beyond it.
[[nodiscard]] Problem problem_to(const Scene& scene, const Vehicle& vehicle, const RigMotion& from,
                                 const RigMotion& to);

/// Moving obstacles with the clock set forward by `t` seconds: time `t` becomes 0.
[[nodiscard]] std::vector<MovingObstacle> later(std::vector<MovingObstacle> moving, double t);

}  // namespace vandplan::replanning

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which drives could follow on the one that is under way?
//
// All drives begin now, in the frame of the known ground.

#include <limits>
#include <optional>
#include <vector>

#include "replanning/timed_path.h"
#include "vandplan/planner.h"
#include "vandplan/replanner.h"

namespace vandplan::replanning {

/// What ways are looked for in.
struct Scene {
  std::shared_ptr<const World> world;
  Vehicle vehicle;  ///< as it is
  Vehicle planned;  ///< with the limits that planned speeds keep
  Pose goal;
  double goal_curvature = 0.0;
  std::vector<GoalRegion> goal_set = {};    ///< instead of `goal`; empty if that is the only one
  std::vector<MovingObstacle> moving = {};  ///< times count from now
};

/// How much work a look may be: of planners, and of searches for times.
struct Effort {
  std::int64_t iterations = 0;
  std::int64_t states = 0;
  std::uint64_t seed = 1;
  bool whole_drive = false;  ///< planners look for cheap drives, not paths: a trial costs more
};

/// How much was done.
struct Work {
  std::int64_t iterations = 0;
  std::int64_t states = 0;
};

/// Where other drives to the goal are looked for.
enum class Look : std::uint8_t {
  new_times,     ///< along the same path
  from_stop,     ///< on another path, from where the vehicle can stand first
  without_stop,  ///< on another path, wheels as they are
  around,        ///< on a path around those who are in the way
};

/// A drive that may be taken.
struct Way {
  TimedPath drive;
  TickOutcome outcome = TickOutcome::none;
  bool reaches_goal = false;
  double cost = 0.0;  ///< [m], or [s] where the cost is the time
};

/// Which ways to the goal are wanted.
struct Wish {
  double committed = 0.0;                                 ///< so long they are the same [s]
  bool rest_reaches_goal = false;                         ///< what is under way does
  double most = std::numeric_limits<double>::infinity();  ///< only what costs less
};

class Ways {
 public:
  Ways(const Scene& scene, const PlanOptions& options) : scene_(scene), options_(options) {}

  static constexpr int stops = 6;  ///< that are looked at along a way

  /// From standing at a pose to the goal.
  [[nodiscard]] std::optional<Way> from_standing(const Pose& pose, double curvature,
                                                 const Effort& effort);

  /// To the goal, the same as `rest` for the committed seconds, if a look finds one.
  [[nodiscard]] std::optional<Way> to_goal(Look look, const CutDrive& rest, const Wish& wish,
                                           const Effort& effort);

  /// To the i-th standstill on the way of `rest`, of `stops`, the nearest first.
  [[nodiscard]] std::optional<Way> to_stop(int i, const CutDrive& rest, double margin,
                                           const Effort& effort);

  /// Braking at once, as hard as it may be.
  [[nodiscard]] Way braking(const CutDrive& rest) const;

  /// What a drive costs that begins in a gear: length at its price, and time.
  [[nodiscard]] double cost_of(const TimedPath& drive) const;

  /// All that was done to find ways.
  [[nodiscard]] const Work& work() const noexcept { return work_; }

 private:
  [[nodiscard]] std::optional<TimedPath> timed(const Path& path, const Motion& begin, double t,
                                               double margin, const Effort& effort, double longest);
  [[nodiscard]] std::optional<std::vector<Segment>> segments_to_goal(const Pose& pose,
                                                                     double curvature, double t,
                                                                     const PlanOptions& options,
                                                                     bool whole_drive);
  [[nodiscard]] std::optional<Path> path_of(Look look, const CutDrive& from, double t,
                                            const Effort& effort);
  [[nodiscard]] double braking_distance(double v) const;

  const Scene& scene_;
  const PlanOptions& options_;
  Work work_;
};

/// The problem from a pose to the goal of a scene, or to its set of goals, where nothing moves.
[[nodiscard]] Problem problem_from(const Scene& scene, const Vehicle& vehicle, const Pose& pose,
                                   double curvature);

/// What moves, seen so many seconds later.
[[nodiscard]] std::vector<MovingObstacle> later(std::vector<MovingObstacle> moving, double t);

}  // namespace vandplan::replanning

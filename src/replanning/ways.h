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
  std::vector<MovingObstacle> moving = {};  ///< times count from now
};

/// How much work a look may be.
struct Effort {
  std::int64_t iterations = 0;
  std::int64_t states = 0;
  std::uint64_t seed = 1;
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
  double committed = 0.0;          ///< so long they are the same [s]
  bool rest_reaches_goal = false;  ///< what is under way does
  bool with_times = true;          ///< along the same path, too
  bool is_flying = true;           ///< on other paths without a stop, too
  bool is_urgent = false;          ///< whatever it takes: others are gone round
  double most = std::numeric_limits<double>::infinity();  ///< only what costs less
};

class Ways {
 public:
  Ways(const Scene& scene, const PlanOptions& options) : scene_(scene), options_(options) {}

  /// From standing at a pose to the goal.
  [[nodiscard]] std::optional<Way> from_standing(const Pose& pose, double curvature,
                                                 const Effort& effort) const;

  /// To the goal, each the same as `rest` for `committed` seconds: with other times, and along
  /// other paths.
  [[nodiscard]] std::vector<Way> to_goal(const CutDrive& rest, const Wish& wish,
                                         const Effort& effort) const;

  /// To standstills on the way of `rest`, the nearest first.
  [[nodiscard]] std::vector<Way> to_stops(const CutDrive& rest, double margin,
                                          const Effort& effort) const;

  /// Braking at once, as hard as it may be.
  [[nodiscard]] Way braking(const CutDrive& rest) const;

  /// What a drive costs that begins in a gear: length at its price, and time.
  [[nodiscard]] double cost_of(const TimedPath& drive) const;

 private:
  [[nodiscard]] std::optional<TimedPath> timed(const Path& path, const Motion& begin, double t,
                                               double margin, const Effort& effort,
                                               double longest) const;
  [[nodiscard]] std::vector<Segment> segments_to_goal(const Pose& pose, double curvature, double t,
                                                      const PlanOptions& options) const;
  [[nodiscard]] double braking_distance(double v) const;

  const Scene& scene_;
  const PlanOptions& options_;
};

/// What moves, seen so many seconds later.
[[nodiscard]] std::vector<MovingObstacle> later(std::vector<MovingObstacle> moving, double t);

}  // namespace vandplan::replanning

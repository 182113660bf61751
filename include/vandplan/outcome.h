// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a planner answer?
//
// The answer of a planner holds segments, not poses, so it means the same in every frame. `plan`
// (planner.h) makes it a result that the judge has checked.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/speed.h"

namespace vandplan {

/// How a run ended. There is a path if and only if the status is `solved`.
enum class PlanStatus {
  solved,              ///< a path was found, and the judge accepts it
  start_in_collision,  ///< the start collides, is too near to something, or lies outside the bounds
  goal_in_collision,   ///< the goal collides, is too near to something, or lies outside the bounds
  iteration_limit,     ///< no path within the iterations
  node_limit,          ///< the search ran out of nodes before it had a path
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

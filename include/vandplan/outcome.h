// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a planner answer?
//
// An answer holds segments, not poses: it means the same in every frame. `plan` (planner.h) makes a
// result of it that the judge has seen.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/speed.h"

namespace vandplan {

/// How a run ended. A path is there if and only if it is `solved`.
enum class PlanStatus {
  solved,
  start_in_collision,  ///< or outside the bounds
  goal_in_collision,   ///< or outside the bounds
  iteration_limit,
  node_limit,
  time_limit,
  stopped,   ///< by the caller
  no_path,   ///< proven: there is none
  rejected,  ///< the planner's path failed the judge
};

/// "solved", "start_in_collision", ...
[[nodiscard]] std::string_view name_of(PlanStatus status) noexcept;

/// All of them, in order.
[[nodiscard]] const std::vector<PlanStatus>& plan_statuses();

/// When the best path got better.
struct CostSample {
  double time = 0.0;  ///< since the run began [s]
  std::int64_t iteration = 0;
  /// Cost of that path [m], or [s] where the cost is the time. It falls from sample to sample, but
  /// among moving obstacles: a path that costs more may have a shorter drive.
  double cost = 0.0;
  bool operator==(const CostSample&) const = default;
};

/// Something that a planner counts, by name: "nodes", "exact_solves", "edge_checks".
struct Counter {
  std::string name;
  std::int64_t value = 0;
  bool operator==(const Counter&) const = default;
};

/// Time spent in one phase of a run, by name: "ranking", "steering", "checking".
struct PhaseTime {
  std::string name;
  double seconds = 0.0;
  bool operator==(const PhaseTime&) const = default;
};

/// A search tree: poses, and each node's parent, -1 for a root. Parents come before children. A
/// search that grows several trees has several roots.
struct TreeSnapshot {
  std::vector<Pose> poses;
  std::vector<std::int32_t> parents;
};

/// What a planner returns. Cost and time of the path are worked out by `plan`.
struct PlannerAnswer {
  PlanStatus status = PlanStatus::stopped;
  /// From the task's start to its goal; there if and only if the status is `solved`.
  std::optional<std::vector<Segment>> segments = {};
  /// When the vehicle is where; there if the task has something that moves, and a path.
  std::optional<SpeedProfile> speeds = {};
  double lower_bound = 0.0;  ///< no path costs less [m]; proven; 0: nothing is
  std::int64_t iterations = 0;
  std::vector<CostSample> anytime = {};
  std::vector<Counter> counters = {};
  std::vector<PhaseTime> phases = {};     ///< when the planner was asked to measure them
  std::optional<TreeSnapshot> tree = {};  ///< in the task's frame, when it was asked for
  std::string reason = {};                ///< why there is no path, one line; or empty
};

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do I plan?
//
// Every planner is a function (Problem, PlanOptions) -> PlanResult in one table. `plan` runs one
// and lets the independent judge see its path before anybody else does.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan {

/// How a run ended. A path is there exactly when the status is `solved`.
enum class PlanStatus {
  solved,
  start_in_collision,  ///< or outside the bounds
  goal_in_collision,   ///< or outside the bounds
  iteration_limit,
  node_limit,
  time_limit,
  stopped,  ///< by the caller
};

/// The name as written in files, "start_in_collision".
[[nodiscard]] std::string_view name_of(PlanStatus status) noexcept;

/// The best path got better.
struct CostSample {
  double time = 0.0;  ///< since the run began [s]
  std::int64_t iteration = 0;
  double cost = 0.0;
};

/// A search tree as it stood at the end, for pictures. `parent[i]` < i; node 0 is the root.
struct TreeSnapshot {
  std::vector<Pose> poses;
  std::vector<std::int32_t> parents;
};

/// What a run did and what it found.
struct PlanResult {
  PlanStatus status = PlanStatus::stopped;
  std::optional<Path> path;  ///< in the frame of the problem's world
  double cost = 0.0;         ///< of the path [m]
  double lower_bound = 0.0;  ///< no path costs less [m]; proven
  std::int64_t iterations = 0;
  std::int64_t nodes = 0;
  double time_total = 0.0;  ///< [s]
  std::vector<CostSample> anytime;
  std::optional<TreeSnapshot> tree;  ///< when options.keep_tree
  std::int64_t exact_solves = 0;     ///< steering problems solved
  std::int64_t edge_checks = 0;      ///< edges tested for collision
  double time_ranking = 0.0;         ///< choosing parents, when options.profile [s]
  double time_steering = 0.0;        ///< exact steering, when options.profile [s]
  double time_checking = 0.0;        ///< collision checks, when options.profile [s]
};

using PlannerFunction = PlanResult (*)(const Problem&, const PlanOptions&);

/// A line of the table of planners.
struct PlannerInfo {
  std::string_view name;
  PlannerFunction function;
  std::string_view summary;
  bool weighs = false;  ///< minds reverse_weight and gear_change_cost; else its cost is the length
};

/// Every planner, in the order of documentation.
[[nodiscard]] std::span<const PlannerInfo> planners() noexcept;

/// The planner to use when nobody names one.
[[nodiscard]] const PlannerInfo& default_planner() noexcept;

/// Throws InputError when there is no planner of that name.
[[nodiscard]] const PlannerInfo& planner_named(std::string_view name);

/// Runs a planner and judges its path. Throws InputError for an option out of range, and
/// std::logic_error if the judge rejects the path (a bug of ours: nothing unsafe gets out).
[[nodiscard]] PlanResult plan(const Problem& problem, const PlannerInfo& planner,
                              const PlanOptions& options);

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it to the goal, about?
//
// Estimates guide searches. docs/algorithms/estimates.md says what each of them knows and leaves
// out. All poses are in the frame of the task.

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "vandplan/heuristic_table.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Estimated length from a pose to the goal of one task. It is made for one run: a call may fill a
/// cache, so threads do not share it.
struct GoalEstimate {
  std::string name = {};
  /// Whether the estimate is never above the length of the shortest path among the obstacles, but
  /// for rounding (1e-9, relative). A search that proves what it finds needs that.
  bool is_admissible = false;
  /// Estimated length from a pose to the goal [m]; infinite where the goal cannot be reached.
  std::function<double(const LocalPose&)> length = {};
};

/// Names of the estimates, the simplest first: "euclid", "hlut-1", ..., "choi".
[[nodiscard]] std::span<const std::string_view> goal_estimate_names() noexcept;

/// Name of the estimate that looks up a user's table (`PlanOptions::table`).
inline constexpr std::string_view user_table = "table";

/// The estimate of that name for a task, which must outlive it. Throws InputError naming "estimate"
/// for an unknown name (the message lists the names), and for `user_table`.
[[nodiscard]] GoalEstimate make_goal_estimate(std::string_view name, const Task& task);

/// The estimate of that name for a task, which must outlive it. `user_table` looks up `table`,
/// which may be null for other names. Throws InputError naming "estimate" if the name is unknown or
/// the table is missing.
[[nodiscard]] GoalEstimate make_goal_estimate(std::string_view name, const Task& task,
                                              const HeuristicTable* table);

/// The larger of two estimates at each pose; admissible if both are.
[[nodiscard]] GoalEstimate max_of(GoalEstimate a, GoalEstimate b);

}  // namespace vandplan::search

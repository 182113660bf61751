// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How did a call end, in the words of ROS?

#include <cstdint>
#include <string_view>

#include "vandplan/problem.h"

namespace vandplan::ros {

/// How a call of the planner ended. There is a path if and only if it is `solved`.
enum class Outcome : std::uint8_t {
  solved,
  start_outside_map,  ///< the start lies outside the costmap
  goal_outside_map,   ///< the goal, all goals or a via point lie outside the costmap
  start_occupied,     ///< the body would touch something at the start, or be nearer than its margin
  goal_occupied,      ///< at the goal, at all goals or at a via point
  no_path,            ///< there is no path, or the judge rejects the planner's one
  timed_out,          ///< no path within the time, the iterations or the nodes
  cancelled,          ///< the caller asked to stop
  invalid,            ///< a pose, a parameter, the footprint or the costmap is wrong
};

/// Name of the outcome: "solved", "start_outside_map", ...
[[nodiscard]] std::string_view name_of(Outcome outcome) noexcept;

/// The outcome of a run that ended so.
[[nodiscard]] Outcome outcome_of(PlanStatus status) noexcept;

}  // namespace vandplan::ros

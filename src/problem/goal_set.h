// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which sets of goals are valid, and which poses do they hold?

#include <string>
#include <vector>

#include "vandplan/problem.h"

namespace vandplan::problem {

/// Checks a set of goals in the scenario's frame. Throws InputError naming "goal.x",
/// "goal.any_of[2].heading" or another key when the set holds no region, a number is out of range,
/// an interval is crossed, or a region is more than 100 km from the start. `where`: key of the set.
void check_goal_set(const std::vector<GoalRegion>& set, const Vehicle& vehicle, const Pose& start,
                    const std::string& where = "goal");

/// Checks vias in the scenario's frame, as sets of goals. Throws InputError naming "via[1].x" or
/// another key.
void check_via(const std::vector<Via>& via, const Vehicle& vehicle, const Pose& start);

/// Checked vias moved into the frame of `origin`.
[[nodiscard]] std::vector<Via> local_via(const std::vector<Via>& via, const Point& origin);

/// A checked set moved into the frame of `origin`; corners of areas are counter-clockwise.
[[nodiscard]] std::vector<GoalRegion> local_goal_set(const std::vector<GoalRegion>& set,
                                                     const Point& origin);

/// State of the vehicle whose axle is at `axle`: the trailer's axle if the region is of the
/// trailer, otherwise the rear axle.
[[nodiscard]] State state_at(const Vehicle& vehicle, const GoalRegion& region, const Pose& axle,
                             double hitch_angle);

/// A state of the region: the middle of all intervals, or the first corner of the area.
[[nodiscard]] State some_goal(const Vehicle& vehicle, const GoalRegion& region);

/// A task without a set of goals, with another goal: a state and a curvature [1/m]. With a ramp in
/// `options`, its checker has ramps at the start and at the new goal.
[[nodiscard]] Task task_to(const Task& task, const LocalState& goal, double curvature,
                           const ClearanceOptions& options);

/// Moves the goal by 1 nm if start and goal are the same pose with different curvatures, and the
/// steering is `continuous`. Planners tell start and goal apart by their poses.
void tell_ends_apart(Task& task);

/// Replaces the task's checker, which has no margin, by one with margin and ramps of `options`.
void keep_margin(Task& task, const ClearanceOptions& options);

}  // namespace vandplan::problem

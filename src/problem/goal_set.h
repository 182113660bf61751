// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a good set of goals, and which poses does it hold?

#include <vector>

#include "vandplan/problem.h"

namespace vandplan::problem {

/// Throws InputError naming "goal.x", "goal.any_of[2].heading" or another key when the set holds no
/// region, a number is out of range, an interval is crossed, or a region is too far from the start.
void check_goal_set(const std::vector<GoalRegion>& set, const Vehicle& vehicle, const Pose& start);

/// A checked set in the frame of `origin`; the corners of its areas are counter-clockwise.
[[nodiscard]] std::vector<GoalRegion> local_goal_set(const std::vector<GoalRegion>& set,
                                                     const Point& origin);

/// Where the vehicle is if the axle that the region speaks of is there.
[[nodiscard]] RigState state_at(const Vehicle& vehicle, const GoalRegion& region, const Pose& axle,
                                double hitch_angle);

/// Some state of a region: about in its middle.
[[nodiscard]] RigState some_goal(const Vehicle& vehicle, const GoalRegion& region);

/// A task without a set of goals, to another goal. The margin gives way around that one.
[[nodiscard]] Task task_to(const Task& task, const Local<RigState>& goal, double curvature,
                           const ClearanceOptions& options);

/// Moves a goal a little that is where the start is, if the wheels have to be turned in between
/// while the vehicle drives: planners know ends by their place.
void tell_ends_apart(Task& task);

/// Lets the vehicle keep its distance: `checker` of the task is without a margin before.
void keep_margin(Task& task, const ClearanceOptions& options);

}  // namespace vandplan::problem

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where in a set of goals can the vehicle stand, if no pose that was tried is free?

#include <functional>
#include <vector>

#include "planners/goal_poses.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// What a search for free poses found.
struct FreePoints {
  std::vector<GoalPoint> points;  ///< poses that fit, evenly spread
  bool is_proof = false;          ///< whether no pose of the regions with intervals is free
};

/// Searches the regions with intervals of the task's set for poses that `fits` accepts. Halves
/// parts of the regions, and drops a part if the vehicle collides at all its poses, or zones forbid
/// to move at all of them. Ends with the size of parts at which 64 poses are found, or with a limit
/// of work. `only`: gear of all paths; 0: both.
[[nodiscard]] FreePoints free_points(const Task& task, search::GearSign only,
                                     const search::Budget& budget,
                                     const std::function<bool(const GoalPoint&)>& fits);

}  // namespace vandplan::planning

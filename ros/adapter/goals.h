// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// At which poses of the rear axle does a request allow its path to end?

#include <cstddef>
#include <vector>

#include "ros/adapter/planner.h"
#include "vandplan/path.h"

namespace vandplan::ros {

/// The pose of the rear axle of a robot whose base_link has that pose.
[[nodiscard]] Pose axle_pose(const Pose& base, double rear_axle) noexcept;

/// Regions of goals, and the goal of the request from which each comes.
struct Goals {
  std::vector<GoalRegion> regions = {};
  std::vector<std::size_t> origins = {};  ///< index of the goal, for each region
};

/// The goals of a request. Throws InputError naming "goal_heading_mode" for any heading with a rear
/// axle that is not at base_link.
[[nodiscard]] Goals goals_of(const Request& request);

/// The boxes around the goals of a request in which the path may end otherwise.
[[nodiscard]] Goals goals_beside(const Request& request);

}  // namespace vandplan::ros

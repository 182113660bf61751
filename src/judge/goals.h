// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// At which goal of a set does a path end, in the eyes of the judge?

#include <cstddef>
#include <optional>

#include "judge/track.h"
#include "judge/trailing.h"
#include "vandplan/problem.h"

namespace vandplan::judge {

/// A goal of a set, to which the end of a path is compared.
struct Goal {
  std::size_t index = 0;  ///< index of the goal's region in the set
  Pose pose = {};
  double curvature = 0.0;    ///< curvature at the goal [1/m]
  double hitch_angle = 0.0;  ///< hitch angle at the goal [rad]; 0 without a trailer
  /// Length by which the straight line at the end is shorter than the goal asks for [m].
  double lack_of_straight = 0.0;
};

/// Distance of a place from a closed polygon [m]; 0 inside.
[[nodiscard]] Real distance_from(const Polygon& area, Real x, Real y);

/// Distance of a place from the places of a region [m]; 0 inside.
[[nodiscard]] Real distance_from(const GoalRegion& region, Real x, Real y);

/// Smallest turn from a heading to a heading of a region [rad].
[[nodiscard]] Real turn_into(const GoalRegion& region, Real heading);

/// Turn from a hitch angle to the nearest one of a region [rad].
[[nodiscard]] Real fold_into(const GoalRegion& region, Real angle);

/// Nearest goal to the end of a track: in region number `only`, or in any region of a non-empty
/// set. The error of a goal is the sum of what exceeds the judge's tolerance: in distance [m], in
/// angles [rad], in length of the straight last stretch [m] and, if `wheels_count`, in curvature
/// [1/m]. The first region wins ties. `trailing`
/// is null without a trailer.
[[nodiscard]] Goal nearest_goal(const Task& task, const Track& track, const Trailing* trailing,
                                bool wheels_count, std::optional<std::size_t> only);

}  // namespace vandplan::judge

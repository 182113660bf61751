// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which goal of a set does a path end at, in the eyes of the judge?

#include <cstddef>
#include <optional>

#include "judge/track.h"
#include "judge/trailing.h"
#include "vandplan/problem.h"

namespace vandplan::judge {

/// A goal of a set: what the end of a path is held to.
struct Goal {
  std::size_t index = 0;  ///< of its region in the set
  Pose pose = {};
  double curvature = 0.0;    ///< [1/m]
  double hitch_angle = 0.0;  ///< [rad]; 0 without a trailer
};

/// How far a place is from a closed polygon [m]; 0 in it.
[[nodiscard]] Real distance_from(const Polygon& area, Real x, Real y);

/// The goal nearest to the end of a track: in region number `only`, or else in any region. The set
/// must have a region. A goal is off by the sum of what exceeds the judge's tolerance in distance
/// [m], in angles [rad] and, where wheels may not turn at standstill, in curvature [1/m]. Of goals
/// equally far off the first region's is returned. `trailing` is null without a trailer.
[[nodiscard]] Goal nearest_goal(const Task& task, const Track& track, const Trailing* trailing,
                                bool wheels_count, std::optional<std::size_t> only);

}  // namespace vandplan::judge

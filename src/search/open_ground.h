// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a path cost at least, whatever the obstacles?

#include "steering/words.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// Lower bounds for all paths on open ground. A path is driven forward only, or in reverse only, or
/// changes gear.
struct OpenGround {
  double forward = 0.0;   ///< lower bound of the length of paths driven forward only [m]
  double reverse = 0.0;   ///< lower bound of the length of paths driven in reverse only [m]
  double shortest = 0.0;  ///< lower bound of the length of all paths [m]
  /// Most that a path saves if its ends are off as far as is allowed [m].
  double leeway = 0.0;
};

/// Lower bound of the length of paths in the gears that a rule allows [m].
[[nodiscard]] double length_lower_bound(const OpenGround& ground, const CostRule& rule);

/// Lower bounds for all paths between two poses, whatever their curvatures there. Paths may begin
/// and end as far off them as is said. `radius`: turning radius [m].
[[nodiscard]] OpenGround open_ground(const Pose& first, const steering::Closing& off_first,
                                     const Pose& last, const steering::Closing& off_last,
                                     double radius);

/// Lower bounds of a task. With prices they hold for every path whose ends are off by at most
/// `ends`, which is the judge's tolerance by default. By length they hold for exact ends only, and
/// the leeway is 0.
[[nodiscard]] OpenGround open_ground(const Task& task, const CostRule& rule,
                                     const steering::Closing& ends = steering::judged);

/// Lower bound of the cost of all paths [m], if none is shorter than `around` metres because of
/// obstacles.
[[nodiscard]] double cost_lower_bound(const OpenGround& ground, const CostRule& rule,
                                      double around);

}  // namespace vandplan::search

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a path cost at least, whatever stands in the way?

#include "steering/words.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

/// What is proven of all paths on open ground. A path is driven forward only, or in reverse only,
/// or changes gear.
struct OpenGround {
  double forward = 0.0;   ///< length of a path that is driven forward only, at least [m]
  double reverse = 0.0;   ///< in reverse only [m]
  double shortest = 0.0;  ///< of any path [m]
  /// What a path may save by ending beside the poses, as the judge allows [m].
  double leeway = 0.0;
};

/// Length of the shortest path in the gears that a rule allows, at least [m].
[[nodiscard]] double least_length(const OpenGround& ground, const search::CostRule& rule);

/// Under prices all of it holds for every path that the judge accepts: start and goal may be off by
/// its tolerance, or by another one, which is then the leeway. Under a neutral rule it holds for
/// paths that begin and end just there, and nothing is left open.
[[nodiscard]] OpenGround open_ground(const Task& task, const search::CostRule& rule,
                                     const steering::Closing& ends = steering::judged);

/// What no path costs less than, if none is shorter than `around`, because of what stands in the
/// way [m].
[[nodiscard]] double least_cost(const OpenGround& ground, const search::CostRule& rule,
                                double around);

}  // namespace vandplan::anytime

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a path cost at least, whatever stands in the way?

#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

/// What is proven of all paths on open ground.
struct OpenGround {
  double bound = 0.0;  ///< no path costs less [m]
  double leeway =
      0.0;  ///< what a path may save by ending beside the poses, as the judge allows [m]
};

/// Under prices the bound holds for every path that the judge accepts: start and goal may be off by
/// its tolerance, which is then the leeway. Under a neutral rule it holds for paths that begin and
/// end just there, and nothing is left open.
[[nodiscard]] OpenGround open_ground(const Task& task, const search::CostRule& rule);

}  // namespace vandplan::anytime

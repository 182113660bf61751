// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// A random tree whose edges are improved as it grows: RRT*.
// Theory and pseudo-code: docs/algorithms/rrt_star.md.

#include "vandplan/planner.h"

namespace vandplan::rrt_star {

/// The planner "rrt-star".
[[nodiscard]] Planner planner();

}  // namespace vandplan::rrt_star

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Two random trees, one from the start and one from the goal, until they meet: RRT-Connect.
// Theory and pseudo-code: docs/algorithms/rrt_connect.md.

#include "vandplan/planner.h"

namespace vandplan::rrt_connect {

/// The planner "rrt-connect".
[[nodiscard]] Planner planner();

}  // namespace vandplan::rrt_connect

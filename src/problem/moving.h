// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Are the moving obstacles of a user valid, and which key is wrong if not?

#include <span>
#include <vector>

#include "vandplan/motion.h"

namespace vandplan::problem {

/// Moving obstacles with trajectories moved from the scenario's frame into the frame of `origin`,
/// and cleaned outlines. Throws InputError naming "moving[2].trajectory[5]" or another key.
[[nodiscard]] std::vector<MovingObstacle> local_moving(std::span<const MovingObstacle> moving,
                                                       const Point& origin);

}  // namespace vandplan::problem

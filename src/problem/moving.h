// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is what is said to move good, and which key is wrong if not?

#include <span>
#include <vector>

#include "vandplan/moving.h"

namespace vandplan::problem {

/// What moves, in the frame of `origin`; outlines are cleaned and simple. Throws InputError naming
/// "moving[2].trajectory[5]" or another key.
[[nodiscard]] std::vector<MovingObstacle> local_moving(std::span<const MovingObstacle> moving,
                                                       const Point& origin);

}  // namespace vandplan::problem

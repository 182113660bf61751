// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How short can a forward-only path be at least, if its end may be a little beside the pose?

#include "steering/words.h"
#include "vandplan/geometry.h"

namespace vandplan::steering {

/// No forward-only path of curvature at most 1/radius from `from` to any pose within `off` of `to`
/// is shorter [m]. Where an arc of the shortest path vanishes for one of these poses, so does the
/// jump of the Dubins length. `radius` > 0 [m]. docs/algorithms/steering.md, section 8.
[[nodiscard]] double dubins_bound(const Pose& from, const Pose& to, double radius,
                                  const Closing& off) noexcept;

}  // namespace vandplan::steering

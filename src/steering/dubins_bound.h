// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How short can a forward-only path be, if it may end a little beside the pose?

#include "steering/words.h"
#include "vandplan/geometry.h"

namespace vandplan::steering {

/// Lower bound of the lengths of forward-only paths of curvature at most 1/radius, from `from` to
/// any pose within `off` of `to` [m]. Where an arc vanishes for one of these poses, the Dubins
/// length jumps and the bound does not. `radius` > 0 [m]. Derivation: docs/proofs/steering.md.
[[nodiscard]] double dubins_bound(const Pose& from, const Pose& to, double radius,
                                  const Closing& off) noexcept;

}  // namespace vandplan::steering

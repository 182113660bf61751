// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which forward-only path is shortest on open ground?
//
// Dubins 1957: a shortest path of bounded curvature is an arc, a line or arc, and an arc.
// Derivation and formulas: docs/algorithms/steering.md.

#include <vector>

#include "vandplan/path.h"

namespace vandplan {

/// The shortest path from `from` to `to` driving forward with curvature -1/radius, 0 or 1/radius.
/// Ties go to the first word of `dubins_words`. Throws InputError naming "radius" unless it is
/// finite and > 0 [m].
[[nodiscard]] Piece dubins(const Pose& from, const Pose& to, double radius);

/// The length of the shortest forward-only path, `dubins(from, to, radius)` [m]. Throws InputError
/// naming "radius" unless it is finite and > 0 [m].
[[nodiscard]] double dubins_length(const Pose& from, const Pose& to, double radius);

/// The paths of all words that join the poses, in the order LSL, RSR, LSR, RSL, RLR, LRL. There are
/// at most 6 words. Throws InputError naming "radius" unless it is finite and > 0 [m].
[[nodiscard]] std::vector<Piece> dubins_words(const Pose& from, const Pose& to, double radius);

}  // namespace vandplan

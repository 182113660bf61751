// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What lies on the level on which the vehicle starts, and what on a bridge above or below?

#include "io/roads.h"

namespace vandplan::io {

/// Height that a vehicle needs above its ground [m].
inline constexpr double clear_height = 4.5;

/// Takes away, and counts as left out, the lanes and areas above and below those that the ground
/// connects with the start, whatever is connected with what goes, and the obstacles above and below
/// the ground that stays. Lanes that stay and cross at different heights are counted: they become
/// crossings. Where several levels hold the start, it is on the lowest that leads to the goal. If
/// none holds it, everything stays.
void keep_level(const Point& start, const Point& goal, Roads& roads);

}  // namespace vandplan::io

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What may the wheels do?

#include "vandplan/search.h"

namespace vandplan::search {

/// Whether the curvature may jump between what was driven before a place and what is driven in gear
/// `next` behind it. Where wheels need time to turn, the vehicle must stand there: it changes gear,
/// or nothing is known of the way before.
[[nodiscard]] bool may_jump(Steering steering, const Driven& before, GearSign next);

/// Whether a segment may be driven after `before`: the curvature goes on as it was, or may jump
/// there.
[[nodiscard]] bool may_follow(const Connector& connector, const Driven& before,
                              const Segment& segment);

/// Whether the vehicle can drive a segment: its gear is allowed, and the wheels turn as far and as
/// fast as the segment needs.
[[nodiscard]] bool can_drive(const Connector& connector, const Segment& segment);

/// Gear in which the vehicle rolls on beyond the start, or the goal; 0: it stands there.
[[nodiscard]] GearSign rolling_beyond(const Task& task, bool is_start);

/// Whether the wheels are held to the task's curvature at an end, beyond which the vehicle rolls in
/// gear `beyond`.
[[nodiscard]] bool holds_wheels(const Task& task, GearSign beyond);

/// Gears and curvatures before the start and after the goal, as far as the task says. `initial`:
/// gear before the start, for prices of gear changes; what the wheels may do does not depend on it.
[[nodiscard]] DrivenBeside driven_at_ends(const Task& task, GearSign initial = 0);

/// Gears and curvatures that a piece between `beside` must match. If the wheels turn at once, only
/// the gear before the piece counts.
[[nodiscard]] DrivenBeside fitted_driven(const Task& task, const DrivenBeside& beside);

}  // namespace vandplan::search

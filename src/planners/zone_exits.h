// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do zones let a vehicle neither leave a pose nor come to it?
//
// The curvature with which a vehicle leaves a pose decides nothing: the direction of travel is that
// of the pose.

#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// Whether zones let the vehicle drive on from a state in a gear that the rule allows; 0: in any.
[[nodiscard]] bool may_leave(const Task& task, const search::CostRule& rule,
                             const LocalState& state, search::GearSign gear = 0);

/// Whether zones let the vehicle come to a state in any gear that the rule allows.
[[nodiscard]] bool may_come(const Task& task, const search::CostRule& rule,
                            const LocalState& state);

}  // namespace vandplan::planning

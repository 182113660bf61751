// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does being near things add to the cost of a path, in the eyes of the judge?

#include <span>

#include "judge/body.h"
#include "vandplan/plan_options.h"

namespace vandplan::judge {

/// The integral of `clearance_weight` max(0, 1 - clearance / `clearance_distance`) along the track
/// of the bodies, of which the one counts that is nearest to something; metres in reverse weighted
/// as the rule has it [m].
[[nodiscard]] double near_cost(std::span<const Body> bodies, const CostOptions& stated);

}  // namespace vandplan::judge

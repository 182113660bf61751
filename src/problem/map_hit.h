// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which cell of the map does a standing vehicle hit?

#include <string>

#include "vandplan/problem.h"
#include "vandplan/rig.h"

namespace vandplan::problem {

/// "occupied at x = 3.25, y = 4.75": the blocked cell under the vehicle or its trailer whose middle
/// is nearest to the rear axle; "unknown at" and "beyond the edge of the map at" likewise. Place
/// and state are in the scenario's frame. Empty if the vehicle hits no cell.
[[nodiscard]] std::string map_hit(const Problem& problem, const RigState& state);

}  // namespace vandplan::problem

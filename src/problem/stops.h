// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where on its way does a vehicle stand because of vias?

#include <span>
#include <vector>

#include "vandplan/problem.h"

namespace vandplan::problem {

/// Driven distances in order at which a vehicle stands at vias of a task with a stop [m]. It stands
/// where it would stand anyway, else where a segment begins, if that place is in the via within
/// 1e-6 m and 1e-6 rad. Vias in which no segment begins or ends are left out. The judge knows where
/// paths pass them.
[[nodiscard]] std::vector<double> stops_at_vias(const Task& task, const LocalState& from,
                                                std::span<const Segment> segments);

}  // namespace vandplan::problem

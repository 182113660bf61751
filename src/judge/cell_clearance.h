// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the vehicle from the blocked cells of a map, in the eyes of the judge?

#include "judge/clearance.h"
#include "vandplan/occupancy_grid.h"

namespace vandplan::judge {

/// Between the closed body and the closed squares of the blocked cells [m]: 0 if they touch,
/// infinity if there are none.
[[nodiscard]] double clearance(const Position& position, const Rectangle& body,
                               const OccupancyGrid& grid);

}  // namespace vandplan::judge

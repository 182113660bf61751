// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do the rules of zones keep a disc in the body away?

#include <vector>

#include "search/open_rows.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// Areas that the centre of a disc in the body keeps away from on all paths: of closed zones, and
/// of those where the gear `only` is forbidden (0: paths in both gears). Zones in which the start
/// or the goal is are left out.
[[nodiscard]] std::vector<ClosedArea> closed_areas(const Task& task, const Disc& disc,
                                                   GearSign only);

}  // namespace vandplan::search

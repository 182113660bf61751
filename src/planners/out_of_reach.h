// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is it proven that no path leads to any pose of a set?

#include <vector>

#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// Whether it is proven that no path leads from the task's start to any place of the regions,
/// whatever the headings. `only`: gear of all paths; 0: both. The work is limited, too.
[[nodiscard]] bool is_out_of_reach(const Task& task, const std::vector<GoalRegion>& regions,
                                   search::GearSign only, const search::Budget& budget);

}  // namespace vandplan::planning

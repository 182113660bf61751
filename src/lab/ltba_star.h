// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a truck drive while its way is still searched for?
//
// docs/algorithms/ltba_star.md.

#include <vector>

#include "vandplan/planner.h"

namespace vandplan::lattice {

/// "cycle_expansions", "cycle_time", "weight", and those of all searches over a lattice.
[[nodiscard]] std::vector<OptionInfo> ltba_star_options();

/// One A* over many cycles; after each of them a part of the way is committed.
[[nodiscard]] PlannerAnswer plan_ltba_star(const Task& task, const PlanOptions& options);

}  // namespace vandplan::lattice

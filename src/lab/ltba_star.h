// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a truck drive while its way is still searched for?
//
// Method: docs/algorithms/ltba_star.md.

#include <vector>

#include "vandplan/planner.h"

namespace vandplan::lattice {

/// Options of LTBA*: "cycle_expansions", "cycle_time", "weight", and the options of every lattice
/// search.
[[nodiscard]] std::vector<OptionInfo> ltba_star_options();

/// Plans by LTBA*: one A* over many cycles. After each cycle a part of the way is committed.
[[nodiscard]] PlannerAnswer plan_ltba_star(const Task& task, const PlanOptions& options);

}  // namespace vandplan::lattice

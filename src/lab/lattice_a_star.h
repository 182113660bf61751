// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which way over a lattice is the shortest, or longer by a known factor at most?
//
// Method: docs/algorithms/lattice.md.

#include <vector>

#include "vandplan/planner.h"

namespace vandplan::lattice {

/// Options of A*: "weight", and the options of every lattice search.
[[nodiscard]] std::vector<OptionInfo> a_star_options();
/// Options of ARA*: "first_weight", "weight_step", "last_weight", and the options of every lattice
/// search.
[[nodiscard]] std::vector<OptionInfo> ara_star_options();

/// Plans by A*: one search with one weight.
[[nodiscard]] PlannerAnswer plan_a_star(const Task& task, const PlanOptions& options);
/// Plans by ARA*: rounds with falling weights, each of which continues the previous round.
[[nodiscard]] PlannerAnswer plan_ara_star(const Task& task, const PlanOptions& options);

}  // namespace vandplan::lattice

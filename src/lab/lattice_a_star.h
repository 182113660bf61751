// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which way over a lattice is the shortest, or at most so many times as long?
//
// docs/algorithms/lattice.md.

#include <vector>

#include "vandplan/planner.h"

namespace vandplan::lattice {

/// "weight", and those that all searches over a lattice have.
[[nodiscard]] std::vector<OptionInfo> a_star_options();
/// "first_weight", "weight_step", "last_weight", and those that all searches over a lattice have.
[[nodiscard]] std::vector<OptionInfo> ara_star_options();

/// One search with one weight.
[[nodiscard]] PlannerAnswer plan_a_star(const Task& task, const PlanOptions& options);
/// Rounds with falling weights, each of which goes on from the one before.
[[nodiscard]] PlannerAnswer plan_ara_star(const Task& task, const PlanOptions& options);

}  // namespace vandplan::lattice

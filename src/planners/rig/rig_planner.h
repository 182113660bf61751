// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a tractor with a trailer get to its goal?
//
// Method: docs/algorithms/trailers.md.

#include "planners/pricing.h"
#include "vandplan/outcome.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::rig {

/// Plans for a vehicle with a trailer: the planner `anytime` for such tasks. Expects start and goal
/// to be free.
[[nodiscard]] PlannerAnswer plan_rig(const Task& task, const PlanOptions& options,
                                     const planning::Pricing& pricing);

}  // namespace vandplan::rig

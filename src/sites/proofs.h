// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Between which poses of a site is it proven that there is no path?

#include <cstddef>
#include <span>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/site_table.h"

namespace vandplan::sites {

/// Numbers of those goals to which it is proven that no path leads from a start: walls, zones or
/// one-way streets part them. Poses are in the scenario's frame; they and the vehicle there are
/// free. The work is limited, so that some proofs are missed. The options must be complete.
[[nodiscard]] std::vector<std::size_t> unreachable_goals(const Problem& problem, const Pose& start,
                                                         const std::vector<Pose>& goals,
                                                         const PlanOptions& options);

/// Changes the outcome of entries of a matrix from "no way" or "outside" to "no path" where that is
/// proven. `threads` share the work, with equal results.
void prove_empty_entries(const Problem& problem, std::span<const Pose> starts,
                         const std::vector<Pose>& goals, const PlanOptions& options, int threads,
                         std::span<SiteCost> costs);

}  // namespace vandplan::sites

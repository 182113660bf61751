// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the trailer alone say about all drives of a rig?
//
// Proofs: docs/proofs/rigs.md.

#include "planners/pricing.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// The task of the trailer as if it drove by itself: its body, its poses at both ends, and the
/// radius below which its axle never turns. `checker` is that of the rig. The task has a vehicle
/// with a trailer.
[[nodiscard]] Task towed_task(const Task& task);

/// Drives for which a bound holds.
enum class Ends {
  judged,  ///< all drives that the judge accepts: start and goal may be off by its tolerance
  exact    ///< drives with exact ends
};

/// Lower bound of the cost of all drives of the rig [m]. By length it holds for exact ends only.
[[nodiscard]] double cost_lower_bound(const Task& task, const search::CostRule& rule,
                                      Ends ends = Ends::judged);

/// Lower bound of the cost of all drives of the rig, where the time is a part of the cost [m], or
/// all of it [s].
[[nodiscard]] double cost_lower_bound(const Task& task, const Pricing& pricing,
                                      Ends ends = Ends::judged);

}  // namespace vandplan::planning

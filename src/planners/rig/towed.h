// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the trailer alone say about all drives of a rig?
//
// Proofs: docs/algorithms/trailers.md.

#include "planners/pricing.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::rig {

/// The task of the trailer, as if it drove by itself: its body, its poses at both ends, and the
/// radius below which its axle never turns; `checker` is that of the rig. The task has a vehicle
/// with a trailer.
[[nodiscard]] Task towed_task(const Task& task);

/// No drive of the rig costs less [m].
[[nodiscard]] double least_cost(const Task& task, const search::CostRule& rule);

/// The same where the time may be a part of the cost [m], or all of it [s].
[[nodiscard]] double least_cost(const Task& task, const planning::Pricing& pricing);

}  // namespace vandplan::rig

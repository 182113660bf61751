// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which workers prove a lower bound, or that there is no path?
//
// Tasks and pricings outlive the workers.

#include <memory>

#include "planners/anytime/portfolio.h"
#include "planners/anytime/worker.h"
#include "planners/pricing.h"

namespace vandplan::anytime {

/// Proves a lower bound of the length of all paths. Iterations bound the way around obstacles of a
/// disc, which may turn at once. Steps bound the way of the vehicle, with its headings. `only`:
/// gear of all paths; 0: both gears.
[[nodiscard]] std::unique_ptr<Worker> length_prover(const Task& task, search::GearSign only);

/// Proves that nothing as wide as the vehicle gets from the start to the goal, or that rules of
/// zones forbid it. `towed`: task of the trailer alone, whose width counts too; null: no trailer.
/// `only`: gear of all paths; 0: both gears.
[[nodiscard]] std::unique_ptr<Worker> wall_prover(const Task& task, const Task* towed,
                                                  search::GearSign only);

/// Whether zones or masks say anything.
[[nodiscard]] bool has_rules_of_ground(const Task& task);

/// Proves what zones and masks add to the cost of all paths, or to their length, if there are only
/// rules. `knows_length`: whether lengths are bounded at all.
[[nodiscard]] std::unique_ptr<Worker> zone_prover(const Task& task,
                                                  const planning::Pricing& pricing,
                                                  bool knows_length);

/// Steps of the zone prover in a round.
[[nodiscard]] Share share_of_zone_prover();

}  // namespace vandplan::anytime

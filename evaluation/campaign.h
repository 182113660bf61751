// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which runs does a comparison have, with which seeds, in which order?

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/run_record.h"
#include "vandplan/evaluation.h"

namespace vandplan::evaluation {

/// Run to be done: indices into the campaign, and complete options.
struct RunSpec {
  std::size_t scenario = 0;
  std::size_t goal = 0;
  std::size_t planner = 0;
  Region region = Region::bounds;
  SharedOptions options;  // options of the run; the seed in them is ignored
  std::uint64_t seed = 1;
};

/// All runs of a campaign, in the order of execution. If the campaign has a shard, only those of
/// the shard. Throws InputError when something is out of range.
///
/// Repeats are spread evenly over the whole time. At each problem, all planners with equally many
/// repeats take their turns before the next problem; each goes first equally often. So a slow
/// minute of the machine hits all of them alike.
[[nodiscard]] std::vector<RunSpec> runs_of(const Campaign& campaign);

/// Complete options of a planner's runs with a vehicle, without seed, region and profile. Only
/// settings that the planner honours are used. Prices and steering depend on the vehicle. Throws
/// InputError naming an option with a bad value, or when the planner cannot plan for the vehicle.
[[nodiscard]] PlanOptions options_of(const Campaign& campaign, const Planner& planner,
                                     const Vehicle& vehicle);

/// Limits of a planner's runs in a campaign; equal for all vehicles. Throws InputError as
/// `options_of` does.
[[nodiscard]] BudgetOptions budget_of(const Campaign& campaign, const Planner& planner);

/// Seed of a repeat. It is equal for all planners and regions, so that runs can be paired. It
/// depends on the arguments alone, so a part of a campaign has the seeds of the whole.
[[nodiscard]] std::uint64_t run_seed(std::uint64_t campaign_seed, const std::string& scenario,
                                     std::size_t goal, int repeat);

}  // namespace vandplan::evaluation

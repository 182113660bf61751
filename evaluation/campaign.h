// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which runs make a comparison, with which seeds, and in which order?

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/run_record.h"
#include "vandplan/evaluation.h"

namespace vandplan::evaluation {

/// One run that is to be done: indices into the campaign, and its complete options.
struct RunSpec {
  std::size_t scenario = 0;
  std::size_t goal = 0;
  std::size_t planner = 0;
  Region region = Region::bounds;
  SharedOptions options;  // but for the seed
  std::uint64_t seed = 1;
};

/// Every run of the campaign in the order in which to do them: the repeats are spread evenly over
/// the whole time, and all planners with equally many repeats take their turn at one problem before
/// the next one comes, each planner going first equally often. So a slow minute of the machine hits
/// all of them alike. Of a campaign with a shard, those of that alone, in the same order. Throws
/// InputError when something is out of range.
[[nodiscard]] std::vector<RunSpec> runs_of(const Campaign& campaign);

/// The complete options of a planner's runs with a vehicle in a campaign, but for seed, region and
/// profile: those settings that it honours. Prices and steering depend on the vehicle. Throws
/// InputError naming the option whose value is no good, or when the planner cannot plan for the
/// vehicle.
[[nodiscard]] PlanOptions options_of(const Campaign& campaign, const Planner& planner,
                                     const Vehicle& vehicle);

/// The limits of a planner's runs in a campaign, the same for all vehicles. Throws InputError as
/// `options_of` does.
[[nodiscard]] BudgetOptions budget_of(const Campaign& campaign, const Planner& planner);

/// The seed of a repeat; the same for every planner and region, so that runs can be paired. It
/// depends on what is named here only: a part of a campaign has the seeds of the whole.
[[nodiscard]] std::uint64_t run_seed(std::uint64_t campaign_seed, const std::string& scenario,
                                     std::size_t goal, int repeat);

}  // namespace vandplan::evaluation

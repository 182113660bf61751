// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which runs make a comparison, with which seeds, and in which order?

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "vandplan/plan_options.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan {

/// A scenario that takes part, and the file it was read from.
struct CampaignScenario {
  Scenario scenario;
  std::string file;
};

/// What to compare.
struct Campaign {
  std::vector<CampaignScenario> scenarios = {};
  std::vector<PlannerInfo> planners = {};
  std::vector<Region> regions = {Region::bounds, Region::scene};
  int repeats = 25;          ///< of every scenario with one goal; >= 1
  int repeats_per_goal = 5;  ///< of every goal in a row of goals; >= 1
  std::uint64_t seed = 1;    ///< every run's seed is derived from it
  bool profile = false;      ///< one run more of each kind that measures where the time goes
  PlanOptions options = {};  ///< of every run, but for seed and region
};

/// One run that is to be done: indices into the campaign, and its complete options.
struct RunSpec {
  std::size_t scenario = 0;
  std::size_t goal = 0;
  std::size_t planner = 0;
  PlanOptions options;
};

/// Every run of the campaign in the order in which to do them: the repeats are spread evenly over
/// the whole time, and all planners take their turn at one problem before the next one comes, each
/// planner going first equally often. So a slow minute of the machine hits all of them alike.
/// Throws InputError when something is out of range.
[[nodiscard]] std::vector<RunSpec> runs_of(const Campaign& campaign);

/// The seed of a repeat; the same for every planner and region, so that runs can be paired. It
/// depends on what is named here only: a part of a campaign has the seeds of the whole.
[[nodiscard]] std::uint64_t run_seed(std::uint64_t campaign_seed, const std::string& scenario,
                                     std::size_t goal, int repeat);

/// The planners of the thesis' comparison: its ten methods and four with exact lengths
/// or bounds of them.
[[nodiscard]] std::vector<PlannerInfo> thesis_planners();

}  // namespace vandplan

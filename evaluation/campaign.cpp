// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/campaign.h"

#include <algorithm>

#include "base/random.h"
#include "evaluation/hash.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

// One turn: every planner and region runs one problem with one seed.
struct Turn {
  std::size_t scenario;
  std::size_t goal;
  int repeat;
  double when;  // in (0, 1): where in the campaign it belongs
};

std::vector<Turn> turns_of(const Campaign& campaign) {
  std::vector<Turn> turns;
  for (std::size_t s = 0; s < campaign.scenarios.size(); ++s) {
    const Scenario& scenario = campaign.scenarios[s].scenario;
    const int repeats = scenario.goals_are_a_row ? campaign.repeats_per_goal : campaign.repeats;
    for (std::size_t goal = 0; goal < scenario.goals.size(); ++goal)
      for (int repeat = 0; repeat < repeats; ++repeat)
        turns.push_back({s, goal, repeat, (repeat + 0.5) / repeats});
  }
  std::ranges::stable_sort(turns, {}, &Turn::when);
  return turns;
}

void check(const Campaign& campaign) {
  if (campaign.scenarios.empty()) throw InputError("scenarios", "none given");
  if (campaign.planners.empty()) throw InputError("planners", "none given");
  if (campaign.regions.empty()) throw InputError("region", "none given");
  if (campaign.repeats < 1) throw InputError("repeats", "must be at least 1");
  if (campaign.repeats_per_goal < 1) throw InputError("goal-repeats", "must be at least 1");
  validate(campaign.options);
}

// One run more on each problem, the middle one of a row of goals. Measuring slows a run down, so
// these are kept apart from those whose time counts.
std::vector<Turn> profiling_turns_of(const Campaign& campaign) {
  std::vector<Turn> turns;
  for (std::size_t s = 0; s < campaign.scenarios.size(); ++s)
    turns.push_back({s, campaign.scenarios[s].scenario.goals.size() / 2, 0, 1.0});
  return turns;
}

void add_turns(const Campaign& campaign, const std::vector<Turn>& turns, bool profile,
               std::vector<RunSpec>& runs) {
  for (const Turn& turn : turns) {
    PlanOptions options = campaign.options;
    options.profile = profile;
    options.seed = run_seed(campaign.seed, campaign.scenarios[turn.scenario].scenario.name,
                            turn.goal, turn.repeat);
    const std::size_t first = turn.scenario + turn.goal + static_cast<std::size_t>(turn.repeat);
    for (const Region region : campaign.regions) {
      options.region = region;
      for (std::size_t i = 0; i < campaign.planners.size(); ++i)
        runs.push_back({turn.scenario, turn.goal, (first + i) % campaign.planners.size(), options});
    }
  }
}

}  // namespace

std::vector<RunSpec> runs_of(const Campaign& campaign) {
  check(campaign);
  std::vector<RunSpec> runs;
  add_turns(campaign, turns_of(campaign), campaign.options.profile, runs);
  if (campaign.profile) add_turns(campaign, profiling_turns_of(campaign), true, runs);
  return runs;
}

std::uint64_t run_seed(std::uint64_t campaign_seed, const std::string& scenario, std::size_t goal,
                       int repeat) {
  std::uint64_t seed = base::stream_seed(campaign_seed, hash_of(scenario));
  seed = base::stream_seed(seed, goal);
  seed = base::stream_seed(seed, static_cast<std::uint64_t>(repeat));
  return seed >> 32;  // short enough to type
}

std::vector<PlannerInfo> thesis_planners() {
  std::vector<PlannerInfo> found;
  for (const PlannerInfo& planner : planners())
    if (planner.name.starts_with("rrt-") && !planner.name.ends_with("-bound"))
      found.push_back(planner);
  return found;
}

}  // namespace vandplan

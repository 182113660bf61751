// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/campaign.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "vandplan/input_error.h"

namespace vandplan {
namespace {

PlanResult no_plan(const Problem&, const PlanOptions&) { return {}; }

CampaignScenario scenario(const std::string& name, std::size_t goals, bool are_a_row) {
  CampaignScenario made;
  made.scenario.name = name;
  made.scenario.goals.resize(goals);
  made.scenario.goals_are_a_row = are_a_row;
  return made;
}

Campaign small_campaign() {
  return {.scenarios = {scenario("single", 1, false), scenario("row", 3, true)},
          .planners = {{"a", no_plan, ""}, {"b", no_plan, ""}, {"c", no_plan, ""}},
          .repeats = 6,
          .repeats_per_goal = 2};
}

TEST(Campaign, RunsEveryPlannerInEveryRegionOnEveryProblemWithEverySeed) {
  const std::vector<RunSpec> runs = runs_of(small_campaign());
  EXPECT_EQ(runs.size(), 3U * 2U * (6U + 3U * 2U));
  std::set<std::tuple<std::size_t, std::size_t, std::size_t, Region, std::uint64_t>> different;
  for (const RunSpec& run : runs)
    different.insert({run.scenario, run.goal, run.planner, run.options.region, run.options.seed});
  EXPECT_EQ(different.size(), runs.size());
}

TEST(Campaign, GivesAllPlannersAndRegionsTheSameSeeds) {
  std::map<std::pair<std::size_t, Region>, std::set<std::uint64_t>> seeds;
  for (const RunSpec& run : runs_of(small_campaign()))
    seeds[{run.planner, run.options.region}].insert(run.options.seed);
  EXPECT_EQ(seeds.size(), 6U);
  for (const auto& [key, found] : seeds) EXPECT_EQ(found, seeds.begin()->second);
}

TEST(Campaign, APartHasTheSeedsOfTheWhole) {
  Campaign part = small_campaign();
  part.scenarios.erase(part.scenarios.begin());
  part.planners.pop_back();
  part.regions = {Region::scene};
  std::set<std::uint64_t> whole_seeds;
  for (const RunSpec& run : runs_of(small_campaign())) whole_seeds.insert(run.options.seed);
  for (const RunSpec& run : runs_of(part)) EXPECT_TRUE(whole_seeds.contains(run.options.seed));
}

TEST(Campaign, SeedsFollowFromOne) {
  EXPECT_EQ(run_seed(1, "a", 0, 0), run_seed(1, "a", 0, 0));
  const std::set<std::uint64_t> different = {run_seed(1, "a", 0, 0), run_seed(2, "a", 0, 0),
                                             run_seed(1, "b", 0, 0), run_seed(1, "a", 1, 0),
                                             run_seed(1, "a", 0, 1)};
  EXPECT_EQ(different.size(), 5U);
}

TEST(Campaign, TakesTurnsSoThatASlowMinuteHitsAllAlike) {
  const std::vector<RunSpec> runs = runs_of(small_campaign());
  // After half of the time, each planner has done half of its runs of each scenario.
  std::map<std::pair<std::size_t, std::size_t>, int> done;
  for (std::size_t i = 0; i < runs.size() / 2; ++i) ++done[{runs[i].planner, runs[i].scenario}];
  for (const auto& [key, count] : done) EXPECT_EQ(count, 6);
  // One problem and seed: all planners and regions in a row.
  std::set<std::uint64_t> seeds;
  for (std::size_t i = 0; i < 6; ++i) seeds.insert(runs[i].options.seed);
  EXPECT_EQ(seeds.size(), 1U);
}

TEST(Campaign, EveryPlannerGoesFirstEquallyOften) {
  std::map<std::size_t, int> first;
  const std::vector<RunSpec> runs = runs_of(small_campaign());
  for (std::size_t i = 0; i < runs.size(); i += 6)
    if (runs[i].scenario == 0) ++first[runs[i].planner];
  EXPECT_EQ(first, (std::map<std::size_t, int>{{0, 2}, {1, 2}, {2, 2}}));
}

TEST(Campaign, ProfilesEveryPlannerInEveryRegionOnceMore) {
  Campaign campaign = small_campaign();
  campaign.profile = true;
  const std::vector<RunSpec> runs = runs_of(campaign);
  const std::size_t timed = runs_of(small_campaign()).size();
  ASSERT_EQ(runs.size(), timed + 2U * 3U * 2U);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].options.profile, i >= timed);
    if (runs[i].options.profile && runs[i].scenario == 1) {
      EXPECT_EQ(runs[i].goal, 1U);
    }
  }
}

TEST(Campaign, OfNothingIsRefused) {
  Campaign campaign = small_campaign();
  campaign.repeats = 0;
  EXPECT_THROW(static_cast<void>(runs_of(campaign)), InputError);
  campaign = small_campaign();
  campaign.planners.clear();
  EXPECT_THROW(static_cast<void>(runs_of(campaign)), InputError);
  campaign = small_campaign();
  campaign.options.goal_bias = 2.0;
  EXPECT_THROW(static_cast<void>(runs_of(campaign)), InputError);
}

}  // namespace
}  // namespace vandplan

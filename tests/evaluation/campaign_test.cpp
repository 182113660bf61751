// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/campaign.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan::evaluation {
namespace {

PlannerAnswer no_plan(const Task&, const PlanOptions&) { return {}; }

// A planner that can be told where to draw samples, and to measure.
Planner planner(const std::string& name) {
  return {.name = name,
          .summary = "",
          .options = {{.name = "region",
                       .summary = "",
                       .default_value = std::string("bounds"),
                       .words = {"bounds", "scene"}},
                      {.name = "profile", .summary = "", .default_value = false}},
          .function = no_plan};
}

CampaignScenario scenario(const std::string& name, std::size_t goals_in_row) {
  CampaignScenario made;
  made.scenario.scenario.name = name;
  made.scenario.row.resize(goals_in_row);
  return made;
}

Campaign small_campaign() {
  return {.scenarios = {scenario("single", 0), scenario("row", 3)},
          .planners = {planner("a"), planner("b"), planner("c")},
          .repeats = 6,
          .repeats_per_goal = 2};
}

TEST(Campaign, RunsEveryPlannerInEveryRegionOnEveryProblemWithEverySeed) {
  const std::vector<RunSpec> runs = runs_of(small_campaign());
  EXPECT_EQ(runs.size(), 3U * 2U * (6U + 3U * 2U));
  std::set<std::tuple<std::size_t, std::size_t, std::size_t, Region, std::uint64_t>> different;
  for (const RunSpec& run : runs)
    different.insert({run.scenario, run.goal, run.planner, run.region, run.seed});
  EXPECT_EQ(different.size(), runs.size());
}

TEST(Campaign, GivesAllPlannersAndRegionsTheSameSeeds) {
  std::map<std::pair<std::size_t, Region>, std::set<std::uint64_t>> seeds;
  for (const RunSpec& run : runs_of(small_campaign()))
    seeds[{run.planner, run.region}].insert(run.seed);
  EXPECT_EQ(seeds.size(), 6U);
  for (const auto& [key, found] : seeds) EXPECT_EQ(found, seeds.begin()->second);
}

TEST(Campaign, APartHasTheSeedsOfTheWhole) {
  Campaign part = small_campaign();
  part.scenarios.erase(part.scenarios.begin());
  part.planners.pop_back();
  part.regions = {Region::scene};
  std::set<std::uint64_t> whole_seeds;
  for (const RunSpec& run : runs_of(small_campaign())) whole_seeds.insert(run.seed);
  for (const RunSpec& run : runs_of(part)) EXPECT_TRUE(whole_seeds.contains(run.seed));
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
  for (std::size_t i = 0; i < 6; ++i) seeds.insert(runs[i].seed);
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
    EXPECT_EQ(runs[i].options->planner.flag("profile"), i >= timed);
    if (i >= timed && runs[i].scenario == 1) {
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
  campaign.settings = {{"threads", "0"}};
  EXPECT_THROW(static_cast<void>(runs_of(campaign)), InputError);
  campaign = small_campaign();
  campaign.planners.push_back(planner("a"));  // who of both would a report mean?
  EXPECT_THROW(static_cast<void>(runs_of(campaign)), InputError);
  campaign = small_campaign();
  campaign.caps = {{"group", 0, 1}};
  EXPECT_THROW(static_cast<void>(runs_of(campaign)), InputError);
  campaign.caps = {{"group", 1, 0}};
  EXPECT_THROW(static_cast<void>(runs_of(campaign)), InputError);
}

TEST(Campaign, GivesSettingsToThosePlannersThatHonourThem) {
  Campaign campaign = small_campaign();
  campaign.planners = {planner("plain"), planner_named("rrt-bsc-euc")};
  campaign.settings = {{"goal_bias", "0.25"}, {"time_limit", "0.5"}};
  for (const RunSpec& run : runs_of(campaign)) {
    EXPECT_EQ(run.options->budget.time_limit, 0.5);
    EXPECT_EQ(run.options->planner.find("goal_bias") != nullptr, run.planner == 1);
    EXPECT_EQ(run.options->planner.word("region"),
              run.region == Region::scene ? "scene" : "bounds");
    if (run.planner == 1) {
      EXPECT_EQ(run.options->planner.number("goal_bias"), 0.25);
    }
  }
}

TEST(Campaign, CountsTheProcessorTimeOfRunsOfOneThread) {
  Campaign campaign = small_campaign();
  campaign.planners = {planner_named("anytime")};
  campaign.profile = false;
  for (const char* const threads : {"1", "2"}) {
    campaign.settings = {{"threads", threads}};
    for (const RunSpec& run : runs_of(campaign))
      EXPECT_EQ(run.options->budget.processor_time, std::string(threads) == "1");
  }
}

TEST(Campaign, SteersAsItsSettingsSayAndOtherwiseInTheShortestStyle) {
  Campaign campaign = small_campaign();
  campaign.planners = {planner("plain"), planner_named("rrt-bsc-euc"), planner_named("anytime")};
  for (const RunSpec& run : runs_of(campaign)) {
    EXPECT_EQ(run.options->cost, shortest_style);
    EXPECT_EQ(run.options->steering, Steering::reeds_shepp);
  }
  campaign.settings = {{"steering", "continuous"}};
  for (const RunSpec& run : runs_of(campaign)) {
    EXPECT_EQ(run.options->steering,
              run.planner == 0 ? Steering::reeds_shepp : Steering::continuous);
  }
}

TEST(Campaign, GivesADriversPricesAndSteeringThatFitTheVehicleOfTheScenario) {
  Campaign campaign = small_campaign();
  campaign.planners = {planner_named("anytime")};
  Vehicle& robot = campaign.scenarios[0].scenario.scenario.vehicle;
  robot.min_turning_radius = 1.0;
  Vehicle& rig = campaign.scenarios[1].scenario.scenario.vehicle;
  rig = vehicle_named("tractor-semitrailer");
  campaign.settings = {{"style", "driver"}};
  for (const RunSpec& run : runs_of(campaign)) {
    const Vehicle& vehicle = run.scenario == 0 ? robot : rig;
    EXPECT_EQ(run.options->cost, prices_of(Style::driver, vehicle));
    EXPECT_EQ(run.options->steering, complete(default_planner(), {}, vehicle).steering);
  }
}

TEST(Campaign, RefusesSettingsThatNobodyHonoursOrThatItSetsItself) {
  for (const Setting& setting :
       {Setting{"gaol_bias", "0.1"}, Setting{"reverse_weight", "2"}, Setting{"seed", "7"},
        Setting{"region", "scene"}, Setting{"profile", "true"}}) {
    Campaign campaign = small_campaign();
    campaign.planners.push_back(planner_named("rrt-bsc-euc"));
    campaign.settings = {setting};
    EXPECT_THROW(static_cast<void>(runs_of(campaign)), InputError) << setting.name;
  }
}

TEST(Campaign, RunsPlannersThatKnowNoRegionInEachRegionAlike) {
  Campaign campaign = small_campaign();
  campaign.planners = {{.name = "plain", .summary = "", .function = no_plan}};
  campaign.profile = true;  // which it cannot do
  const std::vector<RunSpec> runs = runs_of(campaign);
  EXPECT_EQ(runs.size(), 2U * (6U + 3U * 2U));
  for (const RunSpec& run : runs) EXPECT_TRUE(run.options->planner.values().empty());
}

TEST(Campaign, RepeatsAGroupLessOftenWithTheSameSeedsAndOverAllOfTheTime) {
  Campaign campaign = small_campaign();
  campaign.planners[1].properties.groups = {"few"};
  campaign.caps = {{"few", 3, 1}};
  const std::vector<RunSpec> runs = runs_of(campaign);
  EXPECT_EQ(runs.size(), 2U * 2U * (6U + 3U * 2U) + 2U * (3U + 3U * 1U));
  std::set<std::uint64_t> many, few;
  for (const RunSpec& run : runs) (run.planner == 1 ? few : many).insert(run.seed);
  for (const std::uint64_t seed : few) EXPECT_TRUE(many.contains(seed));
  int early = 0;
  for (std::size_t i = 0; i < runs.size() / 2; ++i)
    early += runs[i].planner == 1 && runs[i].scenario == 0;
  EXPECT_GE(early, 2);
  EXPECT_LE(early, 4);  // of six
}

TEST(Campaign, ExplainsWhyThereAreSoManyRuns) {
  Campaign campaign = small_campaign();
  campaign.planners[1].properties.groups = {"few"};
  campaign.caps = {{"few", 2, 2}};
  campaign.profile = true;
  EXPECT_EQ(explain_runs(campaign),
            "76 runs\n"
            "     24 = 2 planners x 2 regions x 1 scenario x 6 repeats\n"
            "     24 = 2 planners x 2 regions x 3 goals x 2 repeats, in rows of goals\n"
            "      4 = 1 planner x 2 regions x 1 scenario x 2 repeats\n"
            "     12 = 1 planner x 2 regions x 3 goals x 2 repeats, in rows of goals\n"
            "     12 = 3 planners x 2 regions x 2 scenarios, once more to measure phases\n");
  EXPECT_EQ(runs_of(campaign).size(), 76U);
}

TEST(Campaign, KnowsWhatWordsMean) {
  EXPECT_EQ(planners_called("thesis").size(), 10U);
  for (const Planner& planner : planners_called("thesis"))
    EXPECT_FALSE(planner.properties.tries_goal);
  EXPECT_EQ(planners_called("thesis-goal").size(), 10U);
  for (const Planner& planner : planners_called("thesis-goal"))
    EXPECT_TRUE(planner.properties.tries_goal);
  EXPECT_EQ(planners_called("all").size(), planners().size());
  ASSERT_EQ(planners_called("anytime").size(), 1U);
  EXPECT_THROW(static_cast<void>(planners_called("thesis-gaol")), InputError);
}

}  // namespace
}  // namespace vandplan::evaluation

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/runner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <stdexcept>
#include <stop_token>
#include <thread>

#include "support/made_up_runs.h"
#include "support/temporary_folder.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/random.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan::evaluation {
namespace {

// Drives straight to the goal; how long that took and what was found on the way is made up.
PlannerAnswer plan_directly(const Task& task, const PlanOptions& options) {
  Rng rng(options.budget.seed);
  const Piece piece = reeds_shepp(task.start, task.goal, task.vehicle.min_turning_radius);
  PlannerAnswer answer{.status = PlanStatus::solved};
  answer.segments.emplace(piece.view().begin(), piece.view().end());
  const double cost = length(*answer.segments);
  answer.anytime = {{uniform01(rng), 1, 2.0 * cost}, {1.0, 2, cost}};
  answer.iterations = static_cast<std::int64_t>(options.budget.seed);
  return answer;
}

PlannerAnswer plan_nothing(const Task&, const PlanOptions&) {
  return {.status = PlanStatus::node_limit};
}

PlannerAnswer plan_wrongly(const Task&, const PlanOptions&) {
  PlannerAnswer answer{.status = PlanStatus::solved};
  answer.segments = {{0.0, 1.0}};
  return answer;
}

// Runs until it is stopped.
PlannerAnswer plan_endlessly(const Task&, const PlanOptions& options) {
  while (!options.budget.stop.stop_requested()) std::this_thread::yield();
  return {};
}

// Sleeps longer than its budget of 10 ms, and says how many iterations it has after that.
PlannerAnswer sleep_past_the_limit(const Task&, const PlanOptions& options) {
  search::Budget budget(options.budget);
  std::this_thread::sleep_for(std::chrono::milliseconds(15));
  static_cast<void>(budget.next());
  return {.status = PlanStatus::node_limit, .iterations = budget.iterations()};
}

Planner planner(const std::string& name, const PlannerFunction& function) {
  return {.name = name, .summary = "", .function = function};
}

Campaign short_campaign() {
  return {
      .scenarios = {{open_ground("first"), "first.yaml"}, {open_ground("second"), "second.yaml"}},
      .planners = {planner("direct", plan_directly), planner("nothing", plan_nothing)},
      .repeats = 5,
      .settings = {{"max_iterations", "100"}}};
}

// On a busy machine a run waits for its core; that is not its time.
TEST(Runner, DoesNotCountWhatARunWaits) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = short_campaign();
  campaign.planners = {planner("sleeper", sleep_past_the_limit)};
  campaign.settings = {{"time_limit", "0.01"}};
  run_campaign(campaign, store, {});
  for (const RunRecord& run : store.runs()) {
    EXPECT_EQ(run.result.iterations, 1);
    EXPECT_LT(run.result.time_total, 0.01);
  }
}

TEST(Runner, StoresEveryRunOfACampaign) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  const Progress progress = run_campaign(short_campaign(), store, {});
  EXPECT_EQ(progress.total, 40);
  EXPECT_EQ(progress.done, 40);
  std::map<std::string, int> statuses;
  for (const RunRecord& run : store.runs()) ++statuses[std::string(name_of(run.result.status))];
  EXPECT_EQ(statuses, (std::map<std::string, int>{{"solved", 20}, {"node_limit", 20}}));
  ASSERT_EQ(store.sessions().size(), 1U);
  EXPECT_EQ(store.sessions()[0].runs, 40);
}

TEST(Runner, KeepsPathsInTheFrameOfTheScenario) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  const Campaign campaign = short_campaign();
  run_campaign(campaign, store, {});
  for (const RunRecord& run : store.runs()) {
    if (!run.result.path) continue;
    EXPECT_EQ(run.result.path->start, campaign.scenarios[0].scenario.scenario.start);
    EXPECT_NEAR(end_pose(*run.result.path).x, 40.0, 1e-6);
  }
}

TEST(Runner, DoesOnlyWhatIsMissing) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = short_campaign();
  campaign.repeats = 2;
  run_campaign(campaign, store, {});
  campaign.repeats = 3;
  const Progress progress = run_campaign(campaign, store, {});
  EXPECT_EQ(progress.kept, 16);
  EXPECT_EQ(progress.done, 8);
  EXPECT_EQ(store.runs().size(), 24U);
  EXPECT_EQ(run_campaign(campaign, store, {}).done, 0);
}

TEST(Runner, FindsTheSameWithOneJobAndWithTwo) {
  const TemporaryFolder folder;
  Store one = Store::create(folder / "one.sqlite");
  Store two = Store::create(folder / "two.sqlite");
  run_campaign(short_campaign(), one, {.jobs = 1});
  run_campaign(short_campaign(), two, {.jobs = 2});
  const auto paths_of = [](Store& store) {
    std::map<std::tuple<std::size_t, std::string, std::uint64_t, Region>, std::string> paths;
    for (const RunRecord& run : store.runs()) {
      std::string path;
      for (const CostSample& sample : run.result.anytime)
        path += std::to_string(sample.time) + " " + std::to_string(sample.cost) + " ";
      paths[{run.scenario, run.planner, run.seed, run.region}] = path;
    }
    return paths;
  };
  EXPECT_EQ(paths_of(one), paths_of(two));
}

TEST(Runner, DropsWhatIsInFlightWhenStopped) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = short_campaign();
  campaign.planners = {planner("direct", plan_directly)};
  run_campaign(campaign, store, {});
  campaign.planners.push_back(planner("endless", plan_endlessly));
  std::stop_source stop;
  stop.request_stop();
  const Progress progress = run_campaign(campaign, store, {.stop = stop.get_token()});
  EXPECT_EQ(progress.total, 40);
  EXPECT_EQ(progress.kept, 20);
  EXPECT_EQ(progress.done, 0);
  EXPECT_EQ(store.runs().size(), 20U);
}

TEST(Runner, KeepsWhatTheJudgeRejectsWithItsReasonAndGoesOn) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = short_campaign();
  campaign.planners.push_back(planner("wrong", plan_wrongly));
  EXPECT_EQ(run_campaign(campaign, store, {.jobs = 2}).done, 60);
  int rejected = 0, solved = 0;
  for (const RunRecord& run : store.runs()) {
    solved += run.result.status == PlanStatus::solved;
    if (run.planner != "wrong") continue;
    ++rejected;
    EXPECT_EQ(run.result.status, PlanStatus::rejected);
    EXPECT_NE(run.result.reason.find("the path ends"), std::string::npos) << run.result.reason;
    EXPECT_FALSE(run.result.path);
  }
  EXPECT_EQ(rejected, 20);
  EXPECT_EQ(solved, 20);
}

TEST(Runner, HandsOnWhatAPlannerThrows) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = short_campaign();
  campaign.planners = {planner("thrower", [](const Task&, const PlanOptions&) -> PlannerAnswer {
    throw std::runtime_error("no");
  })};
  EXPECT_THROW(run_campaign(campaign, store, {.jobs = 2}), std::runtime_error);
  EXPECT_TRUE(store.runs().empty());
}

TEST(Runner, TellsHowFarItIs) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  int last_done = 0;
  run_campaign(short_campaign(), store, {.report = [&](const Progress& progress) {
                 EXPECT_EQ(progress.total, 40);
                 EXPECT_GE(progress.done, last_done);
                 last_done = progress.done;
               }});
  EXPECT_EQ(last_done, 40);
}

TEST(Runner, ExpectsTheRestToTakeAsLongAsWhatIsDone) {
  EXPECT_DOUBLE_EQ((Progress{.total = 40, .kept = 10, .done = 10, .elapsed = 2.0}.left()), 4.0);
  EXPECT_DOUBLE_EQ((Progress{.total = 40}.left()), 0.0);
}

TEST(Runner, RefusesMoreJobsThanCoresWhenTimeIsTheLimit) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = short_campaign();
  campaign.repeats = 1;
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  EXPECT_NO_THROW(run_campaign(campaign, store, {.jobs = cores + 1}));
  campaign.settings.push_back({"time_limit", "0.1"});
  EXPECT_THROW(run_campaign(campaign, store, {.jobs = cores + 1}), InputError);
  EXPECT_NO_THROW(run_campaign(campaign, store, {.jobs = cores}));
  EXPECT_THROW(run_campaign(campaign, store, {.jobs = 0}), InputError);
}

}  // namespace
}  // namespace vandplan::evaluation

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/summary.h"

#include <gtest/gtest.h>

#include <utility>

#include "evaluation/findings.h"
#include "evaluation/methods.h"
#include "evaluation/pooled.h"
#include "evaluation/reasons.h"
#include "support/made_up_runs.h"
#include "support/numbers.h"

namespace vandplan::evaluation {
namespace {

using Verdict = PairedComparison::Verdict;

Summary summary_of(const std::vector<ScenarioFile>& scenarios, const std::vector<RunRecord>& runs) {
  return summarize(scenarios, planners_of(runs, {}), runs);
}

// A run that measured where its time went: half of it in ranking.
RunRecord profiled_run(const std::string& planner, std::uint64_t seed, double cost) {
  RunRecord run = made_up_run(planner, seed, cost);
  run.options.change([](PlanOptions& options) { options.planner.set("profile", true); });
  run.result.phases = {{"ranking", 0.05}, {"steering", 0.02}, {"checking", 0.01}};
  return run;
}

const MethodSummary& method(const Summary& summary, const std::string& planner) {
  for (const MethodSummary& found : summary.scenarios.at(0).methods)
    if (found.planner == planner) return found;
  throw std::out_of_range(planner);
}

TEST(Summary, CountsRunsThatProvedThatThereIsNoPath) {
  std::vector<RunRecord> runs = {made_up_run("a", 1, 50.0), made_up_run("a", 2, {})};
  runs.push_back(made_up_run("a", 3, {}));
  runs.back().result.status = PlanStatus::no_path;
  const Summary summary = summary_of({open_ground("open")}, runs);
  EXPECT_EQ(method(summary, "a").no_path, 1);
  EXPECT_EQ(method(summary, "a").solved, 1);
}

TEST(Summary, TakesTheCostAsItStoodAtATime) {
  const RunRecord run = made_up_run("a", 1, 70.0, 0.01);
  EXPECT_EQ(first_solution_time(run), 0.01);
  EXPECT_EQ(cost_at(run, 0.0099), infinity);
  EXPECT_EQ(cost_at(run, 0.01), 140.0);
  EXPECT_EQ(cost_at(run, 0.1), 70.0);
  EXPECT_EQ(final_cost(run), 70.0);
}

TEST(Summary, CountsUnsolvedRunsAsInfinite) {
  const RunRecord run = made_up_run("a", 1, std::nullopt);
  EXPECT_EQ(first_solution_time(run), infinity);
  EXPECT_EQ(cost_at(run, 1.0), infinity);
  EXPECT_EQ(final_cost(run), infinity);
  const std::vector<RunRecord> runs = {made_up_run("a", 1, 50.0), made_up_run("a", 2, {}),
                                       made_up_run("a", 3, {})};
  const Summary summary = summary_of({open_ground("open")}, runs);
  EXPECT_EQ(method(summary, "a").solved, 1);
  EXPECT_EQ(method(summary, "a").cost_at_end.median, infinity);
  EXPECT_EQ(method(summary, "a").first_time.median, infinity);
}

TEST(Summary, DescribesEveryPlannerOfAScenario) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 25; ++seed)
    runs.push_back(made_up_run("a", seed, 50.0 + static_cast<double>(seed), 0.008));
  runs[3].result.counters = {{"nodes", 5000}};
  const Summary summary = summary_of({open_ground("open")}, runs);
  const MethodSummary& found = method(summary, "a");
  EXPECT_EQ(found.runs, 25);
  EXPECT_EQ(found.solved, 25);
  EXPECT_EQ(found.cost_at_end.median, 62.0);
  EXPECT_EQ(found.cost_at_end.interval.low, 57.0);
  EXPECT_EQ(found.cost_at_end.interval.high, 67.0);
  EXPECT_EQ(found.cost_at_10ms.median, 124.0);
  EXPECT_EQ(found.cost_at_100ms.median, 62.0);
  EXPECT_EQ(found.full, 1);
  EXPECT_EQ(found.cost_when_full.median, 53.0);
  EXPECT_EQ(found.cost_quantiles, (std::vector{50.0, 56.0, 62.0, 68.0, 74.0}));
  EXPECT_EQ(found.best, 0U);
  EXPECT_EQ(found.typical, 12U);
  EXPECT_FALSE(found.phases);
  EXPECT_EQ(found.curve.front().cost.median, infinity);
  EXPECT_EQ(found.curve.back().cost.median, 62.0);
  EXPECT_EQ(found.curve.back().solved, 1.0);
}

TEST(Summary, KeepsProfiledRunsApart) {
  const RunRecord profiled = profiled_run("a", 1, 10.0);
  const Summary summary = summary_of({open_ground("open")}, {made_up_run("a", 1, 50.0), profiled});
  EXPECT_EQ(method(summary, "a").runs, 1);
  EXPECT_EQ(method(summary, "a").cost_at_end.median, 50.0);
  ASSERT_TRUE(method(summary, "a").phases);
  EXPECT_DOUBLE_EQ(method(summary, "a").phases->ranking, 0.5);
  EXPECT_DOUBLE_EQ(method(summary, "a").phases->checking, 0.1);
}

TEST(Summary, OfARowOfGoalsSaysHowFarMoreThanHalfGet) {
  std::vector<RunRecord> runs;
  const int solved[] = {4, 3, 2, 0};  // of 4, at 20, 40, 60 and 80 m
  for (std::size_t goal = 0; goal < 4; ++goal)
    for (int i = 0; i < 4; ++i) {
      const double cost = 30.0 * static_cast<double>(goal + 1);
      runs.push_back(made_up_run("a", static_cast<std::uint64_t>(i),
                                 i < solved[goal] ? std::optional(cost) : std::nullopt));
      runs.back().goal = goal;
    }
  const Summary summary = summary_of({open_ground("row", 4)}, runs);
  const MethodSummary& found = method(summary, "a");
  EXPECT_EQ(found.furthest, 40.0);
  ASSERT_EQ(found.goals.size(), 4U);
  EXPECT_EQ(found.goals[1].solved, 3);
  EXPECT_EQ(found.goals[1].cost, 60.0);
  EXPECT_EQ(found.goals[2].cost, infinity);
  EXPECT_EQ(found.cost_at_end.median, 1.5);  // per metre
  ASSERT_TRUE(found.best);
  EXPECT_EQ(runs[*found.best].goal, 1U);
}

TEST(Summary, ComparesWithTheTwinThatRanksByEuclid) {
  const auto twin_of = [](const char* planner) -> std::string {
    const Planner* const twin = euclid_twin(planner_named(planner), planners());
    return twin == nullptr ? "none" : twin->name;
  };
  EXPECT_EQ(twin_of("rrt-bsc-hlut-4"), "rrt-bsc-euc");
  EXPECT_EQ(twin_of("rrt-opt-rs-goal"), "rrt-opt-euc-goal");
  EXPECT_EQ(twin_of("rrt-opt-euc"), "none");
  EXPECT_EQ(twin_of("anytime"), "none");
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    const double cost = 50.0 + 10.0 * static_cast<double>(seed);
    runs.push_back(made_up_run("rrt-bsc-euc", seed, cost));
    runs.push_back(made_up_run("rrt-bsc-hlut-1", 24 - seed, 0.8 * (290.0 - (cost - 50.0))));
  }
  const Summary summary = summary_of({open_ground("open")}, runs);
  ASSERT_EQ(summary.scenarios[0].twins.size(), 1U);
  const TwinComparison& twins = summary.scenarios[0].twins[0];
  EXPECT_EQ(twins.cost.pairs, 25);
  EXPECT_NEAR(twins.cost.ratio, 0.8, 1e-12);  // pair by pair, though the spread is larger
  EXPECT_EQ(twins.cost.verdict, Verdict::smaller);
  EXPECT_EQ(twins.first_time.verdict, Verdict::no_difference);
  EXPECT_EQ(twins.cost_ratios.size(), 25U);
}

// Twins whose runs set up, and then search, for so long [s].
struct Times {
  double set_up;
  double search;
};

Summary summary_of_times(const Times& table, const Times& euclid) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    for (const auto& [planner, times] :
         {std::pair("rrt-bsc-euc", euclid), {"rrt-bsc-hlut-2", table}}) {
      runs.push_back(made_up_run(planner, seed, 100.0, times.set_up + times.search));
      runs.back().result.phases = {{"setup", times.set_up}};
    }
  }
  return summary_of({open_ground("s")}, runs);
}

PairedComparison first_solutions(const Times& table, const Times& euclid) {
  return summary_of_times(table, euclid).scenarios.at(0).twins.at(0).first_time;
}

TEST(Summary, TimesTheFirstSolutionFromTheFirstIteration) {
  const PairedComparison found = first_solutions({0.001, 0.04}, {0.021, 0.08});
  EXPECT_EQ(found.verdict, Verdict::smaller);
  EXPECT_NEAR(found.ratio, 0.5, 1e-12);
}

TEST(Summary, CallsADifferenceBelowWhatSettingUpTakesATie) {
  for (const auto& [table, euclid] : {std::pair(Times{0.001, 0.004}, Times{0.005, 0.008}),
                                      {Times{0.005, 0.004}, Times{0.001, 0.008}}}) {
    EXPECT_EQ(first_solutions(table, euclid).verdict, Verdict::no_difference);
    EXPECT_EQ(first_solutions(table, euclid).ratio, 1.0);
  }
  EXPECT_EQ(first_solutions({0.001, 0.004}, {0.003, 0.008}).verdict, Verdict::smaller);
}

TEST(Summary, CountsNotHowLateARunNoticesItsLimit) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    runs.push_back(made_up_run("rrt-bsc-euc", seed, 100.0));
    runs.back().result.time_total = 0.11;  // the limit is 0.1 s
    runs.push_back(made_up_run("rrt-bsc-hlut-2", seed, 100.0));
  }
  const Summary summary = summary_of({open_ground("s")}, runs);
  EXPECT_EQ(summary.scenarios.at(0).twins.at(0).time_total.ratio, 1.0);
}

// The table's runs take a tenth of the time, and one of them may be found later than at once.
Summary summary_of_runs_found_at_once(std::int64_t iteration_of_one) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    runs.push_back(made_up_run("rrt-bsc-euc", seed, 100.0, 0.01));
    runs.push_back(made_up_run("rrt-bsc-hlut-2", seed, 100.0, 0.001));
  }
  for (RunRecord& run : runs) {
    run.result.anytime.pop_back();
    run.result.anytime.back().iteration = 1;
  }
  runs.back().result.anytime.back().iteration = iteration_of_one;
  return summary_of({open_ground("s")}, runs);
}

TEST(Summary, SaysWhereNothingIsSearched) {
  const Summary at_once = summary_of_runs_found_at_once(1);
  const TwinComparison& twins = at_once.scenarios.at(0).twins.at(0);
  EXPECT_EQ(twins.first_time.verdict, Verdict::nothing_searched);
  EXPECT_EQ(twins.cost.verdict, Verdict::nothing_searched);
  EXPECT_EQ(tally(at_once, Region::bounds, &TwinComparison::first_time).at(0).nothing_searched, 1);
  for (const Finding& finding : findings(at_once, {open_ground("s")})) {
    EXPECT_FALSE(finding.holds) << finding.claim;
  }
  const Summary later = summary_of_runs_found_at_once(2);
  EXPECT_EQ(later.scenarios.at(0).twins.at(0).first_time.verdict, Verdict::smaller);
}

// Twenty pairs of 25 have p = 0.004: beyond chance among 6 comparisons, and not among 54.
TEST(Summary, JudgesAllComparisonsTogether) {
  const auto verdict_among = [](std::size_t scenarios) {
    std::vector<ScenarioFile> files;
    std::vector<RunRecord> runs;
    for (std::size_t s = 0; s < scenarios; ++s) {
      files.push_back(open_ground("s" + std::to_string(s)));
      for (std::uint64_t seed = 0; seed < 25; ++seed) {
        for (const Region region : {Region::bounds, Region::scene}) {
          for (const char* const planner : {"rrt-bsc-euc", "rrt-bsc-hlut-1"}) {
            runs.push_back(made_up_run(planner, seed, 100.0));
            runs.back().scenario = s;
            runs.back().region = region;
          }
          if (s == 0) runs.back().result.cost = seed < 20 ? 50.0 : 110.0;
        }
      }
    }
    return summary_of(files, runs).scenarios.at(0).twins.at(0).cost.verdict;
  };
  EXPECT_EQ(verdict_among(1), Verdict::smaller);
  EXPECT_EQ(verdict_among(9), Verdict::no_difference);
}

// Names mean nothing: whoever says that he is built like another is his twin.
TEST(Summary, ComparesPlannersOfOthersByTheirProperties) {
  const Planner mine{"zebra", "", {.family = "mine", .strategy = "x", .estimate = "euclid"}};
  const Planner table{"yak", "", {.family = "mine", .strategy = "x", .estimate = "hlut-3"}};
  const Planner stranger{"rrt-bsc-hlut-1", "", {}};
  const std::vector<RunRecord> runs = {made_up_run("zebra", 1, 10.0), made_up_run("yak", 1, 9.0),
                                       made_up_run("rrt-bsc-hlut-1", 1, 8.0),
                                       made_up_run("rrt-bsc-euc", 1, 7.0)};
  const std::vector<Planner> known = {mine, table, stranger};
  const Summary summary = summarize({open_ground("s")}, planners_of(runs, known), runs);
  ASSERT_EQ(summary.scenarios[0].twins.size(), 1U);
  EXPECT_EQ(summary.scenarios[0].twins[0].planner, "yak");
  EXPECT_EQ(summary.scenarios[0].twins[0].twin, "zebra");
  EXPECT_EQ(table_number(table.properties), 3);
  EXPECT_EQ(table_number(stranger.properties), std::nullopt);
}

TEST(Summary, ShowsPlannersThatNobodyKnows) {
  const std::vector<Planner> found =
      planners_of({made_up_run("unknown", 1, 10.0), made_up_run("anytime", 1, 9.0)}, {});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "anytime");  // the library's come first
  EXPECT_EQ(found[1].name, "unknown");
  EXPECT_TRUE(found[1].properties.family.empty());
}

// Nine scenarios; the table halves the cost in `better` of them and doubles the time in all.
std::vector<Finding> findings_when_better_in(std::size_t better) {
  std::vector<ScenarioFile> scenarios;
  std::vector<RunRecord> runs;
  for (std::size_t s = 0; s < 9; ++s) {
    scenarios.push_back(open_ground("s" + std::to_string(s)));
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      runs.push_back(made_up_run("rrt-opt-euc", seed, 100.0, 0.001));
      runs.back().scenario = s;
      runs.push_back(made_up_run("rrt-opt-hlut-2", seed, s < better ? 50.0 : 100.0, 0.002));
      runs.back().scenario = s;
    }
    for (const std::string planner : {"rrt-opt-euc", "rrt-opt-hlut-2"}) {
      runs.push_back(profiled_run(planner, 25, 100.0));
      runs.back().scenario = s;
    }
  }
  return findings(summary_of(scenarios, runs), scenarios);
}

TEST(Findings, SayWhatIsLeftOfTheThesisClaims) {
  const std::vector<Finding> five = findings_when_better_in(5);
  ASSERT_EQ(five.size(), 3U);
  EXPECT_FALSE(five[0].holds);
  EXPECT_TRUE(findings_when_better_in(6)[0].holds);
  EXPECT_EQ(five[0].found,
            "At most in 5 of 9, by rrt-opt-hlut-2; worse in 0, no difference in 4. All scenarios "
            "together better beyond chance: rrt-opt-hlut-2 (56 % of the pairs better, 0 % worse)");
  EXPECT_FALSE(five[1].holds);
  EXPECT_EQ(five[1].found,
            "First solution: at best nothing beyond chance; at worst +100 % by "
            "rrt-opt-hlut-2 in s0. Whole run: at best nothing beyond chance; at worst nothing "
            "beyond chance");
  EXPECT_FALSE(five[2].holds);  // 50 % better, not 90 %
}

TEST(Findings, SayWhy) {
  const std::vector<Finding> five = findings_when_better_in(5);
  EXPECT_EQ(five[0].why,
            "OPT: of 225 pairs 56 % end better, 0 % worse, 44 % with exactly the cost of Euclid. "
            "The tables have entries for 0.24 to 2.1 % of the pairs of samples (median scenario) "
            "and are Euclid for the others.");
  EXPECT_EQ(five[1].why,
            "OPT: an iteration takes 1.00 times as long as with Euclid and solves 3.0 exact "
            "lengths instead of 3.0; ranking is 50 % of the time instead of 50 %.");
  EXPECT_EQ(five[2].why, "OPT: 100 % of the runs are solved with a table, 100 % with Euclid.");
}

TEST(Findings, TablesCoverWhatLiesWithinTheirExtent) {
  Scenario scenario = open_ground("s").scenario;  // 400 m by 400 m
  const auto coverage = [&](int number) {
    return table_coverage(make_problem(scenario), Region::bounds, number);
  };
  EXPECT_NEAR(coverage(1), 0.049375 * 0.049375, 1e-12);
  EXPECT_NEAR(coverage(4), 0.144375 * 0.144375, 1e-12);
  scenario.vehicle.min_turning_radius *= 2.0;  // a table scales with the vehicle
  EXPECT_NEAR(coverage(1), 0.0975 * 0.0975, 1e-12);
  scenario.bounds = {0.0, 50.0, 0.0, 50.0};
  EXPECT_EQ(coverage(4), 1.0);
}

// In one scenario the table is better with every seed below `better`, else worse.
Summary summary_when_better(std::uint64_t better) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    runs.push_back(made_up_run("rrt-bsc-euc", seed, 100.0));
    runs.push_back(made_up_run("rrt-bsc-hlut-1", seed, seed < better ? 50.0 : 110.0));
    runs.push_back(made_up_run("anytime", seed, 40.0));
  }
  return summary_of({open_ground("s")}, runs);
}

TEST(Findings, PoolAllScenariosByTheSignTest) {
  EXPECT_EQ(pooled(summary_when_better(20), Region::bounds).at(0).verdict, Verdict::no_difference);
  EXPECT_EQ(pooled(summary_when_better(26), Region::bounds).at(0).verdict, Verdict::no_difference);
  EXPECT_EQ(pooled(summary_when_better(28), Region::bounds).at(0).verdict, Verdict::smaller);
  const Pooled worse = pooled(summary_when_better(10), Region::bounds).at(0);
  EXPECT_EQ(worse.verdict, Verdict::larger);
  EXPECT_EQ(worse.pairs, 40);
  EXPECT_EQ(worse.cheaper, 10);
  EXPECT_EQ(worse.dearer, 30);
  EXPECT_DOUBLE_EQ(worse.ratio, 1.1);
  EXPECT_EQ(worse.exact_solves, 3.0);
  EXPECT_EQ(worse.runs, 40);
  EXPECT_EQ(worse.twin_solved, 40);
  EXPECT_EQ(pooled(summary_when_better(10), Region::scene).size(), 0U);
}

TEST(Findings, BeginWithTheAnswer) {
  const std::vector<ScenarioFile> files = {open_ground("s")};
  EXPECT_EQ(headline(summary_when_better(32), files, Region::bounds),
            "anytime ends with the shortest paths (medians) in 1 of 1 scenarios. Best random tree: "
            "rrt-bsc-hlut-1, in 1 of 1. As printed: with HLUT-1, paths of BSC in s change most: "
            "-50 % against Euclid. Over all scenarios BSC ends better with 1 of 1 tables, worse "
            "with 0.");
  EXPECT_EQ(headline(summary_when_better(32), files, Region::scene), "");
  const Summary nothing = summary_of(files, {made_up_run("anytime", 1, {})});
  EXPECT_EQ(headline(nothing, files, Region::bounds),
            "No planner solves half of its runs in any scenario.");
  const std::string none = headline(summary_when_better(20), files, Region::bounds);
  EXPECT_NE(none.find("no table makes paths shorter in any one scenario"), std::string::npos)
      << none;
}

TEST(Findings, SayHowManyMoreRunsATableSolves) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    runs.push_back(made_up_run("rrt-bsc-euc", seed, seed < 3 ? std::optional(90.0) : std::nullopt));
    runs.push_back(made_up_run("rrt-bsc-hlut-2", seed, 90.0));
  }
  const std::vector<ScenarioFile> files = {open_ground("narrow")};
  const std::string text = headline(summary_of(files, runs), files, Region::bounds);
  EXPECT_NE(text.find("As printed: with HLUT-2, BSC finds a path in narrow in 100 % of the runs, "
                      "with Euclid in 12 %. Over"),
            std::string::npos)
      << text;
}

// The table is better as printed, and worse with the goal tried.
TEST(Findings, JudgeEverySettingAndRegionOnItsOwn) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    for (const Region region : {Region::bounds, Region::scene}) {
      for (const auto& [planner, cost] : {std::pair("rrt-bsc-euc", 100.0),
                                          {"rrt-bsc-hlut-2", 9.0},
                                          {"rrt-bsc-euc-goal", 100.0},
                                          {"rrt-bsc-hlut-2-goal", 110.0}}) {
        runs.push_back(made_up_run(planner, seed, cost));
        runs.back().region = region;
      }
    }
  }
  const std::vector<ScenarioFile> scenarios = {open_ground("s")};
  const std::vector<Finding> found = findings(summary_of(scenarios, runs), scenarios);
  ASSERT_EQ(found.size(), 12U);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(found[i].where.setting, i < 6 ? GoalSetting::sampled : GoalSetting::tried);
    EXPECT_EQ(found[i].where.region, i / 3 % 2 == 0 ? Region::bounds : Region::scene);
    EXPECT_EQ(found[i].holds, i < 6 && i % 3 != 1) << i;  // no time is saved
  }
  const std::vector<std::string> sentences = verdicts(found);
  EXPECT_EQ(
      sentences,
      (std::vector<std::string>{
          "The thesis claims better paths in at least six of nine scenarios: confirmed as "
          "printed (bounds, scene).",
          "The thesis claims up to 20 % less time: not confirmed.",
          "The thesis claims up to 90 % better path: confirmed as printed (bounds, scene)."}));
}

TEST(Findings, WriteRatiosAsChanges) {
  EXPECT_EQ(change_text(1.0), "0 %");
  EXPECT_EQ(change_text(0.875), "-12 %");
  EXPECT_EQ(change_text(1.034), "+3.4 %");
  EXPECT_EQ(change_text(8.1), "x 8.1");
  EXPECT_EQ(change_text(0.0), "from unsolved to solved");
  EXPECT_EQ(change_text(infinity), "from solved to unsolved");
}

}  // namespace
}  // namespace vandplan::evaluation

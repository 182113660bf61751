// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/report.h"

#include <gtest/gtest.h>

#include <sstream>
#include <utility>

#include "evaluation/runner.h"
#include "support/made_up_runs.h"
#include "support/temporary_folder.h"
#include "vandplan/input_error.h"

namespace vandplan::evaluation {
namespace {

Campaign reported_campaign() {
  Campaign campaign{.planners = {planner_named("rrt-bsc-euc"), planner_named("rrt-bsc-hlut-1")},
                    .repeats = 3,
                    .repeats_per_goal = 2,
                    .profile = true};
  campaign.scenarios = {{open_ground("one</script>"), "one.yaml"},
                        {open_ground("row", 2), "r.yaml"}};
  campaign.settings = {{"max_nodes", "300"}};
  return campaign;
}

void limit(Campaign& campaign, int iterations) {
  std::erase_if(campaign.settings,
                [](const Setting& setting) { return setting.name == "max_iterations"; });
  campaign.settings.push_back({"max_iterations", std::to_string(iterations)});
}

std::string shared_value(const Report& report, const std::string& name) {
  for (const auto& [option, value] : report.options.shared)
    if (option == name) return value;
  return "none";
}

// Runs planners for `seconds` each, plans again by the command of each run, and returns how many of
// the runs have a path.
int paths_repeated(double seconds) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = reported_campaign();
  campaign.settings = {
      {"time_limit", std::to_string(seconds)}, {"goal_bias", "0.2"}, {"max_nodes", "100000"}};
  run_campaign(campaign, store, {});
  const Report report = make_report(store);
  int solved = 0;
  for (RunRecord run : report.runs) {
    store.read_segments(run);
    // vandplan plan FILE --planner NAME --seed N ... as `plan` would read it.
    std::istringstream words(reproduce_command(report, run));
    std::string word, file, planner;
    words >> word >> word >> file >> word >> planner;
    EXPECT_EQ(file, report.files[run.scenario].file);
    PlanOptions options;
    for (std::string flag, value; words >> flag >> value;) {
      const auto set = [&](const std::string& name, const std::string& text) {
        set_option(options, planner_named(planner), name, text);
      };
      if (flag == "--seed") set("seed", value);
      if (flag == "--max-iterations") set("max_iterations", value);
      if (flag != "--set") continue;
      set(value.substr(0, value.find('=')), value.substr(value.find('=') + 1));
    }
    const Problem problem = make_problem(scenario_at(report.scenarios[run.scenario], run.goal));
    const PlanResult again = plan(problem, planner_named(planner), options);
    EXPECT_EQ(counter(again, "nodes"), counter(run.result, "nodes"));
    EXPECT_EQ(again.path.has_value(), run.result.path.has_value());
    if (!again.path || !run.result.path) continue;
    ++solved;
    EXPECT_EQ(again.path->segments, run.result.path->segments);
  }
  return solved;
}

TEST(Report, RepeatsARunThatWasCutByTheClock) {
  // On a slow machine the first limits may leave no run with a path.
  int solved = 0;
  for (double seconds = 0.003; solved <= 10 && seconds < 10.0; seconds *= 4.0)
    solved = paths_repeated(seconds);
  EXPECT_GT(solved, 10);
}

TEST(Report, TellsOfTheRunsOfOneEnvironmentAndOptionsOnly) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = reported_campaign();
  limit(campaign, 30);
  run_campaign(campaign, store, {});
  limit(campaign, 40);
  run_campaign(campaign, store, {});
  const Report last = make_report(store);
  EXPECT_EQ(shared_value(last, "max_iterations"), "40");
  EXPECT_EQ(last.runs.size() * 2, store.runs().size());
  EXPECT_EQ(last.left_out, static_cast<int>(last.runs.size()));
  limit(campaign, 30);
  EXPECT_EQ(make_report(store, campaign).runs.size(), last.runs.size());
  limit(campaign, 50);
  EXPECT_THROW(static_cast<void>(make_report(store, campaign)), InputError);
}

TEST(Report, TellsOfEachPlannerWithTheOptionsItHadLast) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = reported_campaign();
  limit(campaign, 30);
  run_campaign(campaign, store, {});
  const std::size_t half = store.runs().size();
  campaign.settings.push_back({"goal_bias", "0.5"});
  run_campaign(campaign, store, {});
  EXPECT_EQ(make_report(store).runs.size(), half);
  EXPECT_EQ(shared_value(make_report(store), "goal_bias"), "0.5");
  campaign.settings.back().value = "0.05";
  EXPECT_EQ(shared_value(make_report(store, campaign), "goal_bias"), "0.05");
}

TEST(Report, TellsOfWhatAFileHoldsNow) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign before = reported_campaign();
  limit(before, 30);
  Campaign after = before;
  after.scenarios[0].scenario.scenario.obstacles = {{{0, 0}, {1, 0}, {0, 1}}};
  run_campaign(before, store, {});
  run_campaign(after, store, {});
  for (const Campaign& campaign : {before, after}) {
    const Report report = make_report(store, campaign);
    EXPECT_EQ(report.left_out, 16);  // 2 planners, 2 regions, 3 repeats and a profiled run
    for (const RunRecord& run : report.runs) {
      if (report.files[run.scenario].file != "one.yaml") continue;
      EXPECT_EQ(report.scenarios[run.scenario].scenario.obstacles,
                campaign.scenarios[0].scenario.scenario.obstacles);
    }
  }
  EXPECT_EQ(make_report(store).left_out, 16);
}

TEST(Report, TellsOfAFileByTheRunsThatItCompares) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign before = reported_campaign();
  limit(before, 30);
  Campaign after = before;
  after.scenarios[0].scenario.scenario.obstacles = {{{0, 0}, {1, 0}, {0, 1}}};
  limit(after, 20);
  run_campaign(before, store, {});
  const std::size_t runs = store.runs().size();
  run_campaign(after, store, {});
  before.scenarios.erase(before.scenarios.begin());
  const Report report = make_report(store, before);  // as the first file was with these options
  EXPECT_EQ(report.runs.size(), runs);
}

TEST(Report, IsOnePageWithEverythingInIt) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = reported_campaign();
  limit(campaign, 100);
  run_campaign(campaign, store, {});
  const Report report = make_report(store);
  const std::string page = report_html(report, gallery_png(report));
  EXPECT_EQ(page.find("one</script>"), std::string::npos);  // text must not end the script
  EXPECT_NE(page.find("one\\u003c/script>"), std::string::npos);
  EXPECT_NE(page.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  EXPECT_NE(page.find("Michael Bostock"), std::string::npos);
  for (const char* const elsewhere : {"<link rel=\"stylesheet\"", "<script src", "@import"})
    EXPECT_EQ(page.find(elsewhere), std::string::npos) << elsewhere;
  for (const char* const mark : {"/*STYLE*/", "/*D3*/", "/*DATA*/", "/*PROGRAM*/", "<!--"})
    EXPECT_EQ(page.find(mark), std::string::npos) << mark;
}

TEST(Report, ListsAPartOfVeryManyRuns) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  constexpr int count = 20100;  // more than a page lists
  const std::size_t environment = store.index_of(this_environment());
  const std::size_t scenario = store.index_of(stored(open_ground("wide"), "wide.yaml"));
  for (int i = 0; i < count; ++i) {
    // The best is one of those that would be left out.
    RunRecord run =
        made_up_run("rrt-bsc-euc", static_cast<std::uint64_t>(i) + 1, i == 777 ? 40.0 : 50.0 + i);
    run.environment = environment;
    run.scenario = scenario;
    store.add(run);
  }
  const Report report = make_report(store);
  const std::string page = report_html(report, "");
  int rows = 0;
  for (std::size_t at = page.find("vandplan plan wide"); at != std::string::npos;
       at = page.find("vandplan plan wide", at + 1))
    ++rows;
  EXPECT_GE(rows, count / 2);
  EXPECT_LE(rows, count / 2 + 2);  // every other one, the best and the middle one
  EXPECT_NE(page.find("--seed 778 "), std::string::npos);
  EXPECT_NE(page.find("\"all_runs\":20100"), std::string::npos);
  // The example's path was read, and it points to its row.
  EXPECT_NE(page.find("\"best\":{\"run\":389,\"segments\":[[0,40]]}"), std::string::npos);
}

TEST(Report, IsATableInTheTerminal) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = reported_campaign();
  limit(campaign, 100);
  run_campaign(campaign, store, {});
  const Report report = make_report(store);
  const std::string headline = headline_markdown(report);
  EXPECT_NE(headline.find("| planner        | one\\</script> |"), std::string::npos) << headline;
  EXPECT_NE(headline.find("| rrt-bsc-hlut-1 |"), std::string::npos);
  EXPECT_NE(report_markdown(report).find("## row, samples from the scene"), std::string::npos);
}

TEST(Report, NamesOfOthersAreEscapedInTheText) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = reported_campaign();
  campaign.scenarios = {{open_ground("a|b\n# c\x1b[2J ![d](http://e) <f>"), "one.yaml"}};
  campaign.repeats = 1;
  limit(campaign, 30);
  run_campaign(campaign, store, {});
  const Report report = make_report(store, campaign);
  for (const std::string& text : {report_markdown(report), headline_markdown(report)}) {
    EXPECT_NE(text.find("a\\|b\\x0a# c\\x1b\\[2J !\\[d\\](http://e) \\<f>"), std::string::npos)
        << text;
    EXPECT_EQ(text.find("a|b"), std::string::npos);
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
  }
  EXPECT_FALSE(gallery_png(report).empty());
}

TEST(Report, CommandsToRepeatARunQuoteWhatAShellWouldRead) {
  const TemporaryFolder folder;
  Campaign campaign = reported_campaign();
  campaign.repeats = 1;
  campaign.planners[0].name = "mine; ls";
  int stores = 0;
  for (const auto& [file, word] :
       {std::pair<std::string, std::string>{"my yard's.yaml", "'my yard'\\''s.yaml'"},
        {"-o", "./-o"},
        {"$(id)\n.yaml", "$'$(id)\\x0a.yaml'"},
        {"plain/1.yaml", "plain/1.yaml"}}) {
    campaign.scenarios = {{open_ground(file), file}};
    Store store = Store::create(folder / std::to_string(++stores));
    run_campaign(campaign, store, {});
    const Report report = make_report(store, campaign);
    const std::string theirs = reproduce_command(report, report.runs.front());
    const std::string ours = reproduce_command(report, report.runs.back());
    for (const std::string& command : {theirs, ours})
      EXPECT_NE(command.find(" " + word + " --planner "), std::string::npos) << command;
    EXPECT_NE((theirs + ours).find("--planner 'mine; ls' --seed"), std::string::npos) << theirs;
  }
}

TEST(Report, CommandsToRepeatARunSayHowItSteers) {
  const TemporaryFolder folder;
  Campaign campaign = reported_campaign();
  campaign.repeats = 1;
  campaign.planners = {planner_named("rrt-bsc-euc"), planner_named("anytime")};
  const auto commands = [&](const std::string& file) {
    limit(campaign, 30);
    Store store = Store::create(folder / file);
    run_campaign(campaign, store, {});
    const Report report = make_report(store, campaign);
    std::vector<std::string> all;
    for (const RunRecord& run : report.runs) all.push_back(reproduce_command(report, run));
    return all;
  };
  for (const std::string& command : commands("usual"))
    EXPECT_EQ(command.find("steering"), std::string::npos) << command;
  campaign.settings.push_back({"steering", "continuous-between-stops"});
  for (const std::string& command : commands("asked for"))
    EXPECT_NE(command.find(" --set steering=continuous-between-stops"), std::string::npos)
        << command;
}

TEST(Report, PutsTheLongerListDown) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = reported_campaign();
  limit(campaign, 30);
  campaign.scenarios.push_back({open_ground("third"), "3.yaml"});
  run_campaign(campaign, store, {});
  const std::string headline = headline_markdown(make_report(store));
  EXPECT_NE(headline.find("| scenario      | rrt-bsc-euc | rrt-bsc-hlut-1 |"), std::string::npos)
      << headline;
  EXPECT_NE(headline.find("\n| third "), std::string::npos);
}

// Width and height [pixels], from the head of the file.
std::pair<int, int> size_of(const std::string& png) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = 256 * value + static_cast<unsigned char>(png.at(i));
    return value;
  };
  return {number(16), number(20)};
}

TEST(Report, HasAGalleryWithACellForEachScenario) {
  const TemporaryFolder folder;
  Campaign campaign{
      .planners = {planner_named("rrt-bsc-euc")}, .regions = {Region::bounds}, .repeats = 1};
  limit(campaign, 50);
  const auto gallery_of = [&](int scenarios) {
    campaign.scenarios.clear();
    for (int i = 0; i < scenarios; ++i) {
      ScenarioFile scenario = open_ground("number " + std::to_string(i));
      if (i % 2 == 1)
        scenario.scenario.obstacles = {{{39, 29}, {41, 29}, {40, 31}}};  // on the goal: no path
      campaign.scenarios.push_back({scenario, std::to_string(i) + ".yaml"});
    }
    Store store = Store::create(folder / (std::to_string(scenarios) + ".sqlite"));
    run_campaign(campaign, store, {});
    return size_of(gallery_png(make_report(store, campaign)));
  };
  const auto [width, row] = gallery_of(1);  // and the legend
  const int cell = gallery_of(4).second - row;
  EXPECT_GT(cell, 250);
  EXPECT_EQ(gallery_of(3), std::pair(width, row));
  EXPECT_EQ(gallery_of(9), std::pair(width, row + 2 * cell));
  EXPECT_EQ(gallery_of(10), std::pair(width / 3 * 4, row + 2 * cell));
  EXPECT_EQ(gallery_of(33), std::pair(2 * width, row + 5 * cell));
}

TEST(Report, SaysWhichOptionsDiffer) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign = reported_campaign();
  campaign.planners.push_back(planner_named("rrt-bsc-euc-goal"));
  limit(campaign, 30);
  run_campaign(campaign, store, {});
  const Report report = make_report(store);
  EXPECT_EQ(shared_value(report, "max_nodes"), "300");
  EXPECT_EQ(shared_value(report, "try_goal"), "none");
  ASSERT_EQ(report.options.differing.size(), 2U);
  EXPECT_EQ(report.options.differing[0].name, "try_goal");
  EXPECT_EQ(report.options.differing[0].value, "false");
  EXPECT_EQ(report.options.differing[0].planners.size(), 2U);
  EXPECT_NE(headline_markdown(report).find("`try_goal` is true for rrt-bsc-euc-goal.\n"),
            std::string::npos);
}

TEST(Report, TellsOfAllVehiclesWhosePricesDiffer) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  Campaign campaign{.planners = {planner_named("anytime")}, .regions = {Region::bounds}};
  campaign.repeats = 1;
  campaign.scenarios = {{open_ground("truck"), "truck.yaml"}, {open_ground("robot"), "robot.yaml"}};
  campaign.scenarios[1].scenario.scenario.vehicle.min_turning_radius = 3.5;
  campaign.settings = {{"style", "driver"}};
  limit(campaign, 30);
  run_campaign(campaign, store, {});
  for (const Report& report : {make_report(store), make_report(store, campaign)}) {
    EXPECT_EQ(report.runs.size(), 2U);
    EXPECT_EQ(report.left_out, 0);
    EXPECT_EQ(shared_value(report, "gear_change_cost"), "\"5 or 2.5, by the vehicle\"");
    EXPECT_EQ(shared_value(report, "reverse_weight"), "2");
  }
  // A setting of its own makes other runs of one planner, whatever the vehicle.
  campaign.scenarios.pop_back();
  campaign.settings.push_back({"margin", "0.2"});
  run_campaign(campaign, store, {});
  EXPECT_EQ(make_report(store).left_out, 2);
}

TEST(Report, OfNothingIsRefused) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  EXPECT_THROW(static_cast<void>(make_report(store)), InputError);
}

}  // namespace
}  // namespace vandplan::evaluation

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "support/process.h"
#include "support/shared_files.h"
#include "support/yard.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

using Json = nlohmann::json;

class PlanCommand : public testing::Test {
 protected:
  void SetUp() override { write_content(scenario_, yard()); }

  Outcome plan(std::vector<std::string> options) {
    options.insert(options.begin(), {"plan", scenario_});
    return run_vandplan(options);
  }

  /// The `path` of the result as text.
  std::string planned_path(const std::string& planner, const std::string& seed) {
    const Outcome outcome =
        plan({"--json", "--max-iterations", "300", "--planner", planner, "--seed", seed});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out).at("path").dump();
  }

  TemporaryFolder folder_;
  const std::string scenario_ = folder_ / "yard.yaml";
};

TEST_F(PlanCommand, SummaryNamesPlannerAndOutcome) {
  const Outcome outcome = plan({"--planner", "rrt-opt-rs-goal", "--max-iterations", "300"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out.substr(0, 44), "yard, rrt-opt-rs-goal, seed 1\nsolved: length");
  EXPECT_NE(outcome.out.find(", in reverse "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(", clearance "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find(" 0.000"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("gap"), std::string::npos) << "proven by nobody: " << outcome.out;
}

TEST_F(PlanCommand, TheScenarioMayWantOptions) {
  write_content(scenario_, yard() + "options: {margin: 0.4, gear_change_cost: 2}\n");
  const auto options_of = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--json", "--max-iterations", "300"});
    return Json::parse(plan(options).out).at("options");
  };
  EXPECT_EQ(options_of({}).at("margin"), 0.4);
  EXPECT_EQ(options_of({}).at("gear_change_cost"), 2);
  EXPECT_EQ(options_of({"--set", "margin=0"}).at("margin"), 0);
  const Outcome outcome = plan({"--planner", "rrt-opt-rs-goal", "--max-iterations", "300"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "vandplan: warning: " + scenario_ +
                             ":8: options.gear_change_cost: rrt-opt-rs-goal does not honour it\n");
}

TEST_F(PlanCommand, NoPlannerIgnoresTheGearsOfTheScenario) {
  write_content(scenario_, yard() + "options: {gears: forward}\n");
  const Outcome outcome = plan({"--planner", "prm", "--max-iterations", "300"});
  EXPECT_EQ(outcome.status, 2);
  const std::string said = scenario_ + ":8: options.gears: is forward, which prm does not honour";
  EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  const Outcome typed = plan({"--planner", "prm", "--set", "gears=forward"});
  EXPECT_EQ(typed.err.find(scenario_), std::string::npos) << typed.err;
  EXPECT_NE(plan({"--planner", "rrt-opt-rs-goal", "--max-iterations", "300"}).status, 2);
}

TEST_F(PlanCommand, APictureMarksWhatStandsInTheWay) {
  const auto marks = [&](const std::string& from, const std::string& to) {
    write_content(scenario_, replaced(yard(), from, to));
    const std::string picture = folder_ / "hit.svg", result = folder_ / "hit.json";
    const auto is_red = [&] {  // an outline: the colour of nothing else
      return content_of(picture).find("85%,7%,7%") != std::string::npos ||
             content_of(picture).find("85%, 7%, 7%") != std::string::npos;
    };
    EXPECT_EQ(plan({"--max-iterations", "10", "--draw", picture, "--output", result}).status, 1);
    const bool at_once = is_red();
    EXPECT_EQ(run_vandplan({"draw", scenario_, result, "--output", picture}).status, 0);
    EXPECT_EQ(is_red(), at_once) << "from the file of the result";
    return at_once;
  };
  EXPECT_TRUE(marks("start: {x: 0", "start: {x: 10"));
  EXPECT_TRUE(marks("goal: {x: 20", "goal: {x: 51"));
  EXPECT_FALSE(
      marks("[12, -9], [13, -9], [13, 9], [12, 9]", "[12, -99], [13, -99], [13, 99], [12, 99]"));
}

TEST_F(PlanCommand, SummarySaysTheCostAndItsKind) {
  const auto summary = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--max-iterations", "300"});
    return plan(options).out;
  };
  EXPECT_NE(summary({}).find(" m by a driver's prices, "), std::string::npos) << summary({});
  EXPECT_NE(summary({"--set", "style=shortest"}).find(" m by length alone, "), std::string::npos);
  EXPECT_NE(summary({"--set", "gear_change_cost=1"}).find(" m by prices, "), std::string::npos);
  const std::string zones = "zones: [{area: [[-9, 30], [9, 30], [9, 39]], cost: 3}]\n";
  write_content(scenario_, yard() + zones);
  EXPECT_NE(summary({"--set", "style=shortest"}).find(" m by length and the prices of zones, "),
            std::string::npos);
  write_content(scenario_, replaced(yard() + zones, "cost: 3", "gears: forward"));
  EXPECT_NE(summary({"--set", "style=shortest"}).find(" m by length alone, "), std::string::npos);
  write_content(scenario_, yard());
  EXPECT_EQ(summary({"--set", "cost=time"}).find(" by "), std::string::npos);
  write_content(scenario_, replaced(yard(), "radius: 7.0", "radius: 3.0"));
  EXPECT_NE(summary({}).find(" m by a driver's prices for a turning radius of 3 m, "),
            std::string::npos)
      << summary({});
}

TEST_F(PlanCommand, SummarySaysHowFarFromTheShortestAPathMayBe) {
  const Outcome outcome = plan({"--max-iterations", "300"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json result = Json::parse(plan({"--max-iterations", "300", "--json"}).out);
  std::array<char, 40> gap;
  std::snprintf(gap.data(), gap.size(), ", proven: at most %.1f %% above",
                100 * result.at("gap").get<double>());
  EXPECT_NE(outcome.out.find(gap.data()), std::string::npos) << outcome.out;
}

TEST_F(PlanCommand, ManyPairsArePlannedInOneWorld) {
  const std::string poses = folder_ / "poses.csv";
  write_content(poses, "sx,sy,sh,gx,gy,gh\n0,0,0,4,0,0\n0,0,0,0,0,3\n4,0,0,0,0,0\n");
  const std::string file = folder_ / "results.jsonl";
  const Outcome outcome =
      plan({"--poses", poses, "--max-iterations", "300", "--jobs", "2", "--output", file});
  EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  EXPECT_EQ(outcome.out.substr(0, 36), "1: solved: length 4.000 m, gear chan");
  EXPECT_NE(outcome.out.find("yard, anytime: 3 of 3 solved in "), std::string::npos) << outcome.out;
  const std::size_t end = outcome.err.find("100 %");
  EXPECT_NE(end, std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("100 %", end + 1), std::string::npos) << outcome.err;
  std::istringstream lines(content_of(file));
  int pair = 0;
  for (std::string line; std::getline(lines, line);) {
    const Json result = Json::parse(line);
    EXPECT_EQ(result.at("pair"), ++pair);
    EXPECT_EQ(result.at("status"), "solved");
    EXPECT_EQ(result.at("path").at("poses").size() > 0, true);
  }
  EXPECT_EQ(pair, 3);
}

TEST_F(PlanCommand, BinaryResultsAreJudgedAndDrawnLikeOthers) {
  const std::string poses = folder_ / "poses.csv";
  write_content(poses, "0,0,0,4,0,0\n12.5,0,0,0,0,3\n4,0,0,0,0,0\n");
  for (const bool is_many : {false, true}) {
    std::vector<std::string> verdicts;
    for (const std::string& file : {folder_ / "r.vpr", folder_ / "r.json"}) {
      std::vector<std::string> options = {"--max-iterations", "300", "--output", file};
      if (is_many) options.insert(options.end(), {"--poses", poses});
      EXPECT_EQ(plan(options).status, is_many ? 1 : 0);
      verdicts.push_back(run_vandplan({"check", scenario_, file}).out);
      EXPECT_EQ(run_vandplan({"draw", scenario_, file, "-o", folder_ / "r.svg"}).status, 0);
    }
    EXPECT_EQ(verdicts[0], verdicts[1]);
    EXPECT_NE(verdicts[0].find("valid"), std::string::npos) << verdicts[0];
    const std::string bytes = content_of(folder_ / "r.vpr");
    EXPECT_EQ(bytes.substr(0, 8), "vp-plans");
    write_content(folder_ / "r.vpr", bytes.substr(0, bytes.size() - 1));
    const Outcome outcome = run_vandplan({"check", scenario_, folder_ / "r.vpr"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "vandplan: " + (folder_ / "r.vpr") +
                               ": ends too early, in or behind result " + (is_many ? "3" : "1") +
                               ", expected a whole file\n");
  }
}

TEST_F(PlanCommand, ThousandsOfPairsKeepTheirOrder) {
  const std::string poses = folder_ / "poses.csv";
  constexpr int pairs = 4100;  // more than are planned in one go
  std::string rows;
  for (int i = 1; i <= pairs; ++i) rows += "0,0,0," + std::to_string(1 + i % 4) + ",0,0\n";
  write_content(poses, rows);
  const Outcome outcome = plan({"--poses", poses, "--max-iterations", "1", "--jobs", "2"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::string line;
  for (int i = 1; i <= pairs; ++i) {
    std::getline(lines, line);
    const std::string expected =
        std::to_string(i) + ": solved: length " + std::to_string(1 + i % 4) + ".000 m,";
    ASSERT_EQ(line.substr(0, expected.size()), expected);
  }
  std::getline(lines, line);
  EXPECT_TRUE(line.starts_with("yard, anytime: 4100 of 4100 solved in ")) << line;
}

TEST_F(PlanCommand, APairIsPlannedAsIfAlone) {
  const std::string poses = folder_ / "poses.csv";
  write_content(poses, "0,0,0,0,0,3\n0,0,0,20,5,0\n");
  const Outcome many = plan({"--poses", poses, "--max-iterations", "300", "--jobs", "2", "--json"});
  const std::size_t second = many.out.find("\n") + 1;
  ASSERT_EQ(many.status, 0) << many.err;
  EXPECT_EQ(Json::parse(many.out.substr(second)).at("path").dump(), planned_path("anytime", "1"));
}

TEST_F(PlanCommand, ShardsOfPairsAreTheWholeListOnce) {
  const std::string poses = folder_ / "poses.csv";
  std::string rows;
  for (int i = 1; i <= 12; ++i) rows += "0,0,0," + std::to_string(0.25 * i) + ",0,0\n";
  write_content(poses, rows);
  std::vector<double> lengths(12);
  std::size_t found = 0, parts = 0;
  for (const char* const part : {"1/3", "2/3", "3/3"}) {
    const Outcome outcome =
        plan({"--poses", poses, "--max-iterations", "1", "--shard", part, "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    parts += outcome.out.empty() ? 0U : 1U;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line); ++found) {
      const Json result = Json::parse(line);
      lengths.at(result.at("pair").get<std::size_t>() - 1) = result.at("length").get<double>();
    }
  }
  EXPECT_EQ(found, 12U);
  EXPECT_GT(parts, 1U);
  for (std::size_t i = 0; i < lengths.size(); ++i)
    EXPECT_NEAR(lengths[i], 0.25 * static_cast<double>(i + 1), 1e-9);
  EXPECT_EQ(plan({"--poses", poses, "--shard", "4/3"}).status, 2);
  EXPECT_EQ(plan({"--shard", "1/3"}).status, 2);  // of what?
}

TEST_F(PlanCommand, AShardWithoutPairsIsEmpty) {
  const std::string poses = folder_ / "poses.csv";
  write_content(poses, "0,0,0,4,0,0\n");
  int empty = 0;
  for (const char* const part : {"1/2", "2/2"}) {
    const Outcome outcome = plan({"--poses", poses, "--max-iterations", "1", "--shard", part});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    empty += outcome.out.starts_with("yard, anytime: 0 of 0 solved") ? 1 : 0;
  }
  EXPECT_EQ(empty, 1);
}

TEST_F(PlanCommand, WithoutLimitsItRunsForASecondAtMost) {
  const Outcome outcome = plan({"--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out).at("options").at("time_limit"), 1.0);
}

TEST_F(PlanCommand, JsonIsTheResultFile) {
  const std::string file = folder_ / "result.json";
  const Outcome outcome = plan({"--json", "--max-iterations", "300", "--output", file});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, content_of(file));
  const Json result = Json::parse(outcome.out);
  EXPECT_EQ(result.at("format"), "vandplan-result/1");
  EXPECT_EQ(result.at("status"), "solved");
  EXPECT_EQ(result.at("options").at("max_iterations"), 300);
}

TEST_F(PlanCommand, FlagsAndSetReachThePlanner) {
  const Outcome outcome = plan({"--json", "--max-iterations", "7", "--max-nodes", "6", "--seed",
                                "5", "--region", "scene", "--set", "goal_bias=0.5", "--set",
                                "max_parents=3", "--planner", "rrt-bsc-euc"});
  const Json result = Json::parse(outcome.out);
  EXPECT_EQ(result.at("planner"), "rrt-bsc-euc");
  EXPECT_EQ(result.at("seed"), 5);
  const Json& options = result.at("options");
  EXPECT_EQ(options.at("max_iterations"), 7);
  EXPECT_EQ(options.at("max_nodes"), 6);
  EXPECT_EQ(options.at("region"), "scene");
  EXPECT_EQ(options.at("goal_bias"), 0.5);
  EXPECT_EQ(options.at("max_parents"), 3);
  EXPECT_EQ(options.at("time_limit"), nullptr);
}

TEST_F(PlanCommand, AnIterationBudgetRepeatsThePathToTheByte) {
  for (const std::string& name : {default_planner().name, std::string("rrt-opt-euc-goal")}) {
    EXPECT_TRUE(planned_path(name, "1") == planned_path(name, "1")) << name;
  }
  EXPECT_FALSE(planned_path("rrt-opt-euc-goal", "1") == planned_path("rrt-opt-euc-goal", "2"));
}

TEST_F(PlanCommand, ScenarioComesFromStandardInputToo) {
  const std::vector<std::string> budget = {"--json", "--max-iterations", "300"};
  const Outcome from_file = plan(budget);
  const Outcome piped =
      run_vandplan({"plan", "-", "--json", "--max-iterations", "300"}, {.input = scenario_});
  ASSERT_EQ(piped.status, 0) << piped.err;
  EXPECT_EQ(Json::parse(piped.out).at("path"), Json::parse(from_file.out).at("path"));
}

TEST_F(PlanCommand, ResultAndPictureAreWritten) {
  const std::string result = folder_ / "result.json";
  const std::string picture = folder_ / "picture.svg";
  write_content(result, "old");
  ASSERT_EQ(plan({"--max-iterations", "300", "--output", result, "--draw", picture}).status, 0);
  EXPECT_EQ(Json::parse(content_of(result)).at("status"), "solved");
  EXPECT_NE(content_of(picture).find("<svg"), std::string::npos);
}

// ---- statuses ----

struct NoPath {
  const char* status;
  const char* reason;
  const char* from;
  const char* to;
  std::vector<std::string> options;
};

class PlanCommandWithoutPath : public PlanCommand, public testing::WithParamInterface<NoPath> {};

TEST_P(PlanCommandWithoutPath, ExitsWithOneAndNamesTheStatus) {
  const NoPath& no_path = GetParam();
  write_content(scenario_, replaced(yard(), no_path.from, no_path.to));
  const Outcome text = plan(no_path.options);
  EXPECT_EQ(text.status, 1);
  EXPECT_EQ(text.err, "");
  const std::string reason = no_path.reason;
  const std::string why = reason.empty() ? "; " : " (" + reason + "); ";
  EXPECT_NE(text.out.find(std::string("no path: ") + no_path.status + why), std::string::npos)
      << text.out;

  std::vector<std::string> options = no_path.options;
  options.push_back("--json");
  const Outcome json = plan(options);
  EXPECT_EQ(json.status, 1);
  const Json result = Json::parse(json.out);
  EXPECT_EQ(result.at("status"), no_path.status);
  EXPECT_EQ(result.value("reason", ""), reason);
  EXPECT_FALSE(result.contains("path"));
  EXPECT_FALSE(result.contains("length"));
}

INSTANTIATE_TEST_SUITE_P(
    Statuses, PlanCommandWithoutPath,
    testing::Values(NoPath{"start_in_collision",
                           "the footprint hits obstacles[0]",
                           "start: {x: 0",
                           "start: {x: 10",
                           {}},
                    NoPath{"start_in_collision",
                           "the rear axle is 10 m outside the bounds",
                           "start: {x: 0",
                           "start: {x: -60",
                           {}},
                    NoPath{"goal_in_collision",
                           "the footprint hits obstacles[0]",
                           "goal: {x: 20, y: 5",
                           "goal: {x: 9, y: -2",
                           {}},
                    NoPath{"goal_in_collision",
                           "the rear axle is 1 m outside the bounds",
                           "goal: {x: 20",
                           "goal: {x: 51",
                           {}},
                    NoPath{"iteration_limit", "", "", "", {"--max-iterations", "0"}},
                    NoPath{"time_limit", "", "", "", {"--time", "0"}},
                    NoPath{"no_path",
                           "proven: nothing as wide as the vehicle gets from the start to the goal",
                           "[12, -9], [13, -9], [13, 9], [12, 9]",
                           "[12, -60], [13, -60], [13, 60], [12, 60]",
                           {}},
                    // Shut in by walls, so that the tree fills up.
                    NoPath{"node_limit",
                           "",
                           "[12, -9], [13, -9], [13, 9], [12, 9]",
                           "[12, -60], [13, -60], [13, 60], [12, 60]",
                           {"--planner", "rrt-opt-euc", "--max-nodes", "5", "--max-iterations",
                            "100000"}}));

TEST_F(PlanCommand, RowOfGoalsNamesTheFurthestReached) {
  write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5, heading: 0}",
                                    "goals:\n"
                                    "  - {distance: 20, goal: {x: 20, y: 5, heading: 0}}\n"
                                    "  - {distance: 30, goal: {x: 30, y: 5, heading: 0}}\n"
                                    "  - {distance: 60, goal: {x: 60, y: 5, heading: 0}}"));
  const std::string picture = folder_ / "row.png";
  const Outcome text = plan({"--max-iterations", "200", "--draw", picture});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("60 m: no path: goal_in_collision"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("furthest: 30 m\n"), std::string::npos) << text.out;
  EXPECT_TRUE(std::filesystem::exists(picture));

  const Json result = Json::parse(plan({"--max-iterations", "200", "--json"}).out);
  EXPECT_EQ(result.at("furthest"), 30);
  EXPECT_EQ(result.at("goals").size(), 3);

  EXPECT_EQ(plan({"--max-iterations", "0"}).status, 1);
}

// ---- options ----

TEST_F(PlanCommand, AnOptionThatThePlannerDoesNotHonourIsRefused) {
  const Outcome flag = plan({"--max-nodes", "5000"});  // the default of those that have it
  EXPECT_EQ(flag.status, 2);
  EXPECT_EQ(flag.err.substr(0, 60), "vandplan: --max-nodes: is no option of anytime, expected one");
  EXPECT_NE(flag.err.find("rrt-... (28), "), std::string::npos) << flag.err;
  EXPECT_EQ(flag.err.find('\n'), flag.err.size() - 1);

  const Outcome key = plan({"--set", "reverse_weight=2", "--planner", "rrt-bsc-euc"});
  EXPECT_EQ(key.status, 2);
  EXPECT_EQ(key.err,
            "vandplan: reverse_weight: is no option of rrt-bsc-euc, expected one of the planners "
            "that honour it: anytime, hybrid-a-star\n");
}

TEST_F(PlanCommand, TheSteeringIsAnOption) {
  const auto steering_of = [&](const std::string& planner, std::vector<std::string> options) {
    options.insert(options.end(), {"--json", "--max-iterations", "0", "--planner", planner});
    const Outcome outcome = plan(options);
    EXPECT_EQ(outcome.err, "");
    return Json::parse(outcome.out).at("options").at("steering");
  };
  EXPECT_EQ(steering_of("rrt-bsc-euc", {}), "reeds-shepp");
  EXPECT_EQ(steering_of("rrt-bsc-euc", {"--set", "steering=continuous-between-stops"}),
            "continuous-between-stops");
  EXPECT_EQ(steering_of("anytime", {"--set", "steering=continuous", "--set", "style=shortest"}),
            "continuous");
}

TEST_F(PlanCommand, TimeBesideAStyleIsTheFastestDriveInEitherOrder) {
  const auto rule = [&](const char* of_file, const std::vector<std::string>& settings) {
    write_content(scenario_, yard() + of_file);
    std::vector<std::string> arguments = {"--json", "--max-iterations", "0"};
    for (const std::string& setting : settings) {
      arguments.insert(arguments.end(), {"--set", setting});
    }
    const Outcome outcome = plan(arguments);
    EXPECT_EQ(outcome.err, "");
    const Json options = Json::parse(outcome.out).at("options");
    return options.at("cost").get<std::string>() + ", " + options.at("steering").get<std::string>();
  };
  const std::string fastest = "time, reeds-shepp";
  EXPECT_EQ(rule("", {"cost=time", "style=shortest"}), fastest);
  EXPECT_EQ(rule("", {"style=shortest", "cost=time"}), fastest);
  EXPECT_EQ(rule("options: {cost: time, style: shortest}\n", {}), fastest);
  EXPECT_EQ(rule("options: {style: shortest, cost: time}\n", {}), fastest);
  // What is typed replaces what the file says.
  EXPECT_EQ(rule("options: {style: shortest}\n", {"cost=time"}), fastest);
  EXPECT_EQ(rule("options: {cost: time}\n", {"style=shortest"}), "prices, reeds-shepp");
}

TEST_F(PlanCommand, OptionsOfEveryFamilyAreListed) {
  const Outcome help = run_vandplan({"planners", "--options"});
  EXPECT_EQ(help.status, 0);
  for (const Planner& planner : planners()) {
    for (const OptionInfo& info : planner.options) {
      EXPECT_NE(help.out.find("\n  " + info.name + "="), std::string::npos) << info.name;
    }
  }
  EXPECT_NE(help.out.find("try_goal=false|true "), std::string::npos) << help.out;
}

// ---- what reads odd ----

TEST_F(PlanCommand, AHeadingBeyondAFullTurnIsDoubtedAndPlanned) {
  write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5, heading: 0}",
                                    "goal: {x: 20, y: 5, heading: 12.5663706}"));
  const Outcome outcome = plan({"--max-iterations", "300"});
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_EQ(outcome.err.substr(0, 19), "vandplan: warning: ");
  EXPECT_NE(outcome.err.find("yard.yaml:5: goal.heading: is 12.5663706 rad, more than a full turn"),
            std::string::npos)
      << outcome.err;
}

TEST_F(PlanCommand, ControlCharactersOfANameDoNotReachTheTerminal) {
  write_content(scenario_, replaced(yard(), "name: yard", "name: \"\\x1b[31myard\\x9b\""));
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"plan", scenario_, "--max-iterations", "300"},
        std::vector<std::string>{"draw", scenario_, "-o", folder_ / "yard.svg"}}) {
    const Outcome outcome = run_vandplan(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out.substr(0, 16), "\\x1b[31myard\\x9b") << outcome.out;
  }
}

// ---- signals ----

/// Waits until the process handles SIGINT and has computed for a while.
void wait_until_busy(const Process& process) {
  const std::string folder = "/proc/" + std::to_string(process.id());
  const auto field = [&](const std::string& name) {
    const std::string status = content_of(folder + "/status");
    const std::size_t place = status.find(name);
    return place == std::string::npos ? "0" : status.substr(place + name.size());
  };
  const auto handles_signal = [&] {
    return (std::stoull(field("SigCgt:"), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
  };
  const auto processor_time = [&] {  // in ticks, the 14th word of the line
    std::istringstream words(content_of(folder + "/stat"));
    std::string word;
    for (int i = 0; i < 14; ++i) words >> word;
    return std::stol(word);
  };
  const long enough = ::sysconf(_SC_CLK_TCK) / 2;
  while (!handles_signal() || processor_time() < enough) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

TEST_F(PlanCommand, SignalsEndTheRunWithTheBestSoFar) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string file = folder_ / "result.json";
    Process process({"plan", scenario_, "--json", "--time", "1000", "--max-nodes", "10000000",
                     "--planner", "rrt-opt-euc-goal", "--output", file});
    wait_until_busy(process);
    process.send(signal);
    const Outcome outcome = process.wait();
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out).at("status"), "solved");
    EXPECT_EQ(content_of(file), outcome.out);
  }
}

TEST_F(PlanCommand, SignalBeforeTheFirstPathIsNamed) {
  write_content(scenario_, replaced(yard(), "[12, -9], [13, -9], [13, 9], [12, 9]",
                                    "[12, -60], [13, -60], [13, 60], [12, 60]"));
  Process process(
      {"plan", scenario_, "--time", "1000", "--max-nodes", "10000000", "--planner", "rrt-bsc-euc"});
  wait_until_busy(process);
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("no path: stopped"), std::string::npos) << outcome.out;
}

// ---- the nine scenarios ----

TEST(PlanCommandOnThesisScenarios, EveryOneIsReadAndPlanned) {
  const auto files = yaml_files(repository() / "scenarios/thesis");
  EXPECT_EQ(files.size(), 9);
  for (const std::string& file : files) {
    const Outcome outcome = run_vandplan({"plan", file, "--json", "--max-iterations", "20"});
    EXPECT_LE(outcome.status, 1) << file << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out).at("format"), "vandplan-result/1");
  }
}

// ---- streams and files ----

TEST_F(PlanCommand, WithClosedStreamsTheResultIsTheResult) {
  const std::string file = folder_ / "result.json";
  for (const std::vector<int>& closed : {std::vector<int>{1}, {0}, {2}, {0, 1, 2}, {1, 2}}) {
    std::filesystem::remove(file);
    const Outcome outcome = run_vandplan(
        {"plan", scenario_, "--max-iterations", "300", "--output", file}, {.closed = closed});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(Json::parse(content_of(file)).at("status"), "solved");
  }
}

TEST_F(PlanCommand, WarningsThatCannotBePrintedStopNothing) {
  write_content(scenario_, replaced(yard(), "heading: 0}\nobst", "heading: 12.5663706}\nobst"));
  const Outcome outcome =
      run_vandplan({"plan", scenario_, "--max-iterations", "300"}, {.error = "/dev/full"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("solved"), std::string::npos);
}

TEST_F(PlanCommand, ALinkToNothingIsWrittenThrough) {
  std::filesystem::create_symlink("target.json", folder_ / "link.json");
  const std::string link = folder_ / "link.json";
  EXPECT_EQ(plan({"--max-iterations", "300", "--output", link}).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(Json::parse(content_of(folder_ / "target.json")).at("status"), "solved");
}

TEST_F(PlanCommand, AScenarioComesThroughAPipeThatIsOpen) {
  for (const std::string name : {"-", "/dev/stdin"}) {
    const Outcome outcome =
        run_vandplan({"plan", name, "--max-iterations", "300"}, {.input = scenario_});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
}

// ---- far goals ----

// The result is larger than any other file of text may be, and no more of it is held than needs be.
// Where sanitizers keep memory from being limited it is a tenth as large.
TEST_F(PlanCommand, ThePathToAFarGoalIsWrittenAndCheckedInLittleMemory) {
  const std::string far = is_sanitized ? "6000" : "30000";
  write_content(scenario_,
                "name: far\nvehicle: tpcap-car\nbounds: {x: [-1e5, 1e5], y: [-1e5, 1e5]}\n"
                "start: {x: 0, y: 0, heading: 0}\ngoal: {x: " +
                    far + ", y: 12, heading: 0}\nobstacles: []\n");
  ProcessOptions options;
  if (memory_can_be_limited) options.memory = 220'000'000;
  const std::string poses = folder_ / "poses.csv";
  write_content(poses, "0,0,0," + far + ",12,0\n");
  for (const bool is_line : {false, true}) {
    const std::string file = folder_ / (is_line ? "result.jsonl" : "result.json");
    std::vector<std::string> call = {"plan", scenario_, "--max-iterations", "50", "--output", file};
    if (is_line) call.insert(call.end(), {"--poses", poses, "--jobs", "1"});
    const Outcome planned = run_vandplan(call, options);
    ASSERT_EQ(planned.status, 0) << planned.err;
    EXPECT_GT(std::filesystem::file_size(file), std::uintmax_t{is_sanitized ? 6U : 32U} << 20);
    const Outcome checked = run_vandplan({"check", scenario_, file}, options);
    EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
    EXPECT_NE(checked.out.find("valid: length " + far + "."), std::string::npos) << checked.out;
  }
}

}  // namespace
}  // namespace vandplan

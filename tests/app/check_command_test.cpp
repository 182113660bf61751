// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <cmath>

#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/process.h"
#include "support/yard.h"

namespace vandplan {
namespace {

using Json = nlohmann::json;

/// Five metres straight ahead in the yard, as somebody else would write it down.
Json drive_ahead() {
  return Json::parse(R"({
    "format": "vandplan-result/1", "status": "solved", "length": 5, "gear_changes": 0,
    "path": {"start": {"x": 0, "y": 0, "heading": 0},
             "segments": [{"turn": "straight", "length": 3}, {"curvature": 0, "length": 2}]}})");
}

class CheckCommand : public testing::Test {
 protected:
  void SetUp() override {
    write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5,", "goal: {x: 5, y: 0,"));
  }

  Outcome check(const Json& result, const std::vector<std::string>& options = {}) {
    write_content(result_, result.dump());
    std::vector<std::string> arguments = {"check", scenario_, result_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_vandplan(arguments);
  }

  /// What `check` prints about a result that was spoiled.
  std::string verdict(const std::function<void(Json&)>& spoil) {
    Json result = drive_ahead();
    spoil(result);
    const Outcome outcome = check(result);
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }

  TemporaryFolder folder_;
  const std::string scenario_ = folder_ / "yard.yaml";
  const std::string result_ = folder_ / "result.json";
};

TEST_F(CheckCommand, ForeignResultIsJudged) {
  const Outcome outcome = check(drive_ahead());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  // The wall begins at x = 12, the front bumper ends at 10.9.
  EXPECT_EQ(outcome.out,
            "valid: length 5.000 m, gear changes 0, in reverse 0 m, clearance 1.100 m\n");
}

TEST_F(CheckCommand, WhoMovesInTheWayIsNamedWithPlaceAndTime) {
  const auto with_car = [&](const std::string& x) {
    write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5,", "goal: {x: 5, y: 0,") +
                                 "moving:\n  - {outline: [[-1, -1], [1, -1], [1, 1], [-1, 1]], "
                                 "trajectory: [[0, " +
                                 x + ", -8, 0], [8, " + x + ", 8, 0]]}\n");
  };
  with_car("9");  // its nose is at 5.9 m, the other one 1 m wide to each side
  const Outcome hit = check(drive_ahead());
  EXPECT_EQ(hit.status, 1) << hit.err;
  EXPECT_EQ(hit.out.substr(0, 56), "invalid: the footprint hits moving[0] at t = 2.863 s, at");
  with_car("12.5");
  EXPECT_EQ(check(drive_ahead()).out.substr(0, 9), "valid: le");
}

TEST_F(CheckCommand, APlanAmongWhatMovesIsWrittenJudgedAndPlayed) {
  write_content(scenario_, yard() +
                               "moving:\n  - {outline: [[-1, -1], [1, -1], [1, 1], [-1, 1]], "
                               "trajectory: [[0, 9, -8, 0], [8, 9, 8, 0]], after: leaves}\n");
  const Outcome planned =
      run_vandplan({"plan", scenario_, "--max-iterations", "500", "--output", result_});
  EXPECT_EQ(planned.status, 0) << planned.err;
  EXPECT_NE(planned.out.find(" from moving obstacles, first path after "), std::string::npos)
      << planned.out;
  const Outcome checked = run_vandplan({"check", scenario_, result_, "--json"});
  EXPECT_EQ(checked.status, 0) << checked.out;
  EXPECT_GT(Json::parse(checked.out).at("moving_clearance"), 0);
  const std::string film = folder_ / "film.svg";
  EXPECT_EQ(run_vandplan({"draw", scenario_, result_, "--play", "-o", film}).status, 0);
  EXPECT_NE(content_of(film).find("<animateTransform"), std::string::npos);
  EXPECT_EQ(run_vandplan({"draw", scenario_, result_, "--play", "-o", folder_ / "film.png"}).err,
            "vandplan: --play: is for pictures that end in .svg\n");
  EXPECT_EQ(run_vandplan({"plan", scenario_, "--planner", "rrt-opt-rs"}).err,
            "vandplan: moving: is not honoured by rrt-opt-rs, expected one of the planners that "
            "honour it: anytime\n");
}

TEST_F(CheckCommand, TimesOfAResultAreJudged) {
  Json result = drive_ahead();
  const Json start = {{"t", 0}, {"s", 0}, {"v", 0}, {"a", 1}};
  const Json middle = {{"t", 2}, {"s", 2}, {"v", 2}, {"a", 0}};
  const Json brake = {{"t", 2.5}, {"s", 3}, {"v", 2}, {"a", -1}};
  const Json end = {{"t", 4.5}, {"s", 5}, {"v", 0}, {"a", 0}};
  result["speeds"] = {{"duration", 4.5}, {"knots", {start, middle, brake, end}}};
  EXPECT_EQ(check(result).out,
            "valid: length 5.000 m, gear changes 0, in reverse 0 m, clearance 1.100 m, driven in "
            "4.500 s\n");
  result["speeds"]["knots"][1]["v"] = 2.1;
  EXPECT_EQ(check(result).out, "invalid: knots[1] does not follow from the one before\n");
  result["speeds"]["knots"][0]["t"] = 1;
  EXPECT_NE(check(result).err.find("speeds.knots: begin at 1 s, expected 0 s"), std::string::npos);
}

TEST_F(CheckCommand, JsonHoldsTheFigures) {
  const Outcome outcome = check(drive_ahead(), {"--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Json verdict = Json::parse(outcome.out);
  EXPECT_EQ(verdict.at("valid"), true);
  EXPECT_EQ(verdict.at("length"), 5);
  EXPECT_EQ(verdict.at("gear_changes"), 0);
  EXPECT_EQ(verdict.at("reverse_length"), 0);
  EXPECT_NEAR(verdict.at("clearance").get<double>(), 1.1, 1e-3);
}

/// 7 m to the left (1 rad), 2 m back in the same turn, and straight ahead: nowhere near the goal.
Json wander() {
  return Json::parse(R"({"format": "vandplan-result/1",
    "path": {"start": {"x": 0, "y": 0, "heading": 0},
             "segments": [{"turn": "left", "length": 7}, {"turn": "left", "length": -2},
                          {"turn": "straight", "length": 1}]}})");
}

TEST_F(CheckCommand, MetricsSayWhatAPathIsLikeToDrive) {
  const Outcome outcome = check(wander(), {"--metrics", "--speed", "0.5", "--pause", "4"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;  // the path is measured though it is no good
  EXPECT_NE(outcome.out.find("\n  in reverse 20.0 %, turning 1.286 rad, curvature changes 1, "
                             "driven in 28.0 s (at 0.5 m/s, 4 s for each gear change)\n"),
            std::string::npos)
      << outcome.out;
  const Json metrics = Json::parse(check(wander(), {"--metrics", "--json"}).out).at("metrics");
  EXPECT_EQ(metrics.at("length"), 10);
  EXPECT_EQ(metrics.at("gear_changes"), 2);
  EXPECT_EQ(metrics.at("reverse_share"), 0.2);
  EXPECT_NEAR(metrics.at("turning").get<double>(), 9.0 / 7.0, 1e-15);
  EXPECT_EQ(metrics.at("curvature_changes"), 1);
  EXPECT_EQ(metrics.at("driving_time"),
            10 / metrics.at("speed").get<double>() + 2 * metrics.at("pause").get<double>());
}

TEST_F(CheckCommand, MetricsAreAskedForAndNeedASpeed) {
  EXPECT_FALSE(Json::parse(check(wander(), {"--json"}).out).contains("metrics"));
  EXPECT_EQ(check(wander(), {"--speed", "1"}).status, 2);
  EXPECT_EQ(check(wander(), {"--metrics", "--speed", "0"}).err,
            "vandplan: speed: must be > 0 [m/s]\n");
  EXPECT_EQ(check(wander(), {"--metrics", "--pause", "-1"}).err,
            "vandplan: pause: must be >= 0 [s]\n");
}

TEST_F(CheckCommand, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(verdict([](Json& result) { result["path"]["segments"][1]["length"] = 7; }),
            "invalid: the footprint hits obstacles[0] at s = 6.1000 m, where x = 6.1 m, y = 0 m, "
            "heading = 0 rad\n");
  EXPECT_EQ(verdict([](Json& result) { result["path"]["segments"][1]["length"] = 1; }),
            "invalid: the path ends 1 m and 0 rad away at s = 4.0000 m, where x = 4 m, y = 0 m, "
            "heading = 0 rad\n");
  EXPECT_EQ(verdict([](Json& result) { result["path"]["start"]["y"] = 0.5; }),
            "invalid: the path begins 0.5 m and 0 rad away at s = 0.0000 m, where x = 0 m, "
            "y = 0.5 m, heading = 0 rad\n");
  EXPECT_EQ(verdict([](Json& result) { result["length"] = 6; }),
            "invalid: the stated length is 6 m, the path is 5 m long\n");
  EXPECT_EQ(verdict([](Json& result) { result["gear_changes"] = 2; }),
            "invalid: the stated gear changes are 2, the path has 0\n");
  EXPECT_EQ(verdict([](Json& result) {
              result["path"]["segments"][0] = {{"curvature", 0.2}, {"length", 3}};
            }),
            "invalid: curvature 0.2 is tighter than the turning radius of 7 m allows at "
            "s = 0.0000 m, where x = 0 m, y = 0 m, heading = 0 rad\n");
  EXPECT_EQ(verdict([](Json& result) {
              result["path"]["poses"] = {{{"s", 0}, {"x", 0}, {"y", 0.1}, {"heading", 0}}};
            }),
            "invalid: the stated poses[0] is not on the path\n");
}

TEST_F(CheckCommand, TheStatedCostIsRecomputed) {
  EXPECT_EQ(verdict([](Json& result) { result["cost"] = 4.5; }),
            "invalid: the stated cost is 4.5 m, the path costs 5 m\n");
  EXPECT_EQ(verdict([](Json& result) {
              result["cost"] = 5;
              result["options"] = {{"gear_change_cost", 2.5}, {"initial_gear", "reverse"}};
            }),
            "invalid: the stated cost is 5 m, the path costs 7.5 m\n");
  EXPECT_EQ(verdict([](Json& result) {
              result["cost"] = 5;
              result["bound"] = 4;
              result["gap"] = 0.2;
            }),
            "invalid: the stated gap is 0.2, cost and bound make it 0.25\n");
  EXPECT_EQ(verdict([](Json& result) {
              result["cost"] = 5;
              result["bound"] = 6;
            }),
            "invalid: the stated bound is 6 m, the path costs 5 m\n");
}

TEST_F(CheckCommand, TheRuleOfTheCostIsRead) {
  write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5,", "goal: {x: 3, y: 0,"));
  Json result = drive_ahead();
  result["path"]["segments"] = {{{"turn", "straight"}, {"length", 5}},
                                {{"turn", "straight"}, {"length", -2}}};
  result["length"] = 7;
  result["gear_changes"] = 1;
  result["options"] = {{"reverse_weight", 3}, {"gear_change_cost", 10}, {"initial_gear", "any"}};
  result["cost"] = 5 + 3 * 2 + 10;
  EXPECT_EQ(check(result).status, 0);
  result["planner"] = "rrt-bsc-euc";  // its cost is the length
  EXPECT_EQ(check(result).status, 1);
  result["cost"] = 7;
  EXPECT_EQ(check(result).status, 0);
  result["options"]["initial_gear"] = "neutral";
  EXPECT_EQ(check(result).status, 2);
}

TEST_F(CheckCommand, ACostMayBeTheTime) {
  write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5,", "goal: {x: 3, y: 0,"));
  Json result = drive_ahead();
  result["path"]["segments"] = {{{"turn", "straight"}, {"length", 3}}};
  result["length"] = 3;
  result["options"] = {{"cost", "time"}};
  result["cost"] = 2 * std::sqrt(3.0);  // faster by 1 m/s every second to the middle, then slower
  EXPECT_EQ(check(result).status, 0);
  result["cost"] = 3;
  EXPECT_EQ(check(result).out,
            "invalid: the stated cost is 3 s, the fastest drive takes 3.464101615 s\n");
  result["options"]["cost"] = "money";
  EXPECT_EQ(check(result).status, 2);
}

TEST_F(CheckCommand, TheSteeringThatWasInForceIsHeldTo) {
  const auto steered = [](const char* steering) {
    return [steering](Json& result) {
      result["path"]["segments"] = {{{"curvature", 0}, {"length", 1}},
                                    {{"curvature", 0.001}, {"length", 4}}};
      result["options"] = {{"steering", steering}};
    };
  };
  for (const char* const steering : {"continuous-between-stops", "continuous"}) {
    EXPECT_EQ(verdict(steered(steering)),
              "invalid: the curvature jumps from 0 to 0.001 1/m where the vehicle rolls at s = "
              "1.0000 m, where x = 1 m, y = 0 m, heading = 0 rad\n");
  }
  EXPECT_NE(verdict(steered("reeds-shepp")).find("the path ends"), std::string::npos);
  Json result = drive_ahead();
  result["options"] = {{"steering", "continuous"}};
  EXPECT_EQ(check(result).status, 0);
  result["options"]["steering"] = "smooth";
  EXPECT_EQ(check(result).status, 2);
}

TEST_F(CheckCommand, ThePriceOfTurningTheWheelsIsRead) {
  Json result = drive_ahead();
  result["path"]["segments"] = {{{"turn", "straight"}, {"length", 5}},
                                {{"turn", "left"}, {"length", -1}},
                                {{"turn", "left"}, {"length", 1}}};
  result["length"] = 7;
  result["gear_changes"] = 2;
  result["options"] = {{"curvature_change_cost", 14}};
  result["cost"] = 7 + 14 / 7;
  EXPECT_EQ(check(result).status, 0);
  result["cost"] = 7;
  EXPECT_EQ(check(result).status, 1);
}

// The truck ends 1.1 m before the wall; what is nearer than 3 m costs more.
TEST_F(CheckCommand, ThePriceOfBeingNearIsRead) {
  Json result = drive_ahead();
  result["options"] = {{"clearance_weight", 2}, {"clearance_distance", 3}};
  result["cost"] = 5 + 2 * 1.9 * 1.9 / 6;
  EXPECT_EQ(check(result).status, 0) << check(result).out;
  result["options"]["clearance_distance"] = 2;
  EXPECT_EQ(check(result).status, 1);
  result["planner"] = "rrt-opt-rs";  // goes by length, whatever the options say
  result["cost"] = 5;
  EXPECT_EQ(check(result).status, 0);
}

TEST_F(CheckCommand, ThePlaceIsInTheFrameOfTheScenario) {
  std::string far = replaced(yard(), "start: {x: 0", "start: {x: 4500000000");
  far = replaced(far, "goal: {x: 20, y: 5", "goal: {x: 4500000005, y: 0");
  far = replaced(far, "x: [-50, 50]", "x: [4499999950, 4500000050]");
  far = replaced(far, "[12, -9], [13, -9], [13, 9], [12, 9]",
                 "[4500000009, -9], [4500000013, -9], [4500000013, 9], [4500000009, 9]");
  write_content(scenario_, far);
  Json result = drive_ahead();
  result["path"]["start"]["x"] = 4500000000.0;
  const Json verdict = Json::parse(check(result, {"--json"}).out);
  EXPECT_EQ(verdict.at("reason"), "the footprint hits obstacles[0]");
  EXPECT_NEAR(verdict.at("at").at("x").get<double>(), 4500000003.1, 1e-3);
  EXPECT_NEAR(verdict.at("at").at("s").get<double>(), 3.1, 1e-3);
}

TEST_F(CheckCommand, ResultWithoutAPathFailsWithItsStatus) {
  const Json unsolved = {{"format", "vandplan-result/1"}, {"status", "time_limit"}};
  const Outcome outcome = check(unsolved);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "no path: time_limit\n");
  EXPECT_EQ(Json::parse(check(unsolved, {"--json"}).out).at("valid"), false);
}

TEST_F(CheckCommand, AResultWithoutAPathSaysItsReason) {
  const Json unsolved = {{"format", "vandplan-result/1"},
                         {"status", "rejected"},
                         {"reason", "the path ends 1 m away\x1b[0m"}};
  EXPECT_EQ(check(unsolved).out, "no path: rejected (the path ends 1 m away\\x1b[0m)\n");
  EXPECT_EQ(Json::parse(check(unsolved, {"--json"}).out).at("reason"), unsolved["reason"]);
}

TEST_F(CheckCommand, ASmallClearanceIsSaidInMillimetres) {
  Json result =
      drive_ahead();  // the front bumper ends 5.9 m ahead of the rear axle, the wall is at 12
  result["length"] = 6.095;
  result["path"]["segments"][1]["length"] = 3.095;
  write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5,", "goal: {x: 6.095, y: 0,"));
  const Outcome outcome = check(result);
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_NE(outcome.out.find(" mm (accurate to 1.00 mm)\n"), std::string::npos) << outcome.out;
}

// ---- many pairs ----

class CheckPairs : public CheckCommand {
 protected:
  /// Results for three pairs, a line each.
  std::vector<Json> planned() {
    write_content(folder_ / "poses.csv", "0,0,0,4,0,0\n0,0,0,0,0,3\n0,0,0,12,0,0\n");
    const Outcome outcome = run_vandplan(
        {"plan", scenario_, "--poses", folder_ / "poses.csv", "--max-iterations", "300", "--json"});
    std::vector<Json> results;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) results.push_back(Json::parse(line));
    EXPECT_EQ(results.size(), 3U) << outcome.err;
    return results;
  }

  Outcome check_lines(const std::vector<Json>& results, const std::vector<std::string>& options) {
    std::string text;
    for (const Json& result : results) text += result.dump() + '\n';
    write_content(result_, text);
    std::vector<std::string> arguments = {"check", scenario_, result_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_vandplan(arguments);
  }
};

TEST_F(CheckPairs, EachPairIsJudgedAgainstItsOwnStartAndGoal) {
  const Outcome outcome = check_lines(planned(), {});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, 25), "1: valid: length 4.000 m,");
  EXPECT_NE(outcome.out.find("\n3: no path: goal_in_collision (the footprint hits obstacles[0])\n"
                             "yard: 2 valid, 0 invalid, 1 without a path\n"),
            std::string::npos)
      << outcome.out;
}

TEST_F(CheckPairs, OnePathThatIsNoneFailsThemAll) {
  std::vector<Json> results = planned();
  results[0]["goal"]["y"] = 0.5;
  const Outcome text = check_lines(results, {});
  EXPECT_EQ(text.status, 1);
  EXPECT_EQ(text.out.substr(0, 34), "1: invalid: the path ends 0.5 m an");
  const Outcome json = check_lines(results, {"--json"});
  EXPECT_EQ(json.status, 1);
  std::istringstream lines(json.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(Json::parse(line).at("pair"), 1);
  EXPECT_EQ(Json::parse(line).at("valid"), false);
  std::getline(lines, line);
  EXPECT_EQ(Json::parse(line).at("valid"), true);
}

TEST_F(CheckPairs, MistakesNameTheLine) {
  std::vector<Json> results = planned();
  results[1]["path"]["segments"] = 7;
  const Outcome outcome = check_lines(results, {});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("result.json:2: path.segments: is \"7\", expected a list"),
            std::string::npos)
      << outcome.err;
}

TEST_F(CheckPairs, SomeOrOneOfThemAreDrawn) {
  (void)check_lines(planned(), {});
  const auto draw = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"draw", scenario_, result_, "-o", folder_ / "pairs.svg"});
    return run_vandplan(options);
  };
  const Outcome sheet = draw({});
  EXPECT_EQ(sheet.status, 0) << sheet.err;
  EXPECT_EQ(sheet.out, "yard: 3 pairs drawn to " + (folder_ / "pairs.svg") + "\n");
  EXPECT_EQ(draw({"--pair", "2"}).out, "yard: pair 2 drawn to " + (folder_ / "pairs.svg") + "\n");
  EXPECT_EQ(draw({"--pair", "4"}).err, "vandplan: --pair: there is no pair 4\n");
  write_content(result_, drive_ahead().dump());
  EXPECT_EQ(draw({"--pair", "1"}).err,
            "vandplan: --pair: is for files with many results, this one holds one\n");
}

TEST_F(CheckCommand, EveryGoalOfARowIsJudged) {
  write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5, heading: 0}",
                                    "goals:\n"
                                    "  - {distance: 5, goal: {x: 5, y: 0, heading: 0}}\n"
                                    "  - {distance: 20, goal: {x: 20, y: 5, heading: 0}}"));
  const Json unsolved = {{"status", "time_limit"}};
  Json row = {{"format", "vandplan-result/1"}, {"goals", {drive_ahead(), unsolved}}};
  const Outcome half = check(row);
  EXPECT_EQ(half.status, 0) << half.err;
  EXPECT_EQ(half.out,
            "goals[0]: valid: length 5.000 m, gear changes 0, in reverse 0 m, clearance 1.100 m\n"
            "goals[1]: no path: time_limit\n");

  row["furthest"] = 5;
  row["goals"][0]["distance"] = 5;
  row["goals"][1]["distance"] = 20;
  EXPECT_EQ(check(row).status, 0);
  row["furthest"] = nullptr;
  const Outcome none = check(row);
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(
      none.out.find("\ninvalid: the stated furthest is none, the furthest goal reached is 5 m\n"),
      std::string::npos)
      << none.out;

  row["goals"][1] = drive_ahead();
  const Json verdict = Json::parse(check(row, {"--json"}).out);
  EXPECT_EQ(verdict.at("valid"), false);
  EXPECT_EQ(verdict.at("goals").at(0).at("valid"), true);
  EXPECT_EQ(verdict.at("goals").at(1).at("valid"), false);
}

TEST_F(CheckCommand, WhatPlanWritesIsValid) {
  write_content(scenario_, yard());
  for (const std::string planner : {"anytime", "rrt-bsc-euc-goal", "rrt-opt-hlut-4-goal"}) {
    const Outcome planned = run_vandplan({"plan", scenario_, "--planner", planner, "--region",
                                          "scene", "--max-iterations", "500", "--output", result_});
    ASSERT_EQ(planned.status, 0) << planned.err;
    const Outcome outcome = run_vandplan({"check", scenario_, result_});
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  }
}

TEST_F(CheckCommand, ResultThatIsNoResultIsBadInput) {
  write_content(result_, "{}");
  const Outcome outcome = run_vandplan({"check", scenario_, result_});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.substr(0, result_.size() + 12), "vandplan: " + result_ + ":1");
}

}  // namespace
}  // namespace vandplan

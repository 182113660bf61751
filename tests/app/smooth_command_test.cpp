// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

#include "support/process.h"
#include "support/yard.h"

namespace vandplan {
namespace {

using Json = nlohmann::json;

class SmoothCommand : public testing::Test {
 protected:
  void SetUp() override {
    write_content(scenario_, yard());
    const Outcome planned =
        run_vandplan({"plan", scenario_, "--set", "style=shortest", "--set", "steering=reeds-shepp",
                      "--max-iterations", "300", "--output", result_});
    ASSERT_EQ(planned.status, 0) << planned.err;
  }

  Outcome smooth(const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"smooth", scenario_, result_, "--max-iterations", "1500"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_vandplan(arguments);
  }

  TemporaryFolder folder_;
  std::string scenario_ = folder_ / "yard.yaml";
  std::string result_ = folder_ / "r.json";
  std::string smoothed_ = folder_ / "s.json";
};

TEST_F(SmoothCommand, WritesAPathThatTheJudgeHoldsToItsSteering) {
  const Outcome outcome =
      smooth({"--set", "steering=continuous", "--output", smoothed_, "--method", "clothoids"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("smoothed: length"), std::string::npos) << outcome.out;
  const Json written = Json::parse(content_of(smoothed_));
  EXPECT_EQ(written["planner"], "smooth-clothoids");
  EXPECT_EQ(written["options"]["steering"], "continuous");
  EXPECT_EQ(run_vandplan({"check", scenario_, smoothed_}).status, 0);
  EXPECT_EQ(run_vandplan({"speed", scenario_, smoothed_}).status, 0);
}

TEST_F(SmoothCommand, NamesWhatIsWrong) {
  const Outcome method = smooth({"--method", "splines"});
  EXPECT_EQ(method.status, 2);
  EXPECT_NE(method.err.find("\"splines\" is not clothoids or optimised"), std::string::npos);
  const Outcome option = smooth({"--set", "goal_bias=0.1"});
  EXPECT_EQ(option.status, 2);
  const Outcome output = smooth({"--output", folder_ / "missing/s.json"});
  EXPECT_EQ(output.status, 2);
}

// Without a path there is nothing to smooth; the answer says why, as the result does.
TEST_F(SmoothCommand, KeepsAResultWithoutAPath) {
  write_content(result_, R"({"format": "vandplan-result/1", "status": "no_path"})");
  const Outcome outcome = smooth({"--output", smoothed_});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(Json::parse(content_of(smoothed_))["status"], "no_path");
}

TEST_F(SmoothCommand, EndsWithTheStraightLineThatTheGoalAsksFor) {
  write_content(scenario_, replaced(yard(), "x: 20, y: 5, heading: 0",
                                    "x: 20, y: 5, heading: 0, straight: 4"));
  const Outcome planned =
      run_vandplan({"plan", scenario_, "--set", "style=shortest", "--set", "steering=reeds-shepp",
                    "--max-iterations", "600", "--output", result_});
  ASSERT_EQ(planned.status, 0) << planned.err;
  const Outcome outcome = smooth({"--output", smoothed_});
  EXPECT_NE(outcome.out.find("smoothed: length"), std::string::npos) << outcome.out;
  EXPECT_EQ(run_vandplan({"check", scenario_, smoothed_}).status, 0);
}

/// The scenario with options of its own.
std::string yard_that_wants(const std::string& options) {
  return yard() + "options: {" + options + "}\n";
}

/// What is stored of a run under a key.
Json option_of(const std::string& result, const char* key) {
  return Json::parse(content_of(result))["options"][key];
}

/// A driver's path in a yard with this goal.
class SmoothedDriver : public testing::TestWithParam<std::tuple<const char*, int>> {};

INSTANTIATE_TEST_SUITE_P(
    Problems, SmoothedDriver,
    testing::Combine(testing::Values("x: 20, y: 5, heading: 0", "x: 20, y: -3, heading: 3",
                                     "x: 0, y: 4, heading: 3.1415926", "x: 7, y: 3, heading: 1.5"),
                     testing::Values(1, 2)));

TEST_P(SmoothedDriver, IsNotMadeWorse) {
  const auto& [goal, seed] = GetParam();
  const TemporaryFolder folder;
  const std::string scenario = folder / "yard.yaml";
  write_content(scenario, replaced(yard(), "x: 20, y: 5, heading: 0", goal));
  const std::string seed_text = std::to_string(seed);
  for (const char* const steering : {"continuous-between-stops", "continuous"}) {
    const std::string planned = folder / "r.json", smoothed = folder / "s.json";
    const Outcome plan = run_vandplan({"plan", scenario, "--seed", seed_text, "--set", "margin=0.2",
                                       "--set", std::string("steering=") + steering,
                                       "--max-iterations", "1500", "--output", planned});
    ASSERT_EQ(plan.status, 0) << plan.err << plan.out;
    const Outcome smooth = run_vandplan({"smooth", scenario, planned, "--seed", seed_text,
                                         "--max-iterations", "400", "--output", smoothed});
    ASSERT_EQ(smooth.status, 0) << smooth.err << smooth.out;
    const Json before = Json::parse(content_of(planned)), after = Json::parse(content_of(smoothed));
    EXPECT_LE(after["cost"], before["cost"]);
    EXPECT_EQ(after["options"]["steering"], steering);
    EXPECT_EQ(after["options"]["margin"], 0.2);
    EXPECT_EQ(after["options"]["gear_change_cost"], 5.0);
    EXPECT_GE(after["clearance"], 0.2);
    EXPECT_NE(smooth.out.find(" by a driver's prices"), std::string::npos) << smooth.out;
    EXPECT_EQ(run_vandplan({"check", scenario, smoothed}).status, 0);
  }
}

TEST_F(SmoothCommand, TakesWhatIsTypedThenWhatIsStoredThenWhatTheScenarioWants) {
  write_content(scenario_, yard_that_wants("margin: 0.1, margin_ramp: 2, gear_change_cost: 9"));
  const Outcome planned =
      run_vandplan({"plan", scenario_, "--set", "margin=0.2", "--set", "reverse_weight=3",
                    "--max-iterations", "1500", "--seed", "7", "--output", result_});
  ASSERT_EQ(planned.status, 0) << planned.err;
  write_content(scenario_, yard_that_wants("margin: 0.1, margin_ramp: 4, gear_change_cost: 1"));
  ASSERT_EQ(smooth({"--set", "reverse_weight=4", "--output", smoothed_}).status, 0);
  EXPECT_EQ(option_of(smoothed_, "reverse_weight"), 4.0);
  EXPECT_EQ(option_of(smoothed_, "margin"), 0.2);
  EXPECT_EQ(option_of(smoothed_, "margin_ramp"), 2.0);
  EXPECT_EQ(option_of(smoothed_, "gear_change_cost"), 9.0);
  EXPECT_EQ(option_of(smoothed_, "seed"), 1);
  ASSERT_EQ(smooth({"--set", "style=shortest", "--output", smoothed_}).status, 0);
  EXPECT_EQ(option_of(smoothed_, "gear_change_cost"), 0.0);
  ASSERT_EQ(smooth({"--set", "cost=time", "--output", smoothed_}).status, 0);
  EXPECT_EQ(option_of(smoothed_, "cost"), "time");
}

// Somebody else's planner, or a hand, stores no options: the scenario's hold.
TEST_F(SmoothCommand, TakesWhatTheScenarioWantsWhereNothingIsStored) {
  Json planned = Json::parse(content_of(result_));
  planned.erase("options");
  write_content(result_, planned.dump());
  write_content(scenario_, yard_that_wants("margin: 0.1, reverse_weight: 3"));
  const Outcome outcome = smooth({"--output", smoothed_});
  ASSERT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  EXPECT_EQ(option_of(smoothed_, "margin"), 0.1);
  EXPECT_EQ(option_of(smoothed_, "reverse_weight"), 3.0);
  EXPECT_EQ(option_of(smoothed_, "gear_change_cost"), 5.0);
  planned["options"] = {{"margin", 0.05}, {"of_somebody_else", {1, 2}}, {"steering", nullptr}};
  write_content(result_, planned.dump());
  ASSERT_EQ(smooth({"--output", smoothed_}).status, 0);
  EXPECT_EQ(option_of(smoothed_, "margin"), 0.05);
  EXPECT_EQ(option_of(smoothed_, "reverse_weight"), 3.0);
  planned["options"] = {{"min_stroke", -1}};
  write_content(result_, planned.dump());
  const Outcome bad = smooth({});
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.err.find("r.json: options.min_stroke: \"-1\" is not"), std::string::npos)
      << bad.err;
}

TEST_F(SmoothCommand, SaysByWhichCostBeforeAndAfter) {
  const Outcome arcs = smooth({});
  EXPECT_NE(arcs.out.find(" by length alone, "), std::string::npos) << arcs.out;
  EXPECT_NE(arcs.out.find(" m before (not allowed: "), std::string::npos) << arcs.out;
  const Outcome as_driver = smooth({"--set", "style=driver"});
  EXPECT_NE(as_driver.out.find(" by a driver's prices, "), std::string::npos) << as_driver.out;
  const Outcome in_time = smooth({"--set", "cost=time"});
  EXPECT_NE(in_time.out.find(", driven in "), std::string::npos) << in_time.out;
  EXPECT_NE(in_time.out.find(" s before"), std::string::npos) << in_time.out;
}

TEST_F(SmoothCommand, SaysOnOneLineThatAPathStaysAsItWas) {
  ASSERT_EQ(smooth({"--output", smoothed_}).status, 0);
  const Outcome outcome = run_vandplan({"smooth", scenario_, smoothed_, "--max-iterations", "0"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("no better path found, the path is unchanged: length "),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("cost "), std::string::npos) << outcome.out;
  EXPECT_EQ(std::ranges::count(outcome.out, '\n'), 2);
}

}  // namespace
}  // namespace vandplan

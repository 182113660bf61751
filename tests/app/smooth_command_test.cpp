// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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

}  // namespace
}  // namespace vandplan

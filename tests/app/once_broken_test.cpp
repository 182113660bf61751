// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Do inputs that once broke something end as they should: with a path that the judge accepts, or
// with one clear line?

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/process.h"
#include "support/yard.h"

namespace vandplan {
namespace {

class OnceBroken : public testing::Test {
 protected:
  /// Plans the file: there is a path that the judge accepts, or none. The run ends by itself.
  Outcome planned(std::vector<std::string> options) {
    options.insert(options.begin(), {"plan", scenario_});
    const Outcome outcome = run_vandplan(options);
    EXPECT_LE(outcome.status, 1) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out.find("rejected"), std::string::npos) << outcome.out;
    return outcome;
  }

  /// The same, and what is written can be checked.
  void expect_a_sound_result(std::vector<std::string> options) {
    options.insert(options.end(), {"--output", result_});
    if (planned(options).status != 0) return;
    const Outcome checked = run_vandplan({"check", scenario_, result_});
    EXPECT_EQ(checked.status, 0) << checked.err << checked.out;
  }

  /// By planners that go straight for the goal, and by one that goes as far as the bounds let it.
  void expect_sound_answers() {
    expect_a_sound_result({"--max-iterations", "100"});
    for (const char* seed : {"1", "2", "3", "4"}) {
      (void)planned({"--max-iterations", "100", "--seed", seed, "--planner", "rrt-bsc-euc-goal"});
    }
  }

  /// Plans the file, which is refused for that reason.
  void expect_refusal(const std::string& reason) {
    const Outcome outcome = run_vandplan({"plan", scenario_, "--max-iterations", "30"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "vandplan: " + scenario_ + ":" + reason + "\n");
    EXPECT_EQ(outcome.out, "");
  }

  TemporaryFolder folder_;
  const std::string scenario_ = folder_ / "scenario.yaml";
  const std::string result_ = folder_ / "result.json";
};

std::string yard_within(const std::string& bounds) {
  return replaced(yard(), "{x: [-50, 50], y: [-50, 50]}", bounds);
}

TEST_F(OnceBroken, BoundsWithoutEndGiveNoEndlessPaths) {
  write_content(scenario_, yard_within("{x: [-1e10, 1e10], y: [-1e12, 1e12]}"));
  expect_sound_answers();
}

TEST_F(OnceBroken, FarGroundAroundASmallMapIsNotSearchedInSmallSteps) {
  write_content(folder_ / "map.yaml",
                "image: map.pgm\nresolution: 0.05\norigin: [-30, -30, 0]\nnegate: 0\n"
                "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  write_content(folder_ / "map.pgm", "P2\n1 1\n255\n0\n");
  write_content(scenario_,
                yard_within("{x: [-1e9, 1e9], y: [-1e9, 1e9]}") + "map: map.yaml\nunknown: free\n");
  expect_sound_answers();
  expect_a_sound_result({"--time", "0.05"});
}

TEST_F(OnceBroken, ANeedleOfAHundredThousandKilometresIsRefused) {
  write_content(scenario_,
                yard() + "  - [[-2, 350700015], [6, 2.1], [7.7, 2.8], [5.3, 350700015]]\n");
  expect_refusal(
      "8: obstacles[1]: has a corner 350700015 m from the start, expected at most 1e+06 m along "
      "each axis");
}

TEST_F(OnceBroken, ANeedleOfAThousandKilometresIsJudgedAsItIsPlanned) {
  write_content(scenario_, yard() + "  - [[-2, 999999], [6, 6.1], [7.7, 6.8], [5.3, 999998]]\n");
  expect_sound_answers();
}

TEST_F(OnceBroken, AStarOfAHundredThousandCorners) {
  std::string corners;
  for (int i = 0; i < 100'000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 100'000;
    const double radius = i % 2 == 0 ? 1 : 20;
    corners += (i == 0 ? "[" : ", [") + std::to_string(5 + radius * std::cos(angle)) + ", " +
               std::to_string(30 + radius * std::sin(angle)) + "]";
  }
  write_content(scenario_, yard() + "  - [" + corners + "]\n");
  expect_a_sound_result({"--max-iterations", "300"});
  expect_a_sound_result({"--time", "0.05"});
}

}  // namespace
}  // namespace vandplan

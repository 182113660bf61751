// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
//
// Does the judge accept what the thesis' methods find in the thesis' scenarios?
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "support/cases.h"
#include "support/shared_files.h"
#include "vandplan/files.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

const std::filesystem::path thesis = repository() / "scenarios/thesis";

std::vector<ScenarioProblems> thesis_problems() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(thesis)) {
    files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  std::vector<ScenarioProblems> all;
  for (const std::string& file : files) all.push_back(read_problems(file));
  return all;
}

std::vector<std::string> thesis_methods() {
  std::vector<std::string> names;
  for (const Planner& planner : planners()) {
    if (planner.properties.family == "rrt") names.push_back(planner.name);
  }
  return names;
}

class ThesisMethod : public testing::TestWithParam<std::string> {};

TEST_P(ThesisMethod, FindsOnlyPathsThatTheJudgeAccepts) {
  const std::vector<ScenarioProblems> scenarios = thesis_problems();
  ASSERT_EQ(scenarios.size(), 9U);
  const Planner planner = planner_named(GetParam());
  int solved = 0;
  for (const auto& [file, problems] : scenarios) {
    // The nearest, a middle and the furthest goal of a row.
    for (std::size_t goal = 0; goal < problems.size();
         goal += std::max<std::size_t>(1, (problems.size() - 1) / 2)) {
      const Problem& problem = problems[goal];
      for (int seed = 1; seed <= std::max(1, cases(3)); ++seed) {
        SCOPED_TRACE(file.scenario.name + ", goal " + std::to_string(goal) + ", seed " +
                     std::to_string(seed));
        PlanOptions options;
        options.budget.seed = static_cast<std::uint64_t>(seed);
        options.budget.max_iterations = 400;
        options.planner.set("region", seed % 2 == 0 ? "bounds" : "scene");
        const PlanResult result = plan(problem, planner, options);
        EXPECT_NE(result.status, PlanStatus::rejected) << result.reason;
        EXPECT_EQ(result.status == PlanStatus::solved, result.path.has_value());
        if (!result.path) continue;
        ++solved;
        const PathCheck check =
            check_path(problem, *result.path, {result.cost, gear_changes(result.path->segments)});
        EXPECT_TRUE(check.valid) << check.reason;
        EXPECT_NEAR(result.anytime.back().cost, result.cost, 1e-9);
      }
    }
  }
  EXPECT_GE(solved, 8);  // open ground at the least, whatever the method
}

TEST_P(ThesisMethod, GrowsATreeWhoseEveryEdgeTheJudgeAccepts) {
  const Problem cage = read_problems((thesis / "5-leave-cage.yaml").string()).problems[0];
  PlanOptions options;
  options.budget.max_iterations = 300;
  options.planner.set("region", "scene");
  options.planner.set("keep_tree", true);
  const PlanResult result = plan(cage, planner_named(GetParam()), options);
  ASSERT_TRUE(result.tree);
  const TreeSnapshot& tree = *result.tree;
  ASSERT_EQ(static_cast<std::int64_t>(tree.poses.size()), counter(result, "nodes"));
  ASSERT_GT(tree.poses.size(), 30U);
  EXPECT_EQ(tree.parents[0], -1);
  for (std::size_t i = 1; i < tree.poses.size(); ++i) {
    ASSERT_LT(static_cast<std::size_t>(tree.parents[i]), i);
    const Pose& from = tree.poses[static_cast<std::size_t>(tree.parents[i])];
    const Piece edge = reeds_shepp(from, tree.poses[i], 7.0);
    const Problem problem = make_problem(cage.world(), cage.vehicle(), from, tree.poses[i]);
    const PathCheck check =
        check_path(problem, {from, {edge.view().begin(), edge.view().end()}}, {});
    EXPECT_TRUE(check.valid) << "node " << i << ": " << check.reason;
  }
}

std::string name_of_method(const testing::TestParamInfo<std::string>& method) {
  std::string name = method.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, ThesisMethod, testing::ValuesIn(thesis_methods()), name_of_method);

TEST(Rrt, LeastTotalCostIsNeverLongerOnTheSameSamplesThanNearest) {
  // Both draw the same samples; on open ground every one is connected at once.
  const Problem open = read_problems((thesis / "1-open.yaml").string()).problems[0];
  PlanOptions options;
  options.budget.max_iterations = 200;
  const PlanResult nearest = plan(open, planner_named("rrt-bsc-euc"), options);
  const PlanResult least = plan(open, planner_named("rrt-opt-rs"), options);
  ASSERT_TRUE(nearest.path && least.path);
  EXPECT_LE(least.cost, nearest.cost);
  EXPECT_NEAR(least.cost, reeds_shepp_length(open.start(), open.goal(), 7.0), 1e-9);
}

TEST(Rrt, TheParentByExactLengthIsTheNearestOfAll) {
  const Problem open = read_problems((thesis / "1-open.yaml").string()).problems[0];
  PlanOptions options;
  options.budget.max_iterations = cases(500);
  options.planner.set("keep_tree", true);
  const PlanResult result = plan(open, planner_named("rrt-bsc-rs"), options);
  ASSERT_TRUE(result.tree);
  const std::vector<Pose>& poses = result.tree->poses;
  const auto& parents = result.tree->parents;
  const auto length = [&poses](std::size_t from, std::size_t to) {
    return reeds_shepp_length(poses[from], poses[to], 7.0);
  };
  for (std::size_t i = 1; i < poses.size(); ++i) {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < i; ++k) nearest = length(k, i) < length(nearest, i) ? k : nearest;
    EXPECT_EQ(static_cast<std::size_t>(parents[i]), nearest) << "node " << i;
  }
}

TEST(Rrt, WithoutGoalSamplesOnlyTryingTheGoalFromEveryNodeSolves) {
  const Problem open = read_problems((thesis / "1-open.yaml").string()).problems[0];
  PlanOptions options;
  options.budget.max_iterations = 200;
  options.planner.set("goal_bias", 0.0);
  EXPECT_EQ(plan(open, planner_named("rrt-bsc-euc-goal"), options).status, PlanStatus::solved);
  EXPECT_EQ(plan(open, planner_named("rrt-bsc-euc"), options).status, PlanStatus::iteration_limit);
}

TEST(Rrt, AFullTreeEndsTheRun) {
  const Problem narrow = read_problems((thesis / "4-narrow-turn.yaml").string()).problems[0];
  PlanOptions options;
  options.planner.set("max_nodes", std::int64_t{5});
  const PlanResult result = plan(narrow, planner_named("rrt-bsc-euc"), options);
  EXPECT_EQ(result.status, PlanStatus::node_limit);
  EXPECT_EQ(counter(result, "nodes"), 5);
}

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Every planner finds the same path, bit for bit, on every vector target of this machine.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "support/planner_names.h"
#include "support/problems.h"
#include "support/simd_targets.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

class PlannersOnEveryTarget : public testing::TestWithParam<Planner> {};

TEST_P(PlannersOnEveryTarget, FindTheSamePath) {
  const Problem problem =
      problem_of({0, 0, 0}, {30, 0, 1}, {box(14, -12, 16, 12), box(14, 12, 40, 14)});
  PlanOptions options{.cost = shortest_style};
  options.budget.max_iterations = 1500;
  for (const auto& [name, text] : {std::pair{"region", "scene"}, {"keep_tree", "true"}}) {
    if (honours(GetParam(), name)) set_option(options, GetParam(), name, text);
  }
  const PlanResult expected = plan(problem, GetParam(), options);
  ASSERT_TRUE(expected.path);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    const ForcedTarget forced(target);
    SCOPED_TRACE(hwy::TargetName(target));
    const PlanResult result = plan(problem, GetParam(), options);
    EXPECT_EQ(result.path, expected.path);
    EXPECT_EQ(result.iterations, expected.iterations);
    EXPECT_EQ(result.lower_bound, expected.lower_bound);
    EXPECT_EQ(result.counters, expected.counters);
    ASSERT_EQ(result.tree.has_value(), expected.tree.has_value());
    if (!result.tree) continue;
    EXPECT_EQ(result.tree->poses, expected.tree->poses);
    EXPECT_EQ(result.tree->parents, expected.tree->parents);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PlannersOnEveryTarget,
                         testing::ValuesIn(planners().begin(), planners().end()), name_of_test);

}  // namespace
}  // namespace vandplan

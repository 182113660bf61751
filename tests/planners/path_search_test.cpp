// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// A planner that cannot go on is run again: what it has found is told as of the first run.
#include "planners/path_search.h"

#include <gtest/gtest.h>

#include <memory>

#include "support/problems.h"

namespace vandplan {
namespace {

/// Finds a path in its third iteration, if it may have 500; has a millisecond before that.
PlannerAnswer late(const Task& /*task*/, const PlanOptions& options) {
  PlannerAnswer answer{.status = PlanStatus::iteration_limit,
                       .iterations = *options.budget.max_iterations};
  if (answer.iterations < 500) return answer;
  answer.status = PlanStatus::solved;
  answer.segments.emplace();
  answer.anytime = {{0.001, 3, 7.0}};
  return answer;
}

TEST(RestartedSearch, TellsTimesSinceTheFirstRun) {
  const Problem problem = problem_of({0, 0, 0}, {10, 0, 0}, {});
  const std::unique_ptr<planning::PathSearch> search =
      planning::restarted_search(late)(problem.task(), {}, nullptr);
  while (!search->path()) ASSERT_TRUE(search->advance(1'000'000));
  const PlannerAnswer answer = search->answer();
  EXPECT_EQ(answer.iterations, 128 + 256 + 512);
  ASSERT_EQ(answer.anytime.size(), 1U);
  EXPECT_EQ(answer.anytime[0].iteration, 128 + 256 + 3);
  EXPECT_GT(answer.anytime[0].time, 0.001);
  EXPECT_EQ(answer.anytime[0].cost, 7.0);
}

}  // namespace
}  // namespace vandplan

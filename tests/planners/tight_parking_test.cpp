// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Are other people's tight parking cases solved by wheels that are never turned at standstill?
#include <gtest/gtest.h>

#include "../support/cases.h"
#include "../support/continuity.h"
#include "../support/shared_files.h"
#include "vandplan/files.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

// With many locks a search looks at every pose too often, with one it misses what a slot needs.
TEST(TightParking, IsSolvedWithoutJumpsOfCurvature) {
  if (is_sanitized) GTEST_SKIP() << "too slow with a sanitizer";
  PlanOptions options{.cost = shortest_style, .steering = Steering::continuous};
  options.budget.max_iterations = 60'000;
  for (const char* file : {"case13.yaml", "case19.yaml"}) {
    const auto path = shared_folder() / "scenarios" / "tpcap" / file;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no file " << path;
    const ScenarioProblems read = read_problems(path.string());
    ASSERT_EQ(read.problems.size(), 1U);
    const PlanResult result = plan(read.problems.front(), options);
    ASSERT_TRUE(result.path) << file;
    expect_continuous(*result.path, read.problems.front(), Steering::continuous);
  }
}

}  // namespace
}  // namespace vandplan

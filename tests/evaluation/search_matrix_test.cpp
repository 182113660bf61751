// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/search_matrix.h"

#include <gtest/gtest.h>

#include "support/made_up_runs.h"
#include "support/numbers.h"

namespace vandplan::evaluation {
namespace {

Planner search(const std::string& name, const std::string& search, const std::string& estimate) {
  return {.name = name,
          .summary = "",
          .properties = {.family = search, .estimate = estimate, .search = search}};
}

std::vector<Planner> three() {
  return {search("a:x", "a", "x"), search("a:y", "a", "y"), search("b:x", "b", "x")};
}

TEST(SearchMatrix, TakesCostsOverTheLeastOneFound) {
  const std::vector<RunRecord> runs = {made_up_run("a:x", 1, 60.0, 0.008),
                                       made_up_run("a:y", 1, 50.0, 0.02),
                                       made_up_run("b:x", 1, {})};
  const std::vector<MatrixCell> cells = search_matrix(three(), runs, Region::bounds);
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_EQ(cells[0].search, "a");
  EXPECT_EQ(cells[1].estimate, "y");
  EXPECT_EQ(cells[0].first_time.median, 0.008);
  EXPECT_EQ(cells[0].cost_at_1s.median, 60.0 / 50.0);
  EXPECT_EQ(cells[0].cost_at_10ms.median, 120.0 / 50.0);  // the first path costs twice as much
  EXPECT_EQ(cells[1].cost_at_1s.median, 1.0);
  EXPECT_EQ(cells[1].cost_at_10ms.median, infinity);
  EXPECT_EQ(cells[2].solved, 0);
  EXPECT_EQ(cells[2].cost_at_1s.median, infinity);
  EXPECT_EQ(cells[2].first_work.median, infinity);
}

TEST(SearchMatrix, LeavesOutOtherRegionsAndProfiledRuns) {
  std::vector<RunRecord> runs = {made_up_run("a:x", 1, 60.0), made_up_run("a:y", 1, 50.0),
                                 made_up_run("a:y", 2, 70.0)};
  runs[2].options.change([](PlanOptions& options) { options.planner.set("profile", true); });
  const std::vector<MatrixCell> cells = search_matrix(three(), runs, Region::bounds);
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[1].runs, 1);
  EXPECT_TRUE(search_matrix(three(), runs, Region::scene).empty());
}

TEST(SearchMatrix, IsEmptyWhereNoSearchHasTwoEstimates) {
  const std::vector<RunRecord> runs = {made_up_run("a:x", 1, 60.0), made_up_run("b:x", 1, 50.0)};
  EXPECT_TRUE(search_matrix(three(), runs, Region::bounds).empty());
}

TEST(SearchMatrix, ComparesWhatTheLiteratureCompares) {
  const std::vector<Planner> planners = {
      search("hybrid-a-star:choi", "hybrid-a-star", "choi"),
      search("hybrid-a-star:max-hlut-4-grid", "hybrid-a-star", "max-hlut-4-grid")};
  const std::vector<RunRecord> runs = {made_up_run(planners[0].name, 1, 60.0, 0.01),
                                       made_up_run(planners[1].name, 1, 50.0, 0.02),
                                       made_up_run(planners[1].name, 2, 50.0, 0.02)};
  const std::vector<LiteratureFinding> found = literature_findings(planners, runs);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].planner, planners[0].name);
  EXPECT_EQ(found[0].rival, planners[1].name);
  EXPECT_EQ(found[0].cost.pairs, 1);
  EXPECT_EQ(found[0].first_time.ratio, 0.5);
  EXPECT_EQ(found[0].cost.ratio, 60.0 / 50.0);
  EXPECT_EQ(found[0].rival_solved, 1);
  EXPECT_TRUE(literature_findings({planners[0]}, runs).empty());
}

}  // namespace
}  // namespace vandplan::evaluation

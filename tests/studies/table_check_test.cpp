// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/table_check.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "studies/percentile.h"

namespace vandplan::studies {
namespace {

constexpr HeuristicTableOptions small{
    .extent = 2.0, .step = 1.0, .heading_cells = 4, .turning_radius = 5.0};

// A table of which one entry is something else.
HeuristicTable spoilt(const HeuristicTable::GridPoint& cell, float entry) {
  const HeuristicTable table(small);
  std::vector<float> entries(table.entries().begin(), table.entries().end());
  entries[table.index_of(cell)] = entry;
  return {small, entries};
}

TEST(TableCheck, ComparesEveryEntryOfAGoodTable) {
  const EntryCheck check = check_entries(HeuristicTable(small), {});
  EXPECT_EQ(check.compared, 3 * 3 * 5 * 5);
  EXPECT_EQ(check.wrong, 0);
  EXPECT_LT(check.worst_difference, 1e-5);
}

TEST(TableCheck, FindsTheOneWrongEntry) {
  const HeuristicTable::GridPoint cell{2, 1, 0, 3};
  const HeuristicTable table(small);
  const float right = table.entries()[table.index_of(cell)];
  const EntryCheck check = check_entries(spoilt(cell, right + 0.5F), {});
  EXPECT_EQ(check.wrong, 1);
  EXPECT_EQ(check.worst, cell);
  EXPECT_NEAR(check.worst_difference, 0.5, 1e-5);
}

TEST(TableCheck, AnEntryThatIsNoNumberIsTheWorst) {
  const HeuristicTable::GridPoint cell{1, 2, 2, 2};
  const EntryCheck check = check_entries(spoilt(cell, std::nanf("")), {});
  EXPECT_EQ(check.wrong, 1);
  EXPECT_EQ(check.worst, cell);
  EXPECT_TRUE(std::isnan(check.worst_difference));
}

TEST(TableCheck, ASampleRepeatsAndFindsAboutItsShare) {
  const HeuristicTable::GridPoint cell{1, 2, 2, 2};
  const HeuristicTable table = spoilt(cell, 99.0F);
  const EntryCheck check = check_entries(table, {.sample = 22'500, .seed = 3});
  EXPECT_EQ(check.compared, 22'500);
  EXPECT_NEAR(static_cast<double>(check.wrong), 100.0, 50.0);  // one of 225 cells
  EXPECT_EQ(check_entries(table, {.sample = 22'500, .seed = 3}).wrong, check.wrong);
}

TEST(TableCheck, BoundsHoldAndAreNotVoid) {
  const BoundCheck check = check_bounds(20'000, 1);
  EXPECT_EQ(check.pairs, 20'000);
  EXPECT_EQ(check.outside, 0);
  EXPECT_GT(check.median_gap, 0.0);
  EXPECT_LT(check.median_gap, 0.02);
  EXPECT_LT(check.median_gap, check.gap_95);
}

TEST(Percentile, IsTheValueOfTheNearestRank) {
  std::array values{5.0, 1.0, 4.0, 2.0, 3.0};
  EXPECT_EQ(percentile(values, 0.0), 1.0);
  EXPECT_EQ(percentile(values, 50.0), 3.0);
  EXPECT_EQ(percentile(values, 80.0), 4.0);
  EXPECT_EQ(percentile(values, 100.0), 5.0);
}

}  // namespace
}  // namespace vandplan::studies

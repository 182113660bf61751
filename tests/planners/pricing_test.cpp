// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What a drive costs by prices, by its time, by both, and with strokes that are too short.
#include "planners/pricing.h"

#include <gtest/gtest.h>

#include <vector>

#include "planners/drive_time.h"
#include "support/problems.h"

namespace vandplan {
namespace {

using planning::Pricing;
using search::ClearanceSampling;

const std::vector<Segment> there_and_back = {{0, 8}, {0.1, -2}, {0, 9}};

CostOptions by_time() {
  CostOptions cost;
  cost.measure = CostMeasure::time;
  return cost;
}

TEST(Pricing, CountsMetresSecondsOrBoth) {
  const Problem problem = problem_of({0, 0, 0}, {15, 0, 0}, {});
  const Task& task = problem.task();
  const CostOptions prices = by_length_and(2, 5);
  const double metres = 8 + 2 * 2 + 9 + 2 * 5;
  const double seconds = planning::drive_time(task, there_and_back);
  const auto search = ClearanceSampling::search;
  EXPECT_DOUBLE_EQ(Pricing(task, prices).cost(there_and_back, search), metres);
  EXPECT_DOUBLE_EQ(Pricing(task, prices, 0.5).cost(there_and_back, search), metres + 0.5 * seconds);
  EXPECT_DOUBLE_EQ(Pricing(task, prices, 0.5).path_cost(there_and_back, search), metres);
  EXPECT_DOUBLE_EQ(Pricing(task, by_time(), 0.5).cost(there_and_back, search), seconds);
}

// A drive among moving obstacles takes longer than the fastest one.
TEST(Pricing, CountsTheSecondsOfASlowDrive) {
  const Problem problem = problem_of({0, 0, 0}, {15, 0, 0}, {});
  const Pricing both(problem.task(), by_length_and(2, 5), 0.5);
  EXPECT_DOUBLE_EQ(both.timed_cost(30, 100), 80);
  EXPECT_DOUBLE_EQ(both.duration(30, 80), 100);
  const Pricing time(problem.task(), by_time(), 0.5);
  EXPECT_DOUBLE_EQ(time.timed_cost(30, 100), 100);
  EXPECT_DOUBLE_EQ(time.duration(30, 100), 100);
}

TEST(Pricing, HasAMeasureWhereTheWholeDriveCounts) {
  const Problem problem = problem_of({0, 0, 0}, {15, 0, 0}, {});
  const CostOptions prices = by_length_and(2, 5);
  EXPECT_FALSE(Pricing(problem.task(), prices).measure());
  EXPECT_TRUE(Pricing(problem.task(), prices, 0.5).measure());
  EXPECT_TRUE(Pricing(problem.task(), by_time()).measure());
  const Pricing strokes(problem.task(), prices, 0.0, 3.0);
  ASSERT_TRUE(strokes.measure());
  const double cost = strokes.cost(there_and_back, ClearanceSampling::search);
  EXPECT_DOUBLE_EQ(strokes.measure()(there_and_back), cost + 1000);  // a metre is missing
  EXPECT_EQ(strokes.lack(std::vector<Segment>{{0, 1}}), 0);          // no gear changes
}

}  // namespace
}  // namespace vandplan

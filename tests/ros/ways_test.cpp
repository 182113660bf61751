// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Which way does a robot take over ground that costs more?

#include <gtest/gtest.h>

#include <cmath>

#include "ros/adapter/planner.h"
#include "ros/yard.h"

namespace vandplan::ros {
namespace {

/// Length of the path of an answer in cells of a range, by its poses.
double length_in(const Answer& answer, const CellRange& range) {
  double sum = 0.0;
  for (std::size_t i = 1; i < answer.poses.size(); ++i) {
    const Pose& a = answer.poses[i - 1].pose;
    const Pose& b = answer.poses[i].pose;
    const double x = (a.x + b.x) * 5 - range.column, y = (a.y + b.y) * 5 - range.row;
    if (x < 0 || y < 0 || x > range.columns || y > range.rows) continue;
    sum += std::hypot(b.x - a.x, b.y - a.y);
  }
  return sum;
}

TEST(RosWays, GradedCostsHaveAPrice) {
  const CellRange dear{60, 95, 80, 12};
  OwnedCostmap room = walled_room();
  room.fill(dear, 252);
  Planner planner;
  planner.take(room.view());
  const auto planned = [&](double penalty) {
    planner.forget();
    return planner.plan(small_request({3, 10, 0}, {17, 10, 0}, 3000, {{"cost_penalty", penalty}}));
  };
  const Answer straight = planned(0.0);
  ASSERT_EQ(straight.outcome, Outcome::solved) << straight.message;
  EXPECT_NEAR(straight.cost, 14.0, 1e-6);
  EXPECT_NEAR(length_in(straight, dear), 8.0, 0.2);
  const Answer around = planned(2.0);
  ASSERT_EQ(around.outcome, Outcome::solved) << around.message;
  EXPECT_LT(length_in(around, dear), 0.2);
  EXPECT_LT(around.cost, 15.0);
  // 25 of 252 is 10 percent: not worth a detour.
  room.fill(dear, 25);
  planner.take(room.view());
  EXPECT_NEAR(planned(0.5).cost, 14.0 + 8.0 * 0.5 * 0.1, 0.01);
}

TEST(RosWays, CostsThatHaveChangedHaveTheirNewPrice) {
  OwnedCostmap room = walled_room();
  Planner planner;
  planner.take(room.view());
  const Request request = small_request({3, 10, 0}, {17, 10, 0}, 3000);
  EXPECT_NEAR(planner.plan(request).cost, 14.0, 1e-6);
  const auto world = planner.world();
  const CellRange dear{60, 80, 20, 40};  // across the whole way
  room.fill(dear, 126);
  planner.take(room.view());
  EXPECT_NEAR(planner.plan(request).cost, 14.0 + 2.0 * 2.0 * 0.5, 0.01);
  room.fill(dear, unknown_cost);
  planner.take(room.view());
  EXPECT_NEAR(planner.plan(request).cost, 14.0, 1e-6) << "unknown is not dear";
  EXPECT_EQ(planner.world(), world) << "patched";
}

}  // namespace
}  // namespace vandplan::ros

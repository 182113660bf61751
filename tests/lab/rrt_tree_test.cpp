// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Which node did the tree planners take as a parent? Recomputed for every node, by trying them all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/problems.h"
#include "support/radius.h"
#include "vandplan/planner.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

constexpr double of_float = 1e-3;  // ranks are floats: so much may two of them differ [m]

/// A tree on open ground, where every parent may be taken, with all of them tried.
TreeSnapshot open_ground_tree(const std::string& planner) {
  PlanOptions options;
  options.budget.max_iterations = 150;
  options.planner.set("region", "scene");  // far from the bounds, which may be in the way
  options.planner.set("keep_tree", true);
  if (planner.starts_with("rrt-opt")) options.planner.set("max_parents", std::int64_t{1000});
  const Problem problem = problem_of({0, 0, 0}, {30, 20, 1}, {}, {-1e3, 1e3, -1e3, 1e3});
  return plan(problem, planner_named(planner), options).tree.value();
}

class LeastCostParent : public testing::TestWithParam<const char*> {};

// OPT goes on until no later node could be cheaper: its first drivable parent is not enough.
TEST_P(LeastCostParent, IsTheBestOfAllOlderNodes) {
  const auto [poses, parents] = open_ground_tree(GetParam());
  ASSERT_GT(poses.size(), 100U);
  std::vector<double> costs = {0.0};
  int not_nearest = 0;
  for (std::size_t node = 1; node < poses.size(); ++node) {
    double least = std::numeric_limits<double>::infinity();
    double nearest = least;
    std::size_t nearest_node = 0;
    for (std::size_t older = 0; older < node; ++older) {
      const double edge = reeds_shepp_length(poses[older], poses[node], default_radius);
      least = std::min(least, costs[older] + edge);
      if (edge < nearest) nearest_node = older;
      nearest = std::min(nearest, edge);
    }
    const auto parent = static_cast<std::size_t>(parents[node]);
    costs.push_back(costs[parent] + reeds_shepp_length(poses[parent], poses[node], default_radius));
    EXPECT_LE(costs[node], least + of_float) << "node " << node;
    not_nearest += parent != nearest_node;
  }
  EXPECT_GT(not_nearest, 20);
}

INSTANTIATE_TEST_SUITE_P(Rrt, LeastCostParent,
                         testing::Values("rrt-opt-euc", "rrt-opt-bound", "rrt-opt-rs"));

TEST(NearestParent, IsTheNearestByExactLength) {
  const auto [poses, parents] = open_ground_tree("rrt-bsc-rs");
  ASSERT_GT(poses.size(), 100U);
  for (std::size_t node = 1; node < poses.size(); ++node) {
    const auto parent = static_cast<std::size_t>(parents[node]);
    const double taken = reeds_shepp_length(poses[parent], poses[node], default_radius);
    for (std::size_t older = 0; older < node; ++older) {
      EXPECT_LE(taken, reeds_shepp_length(poses[older], poses[node], default_radius) + of_float);
    }
  }
}

}  // namespace
}  // namespace vandplan

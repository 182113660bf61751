// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/search.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vandplan::search {
namespace {

TEST(Tree, BranchRunsFromTheRootToTheNode) {
  Tree tree({0, 0, 0}, 4);
  const NodeId a = tree.add({1, 0, 0}, 0, 1);
  tree.add({9, 9, 0}, 0, 13);
  const NodeId b = tree.add({2, 0, 0}, a, 2);
  const std::vector<Pose> expected = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(tree.branch(b), expected);
  EXPECT_EQ(tree.cost_to_come(b), 2);
}

TEST(Tree, FloatHeadingsAreWrapped) {
  Tree tree({0, 0, 3 * std::numbers::pi}, 1);
  EXPECT_EQ(tree.heading()[0], -std::numbers::pi_v<float>);
  EXPECT_EQ(tree.pose(0).heading, 3 * std::numbers::pi);
}

}  // namespace
}  // namespace vandplan::search

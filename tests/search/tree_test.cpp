// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/search.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vandplan::search {
namespace {

TEST(Tree, BranchRunsFromTheRootToTheNode) {
  Tree tree(LocalPose({0, 0, 0}), 4);
  const NodeId a = tree.add(LocalPose({1, 0, 0}), 0, 1);
  tree.add(LocalPose({9, 9, 0}), 0, 13);
  const NodeId b = tree.add(LocalPose({2, 0, 0}), a, 2);
  const std::vector<LocalPose> expected = {tree.pose(0), tree.pose(a), tree.pose(b)};
  EXPECT_EQ(tree.branch(b), expected);
  EXPECT_EQ(tree.cost_to_come(b), 2);
}

TEST(Tree, FloatHeadingsAreWrapped) {
  Tree tree(LocalPose({0, 0, 3 * std::numbers::pi}), 1);
  EXPECT_EQ(tree.heading()[0], -std::numbers::pi_v<float>);
  EXPECT_EQ(tree.pose(0).heading, 3 * std::numbers::pi);
}

}  // namespace
}  // namespace vandplan::search

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How far is a node of a tree from a sample for somebody who drives in one gear alone?
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "../support/cases.h"
#include "lab/estimates.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"

namespace vandplan {
namespace {

using search::Estimate, search::Tree;

constexpr double radius = 7;

/// Length from the root of a tree to a sample, as it is estimated.
double estimated(search::GearSign gear, Estimate estimate, const Pose& node, const Pose& sample) {
  const LocalPose root(node);
  const Tree tree(root, 1);
  std::vector<float> lengths(1);
  search::estimate_lengths_in(gear, estimate, tree, sample, radius, lengths);
  return static_cast<double>(lengths[0]);
}

// Driving to the sample in reverse is driving from it forward, backwards.
TEST(EstimatesInOneGear, ExactOnesAreThoseOfDubins) {
  for_each_case(1, 500, [](Rng& rng) {
    const Pose node = uniform_pose({-40, 40, -40, 40}, rng);
    const Pose sample = uniform_pose({-40, 40, -40, 40}, rng);
    // Float headings: at a jump of the length it may be that of either side.
    const auto is_near = [](double a, double b) {
      return std::abs(a - b) < 1e-3 ||
             std::abs(std::abs(a - b) - 2 * std::numbers::pi * radius) < 1;
    };
    EXPECT_TRUE(is_near(estimated(1, Estimate::reeds_shepp, node, sample),
                        dubins_length(node, sample, radius)))
        << as_code(node) << " " << as_code(sample);
    EXPECT_TRUE(is_near(estimated(-1, Estimate::reeds_shepp, node, sample),
                        dubins_length(sample, node, radius)))
        << as_code(node) << " " << as_code(sample);
  });
}

TEST(EstimatesInOneGear, TablesHoldThemAtTheirGridPoints) {
  const HeuristicTable table = thesis_table(1);
  int told_apart = 0;
  for (int x = 0; x < table.positions(); x += 3) {
    for (int y = 0; y < table.positions(); y += 4) {
      for (int i = 0; i + 1 < table.headings(); ++i) {
        const HeuristicTable::GridPoint point{x, y, i, (3 * i + x) % (table.headings() - 1)};
        const Pose node = table.node_of(point);
        const Pose sample = table.sample_of(point);
        const double there = dubins_length(node, sample, radius);
        const double back = dubins_length(sample, node, radius);
        EXPECT_NEAR(estimated(1, Estimate::hlut_1, node, sample), there, 1e-3);
        told_apart += std::abs(there - back) > 1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(told_apart, 50);  // it matters which way
}

TEST(EstimatesInOneGear, OutsideOfATableItIsEuclid) {
  EXPECT_NEAR(estimated(1, Estimate::hlut_1, {0, 0, 2}, {30, 40, 0}), 50, 1e-4);
  EXPECT_NEAR(estimated(-1, Estimate::hlut_1, {0, 0, 2}, {30, 40, 0}), 50, 1e-4);
}

// Straight ahead: forward that is the distance, and in reverse a long way around.
TEST(EstimatesInOneGear, ReverseIsTheOtherWay) {
  for (const Estimate estimate : {Estimate::hlut_1, Estimate::hlut_4, Estimate::reeds_shepp}) {
    EXPECT_NEAR(estimated(1, estimate, {0, 0, 0}, {8, 0, 0}), 8, 1e-3);
    EXPECT_GT(estimated(-1, estimate, {0, 0, 0}, {8, 0, 0}), 30);
    EXPECT_NEAR(estimated(-1, estimate, {0, 0, 0}, {-8, 0, 0}), 8, 1e-3);
    EXPECT_GT(estimated(1, estimate, {0, 0, 0}, {-8, 0, 0}), 30);
  }
}

}  // namespace
}  // namespace vandplan

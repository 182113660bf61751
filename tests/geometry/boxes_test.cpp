// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What lies in a box, and which of many boxes overlap one?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/box_tree.h"
#include "vandplan/random.h"

namespace vandplan::geometry {
namespace {

TEST(Bounds, HoldTheirBorder) {
  const Bounds box{-2, 3, 5, 9};
  for (const Point& point :
       {Point{-2, 5}, {-2, 9}, {3, 5}, {3, 9}, {0, 5}, {0, 9}, {-2, 7}, {3, 7}}) {
    EXPECT_TRUE(contains(box, point)) << point.x << ' ' << point.y;
  }
  for (const Point& point : {Point{-2.001, 7}, {3.001, 7}, {0, 4.999}, {0, 9.001}}) {
    EXPECT_FALSE(contains(box, point)) << point.x << ' ' << point.y;
  }
}

bool overlap(const Bounds& a, const Bounds& b) {
  return a.x_min <= b.x_max && b.x_min <= a.x_max && a.y_min <= b.y_max && b.y_min <= a.y_max;
}

/// Up to 40 m wide, on whole metres, so that some only touch.
Bounds random_box(Rng& rng) {
  const auto whole = [&](double low, double high) { return std::floor(uniform(low, high, rng)); };
  const double x = whole(-100, 100);
  const double y = whole(-100, 100);
  return {x, x + whole(0, 41), y, y + whole(0, 41)};
}

TEST(BoxTree, FindsWhatOverlaps) {
  Rng rng(5);
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 64U, 65U, 300U, 600U}) {
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < count; ++i) boxes.push_back(random_box(rng));
    const BoxTree tree(boxes);
    for (int i = 0; i < 200; ++i) {
      const Bounds query = random_box(rng);
      std::vector<std::uint32_t> found;
      EXPECT_FALSE(tree.any(query, [&](std::uint32_t box) {
        found.push_back(box);
        return false;
      }));
      std::vector<std::uint32_t> expected;
      for (std::uint32_t box = 0; box < count; ++box) {
        if (overlap(boxes[box], query)) expected.push_back(box);
      }
      EXPECT_EQ(found, expected) << count;
    }
  }
}

TEST(BoxTree, TakesBoxesInTheirSpatialOrderToo) {
  Rng rng(6);
  std::vector<Bounds> boxes;
  for (int i = 0; i < 500; ++i) boxes.push_back(random_box(rng));
  std::vector<std::uint32_t> order = spatial_order(boxes);
  std::vector<Bounds> ordered;
  for (const std::uint32_t i : order) ordered.push_back(boxes[i]);
  std::ranges::sort(order);
  for (std::uint32_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
  const BoxTree tree(ordered);
  for (std::uint32_t i = 0; i < ordered.size(); ++i) {
    EXPECT_TRUE(tree.any(ordered[i], [&](std::uint32_t box) { return box == i; }));
  }
}

}  // namespace
}  // namespace vandplan::geometry

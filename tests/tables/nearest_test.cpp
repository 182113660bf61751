// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The nearest node is that of comparing all exact lengths, ties included.

#include "vandplan/random.h"
#include "vandplan/tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

#include "support/cases.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using std::numbers::pi;

/// The oracle, and how many nodes are as near as the nearest.
struct Expected {
  std::int32_t node = -1;
  double length = std::numeric_limits<double>::infinity();
  int ties = 0;
};

Expected by_all_lengths(const std::vector<Pose>& nodes, const Pose& sample, double radius) {
  Expected best;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double length = reeds_shepp_length(nodes[i], sample, radius);
    if (length == best.length) ++best.ties;
    if (length < best.length) best = {static_cast<std::int32_t>(i), length, 1};
  }
  return best;
}

NearestNodes with(const std::vector<Pose>& nodes, double radius) {
  NearestNodes all(radius);
  for (const Pose& node : nodes) all.add(node);
  return all;
}

void expect_same(const NearestNodes& all, const std::vector<Pose>& nodes, const Pose& sample,
                 double radius) {
  const Expected expected = by_all_lengths(nodes, sample, radius);
  const auto found = all.nearest(sample);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->node, expected.node) << as_code(sample) << ", radius " << as_code(radius);
  EXPECT_EQ(found->length, expected.length);
  EXPECT_GE(found->exact_solves, expected.ties);
}

std::vector<Pose> uniform_poses(std::size_t count, const Bounds& box, Rng& rng) {
  std::vector<Pose> poses(count);
  for (Pose& pose : poses) pose = uniform_pose(box, rng);
  return poses;
}

TEST(NearestNodes, NoneOfNone) { EXPECT_FALSE(NearestNodes(7.0).nearest({1, 2, 3})); }

TEST(NearestNodes, AreThoseOfAllLengthsAmongUniformNodes) {
  for_each_case(1, 300, [](Rng& rng) {
    const double radius = uniform(0.5, 20.0, rng);
    const double reach = std::pow(10.0, uniform(-1.0, 3.0, rng));
    const std::size_t count = 1 + rng() % (uniform01(rng) < 0.8 ? 100 : 4000);
    const std::vector<Pose> nodes = uniform_poses(count, {-reach, reach, -reach, reach}, rng);
    const NearestNodes all = with(nodes, radius);
    for (int i = 0; i < 20; ++i) {  // two in five of them outside of all nodes
      const double wide = 1.3 * reach;
      expect_same(all, nodes, uniform_pose({-wide, wide, -wide, wide}, rng), radius);
    }
  });
}

TEST(NearestNodes, AreThoseOfAllLengthsAsTheTreeGrows) {
  for_each_case(2, 20, [](Rng& rng) {
    std::vector<Pose> nodes;
    NearestNodes all(7.0);
    double reach = 1.0;  // later nodes lie further out, beyond the grid of the earlier ones
    for (int i = 0; i < 600; ++i) {
      reach *= 1.01;
      nodes.push_back(uniform_pose({-reach, reach, -reach / 5, reach / 5}, rng));
      all.add(nodes.back());
      expect_same(all, nodes, uniform_pose({-reach, reach, -reach, reach}, rng), 7.0);
    }
  });
}

// The images of a node under the symmetries of the length are exactly as near to the origin.
TEST(NearestNodes, TiesGoToTheOlderNode) {
  int ties = 0;
  for_each_case(3, 300, [&ties](Rng& rng) {
    std::vector<Pose> nodes;
    for (int i = 0; i < 40; ++i) {
      const Pose p = uniform_pose({0, 30, 0, 30}, rng);
      for (const Pose& image : {p, Pose{p.x, -p.y, -p.heading}, Pose{-p.x, p.y, -p.heading},
                                Pose{-p.x, -p.y, p.heading}}) {
        nodes.push_back(image);
      }
    }
    std::shuffle(nodes.begin(), nodes.end(), rng);
    expect_same(with(nodes, 7.0), nodes, {0, 0, 0}, 7.0);
    ties += by_all_lengths(nodes, {0, 0, 0}, 7.0).ties > 1 ? 1 : 0;
  });
  EXPECT_GE(ties, cases(300));  // or the test says nothing about them
}

TEST(NearestNodes, TheOldestOfManyEqualNodesIsNearest) {
  Rng rng(4);
  std::vector<Pose> nodes = uniform_poses(50, {-20, 20, -20, 20}, rng);
  for (int i = 0; i < 1000; ++i) nodes.push_back({5, 6, 1});
  const NearestNodes all = with(nodes, 7.0);
  expect_same(all, nodes, {5, 6, 1}, 7.0);
  expect_same(all, nodes, {5, 6.01, 1}, 7.0);
  expect_same(all, nodes, {4.5, 6, 1 + 4 * pi}, 7.0);
}

TEST(NearestNodes, ANodeAtTheSampleIsNearest) {
  for_each_case(5, 200, [](Rng& rng) {
    const std::vector<Pose> nodes = uniform_poses(200, {-5, 5, -5, 5}, rng);
    const NearestNodes all = with(nodes, 7.0);
    const Pose& sample = nodes[rng() % nodes.size()];
    expect_same(all, nodes, sample, 7.0);
    EXPECT_EQ(all.nearest(sample)->length, 0.0);
  });
}

// A fan of nodes that nearly agree: their lengths differ in the last places of a float.
TEST(NearestNodes, AreThoseOfAllLengthsWhereFloatsCannotTell) {
  for_each_case(6, 200, [](Rng& rng) {
    std::vector<Pose> nodes;
    const Pose centre = uniform_pose({-100, 100, -100, 100}, rng);
    const auto little = [&rng] { return std::pow(10.0, uniform(-12.0, -3.0, rng)); };
    for (int i = 0; i < 200; ++i) {
      nodes.push_back({centre.x + little(), centre.y - little(), centre.heading + little()});
    }
    expect_same(with(nodes, 7.0), nodes, uniform_pose({-100, 100, -100, 100}, rng), 7.0);
    expect_same(with(nodes, 7.0), nodes, centre, 7.0);
  });
}

TEST(NearestNodes, AreThoseOfAllLengthsOnALineAndFarFromTheOrigin) {
  for_each_case(7, 100, [](Rng& rng) {
    const double far = uniform01(rng) < 0.5 ? 8.7e9 : 0.0;
    const Bounds line{far - 50, far + 50, -far, -far};
    const std::vector<Pose> nodes = uniform_poses(500, line, rng);
    const NearestNodes all = with(nodes, 7.0);
    expect_same(all, nodes, uniform_pose(line, rng), 7.0);
    expect_same(all, nodes, uniform_pose({far - 60, far + 60, -far - 30, -far + 30}, rng), 7.0);
  });
}

TEST(NearestNodes, HeadingsMayBeAnyAngle) {
  for_each_case(8, 100, [](Rng& rng) {
    std::vector<Pose> nodes = uniform_poses(300, {-20, 20, -20, 20}, rng);
    for (Pose& node : nodes) node.heading = uniform(-30, 30, rng);
    const Pose sample{uniform(-20, 20, rng), uniform(-20, 20, rng), uniform(-30, 30, rng)};
    expect_same(with(nodes, 7.0), nodes, sample, 7.0);
  });
}

/// The oracle of several nodes: all of them by length, those that were removed left out.
std::vector<NearNode> by_length(const std::vector<Pose>& nodes, const std::vector<bool>& removed,
                                const Pose& sample, const NearWanted& wanted) {
  std::vector<NearNode> all;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double length = reeds_shepp_length(nodes[i], sample, 7.0);
    if (!removed[i] && length <= wanted.within)
      all.push_back({static_cast<std::int32_t>(i), length});
  }
  std::ranges::stable_sort(all, {}, &NearNode::length);
  if (all.size() > wanted.count) all.resize(wanted.count);
  return all;
}

TEST(NearestNodes, SeveralAreTheFirstOfAllByLengthWhateverIsAddedAndRemoved) {
  for_each_case(10, 60, [](Rng& rng) {
    std::vector<Pose> nodes;
    std::vector<bool> removed;
    NearestNodes all(7.0);
    std::size_t left = 0;
    const double removing = uniform(0.0, 0.6, rng);  // more are removed than added, sometimes
    for (int i = 0; i < 600; ++i) {
      if (uniform01(rng) < removing && left > 0) {
        std::size_t node = rng() % nodes.size();
        while (removed[node]) node = (node + 1) % nodes.size();
        all.remove(static_cast<std::int32_t>(node));
        removed[node] = true;
        --left;
      } else {
        nodes.push_back(uniform_pose({-40, 40, -40, 40}, rng));
        removed.push_back(false);
        all.add(nodes.back());
        ++left;
      }
      ASSERT_EQ(all.size(), left);
      if (i % 10 > 0) continue;
      const Pose sample = uniform_pose({-50, 50, -50, 50}, rng);
      const std::size_t most = 1 + rng() % 60;
      const double within = uniform(0.0, 60.0, rng);
      for (const NearWanted& wanted :
           {NearWanted{}, {.count = most}, {.within = within}, {.count = most, .within = within}}) {
        const std::vector<NearNode> expected = by_length(nodes, removed, sample, wanted);
        EXPECT_EQ(all.nearest(sample, wanted), expected);
        std::vector<std::int32_t> found = all.nearest_in_any_order(sample, wanted);
        std::vector<std::int32_t> numbers;
        for (const NearNode& near : expected) numbers.push_back(near.node);
        std::ranges::sort(found);
        std::ranges::sort(numbers);
        EXPECT_EQ(found, numbers);
      }
      const auto nearest = all.nearest(sample);
      ASSERT_EQ(nearest.has_value(), left > 0);
      if (nearest) {
        EXPECT_EQ(nearest->node, by_length(nodes, removed, sample, {.count = 1})[0].node);
      }
    }
  });
}

TEST(NearestNodes, AmongEquallyNearOnesTheOlderComeFirst) {
  NearestNodes all(7.0);
  for (int i = 0; i < 100; ++i) all.add({i % 2 == 0 ? 5.0 : -5.0, 0, 0});
  const auto found = all.nearest({0, 0, 0}, {.count = 10});
  ASSERT_EQ(found.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(found[i], (NearNode{static_cast<std::int32_t>(i), 5.0}));
  }
  std::vector<std::int32_t> unordered = all.nearest_in_any_order({0, 0, 0}, {.count = 10});
  std::ranges::sort(unordered);
  EXPECT_EQ(unordered, (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(all.nearest({0, 0, 0}, {.within = 5.0}).size(), 100U);
  EXPECT_TRUE(all.nearest({0, 0, 0}, {.within = std::nextafter(5.0, 0.0)}).empty());
  EXPECT_TRUE(all.nearest({0, 0, 0}, {.count = 0}).empty());
}

TEST(NearestNodes, ACopyGrowsOnItsOwn) {
  NearestNodes first(7.0);
  first.add({10, 0, 0});
  NearestNodes second = first;
  second.add({1, 0, 0});
  EXPECT_EQ(first.size(), 1U);
  EXPECT_EQ(first.nearest({0, 0, 0})->length, 10);
  EXPECT_EQ(second.size(), 2U);
  EXPECT_EQ(second.nearest({0, 0, 0})->length, 1);
  first = second;
  first.add({0, 0, 0});
  EXPECT_EQ(second.nearest({0, 0, 0})->length, 1);
  EXPECT_EQ(first.nearest({0, 0, 0})->node, 2);
}

TEST(NearestNodes, FewLengthsAreComputed) {
  Rng rng(9);
  for (const double reach : {50.0, 200.0}) {
    const Bounds box{-reach, reach, -reach, reach};
    const NearestNodes all = with(uniform_poses(5000, box, rng), 7.0);
    std::vector<std::int64_t> solves;
    for (int i = 0; i < 1000; ++i)
      solves.push_back(all.nearest(uniform_pose(box, rng))->exact_solves);
    std::sort(solves.begin(), solves.end());
    EXPECT_EQ(solves[solves.size() / 2], 1);
    EXPECT_LE(solves.back(), 10);
  }
}

}  // namespace
}  // namespace vandplan

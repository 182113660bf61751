// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Do the trees of the family grow as their papers say? Each is grown again by brute force.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "lab/rewired_tree.h"
#include "support/cases.h"
#include "support/numbers.h"
#include "support/problems.h"
#include "support/radius.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

double length_between(const Pose& from, const Pose& to) {
  return reeds_shepp_length(from, to, default_radius);
}

Problem open_ground() { return problem_of({0, 0, 0}, {40, 30, 1}, {}, {-1e3, 1e3, -1e3, 1e3}); }

Problem around_the_bent_wall() {
  return problem_of({0, 0, 0}, {30, 0, 0}, {box(14, -12, 16, 12), box(-10, 12, 16, 14)});
}

Problem goal_walled_in() {
  return problem_of(
      {0, 0, 0}, {60, 0, 0},
      {box(40, -20, 80, -18), box(40, 18, 80, 20), box(40, -20, 42, 20), box(78, -20, 80, 20)});
}

using TextSettings = std::vector<std::pair<std::string, std::string>>;

PlanResult run(const Problem& problem, const std::string& name, std::int64_t iterations,
               const TextSettings& settings = {}) {
  const Planner planner = planner_named(name);
  PlanOptions options{.cost = shortest_style};
  options.budget.max_iterations = iterations;
  set_option(options, planner, "region", "scene");
  set_option(options, planner, "keep_tree", "true");
  for (const auto& [key, value] : settings) set_option(options, planner, key, value);
  return plan(problem, planner, options);
}

/// The numbers of the `count` nodes that are nearest to a pose, nearest first.
std::vector<std::size_t> nearest(const std::vector<Pose>& nodes, const Pose& to,
                                 std::size_t count) {
  std::vector<std::pair<double, std::size_t>> all;
  for (std::size_t i = 0; i < nodes.size(); ++i) all.emplace_back(length_between(nodes[i], to), i);
  std::ranges::sort(all);
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < std::min(count, all.size()); ++i) first.push_back(all[i].second);
  return first;
}

// ---- hRRT, IkRRT, BkRRT ----

struct Reading {
  std::string planner;
  std::size_t k;
  std::string floor_reading;
  double floor;
};

// On open ground, where every edge is free.
TreeSnapshot guided_tree(const Reading& reading, int iterations) {
  const Problem ground = open_ground();
  const Task& task = ground.task();
  const Local<Bounds> region = sampling_region(task, Region::scene);
  Rng rng(1);
  TreeSnapshot tree{{task.start}, {-1}};
  std::vector<double> costs = {0.0};
  std::vector<double> through = {length_between(task.start, task.goal)};
  const auto passes = [&](std::size_t node) {
    const double most = std::ranges::max(through);
    const double best = through[0];
    const double quality = most == best ? 1.0 : 1.0 - (through[node] - best) / (most - best);
    const double share = reading.floor_reading == "max" ? std::max(quality, reading.floor)
                                                        : std::min(quality, reading.floor);
    return uniform01(rng) < share;
  };
  for (int i = 0; i < iterations; ++i) {
    const bool is_goal = uniform01(rng) < 0.05;
    const LocalPose sample = is_goal ? task.goal : uniform_pose(region, rng);
    std::vector<std::size_t> near = nearest(tree.poses, sample, reading.k);
    if (reading.planner == "bkrrt") {
      near = {*std::ranges::min_element(near, {}, [&](std::size_t n) { return through[n]; })};
    }
    const auto parent = std::ranges::find_if(near, passes);
    if (parent == near.end() || is_goal) continue;
    costs.push_back(costs[*parent] + length_between(tree.poses[*parent], sample));
    through.push_back(costs.back() + length_between(sample, task.goal));
    tree.poses.push_back(sample);
    tree.parents.push_back(static_cast<std::int32_t>(*parent));
  }
  return tree;
}

class GuidedTree : public testing::TestWithParam<Reading> {};

TEST_P(GuidedTree, GrowsAsItsPaperSays) {
  const Reading& reading = GetParam();
  TextSettings settings = {{"floor", std::to_string(reading.floor)},
                           {"floor_reading", reading.floor_reading}};
  if (reading.planner != "hrrt") settings.emplace_back("k", std::to_string(reading.k));
  const int iterations = std::max(cases(600), 100);
  const PlanResult result = run(open_ground(), reading.planner, iterations, settings);
  const TreeSnapshot expected = guided_tree(reading, iterations);
  ASSERT_TRUE(result.tree);
  EXPECT_EQ(result.tree->poses, expected.poses);
  EXPECT_EQ(result.tree->parents, expected.parents);
  EXPECT_LE(counter(result, "refused") + counter(result, "nodes") - 1, result.iterations);
}

INSTANTIATE_TEST_SUITE_P(
    Trees, GuidedTree,
    testing::Values(Reading{"hrrt", 1, "max", 0.1}, Reading{"hrrt", 1, "min", 0.4},
                    Reading{"ikrrt", 5, "max", 0.1}, Reading{"ikrrt", 3, "min", 0.1},
                    Reading{"bkrrt", 5, "max", 0.1}, Reading{"bkrrt", 8, "min", 0.4}),
    [](const auto& test) { return test.param.planner + "_" + test.param.floor_reading; });

TEST(GuidedTree, ASampleThatNobodyMayReachIsCounted) {
  const PlanResult result =
      run(open_ground(), "hrrt", 100, {{"floor", "0"}, {"floor_reading", "min"}});
  EXPECT_EQ(counter(result, "refused"), 100);
  EXPECT_EQ(counter(result, "nodes"), 1);
}

TEST(GuidedTree, TakesTheEstimateThatItIsTold) {
  const auto tree = run(open_ground(), "hrrt", 300).tree;
  EXPECT_EQ(run(open_ground(), "hrrt:reeds-shepp", 300).tree->poses, tree->poses);
  EXPECT_NE(run(open_ground(), "hrrt:euclid", 300).tree->poses, tree->poses);
}

TEST(GuidedTree, RanksByTheEstimateThatItIsTold) {
  const PlanResult result =
      run(open_ground(), "hrrt", 300, {{"ranking", "euclid"}, {"floor", "1"}});
  const std::vector<Pose>& poses = result.tree->poses;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const auto away = [&, at = i](std::size_t n) {
      return std::hypot(poses[n].x - poses[at].x, poses[n].y - poses[at].y);
    };
    const double taken = away(static_cast<std::size_t>(result.tree->parents[i]));
    for (std::size_t older = 0; older < i; ++older) EXPECT_LE(taken, away(older) + 1e-3);
  }
}

// ---- RRT* ----

// RRT* among obstacles, every cost summed up from the start whenever it is asked for.
struct Rewired {
  explicit Rewired(const Task& of_task) : task(of_task), connector(of_task), poses{of_task.start} {}

  [[nodiscard]] double cost(std::size_t node) const {
    if (node == 0) return 0.0;
    const auto above = static_cast<std::size_t>(parents[node]);
    return cost(above) + length_between(poses[above], poses[node]);
  }

  void add(const LocalPose& pose) {
    const double k = 1.1 * std::numbers::e * (1.0 + 1.0 / 3.0) *
                     std::log(static_cast<double>(poses.size()) + 1.0);
    const auto near = nearest(poses, pose, static_cast<std::size_t>(std::ceil(k)));
    double least = infinity;
    std::int32_t parent = -1;
    for (const std::size_t node : near) {
      const double total = cost(node) + length_between(poses[node], pose);
      if (total >= least || !connector.connect(Local(poses[node]), pose)) continue;
      least = total;
      parent = static_cast<std::int32_t>(node);
    }
    if (parent < 0) return;
    poses.push_back(pose);
    parents.push_back(parent);
    for (const std::size_t node : near) {
      if (least + length_between(pose, poses[node]) >= cost(node)) continue;
      if (!connector.connect(pose, Local(poses[node]))) continue;
      parents[node] = static_cast<std::int32_t>(poses.size()) - 1;
      ++rewired;
    }
  }

  const Task& task;
  search::Connector connector;
  std::vector<Pose> poses;
  std::vector<std::int32_t> parents = {-1};
  int rewired = 0;
};

/// Which pose has which parent, whatever the order of the nodes.
std::map<std::tuple<double, double, double>, Pose> edges_of(
    const std::vector<Pose>& poses, const std::vector<std::int32_t>& parents) {
  std::map<std::tuple<double, double, double>, Pose> edges;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    edges[{poses[i].x, poses[i].y, poses[i].heading}] = poses[static_cast<std::size_t>(parents[i])];
  }
  return edges;
}

TEST(RrtStar, RewiresAsItsPaperSays) {
  const Problem problem = around_the_bent_wall();
  const int iterations = std::max(cases(1000), 200);
  const PlanResult result = run(problem, "rrt-star", iterations,
                                {{"goal_bias", "0"}, {"informed", "false"}, {"range", "1000"}});
  Rewired expected(problem.task());
  Rng rng(1);
  const Local<Bounds> region = sampling_region(problem.task(), Region::scene);
  for (int i = 0; i < iterations; ++i) {
    (void)uniform01(rng);  // against the goal's share
    expected.add(uniform_pose(region, rng));
  }
  EXPECT_GT(expected.rewired, 20);
  EXPECT_EQ(counter(result, "rewired"), expected.rewired);
  EXPECT_EQ(edges_of(result.tree->poses, result.tree->parents),
            edges_of(expected.poses, expected.parents));
}

TEST(RrtStar, ItsTreeHasParentsBeforeChildren) {
  const PlanResult result = run(around_the_bent_wall(), "rrt-star", 2000);
  const auto& parents = result.tree->parents;
  EXPECT_EQ(parents[0], -1);
  EXPECT_GT(counter(result, "rewired"), 0);
  for (std::size_t i = 1; i < parents.size(); ++i) {
    EXPECT_GE(parents[i], 0);
    EXPECT_LT(static_cast<std::size_t>(parents[i]), i);
  }
}

TEST(RrtStar, SamplesThatAreOfUseImproveTheSamePathFurther) {
  for (const char* seed : {"1", "2", "3"}) {
    const TextSettings plain = {{"seed", seed}, {"informed", "false"}};
    const PlanResult all = run(around_the_bent_wall(), "rrt-star", 2000, plain);
    const PlanResult informed = run(around_the_bent_wall(), "rrt-star", 2000, {{"seed", seed}});
    ASSERT_TRUE(all.path && informed.path);
    EXPECT_EQ(informed.anytime.front(),
              (CostSample{informed.anytime.front().time, all.anytime.front().iteration,
                          all.anytime.front().cost}));
    EXPECT_LT(counter(informed, "nodes"), counter(all, "nodes"));
    EXPECT_LT(informed.cost, all.cost);
  }
  // Once the path is the shortest of all, no sample is of use.
  const TextSettings goals = {{"goal_bias", "0.9"}};
  EXPECT_EQ(counter(run(open_ground(), "rrt-star", 500, goals), "nodes"), 1);
}

TEST(RrtStar, WithoutTryingTheGoalItIsReachedBySamplesOfIt) {
  const PlanResult sampled = run(around_the_bent_wall(), "rrt-star", 2000, {{"try_goal", "false"}});
  ASSERT_TRUE(sampled.path);
  EXPECT_EQ(
      run(around_the_bent_wall(), "rrt-star", 2000, {{"try_goal", "false"}, {"goal_bias", "0"}})
          .status,
      PlanStatus::iteration_limit);
}

TEST(RrtStar, StepsAreNoLongerThanTheRange) {
  const TextSettings steps = {{"range", "1"}, {"rewire_factor", "0.1"}, {"informed", "false"}};
  const std::vector<Pose> poses = run(open_ground(), "rrt-star", 300, steps).tree->poses;
  ASSERT_GT(poses.size(), 50U);
  for (const Pose& pose : poses) {
    const std::size_t neighbour = nearest(poses, pose, 2)[1];
    EXPECT_LE(length_between(poses[neighbour], pose), 1 * default_radius + 1e-9);
  }
}

// ---- RRT-Connect ----

TEST(RrtConnect, TriesTheGoalFirst) {
  const PlanResult result = run(open_ground(), "rrt-connect", 10, {{"range", "100"}});
  ASSERT_TRUE(result.path);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_NEAR(result.cost, length_between({0, 0, 0}, {40, 30, 1}), 1e-9);
}

TEST(RrtConnect, GrowsOneTreeFromTheStartAndOneFromTheGoal) {
  const Problem problem = goal_walled_in();
  const PlanResult result = run(problem, "rrt-connect", 500);
  const auto& [poses, parents] = *result.tree;
  ASSERT_GT(poses.size(), 100U);
  EXPECT_EQ(poses[0], problem.start());
  EXPECT_EQ(poses[1], problem.goal());
  std::vector<bool> is_inside = {false, true};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(parents[i] < 0, i < 2);
    if (i < 2) continue;
    const auto parent = static_cast<std::size_t>(parents[i]);
    ASSERT_LT(parent, i);
    EXPECT_LE(length_between(poses[parent], poses[i]), 10 * default_radius + 1e-9);
    is_inside.push_back(is_inside[parent]);
    const bool in_room = poses[i].x > 42 && poses[i].x < 78 && std::abs(poses[i].y) < 18;
    EXPECT_EQ(is_inside[i], in_room);
  }
  EXPECT_GT(std::ranges::count(is_inside, true), 10);
}

// A single sample brings one tree step by step to what the other one has reached.
TEST(RrtConnect, ConnectsStepByStep) {
  const PlanResult result = run(open_ground(), "rrt-connect", 10, {{"range", "0.5"}});
  ASSERT_TRUE(result.path);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_NEAR(result.cost, length_between({0, 0, 0}, {40, 30, 1}), 1e-6);
  EXPECT_GT(result.tree->poses.size(), 10U);
}

TEST(RrtConnect, EndsWithItsFirstPath) {
  const PlanResult result = run(around_the_bent_wall(), "rrt-connect", 100'000);
  ASSERT_TRUE(result.path);
  EXPECT_EQ(result.anytime.size(), 1U);
  EXPECT_EQ(result.anytime.front().iteration, result.iterations);
  EXPECT_LT(result.iterations, 100'000);
}

// ---- all of them ----

class FamilyTree : public testing::TestWithParam<std::string> {};

TEST_P(FamilyTree, EndsWhenItIsFull) {
  const PlanResult result = run(goal_walled_in(), GetParam(), 100'000, {{"max_nodes", "200"}});
  EXPECT_EQ(result.status, PlanStatus::node_limit);
  EXPECT_EQ(counter(result, "nodes"), 200);
}

TEST_P(FamilyTree, SteersContinuouslyWhereItIsTold) {
  for (const char* steering : {"continuous-between-stops", "continuous"}) {
    for (const char* seed : {"1", "2", "3"}) {
      const PlanResult result =
          run(around_the_bent_wall(), GetParam(), 1500, {{"steering", steering}, {"seed", seed}});
      EXPECT_EQ(result.status, PlanStatus::solved) << steering << ", seed " << seed;
      ASSERT_FALSE(result.anytime.empty());
      EXPECT_NEAR(result.anytime.back().cost, result.cost, 1e-6);
    }
  }
}

TEST_P(FamilyTree, KeepsAMargin) {
  const PlanResult result = run(around_the_bent_wall(), GetParam(), 1500, {{"margin", "0.5"}});
  ASSERT_TRUE(result.check);
  EXPECT_GT(result.check->clearance, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Trees, FamilyTree,
                         testing::Values("hrrt", "ikrrt", "bkrrt", "rrt-connect", "rrt-star"));

// ---- the tree that is rewired ----

TEST(RewiredTree, CostsFollowWhateverIsMoved) {
  for_each_case(1, 100, [](Rng& rng) {
    search::RewiredTree tree(LocalPose({0, 0, 0}));
    std::vector<std::int32_t> parents = {-1};
    std::vector<double> edges = {0.0};
    const auto is_below = [&](std::int32_t node, std::int32_t above) {
      while (node >= 0 && node != above) node = parents[static_cast<std::size_t>(node)];
      return node == above;
    };
    for (int i = 0; i < 200; ++i) {
      const auto parent = static_cast<std::int32_t>(rng() % parents.size());
      const double edge = static_cast<double>(rng() % 100);  // whole: sums are exact
      const auto node = static_cast<std::int32_t>(rng() % parents.size());
      if (node > 0 && !is_below(parent, node) && uniform01(rng) < 0.5) {
        tree.move(node, parent, edge);
        parents[static_cast<std::size_t>(node)] = parent;
        edges[static_cast<std::size_t>(node)] = edge;
      } else {
        tree.add(LocalPose({static_cast<double>(parents.size()), 0, 0}), parent, edge);
        parents.push_back(parent);
        edges.push_back(edge);
      }
    }
    for (std::size_t i = 0; i < parents.size(); ++i) {
      double cost = 0.0;
      for (auto n = static_cast<std::int32_t>(i); n >= 0; n = parents[static_cast<std::size_t>(n)])
        cost += edges[static_cast<std::size_t>(n)];
      EXPECT_EQ(tree.cost_to_come(static_cast<std::int32_t>(i)), cost);
      EXPECT_EQ(tree.parent(static_cast<std::int32_t>(i)), parents[i]);
    }
    const TreeSnapshot snapshot = tree.snapshot();
    ASSERT_EQ(snapshot.poses.size(), parents.size());
    for (std::size_t i = 1; i < parents.size(); ++i) {
      ASSERT_LT(static_cast<std::size_t>(snapshot.parents[i]), i);
      const auto node = static_cast<std::size_t>(snapshot.poses[i].x);
      EXPECT_EQ(snapshot.poses[static_cast<std::size_t>(snapshot.parents[i])].x, parents[node]);
    }
  });
}

}  // namespace
}  // namespace vandplan

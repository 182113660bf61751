// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does a roadmap answer with its shortest way, and the same whoever asked before?

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "lab/milestones.h"
#include "support/cases.h"
#include "support/numbers.h"
#include "support/problems.h"
#include "support/radius.h"
#include "vandplan/graphs.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

constexpr Local<Bounds> yard(Bounds{-40, 40, -40, 40});

/// Two walls with openings, one after the other.
std::shared_ptr<const World> walls() {
  return world_of({.bounds = yard,
                   .obstacles = {box(-12, -30, -10, 40), box(10, -40, 12, 28), box(20, 0, 26, 4)}});
}

LocalPose free_pose(const CollisionChecker& checker, Rng& rng) {
  for (;;) {
    const LocalPose pose = uniform_pose(yard, rng);
    if (checker.is_free(pose)) return pose;
  }
}

search::Milestones grown(const std::shared_ptr<const World>& world, std::size_t nodes,
                         std::uint64_t seed) {
  search::Milestones milestones(world->checker({}), default_radius, {yard, 6, seed});
  while (milestones.size() < nodes) milestones.sample();
  return milestones;
}

TEST(Milestones, AreJoinedToTheNearestOlderOnes) {
  const search::Milestones all = grown(walls(), 200, 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<std::pair<double, std::int32_t>> older;
    for (std::size_t j = 0; j < i; ++j) {
      older.emplace_back(reeds_shepp_length(all.poses()[j], all.poses()[i], default_radius),
                         static_cast<std::int32_t>(j));
    }
    std::sort(older.begin(), older.end());
    older.resize(std::min<std::size_t>(6, older.size()));
    ASSERT_EQ(all.first_edge()[i + 1] - all.first_edge()[i], static_cast<int>(older.size()));
    for (std::size_t k = 0; k < older.size(); ++k) {
      const auto& [node, length] = all.edges()[static_cast<std::size_t>(all.first_edge()[i]) + k];
      EXPECT_EQ(node, older[k].second);
      EXPECT_EQ(length, older[k].first);
    }
  }
}

TEST(Milestones, LaterOnesChangeNothingOfTheFirst) {
  const search::Milestones few = grown(walls(), 50, 2);
  const search::Milestones many = grown(walls(), 300, 2);
  EXPECT_TRUE(std::equal(few.poses().begin(), few.poses().end(), many.poses().begin()));
  EXPECT_TRUE(std::equal(few.edges().begin(), few.edges().end(), many.edges().begin()));
}

/// Length of the shortest way, every edge of which is looked at: Bellman and Ford.
double by_all_edges(const search::Milestones& all, const LocalPose& from, const LocalPose& to) {
  const std::size_t start = all.size();
  const std::size_t goal = all.size() + 1;
  std::vector<LocalPose> poses = all.poses();
  poses.insert(poses.end(), {from, to});
  struct Edge {
    std::size_t a, b;
    double length;
  };
  std::vector<Edge> edges;
  const auto add = [&](std::size_t a, std::size_t b) {
    const Piece piece = reeds_shepp(poses[a], poses[b], default_radius);
    if (all.checker()->is_free(poses[a], piece.view())) edges.push_back({a, b, piece.length});
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::int32_t e = all.first_edge()[i]; e < all.first_edge()[i + 1]; ++e) {
      add(i, static_cast<std::size_t>(all.edges()[static_cast<std::size_t>(e)].node));
    }
  }
  for (const std::size_t end : {start, goal}) {
    for (const NearNode& near : all.nearest().nearest(poses[end], {.count = 12})) {
      add(static_cast<std::size_t>(near.node), end);
    }
  }
  add(start, goal);
  std::vector<double> lengths(poses.size(), infinity);
  lengths[start] = 0;
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (const auto& [a, b, length] : edges) {
      for (const auto& [begin, end] : {std::pair(a, b), std::pair(b, a)}) {
        if (lengths[begin] + length >= lengths[end]) continue;
        lengths[end] = lengths[begin] + length;
        is_changed = true;
      }
    }
  }
  return lengths[goal];
}

TEST(Roadmap, AnswersWithItsShortestWay) {
  const auto world = walls();
  int found = 0;
  for_each_case(3, 60, [&](Rng& rng) {
    const search::Milestones milestones = grown(world, 40 + rng() % 150, rng());
    const Roadmap roadmap(milestones);
    for (int i = 0; i < 5; ++i) {
      const LocalPose from = free_pose(*milestones.checker(), rng);
      const LocalPose to = free_pose(*milestones.checker(), rng);
      const RoadmapAnswer answer = roadmap.route(from, to);
      const double expected = by_all_edges(milestones, from, to);
      ASSERT_EQ(answer.route.has_value(), expected < infinity) << as_code(from) << as_code(to);
      if (!answer.route) continue;
      ++found;
      EXPECT_NEAR(answer.route->length, expected, 1e-9);
      const Path path{from, answer.route->segments};
      EXPECT_NEAR(length(path), expected, 1e-9);
      EXPECT_LT(reeds_shepp_length(end_pose(path), to, default_radius), 1e-5);
      EXPECT_TRUE(milestones.checker()->is_free(from, path.segments));
    }
  });
  EXPECT_GT(found, cases(60) * 2);
}

TEST(Roadmap, AnEstimateThatJumpsStillFindsTheShortestWay) {
  const search::Milestones milestones = grown(walls(), 300, 4);
  const Roadmap roadmap(milestones);
  Rng rng(4);
  for (int i = 0; i < 20; ++i) {
    const LocalPose from = free_pose(*milestones.checker(), rng);
    const LocalPose to = free_pose(*milestones.checker(), rng);
    // Admissible, but it falls by more than an edge is long.
    const auto jumping = [&](const LocalPose& pose) {
      const bool all = static_cast<int>(std::floor(pose.x)) % 2 == 0;
      return all ? reeds_shepp_length(pose, to, default_radius) : 0.0;
    };
    const RoadmapAnswer straight = roadmap.route(from, to);
    const RoadmapAnswer answer = roadmap.route(from, to, {.estimate = jumping});
    ASSERT_EQ(answer.route.has_value(), straight.route.has_value());
    if (!answer.route) continue;
    EXPECT_NEAR(answer.route->length, straight.route->length, 1e-9);
  }
}

TEST(Roadmap, AnswersTheSameWhateverItHasBeenAsked) {
  const search::Milestones milestones = grown(walls(), 400, 5);
  const Roadmap fresh(milestones);
  const Roadmap known(milestones);
  known.check_edges();
  const Roadmap heir(milestones, &known);
  Rng rng(5);
  for (int i = 0; i < 40; ++i) {
    const LocalPose from = free_pose(*milestones.checker(), rng);
    const LocalPose to = free_pose(*milestones.checker(), rng);
    const RoadmapAnswer first = fresh.route(from, to, {.keep_tree = true});
    for (const Roadmap* other : {&known, &heir}) {
      const RoadmapAnswer answer = other->route(from, to, {.keep_tree = true});
      EXPECT_EQ(answer.expansions, first.expansions);
      EXPECT_EQ(answer.tree->poses, first.tree->poses);
      EXPECT_EQ(answer.tree->parents, first.tree->parents);
      ASSERT_EQ(answer.route.has_value(), first.route.has_value());
      if (!answer.route) continue;
      EXPECT_EQ(answer.route->poses, first.route->poses);
    }
  }
}

TEST(Roadmap, IsBuiltForAWorldAndAVehicle) {
  const auto world = walls();
  const Roadmap roadmap = build_roadmap(*world, {}, {.nodes = 150, .neighbours = 5});
  EXPECT_EQ(roadmap.nodes(), 150);
  EXPECT_EQ(roadmap.edges(), 145 * 5 + 4 + 3 + 2 + 1);
  EXPECT_GT(roadmap.samples(), 150);
  EXPECT_TRUE(roadmap.route(LocalPose({-30, 0, 1}), LocalPose({-30, 20, 1})).route);
  const auto stopped = roadmap.route(LocalPose({-30, 0, 1}), LocalPose({-30, 0, 1.5}),
                                     {.is_interrupted = [] { return true; }});
  EXPECT_LE(stopped.expansions, 256);
  EXPECT_THROW((void)build_roadmap(*world, {}, {.nodes = 0}), InputError);
  EXPECT_THROW((void)build_roadmap(*world, {}, {.neighbours = 0}), InputError);
  EXPECT_THROW((void)build_roadmap(*world, {}, {.margin = -1}), InputError);
  EXPECT_THROW((void)build_roadmap(*world, semitrailer(), {.nodes = 5}), InputError);
  EXPECT_THROW((void)build_roadmap(*world, {}, {.region = Local(Bounds{900, 901, 0, 1})}),
               InputError);
}

// ---- the planner ----

PlanOptions roadmap_iterations(std::int64_t count, std::uint64_t seed = 1) {
  PlanOptions options;
  options.budget.max_iterations = count;
  options.budget.seed = seed;
  options.planner.set("nodes", std::int64_t{1000});
  return options;
}

std::vector<Problem> problems_in(const std::shared_ptr<const World>& world) {
  Rng rng(6);
  std::vector<Problem> problems;
  for (int i = 0; i < 8; ++i) {
    const LocalPose from = free_pose(*world->checker({}), rng);
    problems.push_back(make_problem(world, {}, from, free_pose(*world->checker({}), rng)));
  }
  return problems;
}

void expect_same(const PlanResult& result, const PlanResult& expected) {
  EXPECT_EQ(result.status, expected.status);
  EXPECT_EQ(result.path, expected.path);
  EXPECT_EQ(result.iterations, expected.iterations);
  EXPECT_EQ(result.counters, expected.counters);
  ASSERT_EQ(result.anytime.size(), expected.anytime.size());
  for (std::size_t i = 0; i < result.anytime.size(); ++i) {
    EXPECT_EQ(result.anytime[i].cost, expected.anytime[i].cost);
    EXPECT_EQ(result.anytime[i].iteration, expected.anytime[i].iteration);
  }
}

TEST(Prm, AnswersTheSameWhetherTheRoadmapWasThereOrNot) {
  const Planner prm = planner_named("prm");
  const auto shared = walls();
  // Small after large: what is there already must not be used beyond the budget.
  for (const std::int64_t count : {100'000, 70, 150, 400, 64, 2000}) {
    SCOPED_TRACE(count);
    std::vector<PlanResult> alone;
    for (std::size_t i = 0; i < problems_in(shared).size(); ++i) {
      alone.push_back(plan(problems_in(walls())[i], prm, roadmap_iterations(count)));
      EXPECT_LE(alone.back().iterations, count);
    }
    for (const int jobs : {1, 4}) {
      plan_many(problems_in(shared), prm, roadmap_iterations(count), jobs,
                [&](std::size_t i, const PlanResult& result) { expect_same(result, alone[i]); });
    }
  }
}

TEST(Prm, ManyThreadsGrowOneRoadmap) {
  const Planner prm = planner_named("prm");
  const std::vector<Problem> apart = problems_in(walls());
  std::vector<PlanResult> alone;
  for (const Problem& problem : apart) alone.push_back(plan(problem, prm, roadmap_iterations(900)));
  plan_many(problems_in(walls()), prm, roadmap_iterations(900), 8,
            [&](std::size_t i, const PlanResult& result) { expect_same(result, alone[i]); });
}

TEST(Prm, RoadmapsOfOtherOptionsAreOthers) {
  const Planner prm = planner_named("prm");
  const auto world = walls();
  Vehicle wide;
  wide.width = 3.5;
  const Problem problem = make_problem(world, {}, {-30, 0, 0}, {30, -20, 0});
  const Problem of_wide = make_problem(world, wide, {-30, 0, 0}, {30, -20, 0});
  std::vector<PlanOptions> variants(6, roadmap_iterations(1500));
  variants[1].budget.seed = 2;
  variants[2].clearance.margin = 0.5;
  variants[3].planner.set("neighbours", std::int64_t{4});
  variants[4].planner.set("nodes", std::int64_t{500});
  variants[5].planner.set("region", "scene");
  for (int round = 0; round < 2; ++round) {  // more of them than a world keeps
    for (const PlanOptions& options : variants) {
      const Problem fresh = make_problem(walls(), {}, {-30, 0, 0}, {30, -20, 0});
      expect_same(plan(problem, prm, options), plan(fresh, prm, options));
    }
    const Problem fresh = make_problem(walls(), wide, {-30, 0, 0}, {30, -20, 0});
    expect_same(plan(of_wide, prm, variants[0]), plan(fresh, prm, variants[0]));
  }
}

TEST(Prm, KeepsAMarginWithARampAroundItsEnds) {
  const auto world = walls();
  const Pose near_a_wall{-14, 0, 3.1415926};  // 0.4 m before it
  PlanOptions options = roadmap_iterations(3000);
  options.clearance = {.margin = 0.8, .margin_ramp = 8.0};
  const Problem problem = make_problem(world, {}, near_a_wall, {0, 0, 0});
  const PlanResult result = plan(problem, planner_named("prm"), options);
  EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
}

TEST(Prm, AFreePieceIsProvenToBeTheShortestPath) {
  const Problem problem = make_problem(walls(), {}, {-30, 0, 0}, {-25, 20, 2});
  const PlanResult result = plan(problem, planner_named("prm"), roadmap_iterations(500));
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(result.lower_bound, result.cost);
}

TEST(Prm, EndsWithItsLastMilestone) {
  const auto world = world_of({.bounds = yard, .obstacles = {box(-1, -40, 1, 40)}});
  const Problem problem = make_problem(world, {}, {-20, 0, 0}, {20, 0, 0});
  const PlanResult result = plan(problem, planner_named("prm"), roadmap_iterations(1'000'000));
  EXPECT_EQ(result.status, PlanStatus::node_limit);
  EXPECT_EQ(result.reason, "there is no way through 1000 milestones");
  EXPECT_EQ(counter(result, "nodes"), 1000);
}

}  // namespace
}  // namespace vandplan

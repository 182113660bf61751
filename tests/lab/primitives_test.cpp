// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Primitives join vertices exactly; their table bounds every way over them.
#include "vandplan/graphs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "lab/lattice_graph.h"
#include "lab/lattice_table.h"
#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan::search {
namespace {

using Ends = std::tuple<std::int32_t, std::int32_t, std::int32_t, std::int32_t, int>;

const auto never = [] { return false; };

Ends ends_of(const Primitive& p) {
  return {p.from, p.to, p.dx, p.dy, p.piece.segments[0].length > 0 ? 1 : -1};
}

TEST(Primitives, EndAtTheirVerticesForAnyVehicleAndAnyNumberOfHeadings) {
  for (const double radius : {1e-6, 0.4, 3.5, 7.0, 12.5, 1e6}) {
    for (const int largest : {1, 2, 3}) {
      const auto primitives = make_primitives(radius, {.largest_coordinate = largest});
      EXPECT_EQ(primitives->headings().size(), largest == 1 ? 8U : largest == 2 ? 16U : 32U);
      EXPECT_LE(primitives->largest_curvature(), 1 / radius * (1 + 1e-12));
      for (const Primitive& p : primitives->all()) {
        const Pose begin{0, 0, primitives->headings()[static_cast<std::size_t>(p.from)]};
        const Pose end = end_of(begin, p.piece);
        EXPECT_NEAR(end.x, p.dx * primitives->step(), 1e-11 * radius);
        EXPECT_NEAR(end.y, p.dy * primitives->step(), 1e-11 * radius);
        const double heading = primitives->headings()[static_cast<std::size_t>(p.to)];
        EXPECT_NEAR(wrap_angle(end.heading - heading), 0.0, 1e-12);
        EXPECT_EQ(gear_changes(p.piece.view()), 0);
      }
    }
  }
}

TEST(Primitives, AreThoseOfATurnedAndMirroredGridAndOfTheWayBack) {
  const auto primitives = make_primitives(1.0);
  const auto n = static_cast<std::int32_t>(primitives->headings().size());
  std::set<Ends> all;
  for (const Primitive& p : primitives->all()) all.insert(ends_of(p));
  EXPECT_EQ(all.size(), primitives->all().size());
  for (const auto& [from, to, dx, dy, gear] : all) {
    const std::int32_t quarter = n / 4;
    EXPECT_TRUE(all.contains({(from + quarter) % n, (to + quarter) % n, -dy, dx, gear}));
    EXPECT_TRUE(all.contains({(n - from) % n, (n - to) % n, dx, -dy, gear}));
    EXPECT_TRUE(all.contains({to, from, -dx, -dy, -gear}));
    EXPECT_TRUE(all.contains({(to + n / 2) % n, (from + n / 2) % n, -dx, -dy, gear}));
  }
}

// Without the primitive there is no way between its ends over others that is about as short.
TEST(Primitives, HaveNoneThatShorterOnesReplace) {
  const auto primitives = make_primitives(1.0, {.detour = 1.1});
  for (const Primitive& p : primitives->all()) {
    if (p.from != 0 || p.piece.segments[0].length < 0) continue;
    for (std::int32_t i = primitives->first_from(0); i < primitives->first_from(1); ++i) {
      const Primitive& first = primitives->all()[static_cast<std::size_t>(i)];
      if (first.piece.segments[0].length < 0 || &first == &p) continue;
      const auto heading = static_cast<std::size_t>(first.to);
      for (std::int32_t j = primitives->first_from(heading);
           j < primitives->first_from(heading + 1); ++j) {
        const Primitive& last = primitives->all()[static_cast<std::size_t>(j)];
        if (last.piece.segments[0].length < 0 || last.to != p.to) continue;
        if (first.dx + last.dx != p.dx || first.dy + last.dy != p.dy) continue;
        EXPECT_GT(first.piece.length + last.piece.length, 1.1 * p.piece.length);
      }
    }
  }
}

TEST(Primitives, LeadEverywhere) {
  const auto primitives = make_primitives(1.0);
  const LatticeTable table(*primitives, never);
  ASSERT_TRUE(table.is_whole());
  for (std::int32_t x = -6; x <= 6; ++x) {
    for (std::int32_t y = -6; y <= 6; ++y) {
      for (const std::int32_t h : {0, 1, 2, 3, 13, 14, 15}) {
        EXPECT_LT(table.length_from({x, y, h}), table.most()) << x << ' ' << y << ' ' << h;
      }
    }
  }
}

TEST(Primitives, AreRefusedWithTheirPlace) {
  const auto refusal = [](double step, std::vector<double> headings,
                          std::vector<Primitive> all) -> std::string {
    try {
      const Primitives primitives(step, std::move(headings), std::move(all));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  Primitive ahead{.dx = 1};
  ahead.piece.segments[0] = {0.0, 1.0};
  ahead.piece.count = 1;
  ahead.piece.length = 1.0;
  EXPECT_EQ(refusal(1.0, {0.0}, {ahead}), "");
  EXPECT_EQ(refusal(0.0, {0.0}, {ahead}),
            "step: is out of range, expected more than 0 m and at most 1000 km");
  EXPECT_EQ(refusal(1.0, {}, {ahead}), "headings: are 0, expected 1 to 1024");
  EXPECT_EQ(refusal(1.0, {0.0, 2 * std::numbers::pi}, {ahead}),
            "headings: are the same twice, expected different ones");
  EXPECT_EQ(refusal(1.0, {0.0}, {}), "primitives: are none, expected one at least");
  EXPECT_EQ(refusal(1.0 + 1e-6, {0.0}, {ahead}), "primitives[0]: does not end at its vertex");
  ahead.to = 1;
  EXPECT_EQ(refusal(1.0, {0.0}, {ahead}), "primitives[0]: has a heading that there is not");
}

// Dijkstra from every vertex of a few, as slow as can be.
TEST(LatticeTable, IsTheShortestWayOverThePrimitives) {
  const auto primitives = make_primitives(1.0, {.steps_per_radius = 2, .largest_coordinate = 1});
  const LatticeTable table(*primitives, never);
  const double reach = 6.0;
  using Key = std::tuple<std::int32_t, std::int32_t, std::int32_t>;
  std::map<Key, double> ways = {{{0, 0, 0}, 0.0}};
  for (bool is_better = true; is_better;) {
    is_better = false;
    for (const auto& [key, way] : std::map<Key, double>(ways)) {
      const auto [x, y, h] = key;
      for (const Primitive& p : primitives->all()) {
        const double longer = way + p.piece.length;
        if (p.to != h || longer > reach) continue;
        const auto [at, is_new] = ways.try_emplace({x - p.dx, y - p.dy, p.from}, longer);
        if (!is_new && longer >= at->second - 1e-12) continue;
        at->second = longer;
        is_better = true;
      }
    }
  }
  ASSERT_GT(table.most(), reach);
  for (const auto& [key, way] : ways) {
    const auto [x, y, h] = key;
    const double known = table.length_from({x, y, h});
    EXPECT_LE(known, way);
    EXPECT_GE(known, way * (1 - 1e-4));
  }
}

// From inside the table to outside, too.
TEST(LatticeTable, FallsAlongNoPrimitiveByMoreThanItsLength) {
  const Problem problem = problem_of({0, 0, 0}, {30, 10, 0.4}, {});
  const LatticeGraph graph(problem.task(), standard_lattice(problem.task(), never));
  EXPECT_EQ(graph.least_way(graph.goal()), 0.0);
  for_each_case(1, 3000, [&](Rng& rng) {
    const auto whole = [&](int least, int most) {
      return static_cast<std::int32_t>(std::floor(uniform(least, most + 1.0, rng)));
    };
    const Vertex vertex{whole(-45, 45), whole(-45, 45), whole(0, 15)};
    const double way = graph.least_way(vertex);
    const double shortest = reeds_shepp_length(graph.pose_of(vertex), problem.task().goal, 7.0);
    EXPECT_GE(way, shortest * (1 - 1e-4));
    for (const LatticeGraph::Move& move : graph.moves(vertex.heading)) {
      const Vertex next{vertex.x + move.dx, vertex.y + move.dy, move.to};
      EXPECT_LE(way, (move.length + graph.least_way(next)) * (1 + 2e-5));
    }
  });
}

TEST(LatticeTable, IsLeftWhenInterrupted) {
  const auto primitives = make_primitives(2.0);
  EXPECT_EQ(table_of(*primitives, [] { return true; }), nullptr);
  const auto table = table_of(*primitives, never);
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table_of(*primitives, [] { return true; }), table);
}

TEST(LatticeGraph, HasNoVertexThatItCannotCount) {
  Vehicle vehicle;
  vehicle.min_turning_radius = 1e-6;
  const Problem problem = problem_in({.bounds = wide_bounds}, {-90, 0, 0}, {90, 0, 0}, vehicle);
  const LatticeGraph graph(problem.task(), standard_lattice(problem.task(), never));
  EXPECT_TRUE(graph.joints(problem.task().start).empty());
}

TEST(LatticeGraph, JoinsTheStartExactlyAndHasTheGoalAsAVertex) {
  const Problem problem = problem_of({1.3, -2.1, 0.7}, {11.9, 3.3, -2.9}, {});
  const Task& task = problem.task();
  const LatticeGraph graph(task, standard_lattice(task, never));
  EXPECT_EQ(graph.pose_of(graph.goal()), task.goal);
  const std::vector<Joint> joints = graph.joints(task.start);
  EXPECT_GT(joints.size(), 100U);
  for (const Joint& joint : joints) {
    const Pose end = end_of(task.start, joint.piece);
    const Pose vertex = graph.pose_of(joint.vertex);
    EXPECT_NEAR(std::hypot(end.x - vertex.x, end.y - vertex.y), 0.0, 1e-11);
    EXPECT_NEAR(wrap_angle(end.heading - vertex.heading), 0.0, 1e-12);
  }
}

std::vector<Pose> rounded_poses(const Pose& begin, const Piece& piece, double unit) {
  std::vector<Pose> poses;
  const Path path{begin, {piece.view().begin(), piece.view().end()}};
  for (int i = 0; i <= 20; ++i) {
    const Pose p = pose_at(path, piece.length * i / 20);
    poses.push_back({std::round(p.x / unit) * unit, std::round(p.y / unit) * unit, p.heading});
  }
  return poses;
}

// A sampled and rounded piece is found again, exactly closed.
TEST(FittedPiece, FindsWhatWasSampled) {
  for_each_case(2, 100, [](Rng& rng) {
    const double first = uniform01(rng) < 0.3 ? 0.0 : uniform(0.0, 1.0, rng);
    const double radius = uniform(0.5, 3.0, rng);
    const double turn = uniform(0.1, 1.2, rng);
    Piece piece;
    if (first > 0.0) piece.segments[piece.count++] = {0.0, first};
    piece.segments[piece.count++] = {1 / radius, turn * radius};
    piece.segments[piece.count++] = {0.0, uniform(0.01, 1.0, rng)};
    piece.length = length(piece.view());
    if (uniform01(rng) < 0.5) piece = reversed(piece);
    const Pose begin{0, 0, uniform(-3.0, 3.0, rng)};
    const Pose end = end_of(begin, piece);
    const auto poses = rounded_poses(begin, piece, 1e-5);
    const std::optional<Piece> fitted = fitted_piece(begin, end, poses, 1e-3);
    ASSERT_TRUE(fitted);
    const Pose last = end_of(begin, *fitted);
    EXPECT_NEAR(std::hypot(last.x - end.x, last.y - end.y), 0.0, 1e-9);
    EXPECT_NEAR(fitted->length, piece.length, 1e-3);
  });
}

TEST(FittedPiece, IsNoneForWhatNobodyCanDrive) {
  const std::vector<Pose> sideways = {{0, 0, 0}, {0.0, 0.5, 0}, {0.0, 1.0, 0}};
  EXPECT_FALSE(fitted_piece({0, 0, 0}, {0, 1, 0}, sideways, 0.1));
  const std::vector<Pose> to_and_fro = {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}};
  EXPECT_FALSE(fitted_piece({0, 0, 0}, {0.5, 0, 0}, to_and_fro, 0.1));
  const std::vector<Pose> ahead = {{0, 0, 0}, {0.5, 0.2, 0}, {1, 0, 0}};
  EXPECT_FALSE(fitted_piece({0, 0, 0}, {1, 0, 0}, ahead, 0.05));
}

TEST(ExactHeading, IsTheOneThatWasRounded) {
  EXPECT_NEAR(*exact_heading(0.4636, 16), std::atan2(1.0, 2.0), 1e-15);
  EXPECT_NEAR(*exact_heading(-0.7854, 16), std::atan2(-1.0, 1.0), 1e-15);
  EXPECT_NEAR(*exact_heading(0.3927, 16), std::numbers::pi / 8, 1e-15);
  EXPECT_FALSE(exact_heading(0.42, 16));
}

}  // namespace
}  // namespace vandplan::search

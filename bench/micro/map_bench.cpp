// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What does a collision check cost on a large map? A yard of 200 m with ten obstacles, once as
// polygons and once as 4000 x 4000 cells, and the same random edges in both.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

#include "large_yard.h"
#include "vandplan/problem.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

struct Edge {
  LocalPose from;
  Piece piece;
};

/// From free poses to free poses at most that far away.
std::vector<Edge> random_edges(const CollisionChecker& checker, double longest) {
  Rng rng(1);
  const auto free_pose = [&](const Bounds& within) {
    LocalPose pose(uniform_pose(within, rng));
    while (!checker.is_free(pose)) pose = LocalPose(uniform_pose(within, rng));
    return pose;
  };
  std::vector<Edge> edges;
  while (edges.size() < 4096) {
    const LocalPose from = free_pose(yard);
    const LocalPose to =
        free_pose({std::max(0.0, from.x - longest), std::min(side, from.x + longest),
                   std::max(0.0, from.y - longest), std::min(side, from.y + longest)});
    edges.push_back({from, reeds_shepp(from, to, Vehicle{}.min_turning_radius)});
  }
  return edges;
}

struct Yards {
  std::vector<Polygon> obstacles = ten_obstacles();
  OccupancyGrid map = drawn(obstacles);
  World polygons{{.bounds = yard, .obstacles = obstacles}, {}};
  World mapped{{.bounds = yard, .map = map}, {}};
};

const Yards& yards() {
  static const Yards both;
  return both;
}

void edge_check(benchmark::State& state, const World& world) {
  const std::vector<Edge> edges =
      random_edges(*yards().mapped.checker({}), static_cast<double>(state.range(0)));
  const auto checker = world.checker({});
  std::size_t next = 0;
  std::size_t free = 0;
  for (auto _ : state) {
    const Edge& edge = edges[next];
    next = (next + 1) % edges.size();
    free += checker->is_free(edge.from, edge.piece.view()) ? 1U : 0U;
  }
  state.counters["free"] = static_cast<double>(free) / static_cast<double>(state.iterations());
}

void among_polygons(benchmark::State& state) { edge_check(state, yards().polygons); }
void among_cells(benchmark::State& state) { edge_check(state, yards().mapped); }

/// The map made ready: what planning needs of it.
void make_world(benchmark::State& state) {
  for (auto _ : state) {
    const World world({.bounds = yard, .map = yards().map}, {});
    benchmark::DoNotOptimize(world.checker({}));
  }
}

BENCHMARK(among_polygons)->Arg(5)->Arg(20)->Arg(200);
BENCHMARK(among_cells)->Arg(5)->Arg(20)->Arg(200);
BENCHMARK(make_world)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vandplan

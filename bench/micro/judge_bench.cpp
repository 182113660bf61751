// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What does a verdict cost? Yards of 10 to 100 000 buildings, paths of up to 100 000 segments and
// of up to 900 km, good ones and such that hit the last building of all. Worlds are made outside
// of the loop; in `first` the judge has not seen his before.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "vandplan/judge.h"
#include "vandplan/problem.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 7.0;  // of the turns [m]
constexpr double block = 30.0;  // from building to building [m]

/// A convex building of 3 to 8 corners in a circle of 9 m.
Polygon building(const Point& centre, Rng& rng) {
  const int corners = 3 + static_cast<int>(uniform(0, 6, rng));
  const double first = uniform(0, 2 * pi, rng);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = first + (i + uniform(-0.3, 0.3, rng)) * 2 * pi / corners;
    polygon.push_back({centre.x + 9 * std::cos(angle), centre.y + 9 * std::sin(angle)});
  }
  return polygon;
}

struct Case {
  std::vector<Polygon> obstacles;
  Path path;
  bool valid = true;
};

/// Across a square of so many buildings: a block to the right, a block up, and so on.
Case yard(int buildings) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(buildings)));
  Rng rng(5);
  Case yard;
  for (int i = 0; i < buildings; ++i) {
    yard.obstacles.push_back(building({i % columns * block, i / columns * block}, rng));
  }
  yard.path.start = {radius - block / 2, -block / 2, 0};
  for (int i = 0; i < 2 * columns; ++i) {
    yard.path.segments.push_back({0, block - 2 * radius});
    yard.path.segments.push_back({(i % 2 == 0 ? 1 : -1) / radius, radius * pi / 2});
  }
  return yard;
}

/// What stands where the path ends is in its way.
Case barred(Case open) {
  const Pose end = end_pose(open.path);
  Rng rng(6);
  open.obstacles.push_back(building({end.x + 10, end.y}, rng));
  open.valid = false;
  return open;
}

/// A metre ahead and a metre back, among 10 000 buildings.
Case shuttle(int segments) {
  Case shuttle = yard(10000);
  shuttle.path.segments.clear();
  for (int i = 0; i < segments; ++i) shuttle.path.segments.push_back({0, i % 2 == 0 ? 1.0 : -1.0});
  return shuttle;
}

/// Along a line and back or around a circle, buildings of 1 km on both sides of it, 3 m away.
Case far(double curvature) {
  const double length = curvature == 0 ? 9e5 : 2 * pi / curvature;
  Case far{{}, {{0, 0, 0}, {{curvature, length}}}};
  if (curvature == 0) far.path.segments.push_back({0, -length});
  const Footprint outline{500, 500, 1};
  for (double s = 1e3; s + 1e3 < length; s += 1e3) {
    const Pose middle = pose_at(far.path, s);
    for (const double aside : {-7.0, 7.0}) {
      const auto wall = corners(outline, compose(middle, {0, aside, 0}));
      far.obstacles.emplace_back(wall.begin(), wall.end());
    }
  }
  return far;
}

/// One polygon of so many corners: a disc with teeth that the path goes around.
Case gear_wheel(int corners) {
  Case gear{{{}}, {{0, -60, 0}, {{1.0 / 60, 120 * pi}}}};
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    const double reach = i % 2 == 0 ? 58.0 : 20.0;
    gear.obstacles[0].push_back({reach * std::cos(angle), reach * std::sin(angle)});
  }
  return gear;
}

Problem problem_of(const Case& c) {
  const Surroundings surroundings{.bounds = {-1e6, 1e6, -1e6, 1e6}, .obstacles = c.obstacles};
  const auto world = std::make_shared<const World>(surroundings, Point{});
  return make_problem(world, {}, c.path.start, end_pose(c.path));
}

void judge(benchmark::State& state, const Case& c) {
  const Problem problem = problem_of(c);
  const PathCheck check = check_path(problem, c.path);
  if (check.valid != c.valid) state.SkipWithError(check.reason.c_str());
  for (auto _ : state) benchmark::DoNotOptimize(check_path(problem, c.path));
}

void good_path(benchmark::State& state) { judge(state, yard(static_cast<int>(state.range(0)))); }

void hits_the_last(benchmark::State& state) {
  judge(state, barred(yard(static_cast<int>(state.range(0)))));
}

void many_segments(benchmark::State& state) {
  judge(state, shuttle(static_cast<int>(state.range(0))));
}

void far_along_walls(benchmark::State& state) {
  judge(state, far(state.range(0) == 0 ? 0.0 : 1.0 / static_cast<double>(state.range(0))));
}

void around_a_polygon(benchmark::State& state) {
  judge(state, gear_wheel(static_cast<int>(state.range(0))));
}

/// A world that the judge sees for the first time.
void first(benchmark::State& state) {
  const Case c = yard(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    state.PauseTiming();
    const Problem problem = problem_of(c);
    state.ResumeTiming();
    benchmark::DoNotOptimize(check_path(problem, c.path));
  }
}

BENCHMARK(good_path)->Arg(10)->Arg(1000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(hits_the_last)->Arg(10)->Arg(1000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(first)->Arg(10)->Arg(1000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(many_segments)->Arg(2000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(far_along_walls)->Arg(0)->Arg(140000)->Unit(benchmark::kMicrosecond);
BENCHMARK(around_a_polygon)->Arg(100)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace vandplan

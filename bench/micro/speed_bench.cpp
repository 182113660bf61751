// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What does the fastest drive along a path of 100 m cost? Paths of Reeds-Shepp words, which stand
// at every joint, and of clothoids, arcs and lines without jumps, at yard speeds and at speeds at
// which turns hold the vehicle back; without and with a limit of jerk.

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "vandplan/motion.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

constexpr double wanted = 100.0;  // [m]
constexpr double radius = 7.0;    // [m]
constexpr int count = 64;         // paths, one after the other

/// The path, cut to 100 m.
Path cut(Path path) {
  double left = wanted;
  for (Segment& segment : path.segments) {
    segment = part_of(segment, 0.0, std::min(left, std::abs(segment.length)));
    left -= std::abs(segment.length);
  }
  path.segments = merged(path.segments);
  return path;
}

Path words(Rng& rng) {
  Path path;
  Pose pose;
  while (length(path) < wanted) {
    const Pose goal = uniform_pose({-20, 20, -20, 20}, rng);
    const Piece piece = reeds_shepp(pose, goal, radius);
    path.segments.insert(path.segments.end(), piece.view().begin(), piece.view().end());
    pose = goal;
  }
  return cut(path);
}

/// Turns of clothoid, arc, clothoid, with lines in between and a gear change now and then.
Path turns(Rng& rng) {
  constexpr double rate = 0.11;  // [1/m^2]
  constexpr double bend = 1 / radius / rate;
  Path path;
  double gear = 1;
  while (length(path) < wanted) {
    const double side = uniform01(rng) < 0.5 ? -1 : 1;
    path.segments.push_back({0, gear * uniform(1, 10, rng)});
    path.segments.push_back({0, gear * bend, side * rate});
    path.segments.push_back({side / radius, gear * uniform(0.5, 6, rng)});
    path.segments.push_back({side / radius, gear * bend, -side * rate});
    if (uniform01(rng) < 0.3) gear = -gear;
  }
  return cut(path);
}

Vehicle truck(double speed) {
  Vehicle vehicle;
  vehicle.limits.max_speed = {speed, speed};
  return vehicle;
}

void run(benchmark::State& state, Path (*make)(Rng&), const Vehicle& vehicle) {
  Rng rng(1);
  std::vector<Path> paths;
  double segments = 0;
  for (int i = 0; i < count; ++i) {
    paths.push_back(make(rng));
    segments += static_cast<double>(paths.back().segments.size());
  }
  double knots = 0;
  std::size_t i = 0;
  for (auto _ : state) {
    const SpeedProfile profile = speed_profile(paths[i], vehicle);
    i = (i + 1) % paths.size();
    knots += static_cast<double>(profile.knots.size());
    benchmark::DoNotOptimize(profile.duration);
  }
  state.counters["segments"] = segments / count;
  state.counters["knots"] = benchmark::Counter(knots, benchmark::Counter::kAvgIterations);
}

void BM_ReedsShepp(benchmark::State& state) { run(state, words, truck(2.5)); }
void BM_Continuous(benchmark::State& state) {
  run(state, turns, truck(static_cast<double>(state.range(0))));
}
void BM_ContinuousWithJerk(benchmark::State& state) {
  Vehicle vehicle = truck(static_cast<double>(state.range(0)));
  vehicle.limits.max_jerk = 2.0;
  run(state, turns, vehicle);
}

BENCHMARK(BM_ReedsShepp)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Continuous)->Unit(benchmark::kMicrosecond)->Arg(2)->Arg(5)->Arg(20);
BENCHMARK(BM_ContinuousWithJerk)->Unit(benchmark::kMicrosecond)->Arg(2)->Arg(5)->Arg(20);

}  // namespace
}  // namespace vandplan

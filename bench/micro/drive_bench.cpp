// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How many times faster than real time is a simulated drive? A path of clothoids, arcs and lines in
// both gears, between walls that stand close to all of it, with noise and delay.

#include <benchmark/benchmark.h>

#include "support/problems.h"
#include "vandplan/drive.h"

namespace vandplan {
namespace {

/// Turns of clothoid, arc, clothoid, ahead and back.
Path turns() {
  constexpr double rate = 0.1;  // [1/m^2]
  constexpr double full = 1 / 7.5;
  constexpr double bend = full / rate;
  Path path;
  for (const double gear : {1.0, -1.0, 1.0}) {
    for (const double side : {1.0, -1.0}) {
      path.segments.push_back({0, gear * bend, side * rate});
      path.segments.push_back({side * full, gear * 6});
      path.segments.push_back({side * full, gear * bend, -side * rate});
      path.segments.push_back({0, gear * 3});
    }
  }
  return path;
}

/// Posts on both sides, as near as noise allows.
Surroundings posts_beside(const Path& path) {
  const Footprint body = footprint(Vehicle{});
  std::vector<Polygon> posts;
  for (const PathPoint& point : sampled(path, 2.0)) {
    for (const double side : {-1.0, 1.0}) {
      const Pose place = compose(point.pose, {2.0, side * (body.half_width + 0.6), 0});
      posts.push_back(box(place.x - 0.1, place.y - 0.1, place.x + 0.1, place.y + 0.1));
    }
  }
  Surroundings things{.bounds = wide_bounds};
  // What the vehicle would sweep away is not there.
  for (const Polygon& post : posts) {
    const CollisionChecker checker(Vehicle{}, {.bounds = wide_bounds, .obstacles = {post}});
    if (checker.is_free(Local(path.start), path.segments)) things.obstacles.push_back(post);
  }
  return things;
}

void run(benchmark::State& state, const DriveOptions& asked) {
  const Path path = turns();
  const Problem problem = problem_of_path(posts_beside(path), path);
  DriveOptions options = asked;
  double driven = 0.0;
  double contacts = 0.0;
  for (auto _ : state) {
    const DriveResult result = drive(problem, path, options);
    driven += result.duration;
    contacts += result.contact ? 1 : 0;
    ++options.seed;
  }
  state.counters["times_real_time"] = benchmark::Counter(driven, benchmark::Counter::kIsRate);
  state.counters["contacts"] = benchmark::Counter(contacts, benchmark::Counter::kAvgIterations);
}

void BM_Drive(benchmark::State& state, const char* controller) {
  run(state, {.controller = controller, .noise = 1, .delay = 0.1});
}
void BM_DriveWithoutNoise(benchmark::State& state) { run(state, {}); }

void BM_Executable(benchmark::State& state) {
  const Path path = turns();
  const Problem problem = problem_of_path(posts_beside(path), path);
  double driven = 0.0;
  for (auto _ : state) driven += executable(problem, path).flowing.duration;
  state.counters["times_real_time"] = benchmark::Counter(driven, benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(BM_Drive, rear_axle_feedback, "rear-axle-feedback")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Drive, lqr, "lqr")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Drive, pure_pursuit, "pure-pursuit")->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DriveWithoutNoise)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Executable)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vandplan

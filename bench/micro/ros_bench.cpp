// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How long does a call of the planner for ROS take, beside the planning? On a costmap of 2000 x
// 2000 cells of which a window of 200 x 200 has changed since the last call.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

#include "ros/yard.h"

namespace vandplan::ros {
namespace {

constexpr std::int32_t side = 2000;  // cells of 5 cm
constexpr Pose start{10, 50, 0};
constexpr Pose goal{90, 50, 0};

/// Pillars all over the yard, and the lane between start and goal free.
OwnedCostmap pillars() {
  OwnedCostmap costmap(side, side, 0.05);
  for (std::int32_t y = 40; y < side; y += 80) {
    for (std::int32_t x = 40; x < side; x += 80) costmap.fill({x, y, 10, 10}, nav2_lethal_cost);
  }
  costmap.fill({0, 980, side, 40}, 0);
  return costmap;
}

/// Moves what stands in a window of 200 x 200 cells to another place in it.
void change(OwnedCostmap& costmap, int i) {
  const std::int32_t x = 900, y = 1040;
  costmap.fill({x, y, 200, 200}, 0);
  costmap.fill({x + i % 7 * 20, y + i % 5 * 20, 40, 40}, nav2_lethal_cost);
  costmap.at(x, y) = static_cast<std::uint8_t>(i % 250);
  costmap.at(x + 199, y + 199) = static_cast<std::uint8_t>(i % 250);
}

void BM_TakeCostmap(benchmark::State& state) {
  OwnedCostmap costmap = pillars();
  KnownCostmap known;
  known.take(costmap.view());
  int i = 0;
  for (auto _ : state) {
    change(costmap, ++i);
    known.take(costmap.view());
    benchmark::DoNotOptimize(known.changes());
  }
}
BENCHMARK(BM_TakeCostmap)->Unit(benchmark::kMillisecond);

void BM_NewWorld(benchmark::State& state) {
  const OwnedCostmap costmap = pillars();
  const Vehicle vehicle = vehicle_of(small_robot(), {});
  for (auto _ : state) {
    Planner planner;
    planner.take(costmap.view());
    benchmark::DoNotOptimize(planner.is_blocked({}, vehicle, {}));
  }
}
BENCHMARK(BM_NewWorld)->Unit(benchmark::kMillisecond);

void BM_PatchedWorld(benchmark::State& state) {
  OwnedCostmap costmap = pillars();
  const Vehicle vehicle = vehicle_of(small_robot(), {});
  Planner planner;
  int i = 0;
  for (auto _ : state) {
    change(costmap, ++i);
    planner.take(costmap.view());
    benchmark::DoNotOptimize(planner.is_blocked({}, vehicle, {}));
  }
}
BENCHMARK(BM_PatchedWorld)->Unit(benchmark::kMillisecond);

// The whole call: "beside" is what it takes without the planner's own time, "most" the longest.
void BM_Call(benchmark::State& state) {
  OwnedCostmap costmap = pillars();
  Planner planner;
  planner.take(costmap.view());
  if (planner.plan(small_request(start, goal)).outcome != Outcome::solved) std::abort();
  std::vector<double> beside;
  int i = 0;
  for (auto _ : state) {
    change(costmap, ++i);
    const auto begin = std::chrono::steady_clock::now();
    planner.take(costmap.view());
    const Answer answer = planner.plan(small_request(start, goal, 100));
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begin;
    if (answer.outcome != Outcome::solved) std::abort();
    beside.push_back(1e3 * (whole.count() - answer.planning_time));
  }
  std::sort(beside.begin(), beside.end());
  state.counters["beside_ms"] = beside[beside.size() / 2];
  state.counters["most_ms"] = beside.back();
}
BENCHMARK(BM_Call)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vandplan::ros

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How long does a call of the planner for ROS take, beside the planning? On a costmap of 2000 x
// 2000 cells of which a window of 200 x 200 has changed since the last call. The arguments of
// benchmarks are prices of graded costs; 0: no mask.

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

/// An obstacle, and costs that fall in rings around it, as the inflation layer makes them.
void fill_graded(OwnedCostmap& costmap, const CellRange& box) {
  for (std::int32_t ring = 10; ring >= 0; --ring) {
    costmap.fill({box.column - ring, box.row - ring, box.columns + 2 * ring, box.rows + 2 * ring},
                 static_cast<std::uint8_t>(nav2_lethal_cost - 20 * ring));
  }
}

/// Pillars all over the yard with graded costs around, and the lane between start and goal free.
OwnedCostmap pillars() {
  OwnedCostmap costmap(side, side, 0.05);
  for (std::int32_t y = 40; y < side; y += 80) {
    for (std::int32_t x = 40; x < side; x += 80) fill_graded(costmap, {x, y, 10, 10});
  }
  costmap.fill({0, 980, side, 40}, 0);
  return costmap;
}

/// Moves what stands in a window of 200 x 200 cells to another place in it.
void change(OwnedCostmap& costmap, int i) {
  const std::int32_t x = 900, y = 1040;
  costmap.fill({x, y, 200, 200}, 0);
  fill_graded(costmap, {x + 10 + i % 6 * 20, y + 10 + i % 5 * 20, 40, 40});
  costmap.at(x, y) = static_cast<std::uint8_t>(i % 250);
  costmap.at(x + 199, y + 199) = static_cast<std::uint8_t>(i % 250);
}

CostRule rule_of(const benchmark::State& state) {
  return {.cost_penalty = static_cast<double>(state.range(0))};
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
    benchmark::DoNotOptimize(planner.is_blocked({}, vehicle, rule_of(state)));
  }
}
BENCHMARK(BM_NewWorld)->Arg(0)->Arg(2)->Unit(benchmark::kMillisecond);

void BM_PatchedWorld(benchmark::State& state) {
  OwnedCostmap costmap = pillars();
  const Vehicle vehicle = vehicle_of(small_robot(), {});
  Planner planner;
  int i = 0;
  for (auto _ : state) {
    change(costmap, ++i);
    planner.take(costmap.view());
    benchmark::DoNotOptimize(planner.is_blocked({}, vehicle, rule_of(state)));
  }
}
BENCHMARK(BM_PatchedWorld)->Arg(0)->Arg(2)->Unit(benchmark::kMillisecond);

// The whole call: "beside" is what it takes without the planner's own time, "most" the longest.
void BM_Call(benchmark::State& state) {
  OwnedCostmap costmap = pillars();
  Planner planner;
  planner.take(costmap.view());
  const auto request = [&](std::int64_t iterations) {
    Request wish = small_request(start, goal, iterations);
    wish.cost_rule = rule_of(state);
    return wish;
  };
  if (planner.plan(request(2000)).outcome != Outcome::solved) std::abort();
  std::vector<double> beside;
  int i = 0;
  for (auto _ : state) {
    change(costmap, ++i);
    const auto begin = std::chrono::steady_clock::now();
    planner.take(costmap.view());
    const Answer answer = planner.plan(request(100));
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begin;
    if (answer.outcome != Outcome::solved) std::abort();
    beside.push_back(1e3 * (whole.count() - answer.planning_time));
  }
  std::sort(beside.begin(), beside.end());
  state.counters["beside_ms"] = beside[beside.size() / 2];
  state.counters["most_ms"] = beside.back();
}
BENCHMARK(BM_Call)->Arg(0)->Arg(2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vandplan::ros

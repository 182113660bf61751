// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does one call of the steering of a semitrailer cost? Pairs of states within the argument [m]
// of each other; beside it, the length for the tractor alone. And what does it cost to check an arc
// of 3 m with both bodies, and with the tractor alone?
#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

#include "vandplan/collision.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

Vehicle semitrailer() {
  Vehicle vehicle;
  vehicle.min_turning_radius = 5.9;
  vehicle.hitch = 0.6;
  vehicle.trailer = Trailer{};
  return vehicle;
}

struct StatePair {
  State from, to;
};

std::vector<StatePair> pairs_within(double reach) {
  Rng rng(1);
  const auto any = [&]() -> State {
    return {{uniform(0, reach, rng), uniform(0, reach, rng),
             uniform(-std::numbers::pi, std::numbers::pi, rng)},
            uniform(-1.2, 1.2, rng)};
  };
  std::vector<StatePair> pairs(1024);
  for (StatePair& pair : pairs) pair = {any(), any()};
  return pairs;
}

void BM_rig(benchmark::State& state) {
  const auto pairs = pairs_within(static_cast<double>(state.range(0)));
  const RigSteering steering(semitrailer());
  std::size_t i = 0;
  for (auto _ : state) {
    const StatePair& pair = pairs[i++ % pairs.size()];
    benchmark::DoNotOptimize(steering.steer(pair.from, pair.to));
  }
}

void BM_tractor(benchmark::State& state) {
  const auto pairs = pairs_within(static_cast<double>(state.range(0)));
  std::size_t i = 0;
  for (auto _ : state) {
    const StatePair& pair = pairs[i++ % pairs.size()];
    benchmark::DoNotOptimize(reeds_shepp_length(pair.from.pose, pair.to.pose, 5.9));
  }
}

/// A yard of 100 m x 100 m with boxes of 3 m x 3 m, all 12 m.
CollisionChecker checker_of(const Vehicle& vehicle) {
  Surroundings yard{.bounds = {-60, 60, -60, 60}};
  for (double x = -48; x < 50; x += 12) {
    for (double y = -48; y < 50; y += 12) {
      yard.obstacles.push_back({{x, y}, {x + 3, y}, {x + 3, y + 3}, {x, y + 3}});
    }
  }
  return CollisionChecker(vehicle, yard);
}

struct Arc {
  State from;
  Segment segment;
};

/// Arcs in either gear that the rig may drive freely, so that nothing is found early.
std::vector<Arc> free_arcs(const CollisionChecker& checker, const Vehicle& vehicle) {
  Rng rng(2);
  std::vector<Arc> arcs;
  while (arcs.size() < 1024) {
    const Arc arc{
        {{uniform(-50, 50, rng), uniform(-50, 50, rng),
          uniform(-std::numbers::pi, std::numbers::pi, rng)},
         uniform(-0.8, 0.8, rng)},
        {uniform(-1, 1, rng) / vehicle.min_turning_radius, uniform(-1, 1, rng) < 0 ? -3.0 : 3.0}};
    if (checker.is_free(Local(arc.from), arc.segment)) arcs.push_back(arc);
  }
  return arcs;
}

void BM_check_rig(benchmark::State& state) {
  const Vehicle vehicle = semitrailer();
  const CollisionChecker checker = checker_of(vehicle);
  const auto arcs = free_arcs(checker, vehicle);
  std::size_t i = 0;
  for (auto _ : state) {
    const Arc& arc = arcs[i++ % arcs.size()];
    benchmark::DoNotOptimize(checker.is_free(Local(arc.from), arc.segment));
  }
}

void BM_check_tractor(benchmark::State& state) {
  const Vehicle vehicle = semitrailer();
  const CollisionChecker checker = checker_of(vehicle);
  const auto arcs = free_arcs(checker, vehicle);
  std::size_t i = 0;
  for (auto _ : state) {
    const Arc& arc = arcs[i++ % arcs.size()];
    benchmark::DoNotOptimize(checker.tractor_is_free(Local(arc.from.pose), {&arc.segment, 1}));
  }
}

BENCHMARK(BM_check_rig);
BENCHMARK(BM_check_tractor);
BENCHMARK(BM_rig)->Arg(5)->Arg(20)->Arg(60);
BENCHMARK(BM_tractor)->Arg(20);

}  // namespace
}  // namespace vandplan

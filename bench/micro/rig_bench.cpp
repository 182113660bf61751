// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does one call of the steering of a semitrailer cost? Pairs of states within the argument [m]
// of each other; beside it, the length for the tractor alone.
#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

#include "vandplan/random.h"
#include "vandplan/reeds_shepp.h"
#include "vandplan/rig_steering.h"

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
  RigState from, to;
};

std::vector<StatePair> pairs_within(double reach) {
  Rng rng(1);
  const auto any = [&]() -> RigState {
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

BENCHMARK(BM_rig)->Arg(5)->Arg(20)->Arg(60);
BENCHMARK(BM_tractor)->Arg(20);

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does one steering call cost? Pairs of poses within the argument [m] of each other, R = 7 m.
#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

#include "base/trigonometry.h"
#include "support/pose_pairs.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

constexpr double radius = 7;

std::vector<DrawnPair> pairs_within(double reach) {
  Rng rng(1);
  std::vector<DrawnPair> pairs(4096);
  for (DrawnPair& pair : pairs) pair = near_pair(reach, rng);
  return pairs;
}

template <auto steer>
void BM_steering(benchmark::State& state) {
  const std::vector<DrawnPair> pairs = pairs_within(static_cast<double>(state.range(0)));
  std::size_t i = 0;
  for (auto _ : state) {
    const DrawnPair& pair = pairs[i++ % pairs.size()];
    benchmark::DoNotOptimize(steer(pair.from, pair.to, radius));
  }
}
BENCHMARK(BM_steering<reeds_shepp_length>)->Name("reeds_shepp_length")->Arg(10)->Arg(200);
BENCHMARK(BM_steering<reeds_shepp>)->Name("reeds_shepp")->Arg(10)->Arg(200);
BENCHMARK(BM_steering<reeds_shepp_words>)->Name("reeds_shepp_words")->Arg(10)->Arg(200);
BENCHMARK(BM_steering<dubins_length>)->Name("dubins_length")->Arg(10)->Arg(200);

void BM_sin_cos(benchmark::State& state) {
  const std::vector<DrawnPair> pairs = pairs_within(1);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(base::sin_cos(pairs[i++ % pairs.size()].from.heading));
  }
}
BENCHMARK(BM_sin_cos)->Name("sin_cos");

void BM_atan_2(benchmark::State& state) {
  const std::vector<DrawnPair> pairs = pairs_within(1);
  std::size_t i = 0;
  for (auto _ : state) {
    const Pose& pose = pairs[i++ % pairs.size()].from;
    benchmark::DoNotOptimize(base::atan_2(pose.y, pose.x));
  }
}
BENCHMARK(BM_atan_2)->Name("atan_2");

}  // namespace
}  // namespace vandplan

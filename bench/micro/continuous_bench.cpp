// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does one call of continuous steering cost? Pairs of poses within the first argument [m] of
// each other, R = 7 m; the second argument is the way from straight to full lock [cm].
#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "steering/continuous/priced_pieces.h"
#include "support/pose_pairs.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

constexpr double radius = 7;

enum class Call { steer, length, length_of_bent_ends, length_of_leg };

template <Continuity continuity, Call call>
void BM_continuous(benchmark::State& state) {
  Rng rng(1);
  std::vector<DrawnPair> pairs(4096);
  for (DrawnPair& pair : pairs) pair = near_pair(static_cast<double>(state.range(0)), rng);
  const double ramp = static_cast<double>(state.range(1)) / 100;
  const ContinuousSteering steering(radius, 1 / (radius * ramp), continuity);
  const ContinuousQuery bent{0.5 / radius, -0.3 / radius};
  ContinuousQuery leg;
  leg.goal_stands = false;
  std::size_t i = 0;
  for (auto _ : state) {
    const DrawnPair& pair = pairs[i++ % pairs.size()];
    if constexpr (call == Call::steer) {
      benchmark::DoNotOptimize(steering.steer(pair.from, pair.to));
    } else if constexpr (call == Call::length) {
      benchmark::DoNotOptimize(steering.length(pair.from, pair.to));
    } else if constexpr (call == Call::length_of_leg) {
      benchmark::DoNotOptimize(steering.length(pair.from, pair.to, leg));
    } else {
      benchmark::DoNotOptimize(steering.length(pair.from, pair.to, bent));
    }
  }
}

/// The least word with up to twice the length of Reeds and Shepp's; the third argument is how many
/// gear changes it has.
void BM_words(benchmark::State& state) {
  Rng rng(1);
  std::vector<DrawnPair> pairs(4096);
  for (DrawnPair& pair : pairs) pair = near_pair(static_cast<double>(state.range(0)), rng);
  std::vector<double> longest;
  for (const DrawnPair& p : pairs) longest.push_back(2 * reeds_shepp_length(p.from, p.to, radius));
  const double ramp = static_cast<double>(state.range(1)) / 100;
  const ContinuousSteering steering(radius, 1 / (radius * ramp), Continuity::between_stops);
  const std::array ends{steering::continuous::PieceEnds{}};
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t n = i++ % pairs.size();
    double least = longest[n];
    steering::continuous::for_priced_pieces(
        steering, pairs[n].from, pairs[n].to, ends, {static_cast<int>(state.range(2)), least},
        [&](const Piece& word, std::size_t) { return least = std::min(least, word.length); });
    benchmark::DoNotOptimize(least);
  }
}

/// To the end of a clothoid of so many centimetres, from straight to full lock over 3.6 m.
void BM_advance(benchmark::State& state) {
  const double length = static_cast<double>(state.range(0)) / 100;
  const Segment clothoid{0.0, length, 1 / (radius * 3.6)};
  Pose pose;
  for (auto _ : state) benchmark::DoNotOptimize(pose = advance(pose, clothoid));
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const int ramp : {130, 360}) {
    for (const int reach : {10, 200}) bench->Args({reach, ramp});
  }
}
BENCHMARK(BM_continuous<Continuity::between_stops, Call::steer>)
    ->Name("between_stops")
    ->Apply(sizes);
BENCHMARK(BM_continuous<Continuity::between_stops, Call::length>)
    ->Name("between_stops_length")
    ->Apply(sizes);
BENCHMARK(BM_continuous<Continuity::throughout, Call::steer>)->Name("throughout")->Apply(sizes);
BENCHMARK(BM_continuous<Continuity::throughout, Call::length>)
    ->Name("throughout_length")
    ->Apply(sizes);
BENCHMARK(BM_continuous<Continuity::throughout, Call::length_of_bent_ends>)
    ->Name("throughout_length_bent")
    ->Apply(sizes);
BENCHMARK(BM_continuous<Continuity::between_stops, Call::length_of_leg>)
    ->Name("leg_length")
    ->Apply(sizes);
BENCHMARK(BM_advance)->Name("advance")->Arg(100)->Arg(360)->Arg(900);
BENCHMARK(BM_words)->Name("words")->ArgsProduct({{10, 200}, {130, 360}, {0, 1, 2}});

}  // namespace
}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does the exact nearest node by Reeds-Shepp length cost? Arguments: nodes, and within how
// many metres of the origin nodes and samples are uniform; R = 7 m.
#include "vandplan/tables.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

constexpr double radius = 7;

std::vector<Pose> poses(std::int64_t count, std::int64_t reach, std::uint64_t seed) {
  Rng rng(seed);
  const auto r = static_cast<double>(reach);
  std::vector<Pose> list(static_cast<std::size_t>(count));
  for (Pose& pose : list) pose = uniform_pose({-r, r, -r, r}, rng);
  return list;
}

NearestNodes with(const std::vector<Pose>& nodes) {
  NearestNodes all(radius);
  for (const Pose& node : nodes) all.add(node);
  return all;
}

void BM_nearest(benchmark::State& state) {
  const NearestNodes nodes = with(poses(state.range(0), state.range(1), 1));
  const std::vector<Pose> samples = poses(4096, state.range(1), 2);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(nodes.nearest(samples[i++ % samples.size()]));
  }
  std::vector<double> solves;
  for (const Pose& sample : samples) {
    solves.push_back(static_cast<double>(nodes.nearest(sample)->exact_solves));
  }
  std::sort(solves.begin(), solves.end());
  state.counters["solves_median"] = solves[solves.size() / 2];
  state.counters["solves_p99"] = solves[solves.size() * 99 / 100];
  state.counters["solves_max"] = solves.back();
}

// Without an index: exact lengths of all nodes in one batch, in float, and the least of them.
void BM_least_of_batch(benchmark::State& state) {
  const std::vector<Pose> nodes = poses(state.range(0), state.range(1), 1);
  const std::vector<Pose> samples = poses(64, state.range(1), 2);
  std::vector<float> x, y, heading, lengths(nodes.size());
  for (const Pose& node : nodes) {
    x.push_back(static_cast<float>(node.x));
    y.push_back(static_cast<float>(node.y));
    heading.push_back(static_cast<float>(node.heading));
  }
  std::size_t i = 0;
  for (auto _ : state) {
    reeds_shepp_lengths({x, y, heading}, samples[i++ % samples.size()], radius, lengths);
    benchmark::DoNotOptimize(std::min_element(lengths.begin(), lengths.end()));
  }
}

// Without an index: the exact length of every node.
void BM_least_of_all(benchmark::State& state) {
  const std::vector<Pose> nodes = poses(state.range(0), state.range(1), 1);
  const std::vector<Pose> samples = poses(64, state.range(1), 2);
  std::size_t i = 0;
  for (auto _ : state) {
    const Pose& sample = samples[i++ % samples.size()];
    double least = 1e300;
    for (const Pose& node : nodes) {
      least = std::min(least, reeds_shepp_length(node, sample, radius));
    }
    benchmark::DoNotOptimize(least);
  }
}

void BM_add(benchmark::State& state) {
  const std::vector<Pose> nodes = poses(state.range(0), state.range(1), 1);
  for (auto _ : state) benchmark::DoNotOptimize(with(nodes).size());
  state.counters["per_node"] =
      benchmark::Counter(static_cast<double>(state.iterations() * state.range(0)),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->Unit(benchmark::kMicrosecond)->Args({5000, 50})->Args({5000, 200});
  bench->Args({100000, 50})->Args({100000, 200});
}
BENCHMARK(BM_nearest)->Name("nearest")->Apply(sizes);
BENCHMARK(BM_add)->Name("add_all")->Apply(sizes);
BENCHMARK(BM_least_of_batch)->Name("least_of_batch")->Apply(sizes);
BENCHMARK(BM_least_of_all)->Name("least_of_all")->Apply(sizes);

}  // namespace
}  // namespace vandplan

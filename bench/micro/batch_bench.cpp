// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does one of 5 000 nodes cost, in a table or exactly? Nodes and samples within the argument
// [m] of the origin, R = 7 m. The kernels once for every vector target of this machine too.
#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "simd/length_kernels.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"
#ifdef VANDPLAN_BENCH_TARGETS
#include <hwy/targets.h>
#endif

namespace vandplan {
namespace {

constexpr double radius = 7;
constexpr std::size_t node_count = 5000;

struct Inputs {
  std::vector<Pose> nodes, samples;
  std::vector<float> x, y, heading;
  std::vector<float> out, high;

  explicit Inputs(double reach) : out(node_count), high(node_count) {
    Rng rng(1);
    const Bounds box{-reach, reach, -reach, reach};
    for (std::size_t i = 0; i < node_count; ++i) {
      nodes.push_back(uniform_pose(box, rng));
      x.push_back(static_cast<float>(nodes.back().x));
      y.push_back(static_cast<float>(nodes.back().y));
      heading.push_back(static_cast<float>(nodes.back().heading));
    }
    for (int i = 0; i < 64; ++i) samples.push_back(uniform_pose(box, rng));
  }
  [[nodiscard]] PoseColumns columns() const { return {x, y, heading}; }
};

/// `work(inputs, sample)` does all nodes.
template <typename Work>
void run(benchmark::State& state, Work work) {
  Inputs inputs(static_cast<double>(state.range(0)));
  std::size_t i = 0;
  for (auto _ : state) {
    work(inputs, inputs.samples[i++ % inputs.samples.size()]);
    benchmark::DoNotOptimize(inputs.out.data());
    benchmark::ClobberMemory();
  }
  const auto items = static_cast<double>(state.iterations()) * node_count;
  state.counters["per_node"] =
      benchmark::Counter(items, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void by_thesis_table(Inputs& in, const Pose& sample) {
  static const HeuristicTable table = thesis_table(4);
  table.distances(in.columns(), sample, radius, in.out);
}

void by_bounds(Inputs& in, const Pose& sample) {
  length_bounds(in.columns(), sample, radius, in.out, in.high);
}

void exactly(Inputs& in, const Pose& sample) {
  reeds_shepp_lengths(in.columns(), sample, radius, in.out);
}

void by_scalar_twin(Inputs& in, const Pose& sample) {
  simd::scalar::reeds_shepp_lengths(in.x, in.y, in.heading,
                                    {static_cast<float>(sample.x), static_cast<float>(sample.y),
                                     static_cast<float>(sample.heading)},
                                    static_cast<float>(radius), in.out);
}

void in_double(Inputs& in, const Pose& sample) {
  for (std::size_t i = 0; i < node_count; ++i) {
    in.out[i] = static_cast<float>(reeds_shepp_length(in.nodes[i], sample, radius));
  }
}

using Work = void (*)(Inputs&, const Pose&);

void add(const std::string& name, Work work) {
  benchmark::RegisterBenchmark(name.c_str(), [work](benchmark::State& state) { run(state, work); })
      ->Arg(10)
      ->Arg(50)
      ->Arg(200);
}

#ifdef VANDPLAN_BENCH_TARGETS
/// As a processor without anything better would do it.
void add_on(std::int64_t target, const std::string& name, Work work) {
  const auto forced = [target, work](benchmark::State& state) {
    hwy::SetSupportedTargetsForTest(target);
    run(state, work);
    hwy::SetSupportedTargetsForTest(0);
  };
  benchmark::RegisterBenchmark((name + "/" + hwy::TargetName(target)).c_str(), forced)
      ->Arg(10)
      ->Arg(50);
}
#endif

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  using namespace vandplan;
  const std::pair<const char*, Work> kernels[] = {
      {"thesis_table_4", by_thesis_table}, {"bound_table", by_bounds}, {"exact_lengths", exactly}};
  for (const auto& [name, work] : kernels) add(name, work);
  add("exact_lengths_scalar_twin", by_scalar_twin);
  add("reeds_shepp_length", in_double);
#ifdef VANDPLAN_BENCH_TARGETS
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    for (const auto& [name, work] : kernels) add_on(target, name, work);
  }
#endif
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

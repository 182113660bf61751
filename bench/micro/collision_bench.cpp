// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What does a collision check cost? Random Reeds-Shepp edges between free poses of a scenario.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "support/collision_oracle.h"
#include "support/shared_files.h"
#include "vandplan/files.h"
#include "vandplan/problem.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

struct Edge {
  Pose from;
  Piece piece;
};

/// Edges as a planner meets them: from a free pose to a free pose.
struct Edges {
  Problem problem;
  std::vector<Edge> edges;

  [[nodiscard]] bool is_free(const Edge& edge) const {
    return problem.task().checker->is_free(Local(edge.from), edge.piece.view());
  }
};

Edges random_edges(const std::string& file, Region region, double longest) {
  constexpr std::size_t count = 4096;
  Edges result{read_problems(file).problems.back(), {}};
  const Task& task = result.problem.task();
  const Bounds box = sampling_region(task, region);
  Rng rng(1);
  const auto free_pose = [&](const Bounds& within) {
    Pose pose = uniform_pose(within, rng);
    while (!task.checker->is_free(Local(pose))) pose = uniform_pose(within, rng);
    return pose;
  };
  while (result.edges.size() < count) {
    const Pose from = free_pose(box);
    const Pose to =
        free_pose({std::max(box.x_min, from.x - longest), std::min(box.x_max, from.x + longest),
                   std::max(box.y_min, from.y - longest), std::min(box.y_max, from.y + longest)});
    result.edges.push_back({from, reeds_shepp(from, to, task.vehicle.min_turning_radius)});
  }
  return result;
}

/// Median over the edges of the time of one check [ns].
double median_time(const Edges& edges) {
  constexpr int repeats = 32;
  std::vector<double> times;
  for (const Edge& edge : edges.edges) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < repeats; ++i) benchmark::DoNotOptimize(edges.is_free(edge));
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
    times.push_back(time.count() / repeats);
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

/// What an edge check costs with a margin of 0.3 m, over what it costs without, for edges that keep
/// it: all of them one after the other, in turns, the median of the ratios.
double margin_ratio(const Edges& edges) {
  constexpr int repeats = 31;
  const Task with = task_of(edges.problem, {.margin = 0.3});
  const Task& without = edges.problem.task();
  std::vector<Edge> kept;
  std::ranges::copy_if(edges.edges, std::back_inserter(kept), [&](const Edge& edge) {
    return with.checker->is_free(Local(edge.from), edge.piece.view());
  });
  const auto seconds = [&](const Task& task) {
    const auto begin = std::chrono::steady_clock::now();
    for (const Edge& edge : kept) {
      benchmark::DoNotOptimize(task.checker->is_free(Local(edge.from), edge.piece.view()));
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  std::vector<double> ratios;
  for (int i = 0; i < repeats; ++i) {
    const double plain = seconds(without);
    ratios.push_back(seconds(with) / plain);
  }
  std::nth_element(ratios.begin(), ratios.begin() + repeats / 2, ratios.end());
  return ratios[repeats / 2];
}

void edge_check(benchmark::State& state, const Edges& edges) {
  std::size_t next = 0;
  std::int64_t segments = 0;
  for (auto _ : state) {
    const Edge& edge = edges.edges[next];
    next = (next + 1) % edges.edges.size();
    segments += edge.piece.count;
    benchmark::DoNotOptimize(edges.is_free(edge));
  }
  const auto free = std::count_if(edges.edges.begin(), edges.edges.end(),
                                  [&](const Edge& edge) { return edges.is_free(edge); });
  state.counters["free"] = static_cast<double>(free) / static_cast<double>(edges.edges.size());
  state.counters["median_ns"] = median_time(edges);
  state.counters["margin_ratio"] = margin_ratio(edges);
  state.counters["segments"] =
      static_cast<double>(segments) / static_cast<double>(state.iterations());
}

void pose_check(benchmark::State& state, const Edges& edges) {
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(edges.problem.task().checker->is_free(Local(edges.edges[next].from)));
    next = (next + 1) % edges.edges.size();
  }
}

std::string name_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

void add(const std::string& name, const std::string& file, Region region, double longest) {
  const auto edges = std::make_shared<Edges>(random_edges(file, region, longest));
  benchmark::RegisterBenchmark(("edge/" + name + "/" + name_of(file)).c_str(),
                               [=](benchmark::State& state) { edge_check(state, *edges); });
  benchmark::RegisterBenchmark(("pose/" + name + "/" + name_of(file)).c_str(),
                               [=](benchmark::State& state) { pose_check(state, *edges); });
}

const bool added = [] {
  for (const std::string& file : yaml_files(repository() / "scenarios" / "thesis")) {
    add("bounds", file, Region::bounds, 400);
    add("scene", file, Region::scene, 400);
    add("scene-10m", file, Region::scene, 10);
  }
  int skip = 0;
  for (const std::string& file : yaml_files(shared_folder() / "scenarios" / "dlp")) {
    if (skip++ % 10 == 0) {
      add("scene", file, Region::scene, 400);
      add("scene-10m", file, Region::scene, 10);
    }
  }
  return true;
}();

}  // namespace
}  // namespace vandplan

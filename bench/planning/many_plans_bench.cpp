// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How many plans a second in one world? Random pairs of free poses in a yard of 200 m, 4000 x 4000
// cells; every path is judged before it counts.
// usage: many_plans_bench PAIRS SECONDS THREADS

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "large_yard.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan {
namespace {

int run(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: many_plans_bench PAIRS SECONDS THREADS\n");
    return 2;
  }
  const auto world = std::make_shared<const World>(
      Vehicle{}, Surroundings{.bounds = yard, .map = drawn(ten_obstacles())}, Point{});
  Rng rng(1);
  const auto free_pose = [&] {
    Pose pose = uniform_pose(yard, rng);
    while (!world->checker().is_free(pose)) pose = uniform_pose(yard, rng);
    return pose;
  };
  std::vector<Problem> problems;
  for (int i = 0; i < std::atoi(argv[1]); ++i) {
    const Pose start = free_pose();
    problems.push_back(make_problem(world, start, free_pose()));
  }
  PlanOptions options;
  options.time_limit = std::atof(argv[2]);
  std::atomic<std::size_t> next = 0;
  std::atomic<int> solved = 0;
  const auto begin = std::chrono::steady_clock::now();
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < std::atoi(argv[3]); ++i) {
      threads.emplace_back([&] {
        for (std::size_t k = next++; k < problems.size(); k = next++) {
          solved += plan(problems[k], default_planner(), options).path ? 1 : 0;
        }
      });
    }
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  std::printf("%d of %zu solved, %.1f plans per second\n", solved.load(), problems.size(),
              static_cast<double>(problems.size()) / time.count());
  return 0;
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) { return vandplan::run(argc, argv); }

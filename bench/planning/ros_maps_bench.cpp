// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Does the planner for ROS find a path between all pairs of a map, and what does it add to the
// library's time to a first path?
// usage: ros_maps_bench SCENARIO.yaml PAIRS.csv
//
// SCENARIO has a map and a vehicle; PAIRS are starts and goals: x, y, heading, x, y, heading. The
// maps of Nav2's own benchmark are of this kind. Both plan in one world until the first path, in
// turn. Times are medians of processor time [ms]: "call" is the adapter's, "library" that of
// `plan`, and "added" that of the differences. What is not solved is named.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "ros/adapter/planner.h"
#include "vandplan/files.h"
#include "vandplan/planner.h"

namespace vandplan::ros {
namespace {

template <typename Call>
double milliseconds_of(const Call& call) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  };
  const double begin = now();
  call();
  return now() - begin;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Costs of a map as Nav2 has them, without inflation.
std::vector<std::uint8_t> costs_of(const OccupancyGrid& map) {
  std::vector<std::uint8_t> costs;
  for (const Cell cell : *map.cells) {
    const std::uint8_t other = cell == Cell::unknown ? unknown_cost : 0;
    costs.push_back(cell == Cell::occupied ? nav2_lethal_cost : other);
  }
  return costs;
}

void run(const Scenario& scenario, const std::string& file) {
  const std::vector<std::uint8_t> costs = costs_of(*scenario.map);
  Planner planner;
  planner.take({.costs = costs,
                .columns = scenario.map->columns,
                .rows = scenario.map->rows,
                .resolution = scenario.map->resolution,
                .origin = scenario.map->origin});
  Request request{.vehicle = scenario.vehicle};
  request.options.budget = {.time_limit = 10.0, .target_gap = 1000.0};
  (void)planner.is_blocked({}, request.vehicle, request.cost_rule);  // builds the world
  std::vector<double> calls, library, added;
  int solved = 0;
  const PosePairs pairs = read_pose_pairs(file);
  for (const auto& [start, goal] : pairs.pairs) {
    request.start = start;
    request.goals = {goal};
    Answer answer;
    const auto ask_library = [&] {
      library.push_back(milliseconds_of([&] {
        const Problem problem = make_problem(planner.world(), request.vehicle, start, goal);
        (void)vandplan::plan(problem, default_planner(), request.options);
      }));
    };
    const bool is_second = calls.size() % 2 == 0;  // whoever is first warms the caches
    if (is_second) ask_library();
    calls.push_back(milliseconds_of([&] { answer = planner.plan(request); }));
    if (!is_second) ask_library();
    if (answer.outcome == Outcome::solved) {
      ++solved;
    } else {
      std::fprintf(stderr, "%s: %zu: %s\n", file.c_str(), calls.size(), answer.message.c_str());
    }
    added.push_back(calls.back() - library.back());
  }
  std::printf("pairs,solved,call,library,added\n%zu,%d,%.3f,%.3f,%.3f\n", calls.size(), solved,
              median(calls), median(library), median(added));
}

}  // namespace
}  // namespace vandplan::ros

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::fputs("usage: ros_maps_bench SCENARIO.yaml PAIRS.csv\n", stderr);
    return 2;
  }
  vandplan::ros::run(vandplan::read_scenario(argv[1]), argv[2]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}

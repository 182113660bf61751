// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How soon and how well does the default planner plan among moving obstacles?
//
// usage: moving_bench WORLDS ITERATIONS [BEST [FIRST [KIND]]]
// WORLDS random worlds of each kind (support/moving_worlds.h) or of KIND alone, from number FIRST
// on. A line (CSV) for each world: first drive (iterations, and the processor time of a run that
// ends there); after ITERATIONS the cost of prices and 2 m for each second, the seconds, and both
// over those of the cheapest of twelve runs of BEST iterations; segments below 5 cm; gear changes.
// Then medians, and 95 % or the worst, by kind.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "support/moving_worlds.h"
#include "support/plans.h"
#include "vandplan/planner.h"

namespace {

using namespace vandplan;

double seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double duration_of(const PlanResult& result) {
  return result.path ? result.speeds->duration : never;
}

double cost_of(const PlanResult& result) {
  return result.path ? result.cost + 2 * duration_of(result) : never;
}

PlanResult planned(const Scenario& scenario, std::int64_t iterations, std::uint64_t seed) {
  PlanOptions options;
  options.budget.max_iterations = iterations;
  options.budget.seed = seed;
  return plan(scenario, options);
}

/// Figures of some worlds.
struct Figures {
  std::vector<double> first;          // processor time until the first drive [s]
  std::vector<double> cost, seconds;  // excess over the cheapest run
  int crumbs = 0;                     // segments below 5 cm

  void add(const Figures& more) {
    first.insert(first.end(), more.first.begin(), more.first.end());
    cost.insert(cost.end(), more.cost.begin(), more.cost.end());
    seconds.insert(seconds.end(), more.seconds.begin(), more.seconds.end());
    crumbs += more.crumbs;
  }

  void print(const char* name) const {
    std::printf(
        "# %s: first drive %.1f ms, 95 %%: %.1f ms; cost %.2f %%, worst %.2f %%; "
        "seconds %.2f %%, worst %.2f %%; crumbs %d\n",
        name, 1e3 * quantile(first, 0.5), 1e3 * quantile(first, 0.95), 1e2 * quantile(cost, 0.5),
        1e2 * quantile(cost, 1.0), 1e2 * quantile(seconds, 0.5), 1e2 * quantile(seconds, 1.0),
        crumbs);
  }
};

/// Plans in one world, and prints its line. `most`: iterations of the twelve runs; 0: none.
Figures measured(const std::string& name, const Scenario& scenario, std::int64_t iterations,
                 std::int64_t most) {
  const PlanResult result = planned(scenario, iterations, 1);
  double best = cost_of(result);
  double best_duration = duration_of(result);
  for (std::uint64_t seed = 1; most > 0 && seed <= 12; ++seed) {
    const PlanResult other = planned(scenario, most, seed);
    if (cost_of(other) >= best) continue;
    best = cost_of(other);
    best_duration = duration_of(other);
  }
  std::int64_t first = iterations;
  int crumbs = 0;
  if (result.path) {
    first = result.anytime.front().iteration;
    for (const Segment& s : result.path->segments) crumbs += std::abs(s.length) < 0.05;
  }
  const double begin = seconds();
  (void)planned(scenario, std::max<std::int64_t>(first, 1), 1);
  const double time = result.path ? seconds() - begin : never;
  const bool is_any = std::isfinite(best);
  const double excess = is_any ? cost_of(result) / best - 1 : 0.0;
  const double longer = is_any ? duration_of(result) / best_duration - 1 : 0.0;
  std::printf("%s,%lld,%.2f,%.2f,%.2f,%.4f,%.4f,%d,%d\n", name.c_str(),
              static_cast<long long>(first), 1e3 * time, cost_of(result), duration_of(result),
              excess, longer, crumbs, result.path ? gear_changes(result.path->segments) : 0);
  return {{time}, {excess}, {longer}, crumbs};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    return std::fprintf(stderr, "usage: moving_bench WORLDS ITERATIONS [BEST [FIRST [KIND]]]\n"), 2;
  }
  const int worlds = std::atoi(argv[1]);
  const std::int64_t iterations = std::atoll(argv[2]);
  const std::int64_t most = argc > 3 ? std::atoll(argv[3]) : 0;
  const int from = argc > 4 ? std::atoi(argv[4]) : 0;
  Figures all;
  std::printf(
      "world,first_iteration,first_ms,cost,seconds,excess,seconds_excess,crumbs,gear_changes\n");
  for (std::size_t kind = 0; kind < std::size(moving_kinds); ++kind) {
    if (argc > 5 && std::strcmp(argv[5], moving_kinds[kind]) != 0) continue;
    Figures of_kind;
    for (int i = from; i < from + worlds; ++i) {
      const std::string name = moving_kinds[kind] + ("-" + std::to_string(i));
      of_kind.add(
          measured(name, moving_world(kind, static_cast<std::uint64_t>(i)), iterations, most));
    }
    of_kind.print(moving_kinds[kind]);
    all.add(of_kind);
  }
  all.print("all");
}

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// When does `anytime` find its first path, and how near is it to the best one then on?
// usage: anytime_bench SEEDS SECONDS SCENARIO.yaml...    one line per scenario; times are wall
// clock
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "vandplan/input_error.h"
#include "vandplan/io.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// What other planners reached in long runs [m]: OMPL's best of some hundred runs of 1 to 20 s.
double best_of_others(const std::string& name) {
  struct Known {
    const char* name;
    double length;
  };
  constexpr std::array known = {Known{"thesis-1-open", 73.43},
                                Known{"thesis-2-flat-obstacle", 74.99},
                                Known{"thesis-3-h-shape", 116.27},
                                Known{"thesis-4-narrow-turn", 21.99},
                                Known{"thesis-5-leave-cage", 104.64},
                                Known{"thesis-6-enter-cage", 96.59},
                                Known{"thesis-7-cage-to-cage", 148.52},
                                Known{"thesis-8-furthest-open", 201.14},
                                Known{"thesis-9-furthest-walled", 201.24}};
  for (const Known& k : known) {
    if (name == k.name) return k.length;
  }
  return never;
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

double cost_at(const PlanResult& result, double time) {
  double cost = never;
  for (const CostSample& sample : result.anytime) {
    if (sample.time <= time) cost = sample.cost;
  }
  return cost;
}

struct Rates {
  double iterations = 0.0, solves = 0.0, checks = 0.0, time = 0.0;
};

void report(const Scenario& scenario, std::size_t goal, int seeds, double seconds) {
  const Problem problem = make_problem(scenario, goal);
  std::vector<PlanResult> results;
  Rates rates;
  double best = best_of_others(scenario.name);
  std::vector<double> first;
  for (int seed = 1; seed <= seeds; ++seed) {
    PlanOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    options.time_limit = seconds;
    options.region = Region::scene;
    const PlanResult& r = results.emplace_back(plan(problem, planner_named("anytime"), options));
    rates.iterations += static_cast<double>(r.iterations);
    rates.solves += static_cast<double>(r.exact_solves);
    rates.checks += static_cast<double>(r.edge_checks);
    rates.time += r.time_total;
    if (r.path) best = std::min(best, r.cost);
    first.push_back(r.anytime.empty() ? never : 1e3 * r.anytime.front().time);
  }
  const auto unsolved = std::count(first.begin(), first.end(), never);
  std::printf("%-26s %8.3f %8.3f %8.3f %8.3f %4ld  %8.3f", scenario.name.c_str(),
              quantile(first, 0.5), quantile(first, 0.95), quantile(first, 0.99),
              quantile(first, 1.0), static_cast<long>(unsolved), best);
  for (double time : {0.001, 0.003, 0.01, 0.1, 1.0}) {
    if (time > seconds) continue;
    std::vector<double> ratio;
    for (const PlanResult& result : results) ratio.push_back(cost_at(result, time) / best);
    std::printf("  %.4f %.4f %.4f", quantile(ratio, 0.5), quantile(ratio, 0.95),
                quantile(ratio, 1.0));
  }
  std::printf("  %.2f", results.front().lower_bound);
  std::printf("  %.2f %.2f %.2f\n", 1e-6 * rates.iterations / rates.time,
              1e-6 * rates.solves / rates.time, 1e-6 * rates.checks / rates.time);
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: anytime_bench SEEDS SECONDS SCENARIO.yaml...\n");
    return 2;
  }
  std::printf(
      "first path [ms]: median, 95 %%, 99 %%, worst; unsolved; best known [m]; "
      "cost / best at 10 ms, 100 ms, 1 s: median, 95 %%, worst; proven bound [m]; "
      "millions per second: iterations, exact solves, edge checks\n");
  for (int i = 3; i < argc; ++i) {
    const Scenario scenario = read_scenario(argv[i]);
    std::size_t goal = 0;
    for (std::size_t k = 0; k < scenario.goals.size(); ++k) {
      if (scenario.goals[k].distance == 200.0) goal = k;
    }
    report(scenario, goal, std::atoi(argv[1]), std::atof(argv[2]));
  }
  return 0;
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  try {
    return vandplan::run(argc, argv);
  } catch (const vandplan::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}

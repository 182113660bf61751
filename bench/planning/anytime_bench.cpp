// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// When does `anytime` find its first path, and how near is it to the best one then on?
// usage: anytime_bench SEEDS SECONDS [NAME=VALUE...] SCENARIO.yaml...
//
// One line per scenario. Region scene, one thread; times are processor time. NAME is an option of
// all planners: gear_change_cost=5 reverse_weight=2.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "support/figure.h"
#include "support/plans.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

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

// ---- the runs of one scenario ----

constexpr std::array times = {0.001, 0.003, 0.01, 0.1, 1.0};  // [s]

struct Rates {
  double iterations = 0.0, solves = 0.0, checks = 0.0, time = 0.0;
};

struct Runs {
  std::vector<double> first;                            // [ms]
  std::array<std::vector<double>, times.size()> costs;  // at `times` [m]
  double best = never;                                  // of these and of others [m]
  double bound = 0.0;                                   // proven [m]
  Rates rates;
};

void add(Runs& runs, const PlanResult& result) {
  runs.first.push_back(result.anytime.empty() ? never : 1e3 * result.anytime.front().time);
  for (std::size_t i = 0; i < times.size(); ++i) {
    runs.costs[i].push_back(cost_at(result, times[i]));
  }
  if (result.path) runs.best = std::min(runs.best, result.cost);
  runs.bound = std::max(runs.bound, result.lower_bound.value_or(0.0));
  runs.rates.iterations += static_cast<double>(result.iterations);
  runs.rates.solves += static_cast<double>(counter(result, "exact_solves"));
  runs.rates.checks += static_cast<double>(counter(result, "edge_checks"));
  runs.rates.time += result.time_total;
}

void print_heading(double seconds) {
  std::printf("%-26s %8s %8s %8s %8s %8s %9s %9s", "first path [ms]:", "median", "95 %", "99 %",
              "worst", "unsolved", "best [m]", "bound [m]");
  std::printf("  millions a second: iterations, exact solves, edge checks; cost / best at");
  for (const double time : times) {
    if (time <= seconds) std::printf(" %g ms", 1e3 * time);
  }
  std::printf(": median, 95 %%, worst\n");
}

void print(const std::string& name, const Runs& runs, double seconds) {
  const auto unsolved = std::count(runs.first.begin(), runs.first.end(), never);
  std::printf("%-26s", name.c_str());
  for (const double share : {0.5, 0.95, 0.99, 1.0}) {
    std::printf(" %s", figure("%8.3f", quantile(runs.first, share)).c_str());
  }
  std::printf(" %8ld %s %9.2f", static_cast<long>(unsolved), figure("%9.3f", runs.best).c_str(),
              runs.bound);
  const Rates& r = runs.rates;
  std::printf(" ");
  for (const double count : {r.iterations, r.solves, r.checks}) {
    std::printf(" %s", figure("%.2f", 1e-6 * count / r.time).c_str());
  }
  for (std::size_t i = 0; i < times.size() && times[i] <= seconds; ++i) {
    std::printf(" ");
    for (const double share : {0.5, 0.95, 1.0}) {
      const double ratio = quantile(runs.costs[i], share) / runs.best;
      std::printf(" %s", figure("%.4f", ratio).c_str());
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

void report(const std::string& name, const Problem& problem, int seeds, PlanOptions options) {
  Runs runs;
  const bool is_length = vandplan::is_length(options.cost);
  if (is_length) runs.best = best_of_others(name);
  for (int seed = 1; seed <= seeds; ++seed) {
    options.budget.seed = static_cast<std::uint64_t>(seed);
    add(runs, plan(problem, planner_named("anytime"), options));
  }
  print(name, runs, options.budget.time_limit.value_or(default_time_limit));
}

/// Of a row the goal that counts 200 m; otherwise the only one.
std::size_t goal_at_200_m(const ScenarioFile& file) {
  const auto goal = std::ranges::find(file.row, 200.0, &RowGoal::distance);
  return goal == file.row.end() ? 0 : static_cast<std::size_t>(goal - file.row.begin());
}

int run(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: anytime_bench SEEDS SECONDS [NAME=VALUE...] SCENARIO.yaml...\n");
    return 2;
  }
  const int seeds = std::atoi(argv[1]);
  PlanOptions options{.cost = shortest_style};
  options.budget.time_limit = std::atof(argv[2]);
  options.planner.set("region", "scene");
  print_heading(*options.budget.time_limit);
  for (int i = 3; i < argc; ++i) {
    if (set_option(options, argv[i])) continue;
    const auto [file, problems] = read_problems(argv[i]);
    report(file.scenario.name, problems[goal_at_200_m(file)], seeds, options);
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

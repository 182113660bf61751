// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How many plans a second in one world, and how good are they? Random pairs of free poses in a yard
// of 200 m, 4000 x 4000 cells; every path is judged before it counts.
// usage: many_plans_bench PAIRS FOLDER
//        many_plans_bench PAIRS THREADS BEST LIMIT...
// FOLDER: gets the same pairs as files, for `vandplan plan FOLDER/yard.yaml --poses
// FOLDER/poses.csv`. LIMIT: below 1 a time limit in seconds, else a number of iterations; or gap=G,
// until a path is proven to be within G of the optimum, for 0.1 s at most; with gap=1000 the first
// path will do; or gap=G,N, for N iterations at most. Costs are compared with those of plans that
// took BEST seconds; "proven" are those within G, or 0.05.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

#include "large_yard.h"
#include "support/figure.h"
#include "vandplan/files.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::vector<Problem> random_problems(int count) {
  const auto world = std::make_shared<const World>(
      Surroundings{.bounds = yard, .map = drawn(ten_obstacles())}, Point{});
  const auto checker = world->checker({});
  Rng rng(1);
  const auto free_pose = [&] {
    Pose pose = uniform_pose(yard, rng);
    while (!checker->is_free(Local(pose))) pose = uniform_pose(yard, rng);
    return pose;
  };
  std::vector<Problem> problems;
  for (int i = 0; i < count; ++i) {
    const Pose start = free_pose();
    problems.push_back(make_problem(world, {}, start, free_pose()));
  }
  return problems;
}

struct Outcome {
  std::vector<std::optional<Path>> paths;
  std::vector<double> costs;  // infinite without a path [m]
  std::vector<double> gaps;   // above the bound, infinite without a path
  double time = 0.0;          // of all of them [s]
  double processor = 0.0;     // that they took, all threads together [s]
};

Outcome plan_all(const std::vector<Problem>& problems, const PlanOptions& options, int threads) {
  Outcome outcome;
  outcome.paths.resize(problems.size());
  outcome.costs.resize(problems.size(), std::numeric_limits<double>::infinity());
  outcome.gaps = outcome.costs;
  const std::clock_t processor = std::clock();
  const auto begin = std::chrono::steady_clock::now();
  plan_many(problems, default_planner(), options, threads, [&](std::size_t i, PlanResult result) {
    if (result.path) {
      outcome.costs[i] = result.cost;
      outcome.gaps[i] = result.cost / result.lower_bound.value_or(0.0) - 1;
    }
    outcome.paths[i] = std::move(result.path);
  });
  outcome.time = seconds_since(begin);
  outcome.processor = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
  return outcome;
}

/// By how much costs exceed the best ones, sorted, of the pairs that have a best path and that the
/// shortest path on open ground does not join.
std::vector<double> excess_of(const std::vector<Problem>& problems, const Outcome& outcome,
                              const Outcome& best) {
  std::vector<double> excess;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const Problem& problem = problems[i];
    const double radius = problem.vehicle().min_turning_radius;
    const double open = reeds_shepp_length(problem.start(), problem.goal(), radius);
    if (std::isfinite(best.costs[i]) && best.costs[i] > open + 1e-6) {
      excess.push_back(outcome.costs[i] / best.costs[i] - 1);
    }
  }
  std::sort(excess.begin(), excess.end());
  return excess;
}

/// A path, on one thread [s].
double judging_time(const std::vector<Problem>& problems, const Outcome& outcome) {
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < problems.size(); ++i) {
    if (outcome.paths[i]) (void)check_path(problems[i], *outcome.paths[i], {});
  }
  return seconds_since(begin) / static_cast<double>(problems.size());
}

void print_row(const char* limit, const std::vector<Problem>& problems, const Outcome& outcome,
               const Outcome& best, double gap) {
  const auto count = static_cast<double>(problems.size());
  const auto solved = std::count_if(outcome.paths.begin(), outcome.paths.end(),
                                    [](const auto& path) { return path.has_value(); });
  const std::vector<double> excess = excess_of(problems, outcome, best);
  const auto percent = [&](double part) {
    if (excess.empty()) return std::nan("");
    return 100 * excess[static_cast<std::size_t>(part * static_cast<double>(excess.size() - 1))];
  };
  const auto proven = std::count_if(outcome.gaps.begin(), outcome.gaps.end(),
                                    [gap](double found) { return found <= gap; });
  std::printf("%14s", limit);
  const auto print = [](const char* format, double value) {
    std::printf(" %s", figure(format, value).c_str());
  };
  print("%9.1f", 100 * static_cast<double>(solved) / count);
  print("%9.1f", 100 * static_cast<double>(proven) / count);
  print("%10.0f", count / outcome.time);
  print("%13.0f", count / outcome.processor);
  print("%12.2f", percent(0.5));
  print("%8.2f", percent(0.9));
  print("%8.2f", percent(0.95));
  print("%10.0f", 1e6 * judging_time(problems, outcome));
  std::printf("\n");
  std::fflush(stdout);
}

std::string text_of(const Pose& pose, const char* format) {
  std::array<char, 120> text;
  std::snprintf(text.data(), text.size(), format, pose.x, pose.y, pose.heading);
  return text.data();
}

void write_files(const std::vector<Problem>& problems, const std::string& folder) {
  constexpr auto row = "%.17g,%.17g,%.17g";
  constexpr auto map = "{x: %.17g, y: %.17g, heading: %.17g}\n";
  std::string poses;
  for (const Problem& problem : problems) {
    poses += text_of(problem.start(), row) + "," + text_of(problem.goal(), row) + "\n";
  }
  const OccupancyGrid& grid = *problems.front().world()->local().map;
  write_file(folder + "/poses.csv", poses);
  write_file(folder + "/map.pgm", map_to_pgm(grid));
  write_file(folder + "/map.yaml", map_to_yaml(grid, "map.pgm"));
  write_file(folder + "/yard.yaml",
             "name: yard\n"
             "vehicle: {wheelbase: 4.5, front_overhang: 1.4, rear_overhang: 1.6, width: 2.55, "
             "min_turning_radius: 7.0}\n"
             "map: map.yaml\n"
             "start: " +
                 text_of(problems.front().start(), map) +
                 "goal: " + text_of(problems.front().goal(), map));
}

/// What a LIMIT of the command line says.
BudgetOptions limits_of(const std::string& limit) {
  if (limit.starts_with("gap=")) {
    BudgetOptions budget{.time_limit = 0.1, .target_gap = std::atof(limit.c_str() + 4)};
    const std::size_t comma = limit.find(',');
    if (comma == std::string::npos) return budget;
    budget.time_limit.reset();
    budget.max_iterations = std::atoll(limit.c_str() + comma + 1);
    return budget;
  }
  const double number = std::atof(limit.c_str());
  if (number < 1) return {.time_limit = number};
  return {.max_iterations = std::atoll(limit.c_str())};
}

int run(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: many_plans_bench PAIRS (FOLDER | THREADS BEST LIMIT...)\n");
    return 2;
  }
  const std::vector<Problem> problems = random_problems(std::atoi(argv[1]));
  if (argc == 3) {
    write_files(problems, argv[2]);
    return 0;
  }
  const int threads = std::atoi(argv[2]);
  PlanOptions options{.cost = shortest_style};
  options.budget.time_limit = std::atof(argv[3]);
  const Outcome best = plan_all(problems, options, threads);
  std::printf(
      "%zu pairs, %zu of them need more than the shortest path on open ground: above the "
      "best, median, 90 %%, 95 %% [%%]\n",
      problems.size(), excess_of(problems, best, best).size());
  std::printf("%14s %9s %9s %10s %13s %12s %8s %8s %10s\n", "limit", "solved %", "proven %",
              "a second", "a core-second", "median", "90 %", "95 %", "judge [us]");
  constexpr double usual_gap = 0.05;
  print_row(argv[3], problems, best, best, usual_gap);
  for (int i = 4; i < argc; ++i) {
    options.budget = limits_of(argv[i]);
    print_row(argv[i], problems, plan_all(problems, options, threads), best,
              options.budget.target_gap.value_or(usual_gap));
  }
  return 0;
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) { return vandplan::run(argc, argv); }

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How do time and memory grow with the number of buildings and with the way?
// usage: growth_bench SEEDS SECONDS BUILDINGS...
//        growth_bench FOLDER BUILDINGS...
//
// Corner to corner through random sites: "yard" has a building for each 900 m^2, "dense" for each
// 450 m^2. A line (CSV) for each site and planner, medians over the seeds; then, as comments, the
// exponents that fit best. Every run is a process of its own that reads the site (YAML), plans for
// SECONDS and writes its result: that is what the memory covers. Times are processor time.
// FOLDER: gets the sites as files.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/figure.h"
#include "support/growth_peers.h"
#include "support/random_site.h"
#include "support/rounds.h"
#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/result_file.h"

namespace vandplan {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

struct Kind {
  const char* name;
  double area;  // of ground for each building [m^2]
};
constexpr std::array kinds = {Kind{"yard", 900}, Kind{"dense", 450}};

/// Ours: by length, as OMPL's planners go, and by the prices that are the default.
constexpr std::array ours = {"anytime by length", "anytime"};

// ---- one run ----

/// What one run tells, through a pipe.
struct Run {
  double read = 0.0;      // from the file to a checked problem [s]
  double first = never;   // from there to the first path [s]
  double length = never;  // of the last path [m]
  double soon = never;    // cost after a second
  double cost = never;    // cost at the end
  double gap = never;     // of that above the bound, over the bound
  double judge = never;   // of the last path, by a judge who is new to the world [s]
  double write = never;   // of the result [s]
  double memory = 0.0;    // at most, of the process [MB]
};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double cost_at(const PlanResult& result, double time) {
  double cost = never;
  for (const CostSample& sample : result.anytime) {
    if (sample.time <= time) cost = sample.cost;
  }
  return cost;
}

/// The most memory that this process has held so far [MB].
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1e3;
}

void run_ours(Run& run, const std::string& site, const ScenarioProblems& read, bool by_length,
              const BudgetOptions& budget) {
  const Problem& problem = read.problems.front();
  PlanOptions options;
  if (by_length) options.cost = shortest_style;
  options.budget = budget;
  const Planner& planner = default_planner();
  ResultRecord record{.scenario = read.file.scenario.name, .planner = planner.name};
  record.options = complete(planner, options, problem.vehicle());
  record.result = plan(problem, planner, options);
  const PlanResult& result = record.result;
  if (!result.path) return;
  run.first = result.anytime.front().time;
  run.length = length(result.path->segments);
  run.soon = cost_at(result, 1.0);
  run.cost = result.cost;
  run.gap = result.cost / result.lower_bound.value_or(0.0) - 1;
  const double written = now();
  write_results(site + ".json", read.file, {record});
  run.write = now() - written;
  run.memory = peak_memory();  // without the judge's world below
  const Problem anew = make_problems(read.file).front();
  const double judged = now();
  if (!check_path(anew, *result.path).valid) throw std::logic_error("a path that is not valid");
  run.judge = now() - judged;
}

Run run_here(const std::string& site, const std::string& planner, const BudgetOptions& budget) {
  Run run;
  const double begin = now();
  const ScenarioProblems read = read_problems(site);
  run.read = now() - begin;
  if (planner.starts_with("anytime")) {
    run_ours(run, site, read, planner == ours[0], budget);
  } else {
    const Reached reached = run_growth_peer(planner, read.problems.front(), *budget.time_limit);
    run.first = reached.first;
    run.length = run.cost = reached.length;
  }
  if (run.memory == 0) run.memory = peak_memory();
  return run;
}

/// What `work` returns, from a process of its own. Throws where that process fails.
template <typename Work>
Run in_a_process(Work work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    const Run run = work();
    const bool all = write(ends[1], &run, sizeof run) == static_cast<ssize_t>(sizeof run);
    _exit(all ? 0 : 1);
  }
  close(ends[1]);
  Run run;
  const bool all = read(ends[0], &run, sizeof run) == static_cast<ssize_t>(sizeof run);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!all || status != 0) throw std::runtime_error("a run failed");
  return run;
}

// ---- a table and what it says ----

struct Row {
  std::string planner;
  double buildings = 0.0;
  std::vector<Run> runs = {};

  [[nodiscard]] double median(double Run::*field) const {
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(run.*field);
    return vandplan::median(values);
  }
};

/// The least cost that was found for a site, of lengths or of prices.
double best_cost(const std::vector<Row>& of_site, bool by_length) {
  double best = never;
  for (const Row& row : of_site) {
    if ((row.planner != "anytime") != by_length) continue;
    for (const Run& run : row.runs) best = std::min(best, run.cost);
  }
  return best;
}

void print(const char* kind, const Row& row, double best) {
  std::printf("%s,%.0f,%s", kind, row.buildings, row.planner.c_str());
  // What is not known has an empty field.
  const auto field = [](const char* format, double value) {
    std::printf(",");
    if (std::isfinite(value)) std::printf(format, value);
  };
  const double length = row.median(&Run::length);
  field("%.1f", length);
  field("%.4f", row.median(&Run::read));
  field("%.5f", row.median(&Run::first));
  field("%.2f", 100 * (row.median(&Run::soon) / best - 1));
  field("%.2f", 100 * (row.median(&Run::cost) / best - 1));
  field("%.2f", 100 * row.median(&Run::gap));
  field("%.2f", 1e6 * row.median(&Run::judge) / length);
  field("%.4f", row.median(&Run::write));
  field("%.1f", row.median(&Run::memory));
  std::printf("\n");
}

/// The exponent of `y` against `x` that leaves the least squares of logarithms; not a number where
/// there are fewer than two points.
double exponent(const std::vector<double>& x, const std::vector<double>& y) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    const double a = std::log(x[i]), b = std::log(y[i]);
    n += 1, sx += a, sy += b, sxx += a * a, sxy += a * b;
  }
  return n < 2 ? std::nan("") : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void print_exponents(const char* kind, const std::string& planner, const std::vector<Row>& rows) {
  std::vector<double> length, buildings, read, first, memory;
  for (const Row& row : rows) {
    if (row.planner != planner) continue;
    length.push_back(row.median(&Run::length));
    buildings.push_back(row.buildings);
    read.push_back(row.median(&Run::read));
    first.push_back(row.median(&Run::first));
    memory.push_back(row.median(&Run::memory));
  }
  std::printf(
      "# %s, %s: first path ~ length^%s, reading ~ buildings^%s, memory ~ "
      "buildings^%s\n",
      kind, planner.c_str(), figure("%.2f", exponent(length, first)).c_str(),
      figure("%.2f", exponent(buildings, read)).c_str(),
      figure("%.2f", exponent(buildings, memory)).c_str());
}

void measure(const Kind& kind, int seeds, double seconds, const std::vector<int>& numbers,
             const TemporaryFolder& folder) {
  std::vector<std::string> planners(ours.begin(), ours.end());
  for (const std::string& peer : growth_peers()) planners.push_back(peer);
  std::vector<Row> rows;
  for (const int buildings : numbers) {
    const std::string site = folder.path() + "/site.yaml";
    in_a_process([&] {
      write_file(site, to_yaml(random_site(kind.name, buildings, kind.area)));
      return Run{};
    });
    std::vector<Row> of_site;
    for (const std::string& planner : planners) {
      of_site.push_back({planner, static_cast<double>(buildings)});
    }
    for (int seed = 1; seed <= seeds; ++seed) {
      const BudgetOptions budget{.time_limit = seconds, .seed = static_cast<std::uint64_t>(seed)};
      for (Row& row : of_site) {
        row.runs.push_back(in_a_process([&] { return run_here(site, row.planner, budget); }));
      }
    }
    for (const Row& row : of_site) {
      print(kind.name, row, best_cost(of_site, row.planner != "anytime"));
    }
    rows.insert(rows.end(), of_site.begin(), of_site.end());
  }
  for (const std::string& planner : planners) print_exponents(kind.name, planner, rows);
}

int run(int argc, char** argv) {
  const bool writes = argc > 1 && std::atoi(argv[1]) == 0;
  const int first = writes ? 2 : 3;
  if (argc <= first) {
    std::fprintf(stderr,
                 "usage: growth_bench SEEDS SECONDS BUILDINGS...\n"
                 "       growth_bench FOLDER BUILDINGS...\n");
    return 2;
  }
  std::vector<int> numbers;
  for (int i = first; i < argc; ++i) numbers.push_back(std::max(1, std::atoi(argv[i])));
  if (writes) {
    for (const Kind& kind : kinds) {
      for (const int buildings : numbers) {
        const std::string name = std::string(kind.name) + "-" + std::to_string(buildings);
        write_file(std::string(argv[1]) + "/" + name + ".yaml",
                   to_yaml(random_site(name, buildings, kind.area)));
      }
    }
    return 0;
  }
  std::printf(
      "kind,buildings,planner,length [m],read [s],first path [s],above best at 1 s [%%],"
      "above best at the end [%%],gap at the end [%%],judge [us/m],write [s],memory [MB]\n");
  const TemporaryFolder folder;
  for (const Kind& kind : kinds) {
    measure(kind, std::atoi(argv[1]), std::atof(argv[2]), numbers, folder);
  }
  return 0;
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  try {
    return vandplan::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}

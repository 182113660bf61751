// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What does each worker of the default planner bring?
// usage: ablation_bench SEEDS SECONDS BEST [NAME=VALUE...] [without=WORKER,...] [SCENARIO.yaml...]
//
// Every problem is planned with all workers, and with each one switched off in turn; `without`
// names groups that are switched off together, instead. One thread; times are processor time. What
// is the best known comes from a run of BEST seconds with all workers, and from all other runs.
// worlds=FIRST-LAST are random worlds by their numbers, slots=FIRST-LAST tight parking slots. NAME
// is an option of all planners, or "style".
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "planners/default_search.h"
#include "support/figure.h"
#include "support/plans.h"
#include "support/random_world.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

constexpr std::array times = {0.01, 0.1, 1.0};       // [s]
constexpr std::array excesses = {0.01, 0.03, 0.05};  // over the best known
constexpr std::array columns = {"1 %", "3 %", "5 %"};

/// Workers that are switched off together; none: all work.
using Group = std::vector<std::string>;

PlannerAnswer plan_without(const Group& off, const Task& task, const PlanOptions& options) {
  const search::Budget budget(options.budget);
  anytime::Portfolio portfolio = planning::portfolio_for(task, options, 0.0, {});
  for (anytime::Slot& slot : portfolio.slots) {
    if (std::ranges::find(off, slot.name) == off.end()) continue;
    slot.share = [](const anytime::Progress&) { return std::int64_t{0}; };
    slot.proofs = {};
  }
  const auto run = anytime::begin_run(std::move(portfolio), budget, options.budget);
  while (run->advance()) {
  }
  return run->answer();
}

Planner planner_without(const Group& off) {
  Planner planner = default_planner();
  planner.function = [off](const Task& task, const PlanOptions& options) {
    return plan_without(off, task, options);
  };
  return planner;
}

/// Names of the workers that a problem needs.
Group workers_of(const Problem& problem, const PlanOptions& options) {
  Group names;
  Planner planner = default_planner();
  planner.function = [&](const Task& task, const PlanOptions& complete) {
    for (const anytime::Slot& slot : planning::portfolio_for(task, complete, 0.0, {}).slots) {
      names.emplace_back(slot.name);
    }
    return PlannerAnswer{};
  };
  (void)plan(problem, planner, options);
  return names;
}

/// What one group brought on one problem with one seed.
struct Run {
  double first = never;                    // path [s]
  std::array<double, times.size()> costs;  // at `times`
};

/// The runs of one problem: of each group, with each seed.
struct Runs {
  std::vector<std::vector<Run>> of_group;
  double best = never;
};

Runs runs_of(const Problem& problem, const std::vector<Planner>& planners, int seeds, double best,
             PlanOptions options) {
  Runs runs;
  runs.of_group.resize(planners.size());
  for (int seed = 1; seed <= seeds; ++seed) {
    options.budget.seed = static_cast<std::uint64_t>(seed);
    for (std::size_t i = 0; i < planners.size(); ++i) {
      const PlanResult result = plan(problem, planners[i], options);
      Run& run = runs.of_group[i].emplace_back();
      if (!result.anytime.empty()) run.first = result.anytime.front().time;
      for (std::size_t t = 0; t < times.size(); ++t) run.costs[t] = cost_at(result, times[t]);
      if (result.path) runs.best = std::min(runs.best, result.cost);
    }
  }
  options.budget.time_limit = best;
  const PlanResult result = plan(problem, planners.front(), options);
  if (result.path) runs.best = std::min(runs.best, result.cost);
  return runs;
}

void print_heading(double seconds) {
  std::printf("%-28s %9s", "switched off", "first ms");
  for (const double time : times) {
    if (time > seconds) continue;
    std::printf("  | %4g ms:", 1e3 * time);
    for (const char* column : columns) std::printf(" %4s", column);
    std::printf(" %7s %8s", "mean %", "unsolved");
  }
  std::printf("\n");
}

/// One line: problems within each excess, by the median of their seeds.
void print(const std::string& name, const std::vector<Runs>& all, std::size_t group,
           double seconds) {
  std::vector<double> first;
  for (const Runs& runs : all) {
    for (const Run& run : runs.of_group[group]) first.push_back(1e3 * run.first);
  }
  std::printf("%-28s %s", name.c_str(), figure("%9.3f", quantile(first, 0.5)).c_str());
  for (std::size_t t = 0; t < times.size() && times[t] <= seconds; ++t) {
    std::array<int, excesses.size()> within{};
    double sum = 0.0;
    int solved = 0, unsolved = 0;
    for (const Runs& runs : all) {
      std::vector<double> costs;
      for (const Run& run : runs.of_group[group]) costs.push_back(run.costs[t]);
      const double excess = quantile(costs, 0.5) / runs.best - 1.0;
      for (std::size_t i = 0; i < within.size(); ++i) within[i] += excess <= excesses[i] ? 1 : 0;
      if (!std::isfinite(excess)) {
        ++unsolved;
        continue;
      }
      sum += excess;
      ++solved;
    }
    std::printf("  |         ");
    for (const int count : within) std::printf(" %4d", count);
    std::printf(" %s %8d", figure("%7.2f", solved > 0 ? 100 * sum / solved : never).c_str(),
                unsolved);
  }
  std::printf("\n");
}

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(at, begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

struct Settings {
  PlanOptions options;
  std::vector<Group> groups;
  std::vector<Problem> problems;
};

void add(Settings& settings, const std::string& argument) {
  const std::size_t equals = argument.find('=');
  const std::string name = argument.substr(0, equals);
  const std::string value = equals == std::string::npos ? "" : argument.substr(equals + 1);
  if (name == "without") {
    settings.groups.push_back(split(value, ','));
  } else if (name == "worlds" || name == "slots") {
    const auto make = name == "worlds" ? random_world : tight_slot;
    const std::vector<std::string> ends = split(value, '-');
    const int last = std::atoi(ends.back().c_str());
    for (int i = std::atoi(ends.front().c_str()); i <= last; ++i) {
      settings.problems.push_back(make(static_cast<std::uint64_t>(i)));
    }
  } else if (name == "style") {
    settings.options.cost = prices_of(style_named(value), Vehicle{});
  } else if (!set_option(settings.options, argument)) {
    settings.problems.push_back(read_problems(argument).problems.front());
  }
}

int run(int argc, char** argv) {
  if (argc < 5) {
    std::fprintf(stderr,
                 "usage: ablation_bench SEEDS SECONDS BEST [NAME=VALUE...] [without=WORKER,...] "
                 "[worlds=FIRST-LAST] [slots=FIRST-LAST] [SCENARIO.yaml...]\n");
    return 2;
  }
  const int seeds = std::atoi(argv[1]);
  const double seconds = std::atof(argv[2]);
  Settings settings;
  settings.options.budget.time_limit = seconds;
  settings.options.budget.processor_time = true;
  for (int i = 4; i < argc; ++i) add(settings, argv[i]);
  if (settings.problems.empty()) return 0;
  if (settings.groups.empty()) {
    for (const std::string& name : workers_of(settings.problems.front(), settings.options)) {
      settings.groups.push_back({name});
    }
  }
  settings.groups.insert(settings.groups.begin(), Group{});
  std::vector<Planner> planners;
  for (const Group& group : settings.groups) planners.push_back(planner_without(group));
  std::vector<Runs> all;
  for (const Problem& problem : settings.problems) {
    all.push_back(runs_of(problem, planners, seeds, std::atof(argv[3]), settings.options));
  }
  const auto solvable = std::erase_if(all, [](const Runs& runs) { return runs.best == never; });
  std::printf("%zu problems, %zu of them without any path\n", all.size() + solvable, solvable);
  print_heading(seconds);
  for (std::size_t i = 0; i < planners.size(); ++i) {
    const Group& group = settings.groups[i];
    print(group.empty() ? "nothing" : base::joined(group), all, i, seconds);
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

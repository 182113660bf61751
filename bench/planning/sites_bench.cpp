// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What does a table of a site cost, and what does it bring the default planner?
//
//   sites_bench [STARTS [TIME OF BEST [HEADINGS CELL]]]
//
// The site is a yard of 100 x 100 m with 50 obstacles, the vehicle a truck with a driver's prices.
// Paths begin at random free poses. Excess is over the cheapest path that is known: of a plan of
// `TIME OF BEST` seconds with the table, and of all other plans. Processor time limits plans.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "support/figure.h"
#include "support/plans.h"
#include "support/truck_yard.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::vector<Problem> from_everywhere(const Problem& problem, std::size_t count) {
  std::vector<Problem> problems;
  for (const Pose& start : truck_yard::free_poses(problem, count, 7)) {
    problems.push_back(with_poses(problem, start, problem.goal()));
  }
  return problems;
}

void print_row(const char* name, const std::vector<double>& excess, double time) {
  const auto within = [&](double most) {
    const auto count = std::ranges::count_if(excess, [most](double e) { return e <= most; });
    return 100.0 * static_cast<double>(count) / static_cast<double>(excess.size());
  };
  std::printf("%-22s %10.3f %8s %8s %8.1f %8.1f %8.1f\n", name, 1e3 * time,
              figure("%8.2f", 100 * quantile(excess, 0.5)).c_str(),
              figure("%8.2f", 100 * quantile(excess, 0.9)).c_str(), within(0.05), within(0.02),
              within(0.01));
}

int run(int argc, char** argv) {
  const std::size_t starts = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100;
  const double best_time = argc > 2 ? std::atof(argv[2]) : 1.0;
  SiteTableOptions cells;
  if (argc > 4) {
    cells.headings = std::atoi(argv[3]);
    cells.cell = std::atof(argv[4]);
  }
  const Problem problem = truck_yard::yard();
  const PlanOptions options = complete(default_planner(), {}, problem.vehicle());
  auto begin = std::chrono::steady_clock::now();
  const std::vector<Pose> goals = {problem.goal()};
  const SiteTable table = make_site_table(problem, goals, options, cells).value();
  std::printf("table: %.3f s, %.3f MB, rounding %.4f m, %d headings, cells of %.3f R\n",
              seconds_since(begin), 1e-6 * static_cast<double>(site_table_to_bytes(table).size()),
              table.rounding(0), cells.headings, cells.cell);

  const std::vector<Problem> problems = from_everywhere(problem, starts);
  const std::vector<double> times = {0.001, 0.005, 0.02};
  std::vector<double> best(problems.size(), never);
  std::vector<double> ways, seconds, errors;
  std::vector<std::vector<double>> with, without, with_time, without_time;
  const auto plans = [&](const PlanOptions& given, std::size_t i, std::vector<double>& spent) {
    std::vector<double> costs;
    for (const double time : times) {
      PlanOptions limited = given;
      limited.budget.time_limit = time;
      limited.budget.processor_time = true;
      const PlanResult result = plan(problems[i], limited);
      costs.push_back(result.path ? result.cost : never);
      spent.push_back(result.time_total);
      best[i] = std::min(best[i], costs.back());
    }
    return costs;
  };
  PlanOptions by_table = options;
  by_table.site = std::make_shared<const SiteTable>(table);
  for (std::size_t i = 0; i < problems.size(); ++i) {
    begin = std::chrono::steady_clock::now();
    const auto way = site_way(table, problems[i], options);
    seconds.push_back(seconds_since(begin));
    ways.push_back(way ? way->cost : never);
    with.push_back(plans(by_table, i, with_time.emplace_back()));
    without.push_back(plans(options, i, without_time.emplace_back()));
    for (PlanOptions limited : {by_table, options}) {
      limited.budget.time_limit = best_time;
      limited.budget.processor_time = true;
      const PlanResult result = plan(problems[i], limited);
      if (result.path) best[i] = std::min(best[i], result.cost);
    }
    errors.push_back(table.cost(problems[i].start(), 0) / best[i] - 1);
  }
  const auto excess = [&](const auto& cost_of) {
    std::vector<double> result;
    for (std::size_t i = 0; i < problems.size(); ++i) {
      if (best[i] < never) result.push_back(cost_of(i) / best[i] - 1);
    }
    return result;
  };
  std::printf("%zu starts, %zu with a path, best known of %g s\n", problems.size(),
              excess([](std::size_t) { return 0.0; }).size(), best_time);
  std::printf("%-22s %10s %8s %8s %8s %8s %8s\n", "", "time [ms]", "median", "90 %", "in 5 %",
              "in 2 %", "in 1 %");
  print_row("value of the table", excess([&](std::size_t i) { return (errors[i] + 1) * best[i]; }),
            0.0);
  print_row("way of the table", excess([&](std::size_t i) { return ways[i]; }),
            quantile(seconds, 0.5));
  std::printf("way of the table, 90 %% of times: %.3f ms\n", 1e3 * quantile(seconds, 0.9));
  for (std::size_t k = 0; k < times.size(); ++k) {
    const auto median = [&](const auto& rows) {
      std::vector<double> column;
      for (const auto& row : rows) column.push_back(row[k]);
      return quantile(column, 0.5);
    };
    char name[40];
    std::snprintf(name, sizeof name, "with, %g ms", 1e3 * times[k]);
    print_row(name, excess([&](std::size_t i) { return with[i][k]; }), median(with_time));
    std::snprintf(name, sizeof name, "without, %g ms", 1e3 * times[k]);
    print_row(name, excess([&](std::size_t i) { return without[i][k]; }), median(without_time));
  }
  return 0;
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) { return vandplan::run(argc, argv); }

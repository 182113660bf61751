// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What do tables to many goals cost, and how good is a matrix of costs?
//
//   site_matrix_bench [GOALS [STARTS [THREADS [PAIRS [TIME OF BEST]]]]]
//
// The site is that of sites_bench; goals and starts are random free poses. The excess of an entry
// of the matrix is over the cheaper one of two plans of `TIME OF BEST` seconds of processor time,
// with the table and without it, for random pairs.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <vector>

#include "support/figure.h"
#include "support/plans.h"
#include "support/truck_yard.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan {
namespace {

/// Times since the begin, by the clock and of all threads' processors [s].
class Clocks {
 public:
  [[nodiscard]] double wall() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  [[nodiscard]] double processor() const {
    return static_cast<double>(std::clock() - processor_begin_) / CLOCKS_PER_SEC;
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::clock_t processor_begin_ = std::clock();
};

double cost_of_plan(const Problem& problem, PlanOptions options, double time) {
  options.budget.time_limit = time;
  options.budget.processor_time = true;
  const PlanResult result = plan(problem, options);
  return result.path ? result.cost : never;
}

/// Excess of entries of the matrix over the best plans, for pairs drawn at random.
void compare(const Problem& problem, const SiteTable& table, const std::vector<Pose>& starts,
             const std::vector<SiteCost>& costs, const PlanOptions& options, std::size_t pairs,
             double time) {
  PlanOptions by_table = options;
  by_table.site = std::make_shared<const SiteTable>(table);
  Rng rng(11);
  std::vector<double> excess;
  std::size_t missing = 0;
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < pairs; ++k) {
    const std::size_t i = rng() % starts.size();
    const std::size_t j = rng() % table.goals().size();
    const SiteCost& cost = costs[i * table.goals().size() + j];
    const Problem pair = with_poses(problem, starts[i], table.goals()[j]);
    const double best =
        std::min(cost_of_plan(pair, by_table, time), cost_of_plan(pair, options, time));
    wrong += cost.lower_bound > best ? 1U : 0U;
    if (best == never) continue;
    if (cost.cost == never) {
      ++missing;
    } else {
      excess.push_back(cost.cost / best - 1);
    }
  }
  std::printf(
      "excess over plans of %g s, %zu pairs: median %s %%, 90 %%: %s %%, 99 %%: %s %%, most %s "
      "%%\n",
      time, excess.size(), figure("%.2f", 100 * quantile(excess, 0.5)).c_str(),
      figure("%.2f", 100 * quantile(excess, 0.9)).c_str(),
      figure("%.2f", 100 * quantile(excess, 0.99)).c_str(),
      figure("%.2f", 100 * quantile(excess, 1.0)).c_str());
  const auto within = std::ranges::count_if(excess, [](double e) { return e <= 0.03; });
  std::printf("within 3 %%: %zd; no entry, but a plan: %zu; bounds above the plan: %zu\n",
              static_cast<std::ptrdiff_t>(within), missing, wrong);
}

int run(int argc, char** argv) {
  const auto count = [&](int i, std::size_t usual) {
    return argc > i ? std::strtoul(argv[i], nullptr, 10) : usual;
  };
  const std::size_t goals = count(1, 200);
  const std::size_t starts = count(2, 200);
  const int threads = static_cast<int>(count(3, 2));
  const Problem problem = truck_yard::yard();
  const PlanOptions options = complete(default_planner(), {}, problem.vehicle());

  const std::vector<Pose> docks = truck_yard::free_poses(problem, goals, 5);
  const Clocks making;
  const SiteTable table = make_site_table(problem, docks, options, {.threads = threads}).value();
  std::printf(
      "%zu goals: %.2f s, processor %.2f s, %.3f MB a goal\n", goals, making.wall(),
      making.processor(),
      1e-6 * static_cast<double>(site_table_to_bytes(table).size()) / static_cast<double>(goals));

  const std::vector<Pose> from = truck_yard::free_poses(problem, starts, 7);
  const Clocks asking;
  const std::vector<SiteCost> costs = site_matrix(table, problem, from, options, threads);
  const double wall = asking.wall();
  const double processor = asking.processor();
  double sum = 0.0;
  std::size_t found = 0;
  std::size_t wrong = 0;
  for (const SiteCost& cost : costs) {
    if (cost.cost == never) continue;
    ++found;
    sum += cost.cost;
    wrong += cost.lower_bound > cost.cost ? 1U : 0U;
  }
  std::printf(
      "%zu entries: %.2f s, processor %.2f s, %.1f us an entry; %zu found, mean cost %.3f m, "
      "bounds above the cost: %zu\n",
      costs.size(), wall, processor, 1e6 * processor / static_cast<double>(costs.size()), found,
      sum / static_cast<double>(std::max<std::size_t>(1, found)), wrong);
  const std::size_t pairs = count(4, 100);
  compare(problem, table, from, costs, options, pairs, argc > 5 ? std::atof(argv[5]) : 1.0);
  return 0;
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) { return vandplan::run(argc, argv); }

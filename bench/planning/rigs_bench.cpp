// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How soon has a rig a path under any prices, and how near is it to the best one after a while?
// usage: rigs_bench open|yards COUNT SECONDS [RUNS SECONDS_OF_RUN] [FIRST_SEED]
//
// Problems come from seeds. One line each, with its prices, the first path of each style, and the
// cost against the best of RUNS long runs with any steering; then the figures. Processor time.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "support/plans.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

constexpr double pi = std::numbers::pi;

/// One problem and the prices that it is planned under.
struct Case {
  std::string vehicle;
  Problem problem;
  CostOptions cost;
};

Pose any_pose(double side, Rng& rng) {
  return {uniform(-side, side, rng), uniform(-side, side, rng), uniform(-pi, pi, rng)};
}

/// A yard of 80 m with 4 to 12 blocks.
void build(Scenario& scenario, Rng& rng) {
  const auto blocks = static_cast<int>(uniform(4, 13, rng));
  for (int i = 0; i < blocks; ++i) {
    const Pose at = any_pose(36, rng);
    const double half = uniform(1, 7, rng), wide = uniform(0.5, 4, rng);
    const double c = std::cos(at.heading), s = std::sin(at.heading);
    Polygon block;
    for (const auto& [u, v] :
         {Point{-half, -wide}, Point{half, -wide}, Point{half, wide}, Point{-half, wide}}) {
      block.push_back({at.x + c * u - s * v, at.y + s * u + c * v});
    }
    scenario.obstacles.push_back(block);
  }
}

/// Driver's prices, one of them drawn evenly by its logarithm from 1 to 1000.
CostOptions any_prices(Rng& rng) {
  CostOptions cost = driver_style;
  const double price = std::pow(1000.0, uniform01(rng));
  const double which = uniform01(rng);
  if (which < 0.4) {
    cost.reverse_weight = price;
  } else if (which < 0.6) {
    cost.gear_change_cost = price;
  } else if (which < 0.8) {
    cost.curvature_change_cost = price;
  } else {
    cost = shortest_style;
    cost.reverse_weight = price;
  }
  return cost;
}

Case any_case(bool is_open, std::uint64_t seed) {
  Rng rng(seed);
  for (;;) {
    Scenario scenario;
    const char* names[] = {"tractor-semitrailer", "truck-drawbar-trailer", "car-caravan"};
    const std::string name = names[static_cast<std::size_t>(uniform(0, 3, rng))];
    scenario.vehicle = vehicle_named(name);
    const double side = is_open ? 60 : 40;
    scenario.bounds = {-side, side, -side, side};
    if (!is_open) build(scenario, rng);
    scenario.start = any_pose(side - 25, rng);
    scenario.goal = any_pose(side - 25, rng);
    const double most = 0.7 * scenario.vehicle.max_hitch_angle;
    const bool is_straight = uniform01(rng) < 0.5;
    const double start = uniform(-most, most, rng), goal = uniform(-most, most, rng);
    if (!is_straight) scenario.hitch_angles = {start, goal};
    const CostOptions cost = any_prices(rng);
    Problem problem = make_problem(scenario);
    const Task& task = problem.task();
    const bool is_free =
        task.checker->is_free(start_state(task)) && task.checker->is_free(goal_state(task));
    if (is_free) return {name, std::move(problem), cost};
  }
}

double first_of(const Case& one, const CostOptions& cost, double seconds) {
  PlanOptions options{.cost = cost};
  options.budget.time_limit = seconds;
  const PlanResult result = plan(one.problem, planner_named("anytime"), options);
  return result.anytime.empty() ? never : 1e3 * result.anytime.front().time;
}

/// The cost of one run [m]; infinite without a path.
double cost_of(const Case& one, double seconds, std::uint64_t seed, Steering steering) {
  PlanOptions options{.cost = one.cost, .steering = steering};
  options.budget.time_limit = seconds;
  options.budget.seed = seed;
  const PlanResult result = plan(one.problem, planner_named("anytime"), options);
  return result.path ? result.cost : never;
}

int run(int argc, char** argv) {
  const std::string kind = argc > 1 ? argv[1] : "";
  if (argc < 4 || (kind != "open" && kind != "yards")) {
    std::fprintf(stderr,
                 "usage: rigs_bench open|yards COUNT SECONDS [RUNS SECONDS_OF_RUN] [FIRST_SEED]\n");
    return 2;
  }
  const double seconds = std::atof(argv[3]);
  const int runs = argc > 5 ? std::atoi(argv[4]) : 0;
  const double run_seconds = argc > 5 ? std::atof(argv[5]) : 0.0;
  const std::uint64_t first_seed =
      argc > 6 ? static_cast<std::uint64_t>(std::atoll(argv[6])) : std::uint64_t{1};
  std::vector<double> excess, slowness, firsts;
  int unsolved = 0, solvable = 0;
  std::printf(
      "seed vehicle                reverse  gears  wheels   first [ms]: shortest driver "
      "priced     cost    best  excess\n");
  for (int i = 0; i < std::atoi(argv[2]); ++i) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
    const Case one = any_case(kind == "open", seed);
    const double first[] = {
        first_of(one, shortest_style, seconds / 4),
        first_of(one, prices_of(Style::driver, one.problem.vehicle()), seconds / 4),
        first_of(one, one.cost, seconds / 4)};
    const double cost = cost_of(one, seconds, 1, Steering::reeds_shepp);
    double best = cost;
    for (int k = 0; k < runs; ++k) {
      const auto steering = static_cast<Steering>(k % 4 == 3 ? 1 : k % 4 == 2 ? 2 : 0);
      best = std::min(best, cost_of(one, run_seconds, static_cast<std::uint64_t>(k + 2), steering));
    }
    std::printf("%4llu %-22s %7.1f %6.1f %7.1f %20.2f %6.2f %6.2f %9.2f %8.2f %6.3f\n",
                static_cast<unsigned long long>(seed), one.vehicle.c_str(),
                *one.cost.reverse_weight, *one.cost.gear_change_cost,
                *one.cost.curvature_change_cost, first[0], first[1], first[2], cost, best,
                cost / best);
    std::fflush(stdout);
    if (best == never) continue;
    ++solvable;
    unsolved += cost == never;
    excess.push_back(cost / best);
    const double soonest = std::min({first[0], first[1], first[2]});
    for (const double time : first) {
      firsts.push_back(time);
      slowness.push_back(time / soonest);
    }
  }
  std::printf("%d solvable, %d unsolved; cost / best: median %.4f, 95 %% %.4f, worst %.4f\n",
              solvable, unsolved, quantile(excess, 0.5), quantile(excess, 0.95),
              quantile(excess, 1.0));
  std::printf(
      "first path [ms]: median %.2f, 95 %% %.2f, worst %.2f; against the soonest style: "
      "median %.2f, 95 %% %.2f, worst %.2f\n",
      quantile(firsts, 0.5), quantile(firsts, 0.95), quantile(firsts, 1.0), quantile(slowness, 0.5),
      quantile(slowness, 0.95), quantile(slowness, 1.0));
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

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What does a table of the site bring a replanner when a truck parks on its way?
//
//   site_replan_bench [STARTS [TICK_ITERATIONS]]
//
// The site is that of sites_bench. From each random start the vehicle drives for 2 s; then a truck
// stands where it would have been 8 s later, and stays. The vehicle goes on for at most 120 s.
// Times are processor time.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <optional>
#include <vector>

#include "support/plans.h"
#include "support/truck_yard.h"
#include "vandplan/planner.h"
#include "vandplan/replanner.h"
#include "vandplan/site_table.h"

namespace vandplan {
namespace {

constexpr double period = 0.1;                                  // between ticks [s]
constexpr double parks_at = 2.0, ahead = 8.0, longest = 120.0;  // [s]
constexpr double away = 15.0;  // least distance of the parked truck from goal and vehicle [m]

/// What became of a drive.
struct Outcome {
  int waits = 0;                  // ticks after the truck has parked without a drive to the goal
  double first = 0.0;             // time of the tick after the patch [s]
  std::vector<double> later;      // times of the ticks after it [s]
  std::optional<double> arrival;  // time of arrival [s]; none if it does not arrive
};

Pose pose_at(const ReplanAnswer& answer, const Vehicle& vehicle, double t) {
  return motion_at(answer.drive->path, vehicle, answer.drive->speeds, t - answer.begin).pose;
}

double distance(const Pose& a, const Pose& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The outline of a truck that parks across the way; none if it would stand at the goal or at the
/// vehicle.
std::optional<Polygon> parked(const ReplanAnswer& answer, const Scenario& scenario) {
  const Pose pose = pose_at(answer, scenario.vehicle, parks_at + ahead);
  const Pose here = pose_at(answer, scenario.vehicle, parks_at);
  if (std::min(distance(pose, scenario.goal), distance(pose, here)) < away) return {};
  const auto outline = corners(footprint(scenario.vehicle), pose);
  return Polygon(outline.begin(), outline.end());
}

std::optional<Outcome> drive(const Scenario& scenario, const ReplanOptions& options) {
  Replanner replanner(scenario, options);
  Outcome outcome;
  for (int i = 0; i * period < parks_at + longest; ++i) {
    const double t = i * period;
    const bool has_parked = t > parks_at - period / 2;
    const bool parks = has_parked && t < parks_at + period / 2;
    if (parks) {
      const auto outline = parked(replanner.answer(), scenario);
      if (!outline) return std::nullopt;
      replanner.patch({.added = {{100, *outline}}});
    }
    const std::clock_t begin = std::clock();
    const ReplanAnswer answer = replanner.tick(t);
    const double time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (parks) outcome.first = time;
    if (has_parked && !parks) outcome.later.push_back(time);
    if (has_parked && !answer.reaches_goal) ++outcome.waits;
    if (!answer.has_arrived) continue;
    outcome.arrival = answer.begin + answer.drive->speeds.duration;
    break;
  }
  return outcome;
}

double mean(const std::vector<double>& numbers) {
  double sum = 0.0;
  for (const double number : numbers) sum += number;
  return numbers.empty() ? 0.0 : sum / static_cast<double>(numbers.size());
}

void print(const char* name, const std::vector<Outcome>& outcomes) {
  int waits = 0;
  std::vector<double> first;
  std::vector<double> later;
  std::vector<double> arrivals;
  for (const Outcome& outcome : outcomes) {
    waits += outcome.waits;
    first.push_back(outcome.first);
    later.insert(later.end(), outcome.later.begin(), outcome.later.end());
    if (outcome.arrival) arrivals.push_back(*outcome.arrival);
  }
  if (outcomes.empty()) return;
  std::printf("%-10s %6zu %7zu %6d %10.2f %20.2f %9.2f %14.2f %9.2f\n", name, outcomes.size(),
              arrivals.size(), waits, mean(arrivals), 1e3 * quantile(first, 0.5),
              1e3 * quantile(first, 0.9), 1e3 * quantile(later, 0.5), 1e3 * quantile(later, 0.99));
}

int run(int argc, char** argv) {
  const std::size_t starts = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 40;
  const std::int64_t iterations = argc > 2 ? std::atoll(argv[2]) : ReplanOptions{}.tick_iterations;
  Scenario scenario = truck_yard::scenario();
  const Problem problem = make_problem(scenario);
  const PlanOptions prices = complete(default_planner(), {}, scenario.vehicle);
  const auto site =
      std::make_shared<ChangingSiteTable>(problem, std::vector{scenario.goal}, prices);
  std::vector<Outcome> outcomes[2];
  for (const Pose& start : truck_yard::free_poses(problem, starts, 9)) {
    scenario.start = start;
    ReplanOptions options{.tick_iterations = iterations};
    options.plan.budget.max_iterations = 2'000;
    auto without = drive(scenario, options);
    options.site = site;
    auto with = drive(scenario, options);
    if (!without || !with) continue;
    outcomes[0].push_back(*std::move(without));
    outcomes[1].push_back(*std::move(with));
  }
  std::printf("%-10s %6s %7s %6s %10s %30s %24s\n", "", "drives", "arrived", "waits", "arrive [s]",
              "tick after it: median, 90 %", "later: median, 99 % [ms]");
  for (int i = 0; i < 2; ++i) print(i == 0 ? "without" : "with site", outcomes[i]);
  return 0;
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) { return vandplan::run(argc, argv); }

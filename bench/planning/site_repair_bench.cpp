// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What does it take to repair a table of a site, compared with making it anew?
//
//   site_repair_bench [TRUCKS [GOALS]]
//
// The site is that of sites_bench. One truck after the other parks at a random free pose and leaves
// again. Times are processor time: of the repair alone, not of the patch of the world.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <vector>

#include "support/plans.h"
#include "support/truck_yard.h"
#include "vandplan/planner.h"
#include "vandplan/replanner.h"
#include "vandplan/site_table.h"

namespace vandplan {
namespace {

double time_of(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double mean(const std::vector<double>& times) {
  double sum = 0.0;
  for (const double time : times) sum += time;
  return sum / static_cast<double>(times.size());
}

int run(int argc, char** argv) {
  const std::size_t trucks = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100;
  const std::size_t goals = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  const Scenario scenario = truck_yard::scenario();
  ChangingWorld ground(surroundings(scenario), {scenario.start.x, scenario.start.y});
  const auto problem = [&] {
    return make_problem(ground.world(), scenario.vehicle, scenario.start, scenario.goal);
  };
  const PlanOptions options = complete(default_planner(), {}, scenario.vehicle);
  std::vector<Pose> docks = truck_yard::free_poses(problem(), goals - 1, 5);
  docks.push_back(scenario.goal);
  std::vector<double> anew;
  for (int i = 0; i < 3; ++i) {
    anew.push_back(time_of([&] { (void)make_site_table(problem(), docks, options); }));
  }
  ChangingSiteTable table(problem(), docks, options);
  std::vector<double> comes;
  std::vector<double> goes;
  for (const Pose& pose : truck_yard::free_poses(problem(), trucks, 9)) {
    const auto outline = corners(footprint(scenario.vehicle), pose);
    ground.patch({.added = {{100, {outline.begin(), outline.end()}}}});
    comes.push_back(time_of([&] { table.repair(problem()); }));
    ground.patch({.removed = {100}});
    goes.push_back(time_of([&] { table.repair(problem()); }));
  }
  const double whole = quantile(anew, 0.5);
  std::printf("%zu goals, made anew: %.1f ms\n", goals, 1e3 * whole);
  std::printf("%-16s %8s %8s %8s %8s   times faster: median, mean\n", "repair [ms]", "median",
              "90 %", "most", "mean");
  for (const auto& [name, times] :
       {std::pair{"a truck parks", &comes}, std::pair{"a truck leaves", &goes}}) {
    std::printf("%-16s %8.2f %8.2f %8.2f %8.2f   %.1f %.1f\n", name, 1e3 * quantile(*times, 0.5),
                1e3 * quantile(*times, 0.9), 1e3 * quantile(*times, 1.0), 1e3 * mean(*times),
                whole / quantile(*times, 0.5), whole / mean(*times));
  }
  return 0;
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) { return vandplan::run(argc, argv); }

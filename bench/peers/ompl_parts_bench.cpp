// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What do OMPL's planners gain from each of our parts?
// usage: peer_ompl_parts_bench RUNS SECONDS bounds|scene SCENARIO.yaml...
//
// RRTConnect: time to the first path, up to ten times SECONDS, in fifteen times as many runs. RRT*
// and BIT*: iterations a second, over as many iterations as OMPL alone does in SECONDS: later ones
// take longer, so that an equal time would count the dearer ones of whoever is faster. In turns on
// the same problems, with the same random numbers; times are processor time. Ordinary checks test
// the polygon of the footprint every 0.1 m. Every path goes through our judge.
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "support/figure.h"
#include "support/ompl_run.h"
#include "support/rounds.h"
#include "vandplan/files.h"
#include "vandplan/ompl.h"

namespace vandplan {
namespace {

namespace ob = ::ompl::base;
namespace og = ::ompl::geometric;

/// Which of our parts take the place of OMPL's.
struct Parts {
  const char* name;
  bool space, checkers, nearest;
};
constexpr std::array all_parts = {
    Parts{"OMPL", false, false, false},          Parts{"space", true, false, false},
    Parts{"checkers", false, true, false},       Parts{"space, nearest", true, false, true},
    Parts{"space, checkers", true, true, false}, Parts{"all", true, true, true},
};

struct Settings {
  int runs;
  double seconds;
  Region region;
};

struct Outcome {
  double time = 0.0;        ///< [s]
  unsigned iterations = 0;  ///< of planners that count them
  bool valid = true;
};

template <typename Planner>
constexpr bool counts = !std::is_base_of_v<og::RRTConnect, Planner>;

/// One run, of as many iterations if that is not 0, else of as much time as there is.
template <typename Planner>
struct Run {
  const Problem& problem;
  const Settings& settings;
  unsigned iterations;

  template <typename ThisPlanner>
  Outcome with(const Parts& parts) const {
    const double radius = problem.vehicle().min_turning_radius;
    ob::StateSpacePtr space = std::make_shared<ob::ReedsSheppStateSpace>(radius);
    if (parts.space) space = std::make_shared<ompl::ReedsSheppStateSpace>(radius);
    og::SimpleSetup setup(space);
    set_up(setup, problem, settings.region, parts.checkers);
    const auto planner = std::make_shared<ThisPlanner>(setup.getSpaceInformation());
    setup.setPlanner(planner);
    setup.setup();
    const auto begin = std::chrono::steady_clock::now();
    Outcome outcome;
    if constexpr (counts<Planner>) {
      const auto is_enough = [&] { return planner->numIterations() >= iterations; };
      setup.solve(iterations > 0 ? ob::PlannerTerminationCondition(is_enough)
                                 : ob::timedPlannerTerminationCondition(settings.seconds));
      outcome.iterations = planner->numIterations();
    } else {
      // Given a number of seconds OMPL starts a thread, which outlasts the search in open ground.
      setup.solve(ob::timedPlannerTerminationCondition(10 * settings.seconds));
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    outcome.time = time.count();
    if (setup.haveExactSolutionPath()) {
      outcome.valid = check_path(problem, path_of(setup.getSolutionPath(), problem)).valid;
    }
    return outcome;
  }

  Outcome operator()(const Parts& parts) const {
    if (!parts.nearest) return with<Planner>(parts);
    if constexpr (std::is_same_v<Planner, og::BITstar>) {
      return with<ompl::BITstar>(parts);
    } else {
      return with<std::conditional_t<std::is_same_v<Planner, og::RRTstar>, ompl::geometric::RRTstar,
                                     ompl::ByLength<Planner>>>(parts);
    }
  }
};

/// Adds a planner's figures to a row of each kind of parts, as how many times better they are.
template <typename Planner>
void compare(const char* name, const Problem& problem, const Settings& settings) {
  std::array<std::vector<double>, all_parts.size()> figures;
  std::array<int, all_parts.size()> rejected{};
  for (int run = 0; run < (counts<Planner> ? 1 : 15) * settings.runs; ++run) {
    unsigned iterations = 0;
    for (std::size_t i = 0; i < all_parts.size(); ++i) {
      ::ompl::RNG::setSeed(static_cast<unsigned>(run) + 1);
      const Outcome outcome = Run<Planner>{problem, settings, iterations}(all_parts[i]);
      if (i == 0) iterations = outcome.iterations;
      figures[i].push_back(counts<Planner> ? outcome.iterations / outcome.time
                                           : 1e3 * outcome.time);
      rejected[i] += outcome.valid ? 0 : 1;
    }
  }
  std::printf("  %-11s %s", name, counts<Planner> ? "it/s" : "ms  ");
  for (std::size_t i = 0; i < all_parts.size(); ++i) {
    const double found = median(figures[i]);
    const double base = median(figures[0]);
    const double times = counts<Planner> ? found / base : base / found;
    std::printf(" %s", figure("%11.5g", found).c_str());
    if (i > 0) std::printf(" %s x", figure("%6.1f", times).c_str());
    if (rejected[i] > 0) std::printf(" (%d rejected)", rejected[i]);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  using namespace vandplan;
  if (argc < 5) {
    std::fprintf(stderr,
                 "usage: peer_ompl_parts_bench RUNS SECONDS bounds|scene SCENARIO.yaml...\n");
    return 2;
  }
  const Settings settings{std::atoi(argv[1]), std::atof(argv[2]),
                          argv[3] == std::string("bounds") ? Region::bounds : Region::scene};
  ::ompl::msg::noOutputHandler();
  std::printf(
      "medians of %d (RRTConnect: 15 times as many); region %s; processor time, without OMPL's "
      "setup\n%-16s",
      settings.runs, argv[3], "");
  for (const Parts& parts : all_parts) std::printf(" %20s", parts.name);
  std::printf("\n");
  for (int i = 4; i < argc; ++i) {
    const auto [file, problems] = read_problems(argv[i]);
    // Of a row the goal that counts 200 m; otherwise the only one.
    const auto goal = std::ranges::find(file.row, 200.0, &RowGoal::distance);
    const auto number = goal == file.row.end() ? 0 : goal - file.row.begin();
    const Problem& problem = problems[static_cast<std::size_t>(number)];
    std::printf("%s\n", file.scenario.name.c_str());
    compare<og::RRTConnect>("RRTConnect", problem, settings);
    compare<og::RRTstar>("RRT*", problem, settings);
    compare<og::BITstar>("BIT*", problem, settings);
  }
}

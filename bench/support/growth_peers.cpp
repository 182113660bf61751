// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "support/growth_peers.h"

#ifdef VANDPLAN_BENCH_OMPL
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <chrono>

#include "support/ompl_run.h"
#include "vandplan/judge.h"
#endif

namespace vandplan {

#ifdef VANDPLAN_BENCH_OMPL

namespace ob = ::ompl::base;
namespace og = ::ompl::geometric;

std::vector<std::string> growth_peers() { return {"RRTConnect", "RRT*"}; }

Reached run_growth_peer(const std::string& name, const Problem& problem, double seconds) {
  ::ompl::msg::noOutputHandler();
  og::SimpleSetup setup(
      std::make_shared<ob::ReedsSheppStateSpace>(problem.vehicle().min_turning_radius));
  set_up(setup, problem, Region::bounds, true);
  const ob::SpaceInformationPtr& si = setup.getSpaceInformation();
  if (name == "RRT*") {
    setup.setPlanner(std::make_shared<og::RRTstar>(si));
  } else {
    setup.setPlanner(std::make_shared<og::RRTConnect>(si));
  }
  setup.setup();
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  Reached reached;
  const auto note = [&](const ob::Planner*, const std::vector<const ob::State*>&, ob::Cost) {
    reached.first = std::min(reached.first, elapsed());
  };
  setup.getProblemDefinition()->setIntermediateSolutionCallback(note);
  setup.solve(seconds);
  if (!setup.haveExactSolutionPath()) return {};
  reached.first = std::min(reached.first, elapsed());
  const PathCheck check = check_path(problem, path_of(setup.getSolutionPath(), problem));
  if (!check.valid) return {};
  reached.length = check.length;
  return reached;
}

#else

std::vector<std::string> growth_peers() { return {}; }

Reached run_growth_peer(const std::string& /*name*/, const Problem& /*problem*/,
                        double /*seconds*/) {
  return {};
}

#endif

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How do OMPL's planners do on the same problems, in turns with ours?
// usage: peer_planners_bench SEEDS SECONDS bounds|scene PLANNER,...|all SCENARIO.yaml...
//
// Planners are OMPL's, as named below, and ours beside "anytime": "RRT*,rrt-star/informed=false".
// Region of the samples, for all alike. Times are processor time, of all threads together.
// Each of OMPL's planners runs twice: with an ordinary test of the footprint's polygon every 0.1 m,
// and with our checker as its motion validator. Every path goes through our judge.
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "support/figure.h"
#include "support/ompl_run.h"
#include "support/plans.h"
#include "vandplan/files.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

namespace ob = ::ompl::base;
namespace og = ::ompl::geometric;
using Space = ob::ReedsSheppStateSpace;

// ---- one run ----

struct Settings {
  int seeds;
  double seconds;
  Region region;
  std::string planners;  // names with commas between and around them, or all

  [[nodiscard]] bool wants(const std::string& name) const {
    return planners == ",all," || planners.find("," + name + ",") != std::string::npos;
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    std::istringstream text(planners);
    for (std::string name; std::getline(text, name, ',');) all.push_back(name);
    return all;
  }
};

struct Outcome {
  double first = never;  // [ms]
  double cost = never;   // at the end [m]
  bool valid = true;
  double rate = 0.0;  // iterations in a second, where they are known
};

using MakePlanner = std::function<ob::PlannerPtr(const ob::SpaceInformationPtr&)>;

template <typename Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr& si) {
  return std::make_shared<Planner>(si);
}

const std::vector<std::pair<const char*, MakePlanner>>& ompl_planners() {
  static const std::vector<std::pair<const char*, MakePlanner>> table = {
      {"RRTConnect", make<og::RRTConnect>},
      {"RRT", make<og::RRT>},
      {"RRT*", make<og::RRTstar>},
      {"InformedRRT*", make<og::InformedRRTstar>},
      {"SORRT*", make<og::SORRTstar>},
      {"BIT*", make<og::BITstar>},
      {"ABIT*", make<og::ABITstar>},
      {"AIT*", make<og::AITstar>},
      {"APS", make<og::AnytimePathShortening>},
  };
  return table;
}

Outcome run_ompl(const Problem& problem, const MakePlanner& make_planner, bool ours,
                 const Settings& settings) {
  const auto space = std::make_shared<Space>(problem.vehicle().min_turning_radius);
  og::SimpleSetup setup(space);
  set_up(setup, problem, settings.region, ours);
  setup.setPlanner(make_planner(setup.getSpaceInformation()));
  setup.setup();
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  Outcome outcome;
  const auto found = [&](const ob::Planner*, const std::vector<const ob::State*>&, ob::Cost) {
    outcome.first = std::min(outcome.first, 1e3 * elapsed());
  };
  setup.getProblemDefinition()->setIntermediateSolutionCallback(found);
  setup.solve(settings.seconds);
  if (const auto* star = dynamic_cast<const og::RRTstar*>(setup.getPlanner().get())) {
    outcome.rate = star->numIterations() / elapsed();
  }
  if (!setup.haveExactSolutionPath()) return outcome;
  outcome.first = std::min(outcome.first, 1e3 * elapsed());
  const Path path = path_of(setup.getSolutionPath(), problem);
  const PathCheck check = check_path(problem, path, {});
  outcome.cost = check.length;
  outcome.valid = check.valid;
  return outcome;
}

/// One of our planners with options of its own: "rrt-star/informed=false".
struct Ours {
  Planner planner;
  std::vector<std::pair<std::string, std::string>> options = {};
};

std::optional<Ours> ours_named(const std::string& text) {
  std::istringstream parts(text);
  std::string part;
  std::getline(parts, part, '/');
  const std::optional<Planner> planner = find_planner(part);
  if (!planner) return std::nullopt;
  Ours ours{*planner};
  while (std::getline(parts, part, '/')) {
    const std::size_t equals = part.find('=');
    ours.options.emplace_back(part.substr(0, equals), part.substr(equals + 1));
  }
  return ours;
}

Outcome run_ours(const Problem& problem, const Ours& ours, int seed, double seconds,
                 Region region) {
  PlanOptions options{.cost = shortest_style};
  options.budget.seed = static_cast<std::uint64_t>(seed);
  options.budget.time_limit = seconds;
  options.planner.set("region", region == Region::scene ? "scene" : "bounds");
  for (const auto& [name, value] : ours.options) set_option(options, ours.planner, name, value);
  const PlanResult result = plan(problem, ours.planner, options);
  Outcome outcome{.rate = static_cast<double>(result.iterations) / result.time_total};
  outcome.valid = result.status != PlanStatus::rejected;
  if (!result.path) return outcome;
  outcome.first = 1e3 * result.anytime.front().time;
  outcome.cost = result.cost;
  return outcome;
}

// ---- the table ----

void print(const char* planner, const std::vector<Outcome>& outcomes) {
  std::vector<double> first, cost, rate;
  int judged = 0;
  for (const Outcome& outcome : outcomes) {
    first.push_back(outcome.first);
    cost.push_back(outcome.cost);
    rate.push_back(outcome.rate);
    judged += outcome.valid ? 0 : 1;
  }
  const auto print_quantiles = [](const char* format, const std::vector<double>& values) {
    for (const double share : {0.5, 0.95, 1.0}) {
      std::printf(" %s", figure(format, quantile(values, share)).c_str());
    }
  };
  std::printf("  %-26s first", planner);
  print_quantiles("%9.3f", first);
  std::printf(" ms   length");
  print_quantiles("%8.2f", cost);
  std::printf(" m   rejected %d   %s iterations/s\n", judged,
              figure("%7.0f", quantile(rate, 0.5)).c_str());
}

void compare(const std::string& scenario, const Problem& problem, const Settings& settings) {
  std::map<std::string, std::vector<Outcome>> outcomes;
  std::vector<std::string> order;
  const auto add = [&](const std::string& name, const Outcome& outcome) {
    if (outcomes[name].empty()) order.push_back(name);
    outcomes[name].push_back(outcome);
  };
  for (int seed = 1; seed <= settings.seeds; ++seed) {
    for (const double time : {0.01, 0.1, settings.seconds}) {
      const std::string name = "anytime, " + std::to_string(std::lround(1e3 * time)) + " ms";
      add(name, run_ours(problem, {default_planner()}, seed, time, settings.region));
    }
    for (const std::string& name : settings.names()) {
      const std::optional<Ours> ours = ours_named(name);
      if (ours) add(name, run_ours(problem, *ours, seed, settings.seconds, settings.region));
    }
    for (const auto& [name, make_planner] : ompl_planners()) {
      if (!settings.wants(name)) continue;
      add(name, run_ompl(problem, make_planner, false, settings));
      add(std::string(name) + ", our checker", run_ompl(problem, make_planner, true, settings));
    }
  }
  std::printf("%s\n", scenario.c_str());
  for (const std::string& name : order) print(name.c_str(), outcomes[name]);
  std::fflush(stdout);
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  using namespace vandplan;
  if (argc < 6) {
    std::fprintf(stderr,
                 "usage: peer_planners_bench SEEDS SECONDS bounds|scene PLANNER,...|all "
                 "SCENARIO.yaml...\n");
    return 2;
  }
  const Settings settings{std::atoi(argv[1]), std::atof(argv[2]),
                          argv[3] == std::string("bounds") ? Region::bounds : Region::scene,
                          "," + std::string(argv[4]) + ","};
  ::ompl::msg::noOutputHandler();
  ::ompl::RNG::setSeed(1);
  std::printf("median, 95 %%, worst of %d; region %s; processor time, without OMPL's setup\n",
              settings.seeds, argv[3]);
  for (int i = 5; i < argc; ++i) {
    const auto [file, problems] = read_problems(argv[i]);
    // Of a row the goal that counts 200 m; otherwise the only one.
    const auto goal = std::ranges::find(file.row, 200.0, &RowGoal::distance);
    const auto number = goal == file.row.end() ? 0 : goal - file.row.begin();
    compare(file.scenario.name, problems[static_cast<std::size_t>(number)], settings);
  }
}

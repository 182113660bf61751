// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Which planners is the default one compared with?

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "lab/estimate_options.h"
#include "lab/field_d_star.h"
#include "lab/hrrt.h"
#include "lab/hybrid_a_star.h"
#include "lab/lattice_planners.h"
#include "lab/prm.h"
#include "lab/rrt.h"
#include "lab/rrt_connect.h"
#include "lab/rrt_star.h"
#include "planners/registered.h"

namespace vandplan::planning {
namespace {

using rrt::Strategy;
using search::Estimate;

/// A strategy that chooses parents, and its part of a planner's name and summary.
struct Choice {
  Strategy strategy;
  const char* name;
  const char* summary;
};

constexpr std::array choices = {
    Choice{Strategy::nearest, "bsc", "RRT, parent = nearest node by "},
    Choice{Strategy::least_total_cost, "opt", "RRT, parent = least total path cost, ranked by "}};

/// An estimate that ranks nodes, and its part of a planner's name and summary.
struct Ranking {
  Estimate estimate;
  const char* name;      ///< part of the planner's name
  const char* property;  ///< value of `PlannerProperties::estimate`
  const char* summary;
  bool in_thesis;  ///< whether it is one of the thesis' five estimates
};

constexpr std::array rankings = {
    Ranking{Estimate::euclid, "euc", "euclid", "Euclid", true},
    Ranking{Estimate::hlut_1, "hlut-1", "hlut-1", "table 1 (10 m, pi/4)", true},
    Ranking{Estimate::hlut_2, "hlut-2", "hlut-2", "table 2 (20 m, pi/4)", true},
    Ranking{Estimate::hlut_3, "hlut-3", "hlut-3", "table 3 (10 m, pi/12)", true},
    Ranking{Estimate::hlut_4, "hlut-4", "hlut-4", "table 4 (30 m, pi/12)", true},
    Ranking{Estimate::bound, "bound", "bound", "lower bound of its length", false},
    Ranking{Estimate::reeds_shepp, "rs", "reeds-shepp", "exact Reeds-Shepp length", false}};

constexpr Ranking by_site = {Estimate::site, "site", "site", "a table of the site", false};

Planner rrt_planner(const Choice& choice, const Ranking& ranking, bool tries_goal) {
  const rrt::Variant variant{choice.strategy, ranking.estimate};
  const std::string search = std::string("rrt-") + choice.name;
  Planner planner{.name = search + "-" + ranking.name,
                  .summary = std::string(choice.summary) + ranking.summary,
                  .properties = {.family = "rrt",
                                 .strategy = choice.name,
                                 .estimate = ranking.property,
                                 .search = search,
                                 .tries_goal = tries_goal,
                                 .capabilities = {Capability::gears, Capability::steering},
                                 .anytime = true},
                  .options = rrt::options(tries_goal),
                  .function = [variant](const Task& task, const PlanOptions& options) {
                    return rrt::plan(task, options, variant);
                  }};
  if (tries_goal) {
    planner.name += "-goal";
    planner.properties.search += "-goal";
    planner.summary += ", goal tried from every node";
  }
  planner.properties.capabilities.add(ranking.estimate == Estimate::site ? Capability::site
                                                                         : Capability::trailers);
  if (ranking.in_thesis) planner.properties.groups = {tries_goal ? "thesis-goal" : "thesis"};
  return planner;
}

}  // namespace

std::vector<Planner> laboratory() {
  std::vector<Planner> planners;
  for (const bool tries_goal : {false, true}) {
    for (const Choice& choice : choices) {
      for (const Ranking& ranking : rankings) {
        planners.push_back(rrt_planner(choice, ranking, tries_goal));
      }
    }
  }
  planners.push_back(hybrid::planner());
  for (Planner& planner : lattice::planners()) planners.push_back(std::move(planner));
  planners.push_back(field_d_star::planner());
  planners.push_back(prm::planner());
  for (const auto selection :
       {hrrt::Selection::nearest, hrrt::Selection::first_of_k, hrrt::Selection::best_of_k}) {
    planners.push_back(hrrt::planner(selection));
  }
  planners.push_back(rrt_connect::planner());
  planners.push_back(rrt_star::planner());
  for (Planner& planner : planners) name_estimate(planner);
  return planners;
}

std::vector<Planner> laboratory_of_sites() {
  std::vector<Planner> planners;
  for (const bool tries_goal : {false, true}) {
    for (const Choice& choice : choices) {
      planners.push_back(rrt_planner(choice, by_site, tries_goal));
    }
  }
  return planners;
}

}  // namespace vandplan::planning

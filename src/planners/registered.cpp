// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/registered.h"

#include <array>
#include <utility>

#include "path/finite.h"
#include "planners/anytime/anytime.h"
#include "planners/anytime/tidy.h"
#include "planners/field_d_star.h"
#include "planners/hrrt.h"
#include "planners/hybrid_a_star.h"
#include "planners/in_time.h"
#include "planners/lattice_planners.h"
#include "planners/prm.h"
#include "planners/rrt.h"
#include "planners/rrt_connect.h"
#include "planners/rrt_star.h"
#include "planners/shared_options.h"
#include "vandplan/input_error.h"
#include "vandplan/path_source.h"

namespace vandplan::planning {
namespace {

using rrt::Strategy;
using search::Estimate;

Planner anytime_planner() {
  return {.name = "anytime",
          .summary = "lattice searches and random trees, each path shortened: the one to use",
          .properties = {.family = "anytime",
                         .honours_prices = true,
                         .style = Style::driver,
                         .honours_time = true,
                         .honours_threads = true,
                         .honours_target_gap = true,
                         .honours_steering = true,
                         .honours_moving = true,
                         .honours_trailers = true,
                         .honours_steering_of_rigs = true,
                         .anytime = true},
          .options = {region_option(), anytime::min_stroke_option()},
          .function = [](const Task& task, const PlanOptions& options) {
            return task.moving.empty() ? anytime::plan_anytime(task, options)
                                       : in_time::plan(task, options);
          }};
}

/// Which node becomes a parent.
struct Choice {
  Strategy strategy;
  const char* name;
  const char* summary;
};

constexpr std::array choices = {
    Choice{Strategy::nearest, "bsc", "RRT, parent = nearest node by "},
    Choice{Strategy::least_total_cost, "opt", "RRT, parent = least total path cost, ranked by "}};

/// What ranks nodes.
struct Ranking {
  Estimate estimate;
  const char* name;      ///< in the planner's name
  const char* property;  ///< its `PlannerProperties::estimate`
  const char* summary;
  bool in_thesis;  ///< one of the thesis' five
};

constexpr std::array rankings = {
    Ranking{Estimate::euclid, "euc", "euclid", "Euclid", true},
    Ranking{Estimate::hlut_1, "hlut-1", "hlut-1", "table 1 (10 m, pi/4)", true},
    Ranking{Estimate::hlut_2, "hlut-2", "hlut-2", "table 2 (20 m, pi/4)", true},
    Ranking{Estimate::hlut_3, "hlut-3", "hlut-3", "table 3 (10 m, pi/12)", true},
    Ranking{Estimate::hlut_4, "hlut-4", "hlut-4", "table 4 (30 m, pi/12)", true},
    Ranking{Estimate::bound, "bound", "bound", "lower bound of its length", false},
    Ranking{Estimate::reeds_shepp, "rs", "reeds-shepp", "exact Reeds-Shepp length", false}};

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
                                 .honours_steering = true,
                                 .honours_trailers = true,
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
  if (ranking.in_thesis) planner.properties.groups = {tries_goal ? "thesis-goal" : "thesis"};
  return planner;
}

}  // namespace

std::vector<Planner> registered_planners() {
  std::vector<Planner> planners = {anytime_planner()};
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

}  // namespace vandplan::planning

namespace vandplan {
namespace {

constexpr std::int64_t most_of_a_source = 10'000;  // iterations of a round

}  // namespace

Planner warm_started(const Path& path) {
  path::check_finite(path);
  Planner planner = default_planner();
  planner.function = [path](const Task& task, const PlanOptions& options) {
    if (!task.moving.empty()) return in_time::plan(task, options);
    const Path known{to_local(*task.world, path.start), path.segments};
    return anytime::plan_anytime(task, options, {.known = &known});
  };
  return planner;
}

Planner with_sources(std::vector<NamedSource> sources) {
  for (const NamedSource& source : sources) {
    if (!source.make) throw InputError("source " + source.name, "has nothing that makes it");
    if (source.share < 1 || source.share > most_of_a_source) {
      throw InputError("source " + source.name, "share: expected 1 to " +
                                                    std::to_string(most_of_a_source) + ", not " +
                                                    std::to_string(source.share));
    }
  }
  Planner planner = default_planner();
  planner.function = [sources = std::move(sources)](const Task& task, const PlanOptions& options) {
    return task.moving.empty() ? anytime::plan_anytime(task, options, {.sources = sources})
                               : in_time::plan(task, options, sources);
  };
  return planner;
}

}  // namespace vandplan

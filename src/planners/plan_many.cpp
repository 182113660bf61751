// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "sites/site.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan {
namespace {

/// The costs that plans are not to exceed: those of the table's ways. Neither a vehicle with a
/// trailer nor wheels that turn only while it rolls can follow a way: then there are none.
std::vector<SiteCost> costs_of_ways(const Problem& problem, std::span<const Pose> starts,
                                    const PlanOptions& options, int jobs) {
  const PlanOptions all = complete(default_planner(), options, problem.vehicle());
  if (problem.vehicle().trailer || all.steering == Steering::continuous) {
    return std::vector<SiteCost>(starts.size() * options.site->goals().size());
  }
  return site_matrix(*options.site, problem, starts, all, jobs);
}

SiteOutcome outcome_without_path(PlanStatus status) {
  if (status == PlanStatus::start_in_collision) return SiteOutcome::start_in_collision;
  if (status == PlanStatus::goal_in_collision) return SiteOutcome::goal_in_collision;
  return status == PlanStatus::no_path ? SiteOutcome::no_path : SiteOutcome::no_plan;
}

/// Takes what a plan brings, in place of a way that is dearer.
void take(const PlanResult& planned, SiteCost& cost) {
  if (planned.path && planned.cost <= cost.cost) {
    cost = {.cost = planned.cost, .outcome = SiteOutcome::plan};
  } else if (cost.outcome != SiteOutcome::way) {
    cost.outcome = outcome_without_path(planned.status);
  }
  cost.lower_bound = sites::is_proven_empty(cost.outcome)
                         ? std::numeric_limits<double>::infinity()
                         : std::min(planned.lower_bound.value_or(0.0), cost.cost);
}

}  // namespace

void plan_many(std::span<const Problem> problems, const Planner& planner,
               const PlanOptions& options, int jobs,
               const std::function<void(std::size_t, PlanResult)>& take) {
  std::vector<std::optional<PlanResult>> results(problems.size());  // results waiting to be taken
  parallel_in_order(
      problems.size(), jobs,
      [&](std::size_t i) { results[i] = plan(problems[i], planner, options); },
      [&](std::size_t i) { take(i, *std::exchange(results[i], std::nullopt)); });
}

std::vector<SiteCost> plan_matrix(const Problem& problem, std::span<const Pose> starts,
                                  const PlanOptions& options, int jobs) {
  if (!options.site) throw InputError("site", "expected a table of the site");
  const std::vector<Pose>& goals = options.site->goals();
  std::vector<SiteCost> costs = costs_of_ways(problem, starts, options, jobs);
  parallel_for(costs.size(), jobs, [&](std::size_t i) {
    if (sites::is_proven_empty(costs[i].outcome)) return;
    const std::size_t start = i / goals.size();
    const Problem pair = sites::between(problem, starts[start], goals[i % goals.size()],
                                        sites::place_in("starts", start));
    take(plan(pair, options), costs[i]);
  });
  return costs;
}

}  // namespace vandplan

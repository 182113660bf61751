// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "sites/site.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan {

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
  std::vector<SiteCost> costs(starts.size() * goals.size());
  parallel_for(costs.size(), jobs, [&](std::size_t i) {
    const std::size_t start = i / goals.size();
    const Problem pair = sites::between(problem, starts[start], goals[i % goals.size()],
                                        sites::place_in("starts", start));
    const PlanResult result = plan(pair, options);
    if (result.path) costs[i].cost = result.cost;
    costs[i].lower_bound = result.lower_bound.value_or(0.0);
  });
  return costs;
}

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/default_search.h"

#include "planners/rig/compose_rig.h"
#include "vandplan/search.h"

namespace vandplan::planning {

anytime::Portfolio portfolio_for(const Task& task, const PlanOptions& options, double time_price,
                                 const anytime::Given& given) {
  return task.vehicle.trailer ? rig::compose(task, options, time_price, given)
                              : anytime::compose(task, options, time_price, given);
}

std::unique_ptr<PathSearch> default_search(const Task& task, const PlanOptions& options,
                                           double time_price, const anytime::Given& given) {
  const search::Budget budget(options.budget);  // its clock begins before the work of composing
  return anytime::begin_run(portfolio_for(task, options, time_price, given), budget,
                            options.budget);
}

}  // namespace vandplan::planning

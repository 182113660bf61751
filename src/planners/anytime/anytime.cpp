// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/anytime.h"

#include "vandplan/search.h"

namespace vandplan::anytime {

PlannerAnswer plan_anytime(const Task& task, const PlanOptions& options, const Given& given) {
  const auto search = drive_search(task, options, 0.0, given);
  while (search->advance()) {
  }
  return search->answer();
}

std::unique_ptr<planning::PathSearch> drive_search(const Task& task, const PlanOptions& options,
                                                   double time_price, const Given& given) {
  const search::Budget budget(options.budget);  // its clock begins before the work of composing
  return begin_run(compose(task, options, time_price, given), budget, options.budget);
}

}  // namespace vandplan::anytime

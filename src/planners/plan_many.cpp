// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "vandplan/planner.h"

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

}  // namespace vandplan

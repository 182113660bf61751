// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "vandplan/planner.h"

namespace vandplan {

void plan_many(std::span<const Problem> problems, const Planner& planner,
               const PlanOptions& options, int jobs,
               const std::function<void(std::size_t, PlanResult)>& take) {
  std::mutex mutex;
  std::vector<std::optional<PlanResult>> waiting(problems.size());  // for those before them
  std::size_t next = 0;                                             // to be taken
  parallel_for(problems.size(), jobs, [&](std::size_t i) {
    PlanResult result = plan(problems[i], planner, options);
    const std::lock_guard lock(mutex);
    waiting[i] = std::move(result);
    // If `take` throws, `next` stays at an empty place: nobody takes anything after that.
    for (; next < waiting.size() && waiting[next]; ++next) {
      take(next, *std::exchange(waiting[next], std::nullopt));
    }
  });
}

}  // namespace vandplan

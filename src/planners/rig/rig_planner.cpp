// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/rig_planner.h"

#include <cstdint>
#include <optional>

#include "planners/rig/rig_run.h"

namespace vandplan::rig {
namespace {

/// A second run, whose wheels need time to turn. What it drives may be driven by wheels that turn
/// at once, too, and it begins with drives of other kinds.
class StricterRun {
 public:
  StricterRun(const Task& task, const PlanOptions& options, double time_left)
      : task_(stricter(task)),
        options_(without_limits(options, time_left)),
        pricing_(task_, options.cost),
        run_(task_, options_, pricing_) {
    run_.begin();
  }
  StricterRun(const StricterRun&) = delete;

  /// Works until it has had its share of the iterations of `first`.
  void work_beside(Run& first) {
    constexpr std::int64_t share = 4;  // the first run does so many times the work
    while (goes_on_ && !first.is_over() && share * run_.iterations() < first.iterations()) {
      const std::int64_t before = run_.iterations();
      goes_on_ = run_.search();
      first.take_from(run_, run_.iterations() - before);
    }
  }

 private:
  static Task stricter(Task task) {
    task.steering = Steering::continuous_between_stops;
    return task;
  }
  static PlanOptions without_limits(PlanOptions options, double time_left) {
    options.budget.max_iterations.reset();
    if (options.budget.time_limit) options.budget.time_limit = time_left;
    return options;
  }

  Task task_;
  PlanOptions options_;
  planning::Pricing pricing_;
  Run run_;
  bool goes_on_ = true;
};

}  // namespace

// The steps of docs/algorithms/trailers.md.
PlannerAnswer plan_rig(const Task& task, const PlanOptions& options,
                       const planning::Pricing& pricing) {
  Run run(task, options, pricing);
  run.begin();
  const bool has_other_kinds = task.steering == Steering::reeds_shepp && !pricing.counts_time() &&
                               !pricing.rule().is_length();
  std::optional<StricterRun> stricter;
  while (run.search()) {
    if (!has_other_kinds || !run.has_drive()) continue;
    if (!stricter) stricter.emplace(task, options, run.time_left());
    stricter->work_beside(run);
  }
  return run.answer();
}

}  // namespace vandplan::rig

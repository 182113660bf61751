// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/path_search.h"

#include <algorithm>
#include <utility>

#include "vandplan/search.h"

namespace vandplan::planning {
namespace {

using Function = std::function<PlannerAnswer(const Task&, const PlanOptions&)>;

constexpr std::int64_t first_round = 128;  // iterations of the first round

class Restarted final : public PathSearch {
 public:
  Restarted(Function planner, const Task& task, const PlanOptions& options)
      : planner_(std::move(planner)), task_(task), options_(options), budget_(options.budget) {}

  bool advance(std::int64_t most) override {
    if (most <= 0 || budget_.is_interrupted()) return false;
    PlanOptions options = options_;
    options.budget.max_iterations = std::min(round_, most);
    if (options.budget.time_limit) {
      *options.budget.time_limit = std::max(*options.budget.time_limit - budget_.elapsed(), 0.0);
    }
    const double begun = budget_.elapsed();
    PlannerAnswer next = planner_(task_, options);
    for (CostSample& sample : next.anytime) {
      sample.time += begun;
      sample.iteration += iterations_;
    }
    // A round without an iteration found nothing to do, and so would the next one.
    const bool is_cut_short = next.status == PlanStatus::iteration_limit ||
                              (next.segments && next.iterations >= *options.budget.max_iterations);
    const bool goes_on = is_cut_short && next.iterations > 0;
    round_ *= 2;
    iterations_ += next.iterations;
    if (next.segments || !answer_.segments) answer_ = std::move(next);
    return goes_on;
  }

  [[nodiscard]] std::optional<std::vector<Segment>> path() override { return answer_.segments; }
  [[nodiscard]] std::int64_t iterations() const override { return iterations_; }
  [[nodiscard]] PlannerAnswer answer() override {
    PlannerAnswer answer = answer_;
    answer.iterations = iterations_;
    return answer;
  }

 private:
  Function planner_;
  const Task& task_;
  PlanOptions options_;
  search::Budget budget_;
  PlannerAnswer answer_;  // last answer that has a path; the last of all if none has
  std::int64_t round_ = first_round;
  std::int64_t iterations_ = 0;
};

}  // namespace

SearchTo restarted_search(Function planner) {
  return [planner = std::move(planner)](const Task& task, const PlanOptions& options,
                                        const Path* /*known*/) {
    return std::make_unique<Restarted>(planner, task, options);
  };
}

}  // namespace vandplan::planning

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/bend_worker.h"

#include <algorithm>
#include <limits>

namespace vandplan::anytime {

BendWorker::BendWorker(const Task& task, const CostRule& rule, std::uint64_t seed)
    : task_(task),
      rule_(rule),
      seed_(seed),
      best_cost_(std::numeric_limits<double>::infinity()),
      told_cost_(best_cost_) {}

Bender& BendWorker::bender() {
  if (!bender_) bender_.emplace(task_, rule_, stream_seed(seed_, 0));
  return *bender_;
}

std::optional<Drive> BendWorker::begin_with(const Path& known) {
  bender().offer(known.segments);
  if (!bender().step()) return std::nullopt;
  best_cost_ = bender_->cost();
  return bender_->best();
}

Counts BendWorker::counts() const { return {0, bender_ ? bender_->checks() : 0}; }

Found BendWorker::work(std::int64_t iterations, const Told& told, const Budget& budget) {
  if (iterations > 0) (void)bender();
  if (told.best != nullptr) {
    best_cost_ = std::min(best_cost_, told.best->cost);
    if (bender_ && told.best->cost < told_cost_) {
      told_cost_ = told.best->cost;
      bender_->offer(*told.best);
    }
  }
  const auto step = [this]() -> std::optional<double> {
    if (!bender_->step() || bender_->cost() >= best_cost_) return std::nullopt;
    return best_cost_ = bender_->cost();
  };
  Found found = work_in_steps(
      iterations, told.enough, budget, [this] { return has_work(); }, step);
  if (!found.improvements.empty()) found.drive = bender_->best();
  return found;
}

}  // namespace vandplan::anytime

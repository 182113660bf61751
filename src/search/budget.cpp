// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>

#include "vandplan/search.h"

namespace vandplan::search {

Budget::Budget(const BudgetOptions& options)
    : time_limit_(options.time_limit),
      max_iterations_(options.max_iterations),
      stop_(options.stop),
      begin_(std::chrono::steady_clock::now()) {}

std::optional<PlanStatus> Budget::exhausted() const {
  if (max_iterations_ && iterations_ >= *max_iterations_) return PlanStatus::iteration_limit;
  if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) return PlanStatus::stopped;
  if (time_limit_ && elapsed() >= *time_limit_) return PlanStatus::time_limit;
  return std::nullopt;
}

bool Budget::next() {
  const std::optional<PlanStatus> end = exhausted();
  if (end) {
    reason_ = *end;
  } else {
    ++iterations_;
  }
  return !end;
}

std::int64_t Budget::left(std::int64_t wanted, std::int64_t promised) const {
  if (!max_iterations_) return wanted;
  return std::clamp<std::int64_t>(*max_iterations_ - iterations_ - promised, 0, wanted);
}

bool Budget::is_interrupted() const {
  return (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) ||
         (time_limit_ && elapsed() >= *time_limit_);
}

double Budget::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

}  // namespace vandplan::search

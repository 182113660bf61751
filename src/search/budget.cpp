// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/budget.h"

#include <algorithm>

namespace vandplan {

Budget::Budget(const PlanOptions& options)
    : time_limit_(options.time_limit),
      max_iterations_(options.max_iterations),
      stop_(options.stop),
      begin_(std::chrono::steady_clock::now()) {}

bool Budget::allows_more() {
  if (max_iterations_ && iterations_ >= *max_iterations_) {
    reason_ = PlanStatus::iteration_limit;
    return false;
  }
  if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) {
    reason_ = PlanStatus::stopped;
    return false;
  }
  if (time_limit_ && elapsed() >= *time_limit_) {
    reason_ = PlanStatus::time_limit;
    return false;
  }
  return true;
}

bool Budget::next() {
  if (!allows_more()) return false;
  ++iterations_;
  return true;
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

}  // namespace vandplan

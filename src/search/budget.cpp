// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <time.h>

#include <algorithm>

#include "vandplan/search.h"

namespace vandplan::search {
namespace {

// Processor time of the calling thread since the thread began.
std::chrono::nanoseconds processor_clock() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

double seconds(std::chrono::nanoseconds duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

Budget::Budget(const BudgetOptions& options)
    : time_limit_(options.time_limit),
      max_iterations_(options.max_iterations),
      stop_(options.stop),
      by_processor_(options.processor_time && options.threads == 1),
      begin_(std::chrono::steady_clock::now()),
      processor_begin_(by_processor_ ? processor_clock() : std::chrono::nanoseconds(0)),
      due_(options.time_limit.value_or(0.0)) {}

std::optional<PlanStatus> Budget::exhausted() const {
  if (max_iterations_ && iterations_ >= *max_iterations_) return PlanStatus::iteration_limit;
  if (stop_.stop_requested()) return PlanStatus::stopped;
  if (is_late()) return PlanStatus::time_limit;
  return std::nullopt;
}

bool Budget::next() {
  if (iterations_ == 0) set_up_time_ = elapsed();
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

bool Budget::is_interrupted() const { return stop_.stop_requested() || is_late(); }

// Reading the processor clock takes fifty times as long as reading the wall clock. A thread gets at
// most one second of processor time a second, so the time left says when to read it next.
bool Budget::is_late() const {
  if (!time_limit_) return false;
  const double now = seconds(std::chrono::steady_clock::now() - begin_);
  if (now < due_) return false;
  if (!by_processor_) return true;
  const double left = *time_limit_ - elapsed();
  if (left > 0.0) due_ = now + left;
  return left <= 0.0;
}

double Budget::elapsed() const {
  if (by_processor_) return seconds(processor_clock() - processor_begin_);
  return seconds(std::chrono::steady_clock::now() - begin_);
}

}  // namespace vandplan::search

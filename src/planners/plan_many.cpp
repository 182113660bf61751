// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How are many problems planned at a time?

#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "vandplan/planner.h"

namespace vandplan {
namespace {

using Take = std::function<void(std::size_t, PlanResult)>;

/// Hands results on in the order of their numbers, whatever order they come in.
class InOrder {
 public:
  explicit InOrder(const Take& take) : take_(take) {}

  void add(std::size_t i, PlanResult result) {
    waiting_.emplace(i, std::move(result));
    for (auto first = waiting_.find(next_); first != waiting_.end(); first = waiting_.find(next_)) {
      take_(next_++, std::move(waiting_.extract(first).mapped()));
    }
  }

 private:
  const Take& take_;
  std::map<std::size_t, PlanResult> waiting_;
  std::size_t next_ = 0;
};

}  // namespace

void plan_many(std::span<const Problem> problems, const Planner& planner,
               const PlanOptions& options, int jobs, const Take& take) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;  // of what follows
  InOrder results(take);
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < problems.size(); i = next++) {
      try {
        PlanResult result = plan(problems[i], planner, options);
        const std::lock_guard lock(mutex);
        if (!failure) results.add(i, std::move(result));
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = problems.size();
      }
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int i = 1; i < jobs; ++i) helpers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace vandplan

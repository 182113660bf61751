// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// May a run go on? The one place of the core that looks at a clock.

#include <chrono>
#include <cstdint>
#include <optional>

#include "vandplan/plan_options.h"
#include "vandplan/planner.h"

namespace vandplan {

/// Counts iterations and time of one run.
class Budget {
 public:
  explicit Budget(const PlanOptions& options);

  /// Begins the next iteration, or says that there is none.
  [[nodiscard]] bool next();
  /// Whether there is a next one.
  [[nodiscard]] bool allows_more();
  /// How many of the `wanted` iterations there are when `promised` ones are taken first.
  [[nodiscard]] std::int64_t left(std::int64_t wanted, std::int64_t promised) const;
  /// Counts iterations that were done.
  void spend(std::int64_t iterations) { iterations_ += iterations; }
  /// Out of time or told to stop; may be asked from several threads.
  [[nodiscard]] bool is_interrupted() const;
  [[nodiscard]] std::int64_t iterations() const noexcept { return iterations_; }
  /// Since the run began [s].
  [[nodiscard]] double elapsed() const;
  /// Why `next` said no.
  [[nodiscard]] PlanStatus reason() const noexcept { return reason_; }

 private:
  std::optional<double> time_limit_;
  std::optional<std::int64_t> max_iterations_;
  const std::atomic<bool>* stop_;
  std::chrono::steady_clock::time_point begin_;
  std::int64_t iterations_ = 0;
  PlanStatus reason_ = PlanStatus::stopped;
};

/// Adds up the time spent in one phase of a run; does nothing unless switched on.
class PhaseTimer {
 public:
  explicit PhaseTimer(bool on) : on_(on) {}
  void start() {
    if (on_) begin_ = std::chrono::steady_clock::now();
  }
  void stop(double& sum) const {
    if (!on_) return;
    sum += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  bool on_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace vandplan

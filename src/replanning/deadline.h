// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// When must a tick answer?

#include <algorithm>
#include <optional>
#include <stop_token>

#include "vandplan/search.h"

namespace vandplan::replanning {

/// End of a search, at a time or when the caller asks for it. It begins when it is made.
class Deadline {
 public:
  /// A deadline that never comes.
  Deadline() : budget_(options_) {}
  /// `time_limit` is in seconds, of the clock of `plans`; none: no limit.
  Deadline(std::optional<double> time_limit, const std::stop_token& stop,
           const BudgetOptions& plans)
      : options_{.time_limit = time_limit, .stop = stop, .processor_time = plans.processor_time},
        budget_(options_) {}

  [[nodiscard]] bool is_over() const { return budget_.is_interrupted(); }

  /// The budget of a planner, cut so that the planner ends in time.
  [[nodiscard]] BudgetOptions cut(BudgetOptions budget) const {
    if (options_.stop.stop_possible()) budget.stop = options_.stop;
    if (!options_.time_limit) return budget;
    const double left = std::max(*options_.time_limit - budget_.elapsed(), 0.0);
    budget.time_limit = std::min(budget.time_limit.value_or(left), left);
    return budget;
  }

 private:
  BudgetOptions options_;
  search::Budget budget_;
};

}  // namespace vandplan::replanning

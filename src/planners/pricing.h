// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a drive cost: the prices of its path, its time, or both?

#include <span>

#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// What the drives of one task cost, in metres; in seconds where the cost is the time.
class Pricing {
 public:
  /// `time_price`: cost of a second beside the prices of the path [m]; without effect where the
  /// cost is the time. The task outlives the pricing.
  Pricing(const Task& task, const CostOptions& cost, double time_price = 0.0);

  /// Prices of the path [m]; those of its length where the cost is the time.
  [[nodiscard]] const search::CostRule& prices() const { return prices_; }
  /// Prices by which routes are found, segment by segment [m]: those of the path, or about those of
  /// the whole drive where a second has a price.
  [[nodiscard]] const search::CostRule& rule() const { return rule_; }
  /// Whether the time is all that counts.
  [[nodiscard]] bool is_time() const { return is_time_; }
  /// Whether the time is a part of the cost: then the cost of a drive is no sum over its segments.
  [[nodiscard]] bool counts_time() const { return is_time_ || time_price_ > 0.0; }

  /// Cost of the fastest drive along `segments` from the start; `near`: what being near things
  /// adds [m].
  [[nodiscard]] double cost(std::span<const Segment> segments, double near) const;
  /// Cost of the fastest drive along `segments` from the start.
  [[nodiscard]] double cost(std::span<const Segment> segments, search::Looks looks) const;

  /// No drive costs less whose path is at least `length` metres long and has prices of at least
  /// `priced` metres.
  [[nodiscard]] double least_cost(double length, double priced) const;

 private:
  const Task& task_;
  search::CostRule prices_;
  search::CostRule rule_;
  bool is_time_;
  double time_price_;
};

}  // namespace vandplan::planning

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a drive cost: the prices of its path, its time, or both?

#include <span>

#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// Costs of the drives of one task [m], or [s] if the cost is the time.
class Pricing {
 public:
  /// `time_price`: cost of a second beside the prices of the path [m]; ignored if the cost is the
  /// time. The task outlives the pricing.
  Pricing(const Task& task, const CostOptions& cost, double time_price = 0.0);

  /// Prices of the path [m]; its length if the cost is the time.
  [[nodiscard]] const search::CostRule& prices() const { return prices_; }
  /// Prices by which routes are found, segment by segment [m]: those of the path, or, if a second
  /// has a price, about those of the whole drive.
  [[nodiscard]] const search::CostRule& rule() const { return rule_; }
  /// Whether the cost is the time alone.
  [[nodiscard]] bool is_time() const { return is_time_; }
  /// Whether the time is a part of the cost. Then the cost of a drive is no sum over its segments.
  [[nodiscard]] bool counts_time() const { return is_time_ || time_price_ > 0.0; }

  /// Cost of the fastest drive along `segments` from the start. `near`: clearance cost of the path
  /// [m].
  [[nodiscard]] double cost(std::span<const Segment> segments, double near) const;
  /// Cost of the fastest drive along `segments` from the start. `sampling`: how finely the
  /// clearance is summed.
  [[nodiscard]] double cost(std::span<const Segment> segments,
                            search::ClearanceSampling sampling) const;

  /// Lower bound of the cost of drives whose path is at least `length` metres long and has prices
  /// of at least `priced` metres.
  [[nodiscard]] double cost_lower_bound(double length, double priced) const;

 private:
  const Task& task_;
  search::CostRule prices_;
  search::CostRule rule_;
  bool is_time_;
  double time_price_;
};

}  // namespace vandplan::planning

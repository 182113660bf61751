// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/pricing.h"

#include <limits>

#include "planners/drive_time.h"

namespace vandplan::planning {
namespace {

search::CostRule rule_of(const Task& task, const CostOptions& cost, double time_price) {
  if (cost.measure == CostMeasure::time) {
    return search::restricted(prices_like_time(task), cost.gears);
  }
  if (time_price == 0.0) return search::cost_rule(cost);
  return with_time(search::cost_rule(cost), task, time_price);
}

}  // namespace

Pricing::Pricing(const Task& task, const CostOptions& cost, double time_price)
    : task_(task),
      prices_(search::cost_rule(cost)),
      rule_(rule_of(task, cost, time_price)),
      is_time_(cost.measure == CostMeasure::time),
      time_price_(time_price) {}

double Pricing::cost(std::span<const Segment> segments, double near) const {
  if (is_time_) {
    constexpr double never = std::numeric_limits<double>::infinity();
    return search::may_drive(prices_, segments) ? drive_time(task_, segments) : never;
  }
  search::Driven driven = prices_.initial_gear;
  const double cost = search::drive_cost(prices_, segments, driven) + near;
  return time_price_ == 0.0 ? cost : cost + time_price_ * drive_time(task_, segments);
}

double Pricing::cost(std::span<const Segment> segments, search::ClearanceSampling sampling) const {
  if (is_time_ || prices_.clearance_weight == 0.0) return cost(segments, 0.0);
  return cost(segments, search::clearance_cost(task_, prices_, task_.start, segments, sampling));
}

double Pricing::cost_lower_bound(double length, double priced) const {
  if (!counts_time()) return priced;
  const double time = drive_time_lower_bound(task_.vehicle, prices_, length);
  return is_time_ ? time : priced + time_price_ * time;
}

}  // namespace vandplan::planning

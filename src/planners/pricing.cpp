// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/pricing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/drive_time.h"
#include "search/zone_bound.h"

namespace vandplan::planning {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double price_of_metre = 1e3;  // price of a metre that strokes are too short [m or s]

/// Sum of the lengths by which strokes are shorter than `least` [m]; 0 without a gear change.
double missing(std::span<const Segment> segments, double least) {
  double sum = 0.0;
  double stroke = 0.0;
  bool changes_gear = false;
  for (const Segment& segment : segments) {
    if (segment.length * stroke < 0.0) {
      sum += std::max(0.0, least - std::abs(stroke));
      stroke = 0.0;
      changes_gear = true;
    }
    stroke += segment.length;
  }
  return changes_gear ? sum + std::max(0.0, least - std::abs(stroke)) : 0.0;
}

/// The rule for a part of a longer drive: gears that go on beyond its ends count.
search::CostRule with_gears_beyond(const Task& task, search::CostRule rule) {
  if (task.beyond.start != 0) rule.initial_gear = task.beyond.start;
  rule.final_gear = task.beyond.goal;
  return rule;
}

search::CostRule rule_of(const Task& task, const CostOptions& cost, double time_price) {
  if (cost.measure == CostMeasure::time) {
    return search::restricted(prices_like_time(task), cost.gears);
  }
  const search::CostRule prices = search::cost_rule(cost, task);
  return time_price == 0.0 ? prices : with_time(prices, task, time_price);
}

}  // namespace

double price_of_lack(std::span<const Segment> segments, double least) {
  return price_of_metre * missing(segments, least);
}

Pricing::Pricing(const Task& task, const CostOptions& cost, double time_price, double min_stroke)
    : task_(task),
      prices_(with_gears_beyond(task, search::cost_rule(cost, task))),
      rule_(with_gears_beyond(task, rule_of(task, cost, time_price))),
      is_time_(cost.measure == CostMeasure::time),
      time_price_(time_price),
      min_stroke_(min_stroke),
      delay_(task.moving.empty() ? nullptr : std::make_shared<const Delay>(task)) {}

double Pricing::near_cost(std::span<const Segment> segments,
                          search::ClearanceSampling sampling) const {
  if (is_time_ || !prices_.has_surcharge()) return 0.0;
  return search::clearance_cost(task_, prices_, start_state(task_), segments, sampling);
}

double Pricing::path_cost(std::span<const Segment> segments, double near) const {
  if (!is_time_) return search::drive_cost(prices_, segments) + near;
  return search::may_drive(prices_, segments) ? drive_time(task_, segments) : never;
}

double Pricing::path_cost(std::span<const Segment> segments,
                          search::ClearanceSampling sampling) const {
  return path_cost(segments, near_cost(segments, sampling));
}

/// Duration of the fastest drive, and about what it loses by letting moving obstacles pass [s].
double Pricing::drive_time_among_movers(std::span<const Segment> segments) const {
  if (!delay_) return drive_time(task_, segments);
  const Path path{task_.start, {segments.begin(), segments.end()}};
  const SpeedProfile drive = fastest_drive(task_, path);
  return drive.duration + delay_->of(path, drive);
}

double Pricing::cost(std::span<const Segment> segments, double near) const {
  if (!counts_time()) return path_cost(segments, near);
  if (is_time_ && !search::may_drive(prices_, segments)) return never;
  const double of_path = is_time_ ? 0.0 : path_cost(segments, near);
  return timed_cost(of_path, drive_time_among_movers(segments));
}

double Pricing::cost(std::span<const Segment> segments, search::ClearanceSampling sampling) const {
  return cost(segments, near_cost(segments, sampling));
}

double Pricing::cost(const search::Route& route) const {
  double near = 0.0;
  for (const search::Leg& leg : route.legs) near += leg.clearance_cost;
  return cost(path_of(route).segments, near);
}

std::function<double(std::span<const Segment>)> Pricing::measure() const {
  if (!counts_time() && min_stroke_ == 0.0) return {};
  return [this](std::span<const Segment> segments) {
    return price(segments, search::ClearanceSampling::search);
  };
}

double Pricing::cost_lower_bound(std::span<const double> lengths, double priced) const {
  if (!counts_time()) return priced;
  double time = 0.0;
  for (const double length : lengths) {
    time += drive_time_lower_bound(task_.vehicle, prices_, length);
  }
  return is_time_ ? time : priced + time_price_ * time;
}

search::MetreCost Pricing::added_metre_cost() const {
  search::MetreCost cost;
  if (!is_time_) cost.priced = std::min(prices_.forward_weight, prices_.reverse_weight);
  if (!counts_time()) return cost;
  cost.second = is_time_ ? 1.0 : time_price_;
  cost.top_speed = top_speed(task_.vehicle, prices_);
  cost.ramps = ramps_to(task_.vehicle, cost.top_speed);
  return cost;
}

search::MetreCost Pricing::metre_cost() const {
  search::MetreCost cost = added_metre_cost();
  cost.anywhere = cost.priced + cost.second / cost.top_speed;
  cost.ramps = {};
  return cost;
}

Pricing pricing_of(const Task& task, const PlanOptions& options, double time_price) {
  return {task, options.cost, time_price, options.planner.number("min_stroke")};
}

}  // namespace vandplan::planning

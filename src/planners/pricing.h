// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a drive cost: the prices of its path, its time, or both?

#include <functional>
#include <memory>
#include <span>

#include "planners/delay.h"
#include "search/route.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::search {
struct MetreCost;
}

namespace vandplan::planning {

/// Addition to the cost of a drive for strokes before and after gear changes that are shorter than
/// `least` [m]: more than any detour costs [m or s].
[[nodiscard]] double price_of_lack(std::span<const Segment> segments, double least);

/// Costs of the drives of one task [m], or [s] if the cost is the time.
class Pricing {
 public:
  /// `time_price`: cost of a second beside the prices of the path [m]; ignored if the cost is the
  /// time. `min_stroke`: least length of strokes that is asked for [m]. The task outlives the
  /// pricing.
  Pricing(const Task& task, const CostOptions& cost, double time_price = 0.0,
          double min_stroke = 0.0);

  /// Prices of the path [m]; its length if the cost is the time.
  [[nodiscard]] const search::CostRule& prices() const { return prices_; }
  /// Prices by which routes are found, segment by segment [m]: those of the path, or, if a second
  /// has a price, about those of the whole drive.
  [[nodiscard]] const search::CostRule& rule() const { return rule_; }
  /// Whether the cost is the time alone.
  [[nodiscard]] bool is_time() const { return is_time_; }
  /// Whether the time is a part of the cost. Then the cost of a drive is no sum over its segments.
  [[nodiscard]] bool counts_time() const { return is_time_ || time_price_ > 0.0; }

  /// Cost of `segments` from the start. If time counts, they are driven as fast as possible, and a
  /// drive that meets a moving obstacle of the task takes longer. `near`: clearance cost of the
  /// path [m].
  [[nodiscard]] double cost(std::span<const Segment> segments, double near) const;
  /// Likewise. `sampling`: how finely the clearance is summed.
  [[nodiscard]] double cost(std::span<const Segment> segments,
                            search::ClearanceSampling sampling) const;
  /// Likewise of a route, with the `clearance_cost` stored in its legs.
  [[nodiscard]] double cost(const search::Route& route) const;

  /// Cost of the path alone, whatever a second costs. If the cost is the time, this is the time of
  /// the fastest drive.
  [[nodiscard]] double path_cost(std::span<const Segment> segments,
                                 search::ClearanceSampling sampling) const;
  /// Cost of a drive that takes `duration` [s] along a path that costs `path_cost`.
  [[nodiscard]] double timed_cost(double path_cost, double duration) const {
    return is_time_ ? duration : path_cost + time_price_ * duration;
  }
  /// Duration of a drive that costs `cost` along a path that costs `path_cost` [s].
  [[nodiscard]] double duration(double path_cost, double cost) const {
    return is_time_ ? cost : (cost - path_cost) / time_price_;
  }

  /// The `price_of_lack` of strokes shorter than `min_stroke`.
  [[nodiscard]] double lack(std::span<const Segment> segments) const {
    return min_stroke_ > 0.0 ? price_of_lack(segments, min_stroke_) : 0.0;
  }
  /// Cost and `lack` of the fastest drive along `segments`.
  [[nodiscard]] double price(std::span<const Segment> segments,
                             search::ClearanceSampling sampling) const {
    return cost(segments, sampling) + lack(segments);
  }
  /// The `price` as searches see it; none where it is a sum over segments. The pricing outlives the
  /// function.
  [[nodiscard]] std::function<double(std::span<const Segment>)> measure() const;

  /// Lower bound of the cost of drives whose path is at least `length` metres long and has prices
  /// of at least `priced` metres.
  [[nodiscard]] double cost_lower_bound(double length, double priced) const {
    return cost_lower_bound({&length, 1}, priced);
  }
  /// Likewise of drives that stand between moves, each of which has at least one of these `lengths`
  /// [m].
  [[nodiscard]] double cost_lower_bound(std::span<const double> lengths, double priced) const;

  /// What each metre costs in a proof about zones: all that it costs at least, or only what zones
  /// and masks add to `cost_lower_bound`.
  [[nodiscard]] search::MetreCost metre_cost() const;
  [[nodiscard]] search::MetreCost added_metre_cost() const;

 private:
  [[nodiscard]] double path_cost(std::span<const Segment> segments, double near) const;
  [[nodiscard]] double drive_time_among_movers(std::span<const Segment> segments) const;
  [[nodiscard]] double near_cost(std::span<const Segment> segments,
                                 search::ClearanceSampling sampling) const;

  const Task& task_;
  search::CostRule prices_;
  search::CostRule rule_;
  bool is_time_;
  double time_price_;
  double min_stroke_;
  std::shared_ptr<const Delay> delay_;  // null if nothing moves
};

/// Costs by the options of a planner that has the option "min_stroke".
[[nodiscard]] Pricing pricing_of(const Task& task, const PlanOptions& options,
                                 double time_price = 0.0);

}  // namespace vandplan::planning

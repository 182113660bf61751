// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/set_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/anytime/cost_bound.h"
#include "planners/goal_poses.h"
#include "planners/leg_bounds.h"
#include "planners/rig/towed.h"

namespace vandplan::planning {
namespace {

constexpr std::size_t halvings_of_set = 20'000;  // halvings of parts of all regions
constexpr std::int64_t work_past_vias = 20'000;  // pairs of parts of vias that are looked at

}  // namespace

SetBounds::SetBounds(const Task& task, const CostOptions& cost, double time_price)
    : task_(task), cost_(cost), time_price_(time_price), pricing_(task, cost, time_price) {}

double SetBounds::to(const Task& to) const {
  const Pricing pricing(to, cost_, time_price_);
  const double straight_there = to.vehicle.trailer ? rig::cost_lower_bound(to, pricing)
                                                   : anytime::CostBound(to, pricing).least({});
  return to.via.empty() ? straight_there
                        : std::max(straight_there, LegBounds(to, pricing, 0).least());
}

double SetBounds::straight_to(const LocalState& place) const {
  const double way = std::hypot(place.pose.x - task_.start.x, place.pose.y - task_.start.y);
  return of_length(std::max(0.0, way - 4 * steering::judged.position));
}

double SetBounds::to_regions() const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t region = 0; region < task_.goal_set.size(); ++region) {
    if (!is_continuous(task_.goal_set[region])) continue;
    const double length =
        length_lower_bound_to(task_, region, halvings_of_set / task_.goal_set.size());
    least = std::min(least, of_length(length));
  }
  if (task_.via.empty() || least == std::numeric_limits<double>::infinity()) return least;
  return std::max(least, LegBounds(task_, pricing_, work_past_vias).least());
}

/// Bound of paths that are at least `length` metres long.
double SetBounds::of_length(double length) const {
  const anytime::OpenGround ground{length, length, length, 0.0};
  return pricing_.counts_time() ? pricing_.cost_lower_bound(length, length)
                                : anytime::cost_lower_bound(ground, pricing_.rule(), 0.0);
}

}  // namespace vandplan::planning

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/cost_bound.h"

#include <algorithm>

#include "planners/towed.h"
#include "steering/words.h"

namespace vandplan::anytime {
namespace {

/// Slack of drives of rigs, and of prices plus time, relative: ends may be off as much.
constexpr double of_ends = 1e-6;

}  // namespace

CostBound::CostBound(const Task& task, const planning::Pricing& pricing)
    : pricing_(pricing),
      ground_(open_ground(task, pricing.rule())),
      is_rig_(task.vehicle.trailer.has_value()) {
  if (!is_rig_) return;
  judged_of_rig_ = planning::cost_lower_bound(task, pricing);
  exact_of_rig_ = planning::cost_lower_bound(task, pricing, planning::Ends::exact);
}

double CostBound::least(const Proven& proven) const {
  return std::max(by_lengths(proven) + proven.added, proven.in_zones);
}

double CostBound::by_lengths(const Proven& proven) const {
  if (is_rig_) return judged_of_rig_ * (1 - of_ends);
  const search::CostRule& rule = pricing_.rule();
  // Ends within the judge's tolerance make the way around obstacles shorter by at most this much.
  const double off = rule.is_length() ? 0.0 : 2 * steering::judged.position;
  const double around =
      std::max({0.0, proven.shortest - off, proven.shortest_turn - ground_.leeway});
  if (!pricing_.counts_time()) return cost_lower_bound(ground_, rule, around);
  const double length = std::max(length_lower_bound(ground_, rule), around);
  return pricing_.cost_lower_bound(length, length);
}

bool CostBound::is_optimal(double cost, const Proven& proven) const {
  if (is_rig_) return cost <= std::max(judged_of_rig_, exact_of_rig_ * (1 + of_ends));
  if (pricing_.counts_time()) {
    return cost <= least(proven) * (1 + (pricing_.is_time() ? search::rounding_of_cost : of_ends));
  }
  return cost <= cost_lower_bound(ground_, pricing_.rule(), 0.0) * (1 + search::rounding_of_cost) +
                     ground_.leeway;
}

}  // namespace vandplan::anytime

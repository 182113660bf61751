// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "sites/estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sites/data.h"
#include "sites/way.h"

namespace vandplan::sites {

CostsToGoal::CostsToGoal(const SiteTable& table, const Task& task)
    : table_(table),
      world_(task.world),
      goal_(goal_in(table, task).value_or(0)),
      farthest_(table.data().layers[goal_].largest_cost()) {}

double CostsToGoal::from(const LocalPose& pose) const {
  return std::min(table_.cost(to_scenario(*world_, pose), goal_), farthest_);
}

CostDifferences::CostDifferences(const SiteTable& table, const Task& task, bool is_one_way,
                                 std::size_t capacity)
    : table_(table), world_(task.world), is_one_way_(is_one_way), costs_(table.goals().size()) {
  for (std::vector<float>& costs : costs_) costs.reserve(capacity);
}

void CostDifferences::add(const LocalPose& node) {
  for (std::size_t goal = 0; goal < costs_.size(); ++goal) costs_[goal].push_back(cost(node, goal));
}

void CostDifferences::raise(const LocalPose& sample, std::span<float> lengths) const {
  for (std::size_t goal = 0; goal < costs_.size(); ++goal) {
    const float rest = cost(sample, goal);
    if (std::isnan(rest)) continue;
    const float* const costs = costs_[goal].data();
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const float saved = costs[i] - rest;
      const float least = is_one_way_ ? saved : std::abs(saved);
      if (least > lengths[i]) lengths[i] = least;  // never with NaN
    }
  }
}

float CostDifferences::cost(const LocalPose& pose, std::size_t goal) const {
  const auto known = static_cast<float>(table_.cost(to_scenario(*world_, pose), goal));
  return std::isfinite(known) ? known : std::numeric_limits<float>::quiet_NaN();
}

SiteTable with_costs(const SiteTable& table,
                     std::function<double(const Pose&, std::size_t goal)> costs) {
  SiteData data = table.data();
  data.costs = std::move(costs);
  return SiteTable(std::make_shared<const SiteData>(std::move(data)));
}

}  // namespace vandplan::sites

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/room_for_margin.h"

#include <algorithm>

namespace vandplan::rig {

std::optional<Task> without_margin(const Task& task, double margin) {
  if (margin == 0.0) return std::nullopt;
  Task bare = task;
  bare.checker = task.world->checker(task.vehicle);
  return bare;
}

search::CostRule rule_of_room(double margin) {
  constexpr double price = 1000.0;  // weight beside which the length is small
  constexpr double least = 0.01;    // least clearance distance of the rule [m]
  CostOptions options = shortest_style;
  options.clearance_weight = price;
  options.clearance_distance = std::max(margin + 2 * CollisionChecker::tolerance, least);
  return search::cost_rule(options);
}

}  // namespace vandplan::rig

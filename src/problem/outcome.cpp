// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/problem.h"

#include <array>

namespace vandplan {

std::string_view name_of(PlanStatus status) noexcept {
  constexpr std::array<std::string_view, 9> names = {
      "solved",     "start_in_collision", "goal_in_collision", "iteration_limit",
      "node_limit", "time_limit",         "stopped",           "no_path",
      "rejected"};
  return names[static_cast<std::size_t>(status)];
}

const std::vector<PlanStatus>& plan_statuses() {
  static const std::vector<PlanStatus> statuses = {PlanStatus::solved,
                                                   PlanStatus::start_in_collision,
                                                   PlanStatus::goal_in_collision,
                                                   PlanStatus::iteration_limit,
                                                   PlanStatus::node_limit,
                                                   PlanStatus::time_limit,
                                                   PlanStatus::stopped,
                                                   PlanStatus::no_path,
                                                   PlanStatus::rejected};
  return statuses;
}

}  // namespace vandplan

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/outcome.h"

#include <array>
#include <cstddef>

namespace vandplan::ros {

std::string_view name_of(Outcome outcome) noexcept {
  constexpr std::array<std::string_view, 9> names = {
      "solved",  "start_outside_map", "goal_outside_map", "start_occupied", "goal_occupied",
      "no_path", "timed_out",         "cancelled",        "invalid"};
  return names[static_cast<std::size_t>(outcome)];
}

Outcome outcome_of(PlanStatus status) noexcept {
  switch (status) {
    case PlanStatus::solved:
      return Outcome::solved;
    case PlanStatus::start_in_collision:
      return Outcome::start_occupied;
    case PlanStatus::goal_in_collision:
      return Outcome::goal_occupied;
    case PlanStatus::iteration_limit:
    case PlanStatus::node_limit:
    case PlanStatus::time_limit:
      return Outcome::timed_out;
    case PlanStatus::stopped:
      return Outcome::cancelled;
    case PlanStatus::no_path:
    case PlanStatus::rejected:
      break;
  }
  return Outcome::no_path;
}

}  // namespace vandplan::ros

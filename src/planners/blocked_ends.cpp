// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/blocked_ends.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

#include "moving/encounters.h"

namespace vandplan::in_time {

std::string proof_of_none(const Task& task, double margin) {
  const State start = start_state(task), goal = goal_state(task);
  const Path none{task.start, {}};
  constexpr double any = std::numeric_limits<double>::infinity();
  const moving::Encounters encounters({none, task.vehicle}, task.moving, margin);
  for (std::size_t i = 0; i < encounters.size(); ++i) {
    const std::optional<double> leaves = encounters.leaves(i);
    const std::string name = "moving[" + std::to_string(i) + "]";
    const bool is_there = leaves.value_or(0.0) >= 0.0;
    if (is_there && encounters.gap(i, start, 0.0, any) <= 0.0) {
      return name + " is where the start is, or nearer to it than the margin";
    }
    const double rest = std::max(encounters.rests(i), 0.0);
    if (!leaves && encounters.gap(i, goal, rest, any) <= 0.0) {
      return name + " stays where the goal is, or nearer to it than the margin";
    }
  }
  return "";
}

}  // namespace vandplan::in_time

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/softer_wheels.h"

#include "planners/commands/closer.h"
#include "planners/commands/wheels.h"

namespace vandplan::rig {
namespace {

/// Shares of the largest curvature rate. Each drive is bent into the next one.
constexpr double sharpnesses[] = {0.7, 0.5, 0.35, 0.25};

}  // namespace

std::deque<Task> with_softer_wheels(const Task& task) {
  std::deque<Task> tasks = {task};
  if (task.steering == Steering::reeds_shepp) return tasks;
  for (const double sharpness : sharpnesses) {
    Task& softer = tasks.emplace_back(task);
    softer.vehicle.limits.max_curvature_rate = sharpness * max_curvature_rate(task.vehicle);
  }
  return tasks;
}

}  // namespace vandplan::rig

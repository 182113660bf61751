// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/softer_wheels.h"

#include "planners/commands/closer.h"
#include "planners/commands/wheels.h"

namespace vandplan::rig {
namespace {

// Of the largest change of curvature per metre. Each drive is bent into the next one.
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

std::optional<std::vector<Segment>> obeyed(const Task& task, std::vector<Segment> chain) {
  const commands::Wheels wheels(task.vehicle, task.steering);
  const commands::WheelEnds ends = commands::wheel_ends(task);
  commands::Closer closer(task.vehicle, task.steering);
  const RigState from{task.start, task.hitch_angles.start};
  const RigState to{task.goal, task.hitch_angles.goal};
  if (!closer.close(from, chain, to, ends)) return std::nullopt;
  if (!task.checker->rig_is_free(Local(from), wheels.driven(chain, ends.before)))
    return std::nullopt;
  return chain;
}

}  // namespace vandplan::rig

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/exact_drive.h"

namespace vandplan::rig {

ExactDrive::ExactDrive(const Task& task)
    : task_(task),
      wheels_(task.vehicle, task.steering),
      ends_(search::driven_at_ends(task)),
      closer_(task.vehicle, task.steering) {}

std::optional<std::vector<commands::Command>> ExactDrive::along(std::span<const Segment> segments) {
  if (segments.empty()) return std::nullopt;
  const LocalState from = start_state(task_);
  const State to = goal_state(task_);
  std::vector<commands::Command> commands = wheels_.commands(segments, ends_);
  if (!closer_.close(from, commands, to, ends_)) return std::nullopt;
  commands = wheels_.tidied(commands, ends_.before);
  if (!closer_.close(from, commands, to, ends_)) return std::nullopt;
  if (!task_.checker->is_free(from, wheels_.driven(commands, ends_.before))) {
    return std::nullopt;
  }
  return commands;
}

}  // namespace vandplan::rig

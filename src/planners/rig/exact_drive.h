// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a drive that nearly ends at the goal become one that does?
//
// Method: docs/algorithms/trailers.md.

#include <optional>
#include <span>
#include <vector>

#include "planners/commands/closer.h"
#include "planners/commands/wheels.h"
#include "vandplan/problem.h"

namespace vandplan::rig {

/// Changes segments that nearly lead from the start of a task to its goal, until they end exactly
/// there. The task has a vehicle with a trailer and outlives the object.
class ExactDrive {
 public:
  explicit ExactDrive(const Task& task);

  /// The commands of a free drive along the segments; none if none was found.
  [[nodiscard]] std::optional<std::vector<commands::Command>> along(
      std::span<const Segment> segments);

 private:
  const Task& task_;
  commands::Wheels wheels_;
  search::DrivenBeside ends_;
  commands::Closer closer_;
};

}  // namespace vandplan::rig

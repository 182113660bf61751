// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is driven from the start to the goal?

#include <cstddef>
#include <optional>
#include <vector>

#include "planners/commands/wheels.h"
#include "search/route.h"

namespace vandplan::anytime {

/// Drive from the start to the goal.
struct Drive {
  /// Commands of the wheels; empty if the segments follow a route.
  std::vector<commands::Command> commands = {};
  /// Segments that are driven; empty if only the commands are known.
  std::vector<Segment> segments = {};
  std::optional<search::Route> route = {};  ///< route that `segments` follow, if it is known
  double cost = 0.0;                        ///< price of the drive [m], or its time [s]
  std::size_t wheels = 0;                   ///< which wheels obey `commands`; 0: those of the task
};

}  // namespace vandplan::anytime

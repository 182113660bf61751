// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is driven from the start to the goal?

#include <optional>
#include <vector>

#include "search/route.h"

namespace vandplan::anytime {

/// Drive from the start to the goal.
struct Drive {
  std::vector<Segment> commands;  ///< commands of the task's wheels; empty if `segments` are set
  std::vector<Segment> segments;  ///< segments that are driven; empty if `commands` are set
  std::optional<search::Route> route;  ///< route that `segments` follow, if it is known
  double cost = 0.0;                   ///< price of the drive [m], or its time [s]
};

}  // namespace vandplan::anytime

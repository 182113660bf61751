// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do other libraries' planners reach on one of our problems? Without OMPL there are none.

#include <limits>
#include <string>
#include <vector>

#include "vandplan/problem.h"

namespace vandplan {

/// Of one run that a planner was given so many seconds for.
struct Reached {
  double first = std::numeric_limits<double>::infinity();   // when the first path was there [s]
  double length = std::numeric_limits<double>::infinity();  // of the last path [m]
};

/// Names of the planners.
std::vector<std::string> growth_peers();

/// Runs one of them by length, with our checker; only a path that the judge finds valid counts.
Reached run_growth_peer(const std::string& name, const Problem& problem, double seconds);

}  // namespace vandplan

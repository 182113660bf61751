// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which problem does a given path solve, if it may be any that leads to one goal?

#include <vector>

#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// The problem that a path solves.
struct Along {
  Problem problem;            ///< has one goal in place of a set
  double last_stretch = 0.0;  ///< straight line at the end [m]; negative in reverse, 0 for none
  /// Driven distance to each via [m]; empty unless all are passed.
  std::vector<double> passed = {};
};

/// The goal in place of a set is the one of the set at which the path ends, whatever else is wrong
/// with the path, or else its end. Among moving obstacles a set stays.
[[nodiscard]] Along along_path(const Problem& problem, const Path& path);

}  // namespace vandplan::planning

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does a moving obstacle block the start or the goal for good?

#include <string>

#include "vandplan/problem.h"

namespace vandplan::in_time {

/// Reason why no drive is possible: the moving obstacle that is at the start, or stays at the goal,
/// nearer than `margin` [m]. Empty if there is none.
[[nodiscard]] std::string proof_of_none(const Task& task, double margin);

}  // namespace vandplan::in_time

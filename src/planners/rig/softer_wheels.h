// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What if the wheels turned over a longer way, at a higher speed?
//
// Method: docs/algorithms/trailers.md.

#include <deque>
#include <optional>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan::rig {

/// The task, and copies whose wheels turn more and more slowly for each metre driven. The task
/// alone if its curvature may jump anywhere.
[[nodiscard]] std::deque<Task> with_softer_wheels(const Task& task);

}  // namespace vandplan::rig

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where is room for the margin of a rig, if searches with the margin find no drive?
//
// Method: docs/algorithms/trailers.md.

#include <optional>

#include "vandplan/search.h"

namespace vandplan::rig {

/// The task without its margin; none if the margin is 0.
[[nodiscard]] std::optional<Task> without_margin(const Task& task, double margin);

/// Rule whose cost is how far, and on how many metres, a drive is nearer to obstacles than the
/// margin; the length hardly counts.
[[nodiscard]] search::CostRule rule_of_room(double margin);

}  // namespace vandplan::rig

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

/// The cost of a drive by how far, and on how many metres, it is nearer to things than the margin.
[[nodiscard]] search::CostRule rule_of_room(double margin);

}  // namespace vandplan::rig

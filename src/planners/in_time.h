// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// The default planner among moving obstacles: paths, and times along them.
// How it works: docs/algorithms/moving.md.

#include <span>

#include "vandplan/plan_options.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan::in_time {

/// Cost of a second of a drive, beside the prices of its path [m].
inline constexpr double time_price = 2.0;

/// Plans the drive whose path and seconds cost least together, and looks for ways around obstacles
/// that it meets. Expects start and goal to be free of standing obstacles. `sources` propose paths
/// among standing obstacles; they are ignored with a trailer.
[[nodiscard]] PlannerAnswer plan(const Task& task, const PlanOptions& options,
                                 std::span<const NamedSource> sources = {});

}  // namespace vandplan::in_time

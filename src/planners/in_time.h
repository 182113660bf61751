// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// The default planner among what moves: paths, and when to be where on them.
// How it works: docs/algorithms/moving.md.

#include <span>

#include "vandplan/outcome.h"
#include "vandplan/path_source.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::in_time {

/// What a second of a drive costs beside the prices of its path [m].
inline constexpr double time_price = 2.0;

/// Plans drives whose paths and seconds cost least together, and looks for ways around what is met.
/// Expects start and goal to be free of what stands. `sources` propose paths where nothing moves;
/// no notice is taken of them with a trailer.
[[nodiscard]] PlannerAnswer plan(const Task& task, const PlanOptions& options,
                                 std::span<const NamedSource> sources = {});

}  // namespace vandplan::in_time

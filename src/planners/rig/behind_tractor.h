// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a rig follow a path that was planned for its tractor alone?
//
// Method: docs/algorithms/trailers.md.

#include <cstdint>
#include <optional>
#include <vector>

#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::rig {

/// How the path of the tractor is planned.
struct TractorTerms {
  double radius = 7.0;          ///< the tractor turns on no smaller one [m]
  double reverse_weight = 2.0;  ///< cost of a metre in reverse [m]
  double distance = 1.0;        ///< nearer to things metres cost more [m]
  std::int64_t iterations = 0;  ///< of planning it
  std::int64_t expansions = 0;  ///< of the searches where the trailer cannot follow
  std::uint64_t seed = 1;
};

/// The commands of a free drive of the rig along a path of its tractor; nothing if there is no such
/// path or the trailer cannot follow. The options are complete. What it does counts as iterations.
[[nodiscard]] std::optional<std::vector<Segment>> drive_behind_tractor(const Task& task,
                                                                       const PlanOptions& options,
                                                                       const TractorTerms& terms,
                                                                       search::Budget& budget);

}  // namespace vandplan::rig

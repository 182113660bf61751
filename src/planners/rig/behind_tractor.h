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

/// Settings for the path of the tractor.
struct TractorTerms {
  double radius = 7.0;          ///< least turning radius of the tractor [m]
  double reverse_weight = 2.0;  ///< cost of a metre in reverse [m]
  double distance = 1.0;        ///< clearance below which metres cost more [m]
  std::int64_t iterations = 0;  ///< most iterations of planning the path
  std::int64_t expansions = 0;  ///< most expansions of searches where the trailer cannot follow
  std::uint64_t seed = 1;
};

/// The commands of a free drive of the rig along a path of its tractor; none if there is no such
/// path or the trailer cannot follow. The options are complete. Work counts as iterations of the
/// budget.
[[nodiscard]] std::optional<std::vector<Segment>> drive_behind_tractor(const Task& task,
                                                                       const PlanOptions& options,
                                                                       const TractorTerms& terms,
                                                                       search::Budget& budget);

}  // namespace vandplan::rig

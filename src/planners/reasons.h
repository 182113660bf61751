// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Why is there no path?

#include <string>

#include "vandplan/planner.h"

namespace vandplan::planning {

/// Sets reason and hit of a result whose start or goal is in collision.
void explain_refusal(const Problem& problem, const ClearanceOptions& options, PlanResult& result);

/// Likely reason of a search that ended without a path: the wheels turn so slowly that from lock to
/// lock the vehicle drives further than its bounds are long. Empty otherwise.
[[nodiscard]] std::string likely_reason(const Task& task);

}  // namespace vandplan::planning

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Why is there no path?

#include <string>

#include "vandplan/planner.h"

namespace vandplan::planning {

/// Says what is in the way of a start or goal in collision.
void explain_refusal(const Problem& problem, const ClearanceOptions& options, PlanResult& result);

/// Why a search that ended without a path is likely to have none: the wheels turn so slowly that
/// from lock to lock the vehicle drives further than its bounds are long. Empty otherwise.
[[nodiscard]] std::string likely_reason(const Task& task);

}  // namespace vandplan::planning

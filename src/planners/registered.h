// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which planners does the library bring? A line here and in registered.cpp for each kind.

#include <vector>

#include "vandplan/planner.h"

namespace vandplan::planning {

/// All of them, the default one first, in the order of the documentation.
[[nodiscard]] std::vector<Planner> registered_planners();

}  // namespace vandplan::planning

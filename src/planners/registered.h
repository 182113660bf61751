// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which planners does the library bring?

#include <vector>

#include "vandplan/planner.h"

namespace vandplan::planning {

/// All of them, the default one first, in the order of the documentation.
[[nodiscard]] std::vector<Planner> registered_planners();

/// The planners that the default one is compared with: the thesis' trees and others' methods. The
/// folder `lab` has them, and nothing else of the library uses it.
[[nodiscard]] std::vector<Planner> laboratory();

}  // namespace vandplan::planning

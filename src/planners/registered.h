// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which planners does the library bring?

#include <vector>

#include "vandplan/planner.h"

namespace vandplan::planning {

/// All planners of the library, the default one first, in the order of the documentation.
[[nodiscard]] std::vector<Planner> registered_planners();

/// The planners of the folder `lab`, to compare the default one with: the thesis' trees and others'
/// methods. Nothing else of the library uses that folder.
[[nodiscard]] std::vector<Planner> laboratory();

/// Trees of the thesis that rank nodes by the estimate "site". They are not among `planners()`,
/// since they cannot plan without a table of the site.
[[nodiscard]] std::vector<Planner> laboratory_of_sites();

}  // namespace vandplan::planning

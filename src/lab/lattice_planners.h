// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which planners search a state lattice?

#include <vector>

#include "vandplan/planner.h"

namespace vandplan::lattice {

/// The planners "lattice-a-star", "lattice-ara-star" and "ltba-star".
[[nodiscard]] std::vector<Planner> planners();

}  // namespace vandplan::lattice

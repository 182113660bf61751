// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Python see a goal?

#include <pybind11/pybind11.h>

#include <vector>

#include "vandplan/path.h"

namespace vandplan::python {

/// Regions of a goal that is a `GoalRegion` or a sequence of them. Empty if the goal is a pose.
[[nodiscard]] std::vector<GoalRegion> goal_set_from(const pybind11::handle& given);

/// Vias from a sequence of `Via` objects, `GoalRegion` objects, and poses.
[[nodiscard]] std::vector<Via> via_from(const pybind11::handle& given);

}  // namespace vandplan::python

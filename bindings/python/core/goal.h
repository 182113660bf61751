// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a goal in Python?

#include <pybind11/pybind11.h>

#include <vector>

#include "vandplan/goal_set.h"

namespace vandplan::python {

/// The regions of a goal: a `GoalRegion` or a sequence of them. Empty for a pose.
[[nodiscard]] std::vector<GoalRegion> goal_set_from(const pybind11::handle& given);

}  // namespace vandplan::python

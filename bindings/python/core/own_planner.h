// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a Python function become a planner?

#include <pybind11/pybind11.h>

#include <memory>

#include "vandplan/planner.h"

namespace vandplan::python {

/// Planner that calls a function. It has no options; its name is that of the function.
[[nodiscard]] std::shared_ptr<const Planner> own_planner(const pybind11::function& function);

/// Holder of a Python function that any thread may copy or release. Releasing takes Python's lock.
[[nodiscard]] std::shared_ptr<const pybind11::function> kept(const pybind11::function& function);

/// Planner function that calls a Python function. Any thread may call, copy or release it, as it
/// takes Python's lock.
[[nodiscard]] PlannerFunction planner_function(const pybind11::function& function);

}  // namespace vandplan::python
